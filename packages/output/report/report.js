// SPDX-License-Identifier: BSD-3-Clause
// Shows the data of a report: of a run (run...) or of a study (study...). Texts from files only ever become text nodes.
"use strict";

const data = JSON.parse(document.getElementById("data").textContent);

// ---- Elements, numbers, tables -----------------------------------------------------------------------------------

/** An element with attributes (functions become listeners) and children (texts or elements). */
function h(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") element.addEventListener(name, value);
    else if (value !== null && value !== false) element.setAttribute(name, value === true ? "" : value);
  }
  element.append(...children.flat().filter((child) => child !== null && child !== undefined));
  return element;
}

/** A number with a few digits: 1234.6, 0.01235, 1.2e-7. */
function short(value, digits = 4) {
  if (value === null || !Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e6 || size < 1e-4) return value.toExponential(digits - 2).replace("e+", "e");
  return String(Number(value.toPrecision(digits)));
}

/** The unit, of those with their sizes, in which numbers up to `most` read well. */
function unitFor(most, units) {
  let chosen = units[0];
  for (const unit of units) if (most >= unit[1]) chosen = unit;
  return { name: chosen[0], size: chosen[1] };
}
const forceUnit = (most) => unitFor(most, [["pN", 1], ["nN", 1e3], ["µN", 1e6], ["mN", 1e9]]);
const largest = (values) => values.reduce((most, v) => Math.max(most, Math.abs(v)), 0);

/** Rows of a CSV text (RFC 4180). */
function csvRows(text) {
  const rows = [];
  let row = [], field = "", quoted = false;
  for (let i = 0; i < text.length; ++i) {
    const c = text[i];
    if (quoted) {
      if (c === '"' && text[i + 1] === '"') field += text[++i];
      else if (c === '"') quoted = false;
      else field += c;
    } else if (c === '"') quoted = true;
    else if (c === "," || c === "\n") {
      row.push(field);
      field = "";
      if (c === "\n") rows.push(row), (row = []);
    } else if (c !== "\r") field += c;
  }
  return rows;
}

/** A table of a CSV file: names of columns, rows as texts, and columns of numbers by name. */
class Table {
  constructor(excerpt) {
    const rows = csvRows(excerpt ? excerpt.text : "");
    this.names = rows.shift() || [];
    this.rows = rows.filter((row) => row.length === this.names.length);
    this.of = excerpt ? excerpt.of : 0;
  }
  has(name) { return this.names.includes(name); }
  texts(name) { const c = this.names.indexOf(name); return this.rows.map((row) => row[c]); }
  column(name) { return this.texts(name).map((text) => (text === "" || text === undefined ? NaN : Number(text))); }
  last(name) { return this.column(name).at(-1); }
  /** Some of the rows. */
  where(keep) {
    const part = new Table(null);
    part.names = this.names;
    part.rows = this.rows.filter((row) => keep((name) => row[this.names.indexOf(name)]));
    return part;
  }
  excerptNote() { return this.rows.length < this.of ? `${this.rows.length} of ${this.of} rows are shown; the file has them all.` : null; }
}

/** A table in an element that scrolls by itself, from the keyboard too. */
function htmlTable(label, names, rows, { tall = false } = {}) {
  return h("div", { class: "scroll" + (tall ? " tall" : ""), tabindex: "0", role: "region", "aria-label": label },
    h("table", {},
      h("thead", {}, h("tr", {}, names.map((name) => h("th", { scope: "col" }, name)))),
      h("tbody", {}, rows.map((row) => h("tr", {}, row.map((field) =>
        h("td", /^[^\d.+–-]/.test(field) ? { class: "text" } : {}, field)))))));
}

/** Filled when it is opened first. */
function lazyDetails(summary, make) {
  const details = h("details", {}, h("summary", {}, summary));
  details.addEventListener("toggle", () => { if (details.open && details.children.length === 1) details.append(make()); });
  return details;
}

/** A group of radio buttons that looks like one control. */
function choice(name, label, options, selected, change) {
  return h("fieldset", { class: "choice" }, h("legend", { class: "hidden-text" }, label), options.map(([value, text]) =>
    h("label", {}, h("input", { type: "radio", name, value, checked: value === selected, change: () => change(value) }), text)));
}

function slider(id, text, count, value, change) {
  const input = h("input", { type: "range", id, min: 0, max: count - 1, step: 1, value, "aria-label": text });
  const shown = h("span", { class: "value quiet", id: id + "-value" });
  input.addEventListener("input", () => change(Number(input.value)));
  return { input, shown, element: count > 1 ? h("label", { class: "slider" }, text, input, shown) : null };
}

/** A section of the page. */
function section(id, title, ...children) {
  const element = h("section", { id, "aria-labelledby": id + "-title" }, h("h2", { id: id + "-title" }, title), children);
  return element;
}

// ---- Charts ------------------------------------------------------------------------------------------------------

const css = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const seriesColour = (n) => css("--s" + (n % 7));
const dashes = [[], [7, 4], [2, 3], [9, 3, 2, 3]];
const points = ["circle", "rect", "triangle", "rectRot", "crossRot", "star", "rectRounded"];
const charts = [];

