// SPDX-License-Identifier: BSD-3-Clause
// The page of a study.

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
    if (found) series.push({ label: name, n, dash: Math.floor(n / 7), points: found.points.map((p) => ({ x: p.x, y: p.y / unit.size })) });
    if (found && Number.isFinite(limit)) series.push({ label: `${name}, extrapolated`, key: null, n, dash: 2, bare: true, points: [{ x: 0, y: limit / unit.size }, { x: found.points.at(-1).x, y: found.points.at(-1).y / unit.size }] });
    lines.push([name, get("sizes"), short(Number(get("finest_element_size"))), short(Number(get("finest_force")) / unit.size, 6), Number.isFinite(limit) ? short(limit / unit.size, 6) : "–", get("order") === "" ? "–" : short(Number(get("order")), 3), get("remark")]);
  });
  if (lines.length === 0) return null;
  return section("convergence", "As elements shrink", series.length > 0 ? lineChart("convergence-chart", "Force against the size of elements", "element size (µm)", `force (${unit.name})`, series, { legend: lines.length > 1 && lines.length <= 7 }) : null,
    h("p", { class: "note" }, `Dotted: to the value at size 0.${lines.length > 7 ? " Point at a curve to read which series it is." : ""}`),
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

/** What varies among the members and has few values: [{name, values}]. */
function variedThings(study) {
  return study.names.slice(1, study.names.indexOf("status")).map((name) => ({ name, values: [...new Set(study.texts(name))] })).filter(({ values }) => values.length > 1 && values.length <= 7);
}

const spaced = (folder) => folder.replaceAll("__", ", ").replaceAll("_", " ");

/** The forces of all members; of many, colours and dashes tell what varies, and some may be looked at alone. */
function memberForces(study, things) {
  const drawn = data.members.filter((member) => member.supports.length > 0), histories = drawn.map((member) => new Table(member.history));
  if (drawn.length === 0) return null;
  const forces = drawn.map((member, m) => forceAlong(member.supports[0], histories[m])), unit = forceUnit(Math.max(...forces.map(largest)));
  const xs = drawn.map((member, m) => abscissa(member.supports[0], histories[m], member.has_time));
  const folders = study.texts(study.names[0]), value = (member, thing) => study.rows[folders.indexOf(member.folder)][study.names.indexOf(thing.name)];
  const curves = drawn.map((member, m) => ({ member, label: spaced(member.folder), n: m, dash: Math.floor(m / 7), points: xy(xs[m].values, forces[m].map((f) => f / unit.size)) }));
  const draw = (series, options) => lineChart("force-chart", "Force of all members", xs[0].name, `force of ${drawn[0].supports[0].name} (${unit.name})`, series, options), title = `Force against ${xs[0].what}`;
  if (curves.length <= 14 || things.length === 0)
    return section("force", title, draw(curves, { legend: curves.length > 1 && curves.length <= 14 }), curves.length > 14 ? h("p", { class: "note" }, "Point at a curve to read which member it is.") : null);

  const place = new ChartPlace(), note = h("p", { class: "note" }), only = new Map();
  let colour = things[0];
  const redraw = () => {
    const dashed = things.find((thing) => thing !== colour && !only.has(thing)), told = new Set();
    place.show(draw(curves.filter(({ member }) => [...only].every(([thing, wanted]) => value(member, thing) === wanted)).map((curve) => {
      const of = value(curve.member, colour), key = told.has(of) ? null : of;
      told.add(of);
      return { ...curve, key, n: colour.values.indexOf(of), dash: dashed ? dashed.values.indexOf(value(curve.member, dashed)) : 0 };
    }), { legend: true }));
    note.textContent = `Colours tell the ${colour.name}${dashed ? `, dashes the ${dashed.name} (${dashed.values.join("; ")})` : ""}. Point at a curve to read which member it is.`;
  };
  redraw();
  const choose = (thing, wanted) => { if (wanted === "") only.delete(thing); else only.set(thing, wanted); redraw(); };
  return section("force", title, h("div", { class: "controls" },
    select("force-colours", "Colours tell", things.map(({ name }) => [name, name]), colour.name, (name) => { colour = things.find((thing) => thing.name === name); redraw(); }),
    things.map((thing, n) => select(`force-only-${n}`, thing.name, [["", "all"], ...thing.values.map((one) => [one, one])], "", (wanted) => choose(thing, wanted)))), place.element, note);
}

/** A figure of study.csv against what varies. */
function memberFigures(study, things) {
  const figures = study.names.slice(study.names.indexOf("status") + 2).filter((name) => study.column(name).filter(Number.isFinite).length > 1);
  if (things.length === 0 || figures.length === 0) return null;
  const place = new ChartPlace(), chosen = { figure: figures.includes("gain") ? "gain" : figures[0], along: things[0].name, colours: (things[1] || things[0]).name };
  const thingOf = (name) => things.find((thing) => thing.name === name);
  const redraw = () => {
    const along = thingOf(chosen.along), colours = thingOf(chosen.colours), heights = study.column(chosen.figure), where = study.texts(along.name), told = study.texts(colours.name);
    const series = colours.values.map((name, n) => ({ label: name, n, marks: true, points: heights.map((y, row) => ({ x: along.values.indexOf(where[row]) + 0.12 * (n - 0.5 * (colours.values.length - 1)), y, of: told[row] })).filter((point) => point.of === name && Number.isFinite(point.y)) }));
    place.show(lineChart("figures-chart", `${chosen.figure} of all members against ${along.name}, colours by ${colours.name}`, along.name, chosen.figure, series, { xNames: along.values, legend: true }));
  };
  redraw();
  const names = things.map(({ name }) => [name, name]), pick = (id, label, of, options) => select(id, label, options, chosen[of], (value) => { chosen[of] = value; redraw(); });
  return section("figures", "Figures of the members", h("div", { class: "controls" }, pick("figure", "Figure", "figure", figures.map((name) => [name, name])), pick("figure-along", "against", "along", names), pick("figure-colours", "Colours tell", "colours", names)),
    place.element, h("p", { class: "note" }, "Figures at full load, in the units of study.csv: forces in pN, energies in aJ, stresses in Pa; gain and departures as shares."));
}

/** The table of the members; the numbers at the left lead to their reports. */
function memberTable(study) {
  const reports = new Set(data.members.filter((member) => member.has_report).map((member) => member.folder)), isTold = study.names.indexOf("status") > 1;
  const link = (folder, row) => (reports.has(folder) ? h("a", { href: `${encodeURIComponent(folder)}/report.html`, title: folder, "aria-label": `Report of ${spaced(folder)}` }, isTold ? String(row + 1) : folder) : isTold ? String(row + 1) : folder);
  const table = htmlTable("study.csv", study.names, study.rows.map((row, r) => row.map((field, c) => (c === 0 ? link(field, r) : readable(field, 5)))), { tall: study.rows.length > 20 });
  const note = study.excerptNote();
  return section("members", "Members", table, note ? h("p", { class: "note" }, note) : null, lazyDetails("study.csv, with all digits", () => htmlTable("study.csv, all digits", study.names, study.rows)));
}

function showStudy(main) {
  const study = new Table(data.study), done = study.texts("status").filter((status) => status === "done").length, things = variedThings(study);
  document.getElementById("subtitle").textContent = "A study: a family of runs";
  const parts = [tiles([["Members", String(study.of)], ["Came to full load", String(done)], ["Time of all", `${short(study.column("wall_seconds").reduce((a, b) => a + (b || 0), 0), 3)} s`]]),
    memberForces(study, things), memberFigures(study, things), uncertaintySection(), convergenceSection(study), memberTable(study),
    section("provenance", "Where this comes from", h("p", {}, "Each member's own report has its deck, versions and checksums."), lazyDetails("The log", () => h("pre", { tabindex: "0" }, data.log)),
      h("p", { class: "note" }, `This page was made by Stroma ${data.made_by}.`))];
  main.append(...parts.filter((part) => part !== null));
  return async () => {};
}
