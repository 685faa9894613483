// SPDX-License-Identifier: BSD-3-Clause
// What is drawn of a run's history.

const xy = (xs, ys) => xs.map((x, i) => ({ x, y: ys[i] }));
const energyUnit = (most) => unitFor(most, [["aJ", 1], ["fJ", 1e3], ["pJ", 1e6], ["nJ", 1e9]]);
const torqueUnit = (most) => unitFor(most, [["pN µm", 1], ["nN µm", 1e3], ["µN µm", 1e6]]);
const timeUnit = (most) => unitFor(most, [["µs", 1e-6], ["ms", 1e-3], ["s", 1]]);

/** Force of a support along its displacement [pN] at each row of a history. */
function forceAlong(support, history) {
  const length = Math.hypot(...support.displacement) || 1;
  const parts = ["x", "y", "z"].map((axis) => history.column(`${support.name}.reaction_${axis}`));
  return history.rows.map((_, s) => parts.reduce((sum, part, d) => sum + (part[s] * support.displacement[d]) / length, 0));
}

/** An axis of curves: {what, unit, name (both), values, at(row): "5 s", "strain 10 %"}. */
function axisOf(what, unit, values) {
  return { what, unit, values, name: unit ? `${what} (${unit})` : what, at: (row) => [what === "time" ? "" : what, short(values[row]) + (unit === "°" ? unit : ""), unit === "°" ? "" : unit].filter((word) => word !== "").join(" ") };
}

function timeAxis(history) {
  const seconds = history.column("time"), unit = timeUnit(largest(seconds));
  return axisOf("time", unit.name, seconds.map((t) => t / unit.size));
}

/** What a force is drawn against. */
function abscissa(support, history, hasTime) {
  const load = history.column("load");
  if (hasTime) return timeAxis(history);
  if (support && support.follows_load && support.strain !== 0) return axisOf("strain", "%", load.map((l) => 100 * l * support.strain));
  const shear = support && data.shears ? data.shears[support.name] : 0;
  if (shear && support.follows_load) return axisOf("shear strain", "%", load.map((l) => 100 * l * shear));
  const way = support ? Math.hypot(...support.displacement) : 0;
  if (support && support.follows_load && way > 0) return axisOf("displacement", "µm", load.map((l) => l * way));
  return axisOf("load", "", load);
}

/** What a run's curves are drawn against: what its first support does, or how far its first face has turned. */
function runAbscissa(history) {
  const turn = data.turning[0];
  if (data.supports.length > 0 || data.has_time || !turn || !turn.follows_load) return abscissa(data.supports[0], history, data.has_time);
  return axisOf("angle", "°", history.column("load").map((l) => l * turn.degrees));
}

/** The row where a column is largest, by its size. */
const rowOfMost = (values) => values.reduce((best, v, row) => (Math.abs(v) > Math.abs(values[best]) ? row : best), 0);

/** Curves in one unit: [{label, values, ...}] as series. */
const inUnit = (curves, x, unit) => curves.map(({ label, values, ...more }, n) => ({ label, n, points: xy(x.values, values.map((v) => v / unit.size)), ...more }));

/** Components of the forces of supports that are not negligible: [{label, values}]. */
function reactions(history) {
  const all = data.conditions.flatMap((name) => ["x", "y", "z"].map((axis) => ({ label: `${name}, ${axis}`, values: history.column(`${name}.reaction_${axis}`) })));
  const most = Math.max(0, ...all.map((curve) => largest(curve.values)));
  return all.filter((curve) => most > 0 && largest(curve.values) > 0.01 * most).sort((a, b) => largest(b.values) - largest(a.values)).slice(0, 7);
}

/** What the forces of a run are: {title, curves}. */
function forcesOf(history) {
  if (data.supports.length > 0) return { curves: data.supports.map((support) => ({ label: support.name, values: forceAlong(support, history) })), what: "Force" };
  return { curves: reactions(history), what: "Forces of the supports" };
}

/** A chart against time that may have its short times drawn apart. */
function withTimeScale(x, draw) {
  const positive = x.values.filter((v) => v > 0), place = new ChartPlace();
  place.show(draw("linear"));
  if (x.what !== "time" || positive.length < 3 || positive.at(-1) < 100 * positive[0]) return [place.element];
  return [h("div", { class: "controls" }, choice("time-scale", "Scale of time", [["linear", "Linear time"], ["log", "Logarithmic"]], "linear", (scale) => place.show(draw(scale)))), place.element];
}