Chart.defaults.animation = false;
Chart.defaults.maintainAspectRatio = false;
Chart.defaults.font.family = "system-ui, 'Segoe UI', Roboto, 'Noto Sans', 'DejaVu Sans', sans-serif";

/** A chart of lines of {x, y}. series: {label, points, n (colour), dash, bare (no marks), band: [lower, upper]}. */
function lineChart(id, description, x, y, series, { low = false, yFromZero = false, legend = series.length > 1 } = {}) {
  const canvas = h("canvas", { id, role: "img", "aria-label": description });
  const figure = h("figure", {}, h("div", { class: "chart" + (low ? " low" : "") }, canvas));
  const make = () => {
    const datasets = [];
    for (const s of series) {
      const colour = seriesColour(s.n);
      if (s.band) {
        const edge = { borderWidth: 0, pointRadius: 0, pointHitRadius: 0, isBand: true };
        datasets.push({ ...edge, label: s.label + ", lower", data: s.band[0], fill: false });
        datasets.push({ ...edge, label: s.label + ", upper", data: s.band[1], fill: "-1", backgroundColor: colour + "26" });
      }
      datasets.push({ label: s.label, data: s.points, borderColor: colour, backgroundColor: colour, borderDash: dashes[(s.dash || 0) % 4],
        borderWidth: 2, pointStyle: s.bare ? "line" : points[s.n % 7], pointRadius: s.bare ? 0 : 3.5, pointHitRadius: 8, stepped: s.stepped || false });
    }
    const axis = (title) => ({ type: "linear", title: { display: true, text: title, color: css("--quiet") },
      ticks: { color: css("--quiet"), maxTicksLimit: 8 }, grid: { color: css("--line"), drawBorder: false } });
    return new Chart(canvas, { type: "line", data: { datasets }, options: {
      interaction: { mode: "nearest", axis: "xy", intersect: false },
      scales: { x: axis(x), y: { ...axis(y), beginAtZero: yFromZero } },
      plugins: {
        legend: { display: legend, labels: { color: css("--ink"), usePointStyle: true, boxHeight: 7, filter: (item, all) => !all.datasets[item.datasetIndex].isBand } },
        tooltip: { filter: (item) => !item.dataset.isBand, callbacks: { title: (items) => items.length ? `${x}: ${short(items[0].parsed.x)}` : "", label: (item) => `${item.dataset.label}: ${short(item.parsed.y, 6)}` } } } } });
  };
  charts.push({ make, chart: null });
  return figure;
}

/** Charts are made once their elements are in the page, and again where light and dark change. */
function drawCharts() {
  for (const one of charts) {
    if (one.chart) one.chart.destroy();
    one.chart = one.make();
  }
}

// ---- Arrays and colours ------------------------------------------------------------------------------------------

