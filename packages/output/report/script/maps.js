// SPDX-License-Identifier: BSD-3-Clause
// Maps of planes of the specimen.

const shortNames = { von_mises: "Von Mises", principal_stress_1: "Principal stress", principal_strain_1: "Principal strain" };
const fieldNames = { von_mises: "Von Mises stress", principal_stress_1: "Largest principal stress", principal_strain_1: "Largest principal strain", displacement: "Displacement" };
const withUnit = (value, unit) => `${short(value)}${unit === "-" ? "" : " " + unit.replace("um", "µm")}`;

/** The step that is shown first: the last one, or that of most stress where that is gone by then. */
function stepToShow(steps, history) {
  const mean = meanStress(history), rows = history.column("step"), of = steps.map(({ step }) => mean[rows.indexOf(step)] ?? 0);
  const most = rowOfMost(of);
  return of.at(-1) < 0.1 * of[most] ? most : steps.length - 1;
}

/** Two views of one plane, specimen and field, with sliders over z and step, and what is under the pointer. Maps without fields have no
 *  steps, and something else in the field's place. */
class Maps {
  constructor(maps, image, run) {
    this.maps = maps;
    this.image = image !== null && typeof image === "object" ? image : null;
    this.time = timeUnit(Math.max(...maps.steps.map(({ time }) => time)));
    this.z = Math.floor((maps.count[2] - 1) / 2);  // as in the pictures
    this.step = maps.steps.length > 0 ? stepToShow(maps.steps, run) : 0;
    this.field = 0;
    this.layer = this.image ? "image" : "materials";
    this.probe = null;
    this.canvases = { specimen: this.canvas("specimen"), field: this.canvas("field") };
    this.out = h("output", { class: "probe", id: "probe", "aria-live": "polite" });
    this.zSlider = slider("z-slider", "Plane z", maps.count[2], this.z, (z) => { this.z = z; this.draw(); });
    this.stepSlider = slider("step-slider", "Step", maps.steps.length, this.step, (s) => { this.step = s; this.draw(); });
  }

  element(beside = null) {
    const { maps } = this;
    const layers = [...(this.image ? [["image", "Image"]] : []), ["materials", "Materials"]];
    const fields = maps.fields.map((field, f) => [String(f), shortNames[field.name] || fieldNames[field.name] || field.name]);
    this.ticks = h("div", { class: "ticks" });
    this.fieldCaption = h("figcaption", { id: "field-caption" });
    this.specimenLegend = h("ul", { class: "legend" });
    this.specimenScale = h("div", { class: "scale" });
    return h("div", {},
      h("div", { class: "controls" }, this.zSlider.element, this.stepSlider.element),
      h("div", { class: "pair" },
        h("figure", { class: "map" },
          h("div", { class: "controls" }, layers.length > 1 ? choice("layer", "What is shown of the specimen", layers, this.layer, (l) => { this.layer = l; this.draw(); }) : h("h3", {}, "Materials")),
          this.canvases.specimen, this.specimenScale, this.specimenLegend),
        maps.fields.length === 0 ? beside : h("figure", { class: "map" },
          h("div", { class: "controls" }, choice("field", "Field", fields, "0", (f) => { this.field = Number(f); this.draw(); })),
          this.canvases.field, h("div", { class: "scale" }, h("div", { class: "bar", style: `background: ${gradient}` }), this.ticks), this.fieldCaption)),
      this.out, this.notes().map((text) => h("p", { class: "note" }, text)));
  }

  notes() {
    const { maps } = this, notes = [];
    if (maps.merged.some((n) => n > 1) && maps.fields.length === 0) notes.push(`Down-sampled, so that this page stays small: a cell of the materials is the voxel in the middle of ${maps.merged.join(" × ")}.`);
    else if (maps.merged.some((n) => n > 1)) notes.push(`Down-sampled, so that this page stays small: a cell of the maps is the mean over ${maps.merged.join(" × ")} particles (of the strain, the largest principal value of the mean).`);
    if (maps.steps.length < maps.steps_in_file) notes.push(`${maps.steps.length} of the ${maps.steps_in_file} steps of particles.e are shown.`);
    if (this.image && this.image.merged.some((n) => n > 1)) notes.push(`The image is down-sampled: means over ${this.image.merged.slice(0, 2).join(" × ")} voxels${this.image.merged[2] > 1 ? ` of one plane in ${this.image.merged[2]}` : ""}.`);
    if (typeof data.image === "string") notes.push(data.image);
    if (maps.fields.length > 0 && !maps.fields.some((f) => f.name === "principal_strain_1")) notes.push("particles.e does not hold the strain.");
    notes.push("The undeformed body, " + (data.y_downwards ? "y downwards, as image viewers show it." : "y upwards.") + " Arrow keys move the pointer where a map has the focus.");
    return notes;
  }

