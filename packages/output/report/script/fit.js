// SPDX-License-Identifier: BSD-3-Clause
// The page of a fit.

/** "1024 ± 32" of a row of estimates.csv. */
function estimateText(get) {
  const value = Number(get("value")), deviation = get("standard_deviation");
  return deviation === "" ? short(value, 6) : `${short(value, 5)} ± ${short(Number(deviation), 2)}`;
}

/** Rows of a table as functions from a column's name to its text. */
const getters = (table) => table.rows.map((row) => (name) => row[table.names.indexOf(name)]);

function fitTiles(runs, estimates, fitted) {
  const chi2 = runs.column("chi2").filter(Number.isFinite), failed = runs.texts("status").filter((status) => status !== "done").length;
  const list = getters(estimates).slice(0, 4).map((get) => [get("parameter"), estimateText(get), get("standard_deviation") === "" ? "not determined" : `95 %: ${short(Number(get("low")))} to ${short(Number(get("high")))}`]);
  if (chi2.length > 0) list.push(["Misfit χ²", short(Math.min(...chi2)), fitted.of > 0 ? `of ${fitted.of} forces` : "least so far"]);
  list.push(["Runs", String(runs.of), failed > 0 ? `${failed} failed` : "all came to full load"]);
  return tiles(list);
}

/** What the log notes, and whether the misfit is one that the errors allow. */
function fitChecks(runs, estimates, fitted) {
  const { list, tell } = checkList(), notes = data.log.split("\n").filter((line) => line.startsWith("note: ")).map((line) => line.slice(6));
  if (estimates.rows.length === 0) tell("look", "The fit did not come to its end: these are the runs that it made. The same command goes on from them.");
  else {
    const chi2 = Math.min(...runs.column("chi2").filter(Number.isFinite)), free = fitted.of - estimates.rows.length, spread = Math.sqrt(2 * Math.max(free, 1));
    if (free > 0) tell(chi2 <= free + 3 * spread ? "good" : "look", `χ² is ${short(chi2)}; with ${fitted.of} forces and ${estimates.rows.length} number${estimates.rows.length > 1 ? "s" : ""}, ${free} ± ${short(spread, 2)} is what the given errors let expect.`);
    if (notes.length === 0) tell("good", "The measurements tell every number.");
  }
  for (const text of notes) tell("look", text);
  return section("checks", "What to know of this fit", list);
}

/** Intervals of all numbers on one scale: shares of each number's own value. */
function intervalBars(estimates) {
  const known = getters(estimates).filter((get) => get("low") !== "").map((get) => ({ name: get("parameter"), low: Number(get("low")) / Number(get("value")) - 1, high: Number(get("high")) / Number(get("value")) - 1 }));
  if (known.length === 0) return null;
  const widest = Math.max(...known.map(({ low, high }) => Math.max(Math.abs(low), Math.abs(high)))), percent = (share) => 50 + (50 * share) / (widest || 1);
  return h("div", { class: "bars" }, known.flatMap(({ name, low, high }) => [h("span", {}, name),
    h("span", { class: "interval" }, h("i", { style: `left: ${Math.min(percent(low), percent(high))}%; width: ${Math.abs(percent(high) - percent(low))}%` }), h("b")),
    h("span", { class: "value" }, `${short(100 * low, 2)} to +${short(100 * high, 2)} %`)]));
}

function estimatesSection(estimates) {
  if (estimates.rows.length === 0) return null;
  const rows = getters(estimates).map((get) => {
    const number = (name, digits) => (get(name) === "" ? "–" : short(Number(get(name)), digits));
    return [get("parameter"), number("value", 7), number("standard_deviation", 3), get("low") === "" ? "not determined" : `${number("low", 5)} to ${number("high", 5)}`, get("path")];
  });
  return section("estimates", "The numbers", htmlTable("Estimates", ["number", "value", "standard deviation", "95 % interval", "in the deck"], rows),
    h("h3", { class: "below" }, "95 % intervals, of each number's own size"), intervalBars(estimates),
    h("p", { class: "note" }, "Of errors of measurement alone: how wrong the grid and the segmentation are is another question."));
}

/** Correlations of the numbers, tinted by their size. */
function correlationSection(estimates) {
  const names = estimates.texts("parameter");
  if (names.length < 2) return null;
  const rows = getters(estimates).map((get) => h("tr", {}, h("th", { scope: "row" }, get("parameter")), names.map((name) => {
    const text = get(`correlation with ${name}`), value = Number(text);
    return text === "" ? h("td", {}, "–") : h("td", { style: tint(value) }, value.toFixed(3));
  })));
  return section("correlations", "Correlations", h("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": "Correlations" },
    h("table", {}, h("thead", {}, h("tr", {}, ["", ...names].map((name) => h("th", { scope: "col" }, name)))), h("tbody", {}, rows))),
    h("p", { class: "note" }, "Near 1 or -1, two numbers are hard to tell apart: the measurements determine a combination of them. Blue is below zero, orange above."));
}