const unpacked = new Map();
/** The bytes of an array of the page. */
function bytesOf(name) {
  if (!unpacked.has(name)) unpacked.set(name, unpack(document.getElementById(name).textContent));
  return unpacked.get(name);
}
async function unpack(base64) {
  const text = atob(base64), bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// Viridis (S. van der Walt and N. Smith, CC0), in 16 equal parts: light grows evenly, for all kinds of sight.
const viridis = ("440154 48186a 472d7b 424086 3b528b 33638d 2c728e 26828e 21918c 1fa088 28ae80 3fbc73 5ec962 84d44b addc30 " +
  "d8e219 fde725").split(" ").map((hex) => [0, 2, 4].map((at) => parseInt(hex.slice(at, at + 2), 16)));
const colours = Array.from({ length: 256 }, (_, i) => {
  const place = (i / 255) * 16, n = Math.min(15, Math.floor(place));
  return viridis[n].map((low, c) => Math.round(low + (viridis[n + 1][c] - low) * (place - n)));
});
const gradient = `linear-gradient(to right, ${viridis.map((c) => `rgb(${c})`).join(", ")})`;
// Materials, after M. Okabe and K. Ito: told apart by all kinds of sight, by light too.
const materialColours = [[233, 222, 196], [204, 85, 34], [0, 114, 178], [0, 158, 115], [204, 121, 167], [86, 180, 233], [240, 228, 66], [90, 90, 90]];
const materialColour = (m) => materialColours[m % materialColours.length];

// ---- Maps --------------------------------------------------------------------------------------------------------

const fieldNames = { von_mises: "Von Mises stress", principal_stress_1: "Largest principal stress", principal_strain_1: "Largest principal strain" };
const withUnit = (value, unit) => `${short(value)}${unit === "-" ? "" : " " + unit}`;

/** Two views of one plane, specimen and field, with sliders over z and step, and what is under the pointer. */
class Maps {
  constructor(maps, image, run) {
    this.maps = maps;
    this.image = image !== null && typeof image === "object" ? image : null;
    this.run = run;
    this.z = Math.floor(maps.count[2] / 2);
    this.step = maps.steps.length - 1;
    this.field = 0;
    this.layer = this.image ? "image" : "materials";
    this.probe = null;
    this.canvases = { specimen: this.canvas("specimen"), field: this.canvas("field") };
    this.out = h("output", { class: "probe", id: "probe", "aria-live": "polite" });
    this.zSlider = slider("z-slider", "Plane z", maps.count[2], this.z, (z) => { this.z = z; this.draw(); });
    this.stepSlider = slider("step-slider", "Step", maps.steps.length, this.step, (s) => { this.step = s; this.draw(); });
  }

  element() {
    const { maps } = this;
    const layers = [...(this.image ? [["image", "Image"]] : []), ["materials", "Materials"]];
    const fields = maps.fields.map((field, f) => [String(f), fieldNames[field.name] || field.name]);
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
        maps.fields.length === 0 ? null : h("figure", { class: "map" },
          h("div", { class: "controls" }, choice("field", "Field", fields, "0", (f) => { this.field = Number(f); this.draw(); })),
          this.canvases.field, h("div", { class: "scale" }, h("div", { class: "bar", style: `background: ${gradient}` }), this.ticks), this.fieldCaption)),
      this.out, this.notes().map((text) => h("p", { class: "note" }, text)));
  }

  notes() {
    const { maps } = this, notes = [];
    if (maps.merged.some((n) => n > 1)) notes.push(`Down-sampled, so that this page stays small: a cell of the maps is the mean over ${maps.merged.join(" × ")} particles (of the strain, the largest principal value of the mean).`);
    if (maps.steps.length < maps.steps_in_file) notes.push(`${maps.steps.length} of the ${maps.steps_in_file} steps of particles.e are shown.`);
    if (this.image && this.image.merged.some((n) => n > 1)) notes.push(`The image is down-sampled: means over ${this.image.merged.slice(0, 2).join(" × ")} voxels${this.image.merged[2] > 1 ? ` of every ${this.image.merged[2]}th plane` : ""}.`);
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
      this.drawSpecimen(z, material, image);
      if (fields.length > 0) this.drawField(z, step, fields[this.field]);
      for (const canvas of Object.values(this.canvases)) this.drawProbe(canvas, probe);
      this.tell(z, step, probe, fields, material, image);
    }
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
    const when = `step ${number}, load ${short(load)}` + (data.has_time ? `, ${short(time)} s` : "");
    this.canvases.field.setAttribute("aria-label", `${name} at z = ${short(this.height(z))} µm, ${when}: from ${short(least)} to ${withUnit(most, field.unit)}`);
    this.ticks.replaceChildren(...[0, 0.25, 0.5, 0.75, 1].map((t) => h("span", {}, withUnit(low + t * range, t === 1 ? field.unit : "-"))));
    this.fieldCaption.textContent = `${name}, ${when}. In this plane from ${short(least)} to ${withUnit(most, field.unit)}. One scale for all planes and steps: ` +
      `from where 0.5 % lie below to where 0.5 % lie above; the whole field goes from ${short(field.low)} to ${withUnit(field.high, field.unit)}.`;
    this.zSlider.shown.textContent = `${short(this.height(z))} µm (${z + 1} of ${maps.count[2]})`;
    this.stepSlider.shown.textContent = when.replace("step ", "");
    this.zSlider.input.setAttribute("aria-valuetext", this.zSlider.shown.textContent);
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

/** Mean length of the straight ways through each material along x, y, z [um]: from wall to wall. */
function meanChords(material, maps) {
  const [nx, ny, nz] = maps.count, cells = maps.materials.map(() => 0), ends = maps.materials.map(() => [0, 0, 0]);
  for (let k = 0, c = 0; k < nz; ++k)
    for (let j = 0; j < ny; ++j)
      for (let i = 0; i < nx; ++i, ++c) {
        const m = material[c];
        if (m === 0) continue;
        ++cells[m - 1];
        if (i + 1 === nx || material[c + 1] !== m) ++ends[m - 1][0];
        if (j + 1 === ny || material[c + nx] !== m) ++ends[m - 1][1];
        if (k + 1 === nz || material[c + nx * ny] !== m) ++ends[m - 1][2];
      }
  return ends.map((of, m) => of.map((n, d) => (n === 0 ? NaN : (cells[m] / n) * maps.cell[d])));
}

// ---- A run's log -------------------------------------------------------------------------------------------------

/** What a run has said of itself. */
function readLog(text) {
  const lines = text.split("\n"), of = (name) => (lines.find((line) => line.startsWith(name)) || "").slice(name.length).trim();
  const bounds = [];
  const start = lines.findIndex((line) => line.startsWith("bounds "));
  for (let n = start; start >= 0 && n < lines.length && lines[n].trim() !== ""; ++n) bounds.push(lines[n]);
  const elements = /elements of (\S+) x (\S+) x (\S+) um/.exec(of("grid "));
  const stages = [...of("time ").matchAll(/(\S.*?) ([\d.]+) s(?:\s{2}|$)/g)].map((found) => [found[1], Number(found[2])]);
  return {
    notes: lines.filter((line) => line.startsWith("note: ")).map((line) => line.slice(6)),
    rejected: lines.filter((line) => /^step to load \S+ rejected/.test(line)),
    errors: lines.filter((line) => /^stroma: /.test(line)),
    grid: of("grid "), particles: of("particles "), memory: of("memory "), bounds, stages,
    elements: elements ? elements.slice(1).map(Number) : null,
  };
}

/** The table of bounds: [["shear mu", {modulus, gain} x 4], ...]. */
function boundsTable(lines) {
  return lines.slice(3).map((line) => line.trim().split(/\s{2,}/)).filter((row) => row.length === 5);
}