  canvas(name) {
    const canvas = h("canvas", { id: name + "-map", role: "img", tabindex: "0" });
    const at = (event) => {
      const box = canvas.getBoundingClientRect();
      this.point((event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height);
    };
    canvas.addEventListener("pointermove", at);
    canvas.addEventListener("pointerdown", at);
    canvas.addEventListener("keydown", (event) => {
      const move = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
      if (!move) return;
      event.preventDefault();
      const [nx, ny] = this.maps.count, stride = event.shiftKey ? 10 : 1;
      const from = this.probe || { i: Math.floor(nx / 2), j: Math.floor(ny / 2) };
      const j = from.j + move[1] * stride * (data.y_downwards ? 1 : -1);
      this.probe = { i: Math.min(nx - 1, Math.max(0, from.i + move[0] * stride)), j: Math.min(ny - 1, Math.max(0, j)) };
      this.draw();
    });
    return canvas;
  }

  /** The pointer, as parts of the view. */
  point(x, y) {
    const [nx, ny] = this.maps.count, clamp = (v, n) => Math.min(n - 1, Math.max(0, Math.floor(v * n)));
    this.probe = { i: clamp(x, nx), j: clamp(data.y_downwards ? y : 1 - y, ny) };
    this.draw();
  }

  /** Cells as 16 bits: low bytes, then high ones; 65535 is empty. */
  async valuesOf(f, step) {
    const bytes = await bytesOf(`map-${f}-${step}`), n = bytes.length / 2, { low, high } = this.maps.fields[f];
    const scale = (high - low) / 65534;
    return (cell) => { const q = bytes[cell] | (bytes[n + cell] << 8); return q === 65535 ? NaN : low + q * scale; };
  }

  /** One after the other, the last asked for last: a slider asks faster than arrays are unpacked. */
  draw() {
    this.again = true;
    this.drawing = this.drawing || this.drawAll().finally(() => { this.drawing = null; });
    return this.drawing;
  }
  async drawAll() {
    while (this.again) {
      this.again = false;
      const { z, step, probe } = this;
      const fields = await Promise.all(this.maps.fields.map((_, f) => this.valuesOf(f, step)));
      const material = await bytesOf("map-material"), image = this.image ? await bytesOf("image") : null;
      this.zSlider.shown.textContent = `${short(this.height(z))} µm (${z + 1} of ${this.maps.count[2]})`;
      this.zSlider.input.setAttribute("aria-valuetext", this.zSlider.shown.textContent);
      this.drawSpecimen(z, material, image);
      if (fields.length > 0) this.drawField(z, step, fields[this.field]);
      for (const canvas of Object.values(this.canvases)) this.drawProbe(canvas, probe);
      this.tell(z, step, probe, fields, material, image);
    }
  }

  /** Draws them first, and again where the window changes its width; says so where the browser cannot. */
  async begin() {
    if (typeof DecompressionStream === "undefined") {
      this.out.textContent = "This browser is too old to show the maps: it lacks DecompressionStream.";
      return;
    }
    await this.draw();
    let width = window.innerWidth;
    window.addEventListener("resize", () => { if (window.innerWidth !== width) { width = window.innerWidth; this.draw(); } });
  }

  height(z) { return this.maps.origin[2] + (z + 0.5) * this.maps.cell[2]; }
  base(z) { return z * this.maps.count[0] * this.maps.count[1]; }

  /** A plane of cells in colours, as large as the place for it, scaled as the body is. */
  paint(canvas, nx, ny, colourOf) {
    const cells = new OffscreenCanvas(nx, ny), picture = new ImageData(nx, ny);
    for (let j = 0; j < ny; ++j)
      for (let i = 0; i < nx; ++i) {
        const colour = colourOf(i + nx * j);
        if (colour === null) continue;
        const at = 4 * (i + nx * (data.y_downwards ? j : ny - 1 - j));
        picture.data.set(colour, at);
        picture.data[at + 3] = 255;
      }
    cells.getContext("2d").putImageData(picture, 0, 0);
    const { cell, count } = this.maps, ratio = (cell[1] * count[1]) / (cell[0] * count[0]);
    const place = canvas.parentElement.clientWidth;
    const width = Math.max(40, Math.min(place, Math.round(Math.max(320, window.innerHeight * 0.75) / ratio)));
    const height = Math.max(12, Math.round(width * ratio)), dense = window.devicePixelRatio || 1;
    canvas.style.width = width + "px";
    canvas.style.height = height + "px";
    canvas.width = Math.round(width * dense);
    canvas.height = Math.round(height * dense);
    const context = canvas.getContext("2d");
    context.imageSmoothingEnabled = nx > canvas.width;
    context.drawImage(cells, 0, 0, canvas.width, canvas.height);
  }

  drawSpecimen(z, material, image) {
    const { maps } = this, canvas = this.canvases.specimen, place = `at z = ${short(this.height(z))} µm`;
    if (this.layer === "image") {
      const [nx, ny] = this.image.count, base = this.imagePlane(z) * nx * ny;
      this.paint(canvas, nx, ny, (cell) => { const v = image[base + cell]; return [v, v, v]; });
      canvas.setAttribute("aria-label", `Image ${place}`);
      this.specimenScale.replaceChildren(h("div", { class: "bar", style: "background: linear-gradient(to right, #000, #fff)" }),
        h("div", { class: "ticks" }, h("span", {}, short(this.image.low)), h("span", {}, "intensity"), h("span", {}, short(this.image.high))));
      this.specimenLegend.replaceChildren();
      return;
    }
    const base = this.base(z);
    this.paint(canvas, maps.count[0], maps.count[1], (cell) => (material[base + cell] === 0 ? null : materialColour(material[base + cell] - 1)));
    canvas.setAttribute("aria-label", `Materials ${place}: ${maps.materials.join(", ")}`);
    this.specimenScale.replaceChildren();
    this.specimenLegend.replaceChildren(...maps.materials.map((name, m) => h("li", {}, h("i", { style: `background: rgb(${materialColour(m)})` }), name)));
  }

  /** The image's plane next to a plane of the maps. */
  imagePlane(z) {
    const { origin, cell, count } = this.image;
    return Math.min(count[2] - 1, Math.max(0, Math.floor((this.height(z) - origin[2]) / cell[2])));
  }

  drawField(z, step, value) {
    const { maps } = this, field = maps.fields[this.field], base = this.base(z);
    const low = field.shown_low, range = field.shown_high - field.shown_low || 1;
    let least = Infinity, most = -Infinity;
    this.paint(this.canvases.field, maps.count[0], maps.count[1], (cell) => {
      const v = value(base + cell);
      if (Number.isNaN(v)) return null;
      if (v < least) least = v;
      if (v > most) most = v;
      return colours[Math.min(255, Math.max(0, Math.round((255 * (v - low)) / range)))];
    });
    const name = fieldNames[field.name] || field.name, { step: number, load, time } = maps.steps[step];
    const when = `step ${number}, ` + (data.has_time ? `${short(time / this.time.size)} ${this.time.name}` : `load ${short(load)}`);
    this.canvases.field.setAttribute("aria-label", `${name} at z = ${short(this.height(z))} µm, ${when}: from ${short(least)} to ${withUnit(most, field.unit)}`);
    this.ticks.replaceChildren(...[0, 0.25, 0.5, 0.75, 1].map((t) => h("span", {}, withUnit(low + t * range, t === 1 ? field.unit : "-"))));
    this.fieldCaption.textContent = `${name}, ${when}. In this plane from ${short(least)} to ${withUnit(most, field.unit)}. One scale for all planes and steps: ` +
      `from where 0.5 % lie below to where 0.5 % lie above; the whole field goes from ${short(field.low)} to ${withUnit(field.high, field.unit)}.`;
    this.stepSlider.shown.textContent = when.replace("step ", "");
    this.stepSlider.input.setAttribute("aria-valuetext", when);
  }

  drawProbe(canvas, probe) {
    if (!probe) return;
    const context = canvas.getContext("2d"), [nx, ny] = this.maps.count;
    const x = ((probe.i + 0.5) / nx) * canvas.width, j = data.y_downwards ? probe.j : ny - 1 - probe.j, y = ((j + 0.5) / ny) * canvas.height;
    for (const [colour, width] of [["#000", 4], ["#fff", 1.6]]) {
      context.strokeStyle = colour;
      context.lineWidth = width * (window.devicePixelRatio || 1);
      context.beginPath();
      context.arc(x, y, 6 * (window.devicePixelRatio || 1), 0, 2 * Math.PI);
      context.stroke();
    }
  }

  /** What is under the pointer. */
  tell(z, step, probe, fields, material, image) {
    if (!probe) { this.out.replaceChildren(h("span", { class: "quiet" }, "Point at a map to read its values.")); return; }
    const { maps } = this, cell = this.base(z) + probe.i + maps.count[0] * probe.j;
    const x = maps.origin[0] + (probe.i + 0.5) * maps.cell[0], y = maps.origin[1] + (probe.j + 0.5) * maps.cell[1];
    const parts = [["x, y, z", `${short(x)}, ${short(y)}, ${short(this.height(z))} µm`], ["material", material[cell] === 0 ? "empty" : maps.materials[material[cell] - 1]]];
    if (image) {
      const { origin, cell: edge, count, low, high } = this.image;
      const i = Math.floor((x - origin[0]) / edge[0]), j = Math.floor((y - origin[1]) / edge[1]);
      if (i >= 0 && i < count[0] && j >= 0 && j < count[1]) parts.push(["intensity", short(low + (image[(this.imagePlane(z) * count[1] + j) * count[0] + i] / 255) * (high - low), 3)]);
    }
    maps.fields.forEach((field, f) => parts.push([(fieldNames[field.name] || field.name).toLowerCase(), withUnit(fields[f](cell), field.unit)]));
    this.out.replaceChildren(...parts.map(([name, value]) => h("span", {}, `${name} `, h("b", {}, value))));
  }
}
