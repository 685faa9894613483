// SPDX-License-Identifier: BSD-3-Clause
// The tables of a run's last step.

const ranks = { 1: "largest", 2: "middle", 3: "smallest" };
/** A quantity of the tables in words: principal_stress_1 is the largest principal stress. */
function quantityName(name) {
  const principal = /^principal_(\w+)_([123])$/.exec(name);
  if (principal) return `${ranks[principal[2]]} principal ${principal[1]}`;
  return { von_mises: "von Mises stress", jacobian: "volume ratio J" }[name] || name.replaceAll("_", " ");
}

/** Step lines of the histogram of each material. */
function histogramSection() {
  if (!data.tables["histograms.csv"]) return null;
  const table = new Table(data.tables["histograms.csv"]), quantities = [...new Set(table.texts("quantity"))];
  const place = new ChartPlace(), pick = h("select", { id: "quantity", "aria-label": "Quantity", change: () => draw() }, quantities.map((q) => h("option", { value: q }, quantityName(q))));
  const draw = () => {
    const part = table.where((get) => get("quantity") === pick.value), unit = part.texts("unit")[0], names = [...new Set(part.texts("material"))];
    const series = names.map((name, n) => {
      const of = part.where((get) => get("material") === name), low = of.column("low"), high = of.column("high"), volume = of.column("volume");
      const total = volume.reduce((a, b) => a + b, 0) || 1;
      const heights = volume.map((v, i) => (high[i] > low[i] ? v / total / (high[i] - low[i]) : 0));
      return { label: name, n, bare: true, stepped: "before", points: [{ x: low[0], y: 0 }, { x: low[0], y: heights[0] }, ...xy(high, heights), { x: high.at(-1), y: 0 }] };
    });
    const per = unit && unit !== "1" && unit !== "-" ? ` (1/${unit})` : "";
    place.show(lineChart("histogram-chart", `Histogram of ${quantityName(pick.value)} for ${names.join(", ")}`, quantityName(pick.value) + (per ? ` (${unit})` : ""), `share of volume per unit${per}`, series, { yFromZero: true }));
  };
  draw();
  const materials = data.tables["materials.csv"] ? new Table(data.tables["materials.csv"]) : null;
  return section("histograms", "Histograms of each material", h("div", { class: "controls" }, h("label", {}, "Quantity ", pick)), place.element,
    materials ? lazyDetails("Means and percentiles", () => {
      const shown = ["material", "quantity", "unit", "mean", "p05", "p25", "p50", "p75", "p95", "maximum"].filter((name) => materials.has(name));
      return htmlTable("Means and percentiles", shown, materials.rows.map((row) => shown.map((name) => { const field = row[materials.names.indexOf(name)]; return name === "quantity" ? quantityName(field) : readable(field, 4); })), { tall: true });
    }) : null);
}

const readable = (text, digits = 6) => (text !== "" && Number.isFinite(Number(text)) ? short(Number(text), digits) : text);

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
  const shown = [["object", "object"], ["material", "material"], ["volume", "volume (µm³)"], ["axis_1", "longest axis (µm)"], ["von_mises_mean", "von Mises (Pa)"], ["principal_stress_1", "principal stress (Pa)"]].filter(([name]) => table.has(name));
  const triples = [["principal_direction_", "its direction", (v) => v.toFixed(2)], ["centroid_", "centre (µm)", (v) => short(v, 3)]].filter(([name]) => table.has(name + "x"));
  const few = 15, at = (row, name) => row[table.names.indexOf(name)], triple = (row, [name, , read]) => ["x", "y", "z"].map((axis) => read(Number(at(row, name + axis)))).join(", ");
  let by = "volume", down = true, all = false;
  const head = h("tr"), body = h("tbody"), more = h("button", { type: "button", class: "more", click: () => { all = !all; draw(); } });
  const draw = () => {
    const rows = [...table.rows].sort((a, b) => {
      const [p, q] = [at(a, by), at(b, by)], order = Number.isNaN(Number(p)) ? p.localeCompare(q) : Number(p) - Number(q);
      return down ? -order : order;
    });
    head.replaceChildren(...shown.map(([name, title]) => h("th", { scope: "col", ...(name === "material" ? { class: "text" } : {}), "aria-sort": name === by ? (down ? "descending" : "ascending") : "none" },
      h("button", { type: "button", click: () => { down = name === by ? !down : true; by = name; draw(); } }, title + (name === by ? (down ? " ↓" : " ↑") : "")))), ...triples.map(([, title]) => h("th", { scope: "col" }, title)));
    body.replaceChildren(...rows.slice(0, all ? rows.length : few).map((row) => h("tr", {}, shown.map(([name]) => h("td", name === "material" ? { class: "text" } : {}, readable(at(row, name), 4))), triples.map((one) => h("td", {}, triple(row, one))))));
    more.textContent = all ? `The first ${few} only` : `All ${rows.length}`;
  };
  draw();
  const note = table.excerptNote();
  return section("objects", "Objects", table.rows.length === 0 ? h("p", { class: "note" }, "The specimen has no objects.") :
    h("div", { class: "scroll tall", tabindex: "0", role: "region", "aria-label": "Objects" }, h("table", {}, h("thead", {}, head), body)),
    table.rows.length > few ? more : null, note ? h("p", { class: "note" }, note) : null,
    h("p", { class: "note" }, "objects.csv has mean stress and strain tensors and force dipoles too."));
}