// ---- A run -------------------------------------------------------------------------------------------------------

/** Force of a support along its displacement [pN] at each row of a history. */
function forceAlong(support, history) {
  const length = Math.hypot(...support.displacement) || 1;
  const parts = ["x", "y", "z"].map((axis) => history.column(`${support.name}.reaction_${axis}`));
  return history.rows.map((_, s) => parts.reduce((sum, part, d) => sum + (part[s] * support.displacement[d]) / length, 0));
}

/** What a force is drawn against: {what, unit, name (both), values}. */
function abscissa(support, history, hasTime) {
  const load = history.column("load"), named = (what, unit, values) => ({ what, unit, name: unit ? `${what} (${unit})` : what, values });
  if (hasTime) return named("time", "s", history.column("time"));
  if (support && support.follows_load && support.strain !== 0) return named("strain", "%", load.map((l) => 100 * l * support.strain));
  const way = support ? Math.hypot(...support.displacement) : 0;
  if (support && support.follows_load && way > 0) return named("displacement", "µm", load.map((l) => l * way));
  return named("load", "", load);
}

const xy = (xs, ys) => xs.map((x, i) => ({ x, y: ys[i] }));

function forceSection(history) {
  const x = abscissa(data.supports[0], history, data.has_time);
  let figure, title = "Force";
  if (data.supports.length > 0) {
    const forces = data.supports.map((support) => forceAlong(support, history));
    const unit = forceUnit(Math.max(...forces.map(largest)));
    const series = forces.map((force, n) => ({ label: data.supports[n].name, n, points: xy(x.values, force.map((f) => f / unit.size)) }));
    if (!data.has_time && x.values.length > 2) // the straight line from nothing to the end
      series.push({ label: "secant", n: 4, dash: 1, bare: true, points: [0, x.values.length - 1].map((s) => series[0].points[s]) });
    title = `Force against ${x.what}`;
    figure = lineChart("force-chart", `${title}: ${data.supports.map((s, n) => `${s.name} ${short(forces[n].at(-1) / unit.size)} ${unit.name} at the end`).join(", ")}`, x.name, `force (${unit.name})`, series);
  } else {
    title = `Strain energy against ${x.what}`;
    figure = lineChart("force-chart", title, x.name, "strain energy (aJ)", [{ label: "strain energy", n: 0, points: xy(x.values, history.column("strain_energy")) }]);
  }
  const many = history.excerptNote();
  return section("force", title, figure, many ? h("p", { class: "note" }, many) : null,
    lazyDetails("history.csv, as numbers", () => htmlTable("history.csv", history.names, history.rows, { tall: true })));
}

function costSection(history, log) {
  const step = history.column("step").slice(1), total = log.stages.reduce((sum, stage) => sum + stage[1], 0);
  const seconds = history.column("wall_seconds").slice(1);
  const stages = [...log.stages].filter((stage) => stage[1] > 0.005 * total).sort((a, b) => b[1] - a[1]).slice(0, 8);
  return section("cost", "Iterations and time",
    lineChart("iterations-chart", "Iterations of each step", "step", "iterations", [
      { label: "Newton", n: 0, points: xy(step, history.column("newton_iterations").slice(1)) },
      { label: "linear", n: 1, points: xy(step, history.column("linear_iterations").slice(1)) }], { low: true, yFromZero: true }),
    lineChart("seconds-chart", "Wall time up to each step", "step", "wall time (s)", [{ label: "wall time", n: 2, points: xy(step, seconds) }], { low: true, yFromZero: true }),
    stages.length === 0 ? null : h("div", {}, h("h3", {}, "Where the time went"), h("div", { class: "bars" }, stages.flatMap(([name, spent]) =>
      [h("span", {}, name), h("span", { class: "bar", style: `width: ${(100 * spent) / stages[0][1]}%` }), h("span", { class: "value" }, `${spent} s`)]))),
    log.memory ? h("p", { class: "note" }, `Memory: ${log.memory}.`) : null);
}

function tiles(list) {
  return h("dl", { class: "tiles" }, list.filter((tile) => tile !== null).map(([name, value, more]) => h("div", {}, h("dt", {}, name), h("dd", {}, value, more ? h("small", {}, more) : null))));
}

function overview(history, log) {
  const x = abscissa(data.supports[0], history, data.has_time), load = history.last("load");
  const list = data.supports.slice(0, 2).map((support) => {
    const force = forceAlong(support, history), unit = forceUnit(largest(force));
    return [`Force of ${support.name}`, `${short(force.at(-1) / unit.size)} ${unit.name}`, `${x.what} ${short(x.values.at(-1))} ${x.unit}`];
  });
  for (const name of data.materials.slice(0, 3)) list.push([`Von Mises, ${name}`, `${short(history.last(`${name}.von_mises_mean`))} Pa`, `mean; at most ${short(history.last(`${name}.von_mises_max`))} Pa`]);
  list.push(["Steps", String(history.last("step")), load >= 1 ? "full load reached" : `load ${short(load)} of 1 reached`]);
  list.push(["Time", `${short(history.last("wall_seconds"), 3)} s`, log.particles ? log.particles.replace(/,? on /, " particles, on ").replace(/^(\d+) particles/, (_, n) => `${Number(n).toLocaleString("en")} particles`) : null]);
  return tiles(list);
}

