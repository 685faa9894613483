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