function forceSection(history) {
  const x = runAbscissa(history), { curves, what } = forcesOf(history);
  const many = history.excerptNote();
  const ends = [many ? h("p", { class: "note" }, many) : null, lazyDetails("history.csv, as numbers", () => htmlTable("history.csv", history.names, history.rows, { tall: true }))];
  if (curves.length === 0) {
    const energy = history.column("strain_energy"), unit = energyUnit(largest(energy)), title = `Strain energy against ${x.what}`;
    return section("force", title, lineChart("force-chart", title, x.name, `strain energy (${unit.name})`, inUnit([{ label: "strain energy", values: energy }], x, unit)), ...ends);
  }
  const unit = forceUnit(Math.max(...curves.map((curve) => largest(curve.values)))), title = `${what} against ${x.what}`;
  const series = inUnit(curves, x, unit);
  if (data.supports.length > 0 && !data.has_time && x.values.length > 2) // the straight line from nothing to the end
    series.push({ label: "secant", n: 4, dash: 1, bare: true, points: [0, x.values.length - 1].map((s) => series[0].points[s]) });
  const description = `${title}: ${curves.map(({ label, values }) => `${label} ${short(values.at(-1) / unit.size)} ${unit.name} at the end`).join(", ")}`;
  const draw = (xScale) => lineChart("force-chart", description, x.name, `force (${unit.name})`,
    xScale === "log" ? series.map((s) => ({ ...s, points: s.points.filter((p) => p.x > 0) })) : series, { xScale, legend: series.length > 1 || data.supports.length === 0 });
  return section("force", title, ...withTimeScale(x, draw), ...ends);
}

/** The moment of faces that turn. */
function torqueSection(history) {
  const turns = data.turning.filter(({ name }) => history.has(`${name}.torque`));
  if (turns.length === 0) return null;
  const x = runAbscissa(history), curves = turns.map(({ name }) => ({ label: name, values: history.column(`${name}.torque`) })), unit = torqueUnit(Math.max(...curves.map((curve) => largest(curve.values))));
  const title = `Torque against ${x.what}`;
  return section("torque", title, lineChart("torque-chart", `${title}: ${curves.map(({ label, values }) => `${label} ${short(values.at(-1) / unit.size)} ${unit.name} at the end`).join(", ")}`,
    x.name, `torque (${unit.name})`, inUnit(curves, x, unit), { legend: curves.length > 1 }));
}

/** Strain + kinetic energy, less what was put in since the begin, and what damping took: constant but for the steps' errors [aJ]. */
function energyBalance(history) {
  const [strain, kinetic, work, damping] = ["strain_energy", "kinetic_energy", "external_work", "damping_work"].map((name) => history.column(name));
  return strain.map((e, row) => e + kinetic[row] - work[row] + damping[row]);
}

function energySection(history) {
  if (!history.has("kinetic_energy")) return null;
  const x = timeAxis(history), strain = history.column("strain_energy"), kinetic = history.column("kinetic_energy");
  const curves = [{ label: "strain", values: strain }, { label: "kinetic", values: kinetic }, { label: "both", values: strain.map((e, row) => e + kinetic[row]), bare: true },
    { label: "work of supports and loads", values: history.column("external_work"), bare: true, dash: 1 }, { label: "taken by damping", values: history.column("damping_work"), bare: true, dash: 2 }];
  const most = Math.max(...curves.map((curve) => largest(curve.values))), unit = energyUnit(most), shown = curves.filter((curve) => largest(curve.values) > 1e-6 * most);
  return section("energy", "Energy against time", lineChart("energy-chart", `Energy against time: ${shown.map(({ label }) => label).join(", ")}`, x.name, `energy (${unit.name})`, inUnit(shown, x, unit), { yFromZero: true }));
}

/** Materials that press: their pressure and volume. */
function pressureSection(history) {
  const pressing = data.pressures.filter((name) => history.has(`${name}.pressure`));
  if (pressing.length === 0) return null;
  const x = abscissa(null, history, data.has_time);
  const curves = pressing.map((name) => {
    const volume = history.column(`${name}.volume`);
    return { label: name, pressure: history.column(`${name}.pressure`), ratio: volume.map((v) => v / volume[0]) };
  });
  const unit = unitFor(Math.max(...curves.map((curve) => largest(curve.pressure))), [["Pa", 1], ["kPa", 1e3]]), legend = { legend: curves.length > 1 };
  const most = curves.map(({ label, pressure, ratio }) => `${label} ${short(Math.max(...ratio))} of its volume at ${short(pressure[rowOfMost(ratio)] / unit.size)} ${unit.name}`).join(", ");
  const against = (of) => curves.map((curve, n) => ({ label: curve.label, n, points: xy(x.values, of(curve)) }));
  return section("pressure", "Pressure and volume",
    lineChart("pressure-volume-chart", `Pressure against volume: ${most}`, "volume / volume at the begin", `pressure (${unit.name})`, curves.map(({ label, pressure, ratio }, n) => ({ label, n, points: xy(ratio, pressure.map((p) => p / unit.size)) })), { low: true, ...legend }),
    lineChart("pressure-chart", `Pressure against ${x.what}`, x.name, `pressure (${unit.name})`, against((curve) => curve.pressure.map((p) => p / unit.size)), { low: true, ...legend }),
    lineChart("volume-chart", `Volume against ${x.what}`, x.name, "volume / at the begin", against((curve) => curve.ratio), { low: true, ...legend }));
}