/** Notes of the run, and what its results themselves say. */
function checksSection(history, log) {
  const list = h("ul", { class: "checks" });
  const tell = (level, text) => list.append(h("li", {}, h("span", { class: `badge ${level}` }, { good: "in order", look: "look", note: "note" }[level]), h("span", {}, text)));
  const load = history.last("load");
  if (load >= 1) tell("good", `The run came to full load in ${history.last("step")} steps.`);
  else tell("look", `The run ended at ${short(100 * load)} % of the load.`);
  if (log.rejected.length > 0) tell("look", `${log.rejected.length} step${log.rejected.length > 1 ? "s were" : " was"} rejected and halved; the first: ${log.rejected[0]}`);
  const residual = history.column("residual").slice(1);
  if (residual.length > 0) tell("good", `Balance: the residual is at most ${short(Math.max(...residual), 2)} of the forces.`);
  checkBounds(history, log, tell);
  for (const text of log.errors) tell("look", text.replace(/^stroma: /, ""));
  const serious = /locking|rounding|pieces|does not resolve|under-integrates|finer than voxels|not in balance|not drawn|not written|contrast|removed|left out|Stabilization/i;
  for (const text of [...new Set(log.notes)]) tell(serious.test(text) ? "look" : "note", text);
  return { element: section("checks", "What to know of this run", list), tell };
}

/** Whether the stiffness at small strain lies between the bounds for a body between plane grips. */
function checkBounds(history, log, tell) {
  const young = boundsTable(log.bounds).at(-1), support = data.supports[0];
  if (!young || !support || !support.strain || !support.follows_load || data.has_time || history.rows.length < 3) return;
  const axis = support.displacement.findIndex((part) => part !== 0), area = data.length.reduce((product, edge, d) => (d === axis ? product : product * edge), 1);
  const force = forceAlong(support, history), load = history.column("load");
  const secant = (s) => force[s] / (area * Math.abs(support.strain) * load[s]);
  const small = secant(1) + ((secant(1) - secant(2)) * load[1]) / (load[2] - load[1]); // at no strain, by the first two steps
  const reuss = parseFloat(young[1]), voigt = parseFloat(young[4]), name = young[0];
  data.small_strain_modulus = small;
  const where = `${short(small)} Pa at small strain`;
  if (small < 0.99 * reuss) tell("look", `Bounds: force per area and strain is ${where}, below Reuss's bound of ${name}, ${short(reuss)} Pa: empty space, or a grip that does not hold, would explain it.`);
  else if (small > 1.01 * voigt && data.holds_sideways) tell("note", `Bounds: force per area and strain is ${where}, above Voigt's bound of ${name}, ${short(voigt)} Pa, which is one for rollers: grips that hold sideways stiffen a body.`);
  else if (small > 1.01 * voigt) tell("look", `Bounds: force per area and strain is ${where}, above Voigt's bound of ${name}, ${short(voigt)} Pa.`);
  else tell("good", `Bounds: force per area and strain is ${where}, between Reuss (${short(reuss)} Pa) and Voigt (${short(voigt)} Pa) for ${name}.`);
}

/** Few elements across a material: told once the map of materials is unpacked. */
async function checkWidths(maps, log, tell) {
  if (!maps || !log.elements || maps.materials.length < 2 || maps.merged.some((n) => n > 1)) return;
  const chords = meanChords(await bytesOf("map-material"), maps), volume = (m) => chords[m].every(Number.isFinite);
  maps.materials.forEach((name, m) => {
    if (!volume(m)) return;
    const across = [0, 1, 2].filter((d) => maps.count[d] > 1).map((d) => chords[m][d] / log.elements[d]), least = Math.min(...across);
    if (least < 2) tell("look", `Few elements across ${name}: its straight chords are ${across.map((n) => short(n, 2)).join(" × ")} elements long on the average; 2 or more resolve bending.`);
  });
}

/** Step lines of the histogram of each material. */
function histogramSection() {
  if (!data.tables["histograms.csv"]) return null;
  const table = new Table(data.tables["histograms.csv"]), quantities = [...new Set(table.texts("quantity"))];
  const place = h("div"), pick = h("select", { id: "quantity", "aria-label": "Quantity", change: () => draw() }, quantities.map((q) => h("option", { value: q }, q.replaceAll("_", " "))));
  let entry = null;
  const draw = () => {
    const part = table.where((get) => get("quantity") === pick.value), unit = part.texts("unit")[0], names = [...new Set(part.texts("material"))];
    const series = names.map((name, n) => {
      const of = part.where((get) => get("material") === name), low = of.column("low"), high = of.column("high"), volume = of.column("volume");
      const total = volume.reduce((a, b) => a + b, 0) || 1;
      const heights = volume.map((v, i) => (high[i] > low[i] ? v / total / (high[i] - low[i]) : 0));
      return { label: name, n, bare: true, stepped: "before", points: [{ x: low[0], y: 0 }, { x: low[0], y: heights[0] }, ...xy(high, heights), { x: high.at(-1), y: 0 }] };
    });
    if (entry) { charts.splice(charts.indexOf(entry), 1); if (entry.chart) entry.chart.destroy(); }
    const per = unit && unit !== "1" && unit !== "-" ? ` (1/${unit})` : "";
    place.replaceChildren(lineChart("histogram-chart", `Histogram of ${pick.value} for ${names.join(", ")}`, pick.value.replaceAll("_", " ") + (per ? ` (${unit})` : ""), `share of volume per unit${per}`, series, { yFromZero: true }));
    const made = charts.at(-1);
    if (entry) made.chart = made.make();
    entry = made;
  };
  draw();
  const materials = data.tables["materials.csv"] ? new Table(data.tables["materials.csv"]) : null;
  return section("histograms", "Histograms of each material", h("div", { class: "controls" }, h("label", {}, "Quantity ", pick)), place,
    materials ? lazyDetails("Means and percentiles", () => {
      const shown = ["material", "quantity", "unit", "mean", "p05", "p25", "p50", "p75", "p95", "maximum"].filter((name) => materials.has(name));
      return htmlTable("Means and percentiles", shown, materials.rows.map((row) => shown.map((name) => readable(row[materials.names.indexOf(name)]))), { tall: true });
    }) : null);
}