/** Forces as they were measured, as they were found, and of the first run; one section for strains and one for times. */
function fittedSections(fitted) {
  return ["strain", "time"].map((against) => {
    const part = fitted.where((get) => get("against") === against), names = [...new Set(part.texts("measurement"))];
    if (names.length === 0) return null;
    const unit = forceUnit(largest(part.column("measured"))), id = against === "strain" ? "fitted" : "fitted-time", scale = against === "strain" ? 100 : 1;
    const x = against === "strain" ? "strain (%)" : "time (s)", many = names.length > 1 ? (name) => `${name}, ` : () => "";
    const series = [], residuals = [];
    names.forEach((name, m) => {
      const of = part.where((get) => get("measurement") === name), xs = of.column("strain_or_time").map((v) => scale * v), error = of.column("error"), measured = of.column("measured"), best = of.column("fitted");
      const curve = (values) => xy(xs, values.map((v) => v / unit.size));
      series.push({ label: `${many(name)}measured`, n: 2 * m, marks: true, points: curve(measured), errors: error.map((e) => e / unit.size) },
        { label: `${many(name)}fitted`, n: 2 * m + 1, bare: true, points: curve(best) }, { label: `${many(name)}first run`, n: 4, bare: true, dash: 1, points: curve(of.column("start")) });
      residuals.push({ label: name, n: 2 * m, marks: true, points: xy(xs, best.map((f, i) => (measured[i] - f) / error[i])) });
    });
    const ends = part.column("strain_or_time").map((v) => scale * v), range = [Math.min(...ends), Math.max(...ends)];
    const limits = [2, -2].map((y) => ({ label: "±2", n: 4, dash: 1, bare: true, points: range.map((v) => ({ x: v, y })) }));
    return section(id, `Measured and fitted force against ${against}`, lineChart(`${id}-chart`, `Force against ${against}: ${names.join(", ")}, measured and fitted`, x, `force (${unit.name})`, series),
      lineChart(`${id}-residual-chart`, "What is left, in standard deviations of each measured force", x, "(measured - fitted) / error", [...residuals, ...limits], { low: true, legend: names.length > 1 }),
      h("p", { class: "note" }, "Bars are one standard deviation of a measured force; below, what is left in such, of which 95 % should lie between -2 and 2."));
  });
}

function searchSection(runs) {
  const names = runs.names.slice(runs.names.indexOf("status") + 1, -1), at = runs.column("run"), done = runs.where((get) => get("status") === "done");
  const last = names.map((name) => done.column(name)[rowOfLeast(done.column("chi2"))]);
  const sizes = names.flatMap((name, n) => runs.column(name).map((v) => v / last[n])), isWide = Math.min(...sizes) > 0 && Math.max(...sizes) > 20 * Math.min(...sizes);
  const ratios = names.map((name, n) => ({ label: name, n, points: xy(at, runs.column(name).map((v) => v / last[n])) }));
  return section("search", "The way there",
    lineChart("misfit-chart", "Misfit of each run", "run", "misfit χ²", [{ label: "χ²", n: 0, points: xy(done.column("run"), done.column("chi2")) }], { low: true, xScale: "whole", yScale: "log" }),
    last.every((v) => v !== 0) ? lineChart("numbers-chart", "Numbers of each run, of the best run's", "run", "number / that of the best run", ratios, { low: true, xScale: "whole", yScale: isWide ? "log" : "linear", legend: true }) : null);
}
const rowOfLeast = (values) => values.reduce((best, v, row) => (v < values[best] ? row : best), 0);

function showFit(main) {
  const [runs, estimates, fitted] = [data.fit, data.estimates, data.fitted].map((table) => new Table(table));
  document.getElementById("subtitle").textContent = "A fit: numbers by which runs agree with measurements";
  const pair = (...sections) => h("div", { class: "sections-pair" }, sections.filter((one) => one !== null));
  const parts = [fitTiles(runs, estimates, fitted), ...fittedSections(fitted), fitChecks(runs, estimates, fitted), estimatesSection(estimates), pair(searchSection(runs), correlationSection(estimates)),
    section("runs", "Runs", htmlTable("fit.csv", runs.names, runs.rows.map((row) => row.map((field) => readable(field))), { tall: runs.rows.length > 20 }),
      lazyDetails("fitted.csv, as numbers", () => htmlTable("fitted.csv", fitted.names, fitted.rows, { tall: true }))),
    section("provenance", "Where this comes from", h("p", {}, "Each run's folder has its deck, versions and checksums."), lazyDetails("The log", () => h("pre", { tabindex: "0" }, data.log)),
      h("p", { class: "note" }, `This page was made by Stroma ${data.made_by}.`))];
  main.append(...parts.filter((part) => part !== null));
  return async () => {};
}