const readable = (text) => (text !== "" && Number.isFinite(Number(text)) ? short(Number(text), 6) : text);

function wallSection() {
  if (!data.tables["wall_distance.csv"]) return null;
  const table = new Table(data.tables["wall_distance.csv"]), walls = [...new Set(table.texts("label_material"))];
  const series = walls.flatMap((wall, w) => [...new Set(table.texts("material"))].map((material, m) => {
    const part = table.where((get) => get("label_material") === wall && get("material") === material && get("von_mises_mean") !== "");
    const low = part.column("low"), x = part.column("high").map((high, i) => 0.5 * (low[i] + high));
    return { label: walls.length > 1 ? `${material}, wall of ${wall}` : material, n: m, dash: w, points: xy(x, part.column("von_mises_mean")),
      band: [xy(x, part.column("von_mises_p05")), xy(x, part.column("von_mises_p95"))] };
  })).filter((one) => one.points.length > 0);
  if (series.length === 0) return section("wall", "Stress against distance to the wall", h("p", { class: "note" }, "The specimen has no walls."));
  return section("wall", "Stress against distance to the wall",
    lineChart("wall-chart", `Von Mises stress against distance to the wall: ${series.map((s) => s.label).join("; ")}`, `distance to the wall${walls.length === 1 ? " of " + walls[0] : ""} (µm)`, "von Mises stress (Pa)", series, { yFromZero: true }),
    h("p", { class: "note" }, "Lines: means by volume; bands: from the 5th to the 95th percentile."));
}

/** Objects, sorted by what is clicked. */
function objectsSection() {
  if (!data.tables["objects.csv"]) return null;
  const table = new Table(data.tables["objects.csv"]);
  const shown = [["object", "object"], ["material", "material"], ["volume", "volume (µm³)"], ["axis_1", "longest axis (µm)"], ["centroid_x", "x (µm)"], ["centroid_y", "y (µm)"], ["centroid_z", "z (µm)"],
    ["von_mises_mean", "von Mises (Pa)"], ["principal_stress_1", "largest principal stress (Pa)"], ["principal_direction_x", "its direction x"], ["principal_direction_y", "y"], ["principal_direction_z", "z"]].filter(([name]) => table.has(name));
  const few = 15, at = (row, name) => row[table.names.indexOf(name)];
  let by = "volume", down = true, all = false;
  const head = h("tr"), body = h("tbody"), more = h("button", { type: "button", class: "more", click: () => { all = !all; draw(); } });
  const draw = () => {
    const rows = [...table.rows].sort((a, b) => {
      const [p, q] = [at(a, by), at(b, by)], order = Number.isNaN(Number(p)) ? p.localeCompare(q) : Number(p) - Number(q);
      return down ? -order : order;
    });
    head.replaceChildren(...shown.map(([name, title]) => h("th", { scope: "col", "aria-sort": name === by ? (down ? "descending" : "ascending") : "none" },
      h("button", { type: "button", click: () => { down = name === by ? !down : true; by = name; draw(); } }, title + (name === by ? (down ? " ↓" : " ↑") : "")))));
    body.replaceChildren(...rows.slice(0, all ? rows.length : few).map((row) => h("tr", {}, shown.map(([name]) => h("td", name === "material" ? { class: "text" } : {}, readable(at(row, name)))))));
    more.textContent = all ? `The first ${few} only` : `All ${rows.length}`;
  };
  draw();
  const note = table.excerptNote();
  return section("objects", "Objects", table.rows.length === 0 ? h("p", { class: "note" }, "The specimen has no objects.") :
    h("div", { class: "scroll tall", tabindex: "0", role: "region", "aria-label": "Objects" }, h("table", {}, h("thead", {}, head), body)),
    table.rows.length > few ? more : null, note ? h("p", { class: "note" }, note) : null,
    h("p", { class: "note" }, "objects.csv has mean stress and strain tensors and force dipoles too."));
}

function boundsSection(log) {
  const rows = boundsTable(log.bounds);
  if (rows.length === 0) return null;
  return section("bounds", "Bounds of the mixture", h("p", { class: "quiet" }, `${log.bounds[0].replace(/^bounds\s+/, "")}: ${log.bounds[1].trim()}`),
    htmlTable("Bounds", ["", "Reuss", "Hashin-Shtrikman, lower", "Hashin-Shtrikman, upper", "Voigt"], rows),
    data.small_strain_modulus ? h("p", { class: "note" }, `Force per area and strain of this run, at small strain: ${short(data.small_strain_modulus)} Pa.`) : null);
}

/** "NAME: FACT" lines of the comment at the head of deck.xml. */
function provenanceSection(log) {
  const comment = /^<!--([\s\S]*?)-->/.exec(data.deck), list = h("dl", { class: "facts" });
  for (const line of (comment ? comment[1] : "").split("\n").slice(1)) {
    const found = /^\s*([^:]+):\s*(.*)$/.exec(line);
    if (found) list.append(h("dt", {}, found[1]), h("dd", {}, found[2]));
    else if (line.trim() === "" && list.lastElementChild && list.lastElementChild.tagName === "DD") list.append(h("hr"));
  }
  if (list.lastElementChild && list.lastElementChild.tagName === "HR") list.lastElementChild.remove();
  return section("provenance", "Where this comes from", list, log.grid ? h("p", { class: "note" }, `Grid: ${log.grid}.`) : null,
    lazyDetails("The deck, with all defaults", () => h("pre", { tabindex: "0" }, data.deck)), lazyDetails("The log", () => h("pre", { tabindex: "0" }, data.log)),
    h("p", { class: "note" }, `This page was made by Stroma ${data.made_by}.`));
}

function showRun(main) {
  const history = new Table(data.history), log = readLog(data.log);
  document.getElementById("subtitle").textContent = data.folder;
  const checks = checksSection(history, log);
  main.append(overview(history, log));
  let maps = null;
  if (data.maps) {
    maps = new Maps(data.maps, data.image, history);
    main.append(section("maps", "Specimen, stress and strain", maps.element()));
  } else main.append(section("maps", "Specimen, stress and strain", h("p", { class: "note" }, "There is no particles.e in the folder, of which maps could be made.")));
  const missing = ["histograms.csv", "wall_distance.csv", "objects.csv"].filter((name) => !data.tables[name]);
  const parts = [checks.element, h("div", { class: "sections-pair" }, forceSection(history), costSection(history, log)),
    h("div", { class: "sections-pair" }, histogramSection(), wallSection()), objectsSection(), boundsSection(log), provenanceSection(log),
    missing.length > 0 ? h("p", { class: "note" }, `Not in the folder, so not in this report: ${missing.join(", ")}.`) : null];
  main.append(...parts.filter((part) => part !== null));
  return async () => {
    if (maps && typeof DecompressionStream === "undefined") maps.out.textContent = "This browser is too old to show the maps: it lacks DecompressionStream.";
    else if (maps) {
      await maps.draw();
      let width = window.innerWidth;
      window.addEventListener("resize", () => { if (window.innerWidth !== width) { width = window.innerWidth; maps.draw(); } });
      await checkWidths(data.maps, log, checks.tell);
    }
  };
}

// ---- A study -----------------------------------------------------------------------------------------------------

/** Members with their size along the axis in which a series differs: [{size, force}], coarsest first; by the finest's force. */
function sizeSeries(study, finest) {
  const column = study.names.find((name) => name.endsWith(".force") && study.texts(name).includes(finest)), varied = study.names.slice(1, study.names.indexOf("status"));
  if (!column) return null;
  const sizes = new Map(data.members.map((member) => [member.folder, (/elements of (\S+) x (\S+) x (\S+) um/.exec(member.grid) || []).slice(1).map(Number)]));
  const row = study.rows[study.texts(column).indexOf(finest)], at = (of, name) => of[study.names.indexOf(name)];
  for (const name of varied) {
    const group = study.rows.filter((one) => at(one, "status") === "done" && varied.every((other) => other === name || at(one, other) === at(row, other)));
    const axis = [0, 1, 2].find((d) => new Set(group.map((one) => (sizes.get(one[0]) || [])[d])).size === group.length && group.length > 1);
    if (axis !== undefined) return { column, points: group.map((one) => ({ x: sizes.get(one[0])[axis], y: Number(at(one, column)) })).sort((a, b) => b.x - a.x) };
  }
  return null;
}

function convergenceSection(study) {
  const table = new Table(data.convergence), series = [], lines = [];
  let unit = null;
  table.rows.forEach((row, n) => {
    const get = (name) => row[table.names.indexOf(name)], name = get("series") || "all members", found = sizeSeries(study, get("finest_force"));
    const limit = get("extrapolated_force") === "" ? NaN : Number(get("extrapolated_force"));
    unit = unit || forceUnit(Math.abs(Number(get("finest_force"))));
    if (found) series.push({ label: name, n, points: found.points.map((p) => ({ x: p.x, y: p.y / unit.size })) });
    if (found && Number.isFinite(limit)) series.push({ label: `${name}, extrapolated`, n, dash: 1, bare: true, points: [{ x: 0, y: limit / unit.size }, { x: found.points.at(-1).x, y: found.points.at(-1).y / unit.size }] });
    lines.push([name, get("sizes"), short(Number(get("finest_element_size"))), short(Number(get("finest_force")) / unit.size, 6), Number.isFinite(limit) ? short(limit / unit.size, 6) : "–", get("order") === "" ? "–" : short(Number(get("order")), 3), get("remark")]);
  });
  if (lines.length === 0) return null;
  return section("convergence", "As elements shrink", series.length > 0 ? lineChart("convergence-chart", "Force against the size of elements", "element size (µm)", `force (${unit.name})`, series) : null,
    htmlTable("Convergence", ["series", "sizes", "finest (µm)", `force there (${unit.name})`, `at size 0 (${unit.name})`, "observed order", "remark"], lines));
}

/** The force of draws: median, 5 to 95 %, and how inputs and force go together. */
function uncertaintySection() {
  const bands = new Table(data.bands), correlations = new Table(data.correlations);
  if (bands.rows.length === 0) return null;
  const load = bands.column("load"), unit = forceUnit(Math.max(largest(bands.column("low")), largest(bands.column("high"))));
  const curve = (name) => xy(load, bands.column(name).map((force) => force / unit.size));
  const series = [{ label: "median of the draws", n: 0, points: curve("median"), band: [curve("low"), curve("high")] }];
  if (bands.column("finer").some(Number.isFinite))
    series.push({ label: "middle of the inputs", n: 1, dash: 1, bare: true, points: curve("middle") }, { label: "the same on a finer grid", n: 2, dash: 2, bare: true, points: curve("finer") });
  return section("uncertainty", "How sure the force is",
    lineChart("bands-chart", `Force of the draws against load: median ${short(bands.last("median") / unit.size)} ${unit.name} at the end, 5 to 95 % from ${short(bands.last("low") / unit.size)} to ${short(bands.last("high") / unit.size)}`, "load", `force (${unit.name})`, series),
    h("p", { class: "note" }, "The band holds 90 % of the draws, from the 5th to the 95th percentile."),
    correlations.rows.length === 0 ? null : htmlTable("Rank correlations", ["input", "Spearman's rank correlation with the force"], correlations.rows.map((row) => row.map(readable))));
}

function showStudy(main) {
  const study = new Table(data.study), done = study.texts("status").filter((status) => status === "done").length;
  document.getElementById("subtitle").textContent = "A study: a family of runs";
  main.append(tiles([["Members", String(study.of)], ["Came to full load", String(done)], ["Time of all", `${short(study.column("wall_seconds").reduce((a, b) => a + (b || 0), 0), 3)} s`]]));
  const drawn = data.members.filter((member) => member.supports.length > 0), histories = drawn.map((member) => new Table(member.history));
  if (drawn.length > 0) {
    const forces = drawn.map((member, m) => forceAlong(member.supports[0], histories[m])), unit = forceUnit(Math.max(...forces.map(largest)));
    const xs = drawn.map((member, m) => abscissa(member.supports[0], histories[m], member.has_time));
    const series = drawn.map((member, m) => ({ label: member.folder.replaceAll("__", ", ").replaceAll("_", " "), n: m, dash: Math.floor(m / 7), points: xy(xs[m].values, forces[m].map((f) => f / unit.size)) }));
    main.append(section("force", `Force against ${xs[0].what}`, lineChart("force-chart", "Force of all members", xs[0].name, `force of ${drawn[0].supports[0].name} (${unit.name})`, series, { legend: series.length > 1 && series.length <= 14 }),
      series.length > 14 ? h("p", { class: "note" }, "Point at a curve to read which member it is.") : null));
  }
  const uncertainty = uncertaintySection();
  if (uncertainty) main.append(uncertainty);
  const convergence = convergenceSection(study);
  if (convergence) main.append(convergence);
  const reports = new Set(data.members.filter((member) => member.has_report).map((member) => member.folder));
  const table = htmlTable("study.csv", study.names, study.rows.map((row) => row.map((field, c) => (c === 0 && reports.has(field) ? h("a", { href: `${encodeURIComponent(field)}/report.html` }, field) : readable(field)))), { tall: study.rows.length > 20 });
  const note = study.excerptNote();
  main.append(section("members", "Members", table, note ? h("p", { class: "note" }, note) : null, lazyDetails("study.csv, with all digits", () => htmlTable("study.csv, all digits", study.names, study.rows))),
    section("provenance", "Where this comes from", h("p", {}, "Each member's own report has its deck, versions and checksums."), lazyDetails("The log", () => h("pre", { tabindex: "0" }, data.log)),
      h("p", { class: "note" }, `This page was made by Stroma ${data.made_by}.`)));
  return async () => {};
}

// ---- The page ----------------------------------------------------------------------------------------------------

const main = document.getElementById("main");
document.getElementById("kind").textContent = data.kind === "study" ? "study" : "report";
document.getElementById("title").textContent = data.title || data.folder;
const afterwards = data.kind === "study" ? showStudy(main) : showRun(main);
document.getElementById("contents").append(...[...main.querySelectorAll("section[id]")].map((element) => h("a", { href: "#" + element.id }, element.querySelector("h2").textContent)));
drawCharts();
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", drawCharts);
afterwards().then(() => document.documentElement.setAttribute("data-ready", ""));
