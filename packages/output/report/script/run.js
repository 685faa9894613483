// SPDX-License-Identifier: BSD-3-Clause
// The page of a run.

/** Stages of a run that are parts of others. */
const partOf = { smoothing: "linear solve", transfer: "linear solve", "coarsest solve": "linear solve", "coarse operators": "preconditioner", eigenvalues: "preconditioner", "coarsest factors": "preconditioner" };

/** The stages that took longest, each followed by its parts. */
function stageBars(stages, total) {
  const bySeconds = (of) => of.filter(([, spent]) => spent > 0.01 * total).sort((a, b) => b[1] - a[1]);
  const shown = bySeconds(stages.filter(([name]) => !partOf[name])).slice(0, 8), most = shown.length > 0 ? shown[0][1] : 1;
  const bar = (name, spent, isPart) => [h("span", isPart ? { class: "part" } : {}, name), h("span", { class: "bar" + (isPart ? " part" : ""), style: `width: ${(100 * spent) / most}%` }), h("span", { class: "value" }, `${short(spent, 3)} s`)];
  return h("div", { class: "bars" }, shown.flatMap(([name, spent]) => [bar(name, spent, false), ...bySeconds(stages.filter(([part]) => partOf[part] === name)).map(([part, time]) => bar(part, time, true))]).flat());
}

function costSection(history, log) {
  const step = history.column("step").slice(1), seconds = history.column("wall_seconds").slice(1);
  return section("cost", "Iterations and time",
    lineChart("iterations-chart", "Iterations of each step", "step", "iterations", [
      { label: "Newton", n: 0, points: xy(step, history.column("newton_iterations").slice(1)) },
      { label: "linear", n: 1, points: xy(step, history.column("linear_iterations").slice(1)) }], { low: true, yFromZero: true, xScale: "whole" }),
    lineChart("seconds-chart", "Wall time up to each step", "step", "wall time (s)", [{ label: "wall time", n: 2, points: xy(step, seconds) }], { low: true, yFromZero: true, xScale: "whole" }),
    log.stages.length === 0 ? null : h("div", {}, h("h3", {}, "Where the time went"), stageBars(log.stages, seconds.at(-1) || 0),
      h("p", { class: "note" }, "Lighter bars are parts of those above them; fields that are written while they are evaluated count for both stages.")),
    log.memory ? h("p", { class: "note" }, `Memory: ${log.memory}.`) : null);
}

function tiles(list) {
  return h("dl", { class: "tiles" }, list.filter((tile) => tile !== null).map(([name, value, more]) => h("div", {}, h("dt", {}, name), h("dd", {}, value, more ? h("small", {}, more) : null))));
}

/** A tile of a figure at the end, or at its largest where it has gone back to nothing. */
function figureTile(title, values, x, unit, more = "") {
  const most = rowOfMost(values), end = values.length - 1, read = (row) => `${short(values[row] / unit.size)} ${unit.name}`;
  const hasGone = Math.abs(values[end]) < 0.1 * Math.abs(values[most]), isOver = Math.abs(values[end]) < 0.99 * Math.abs(values[most]);
  return [title, read(hasGone ? most : end), hasGone ? `largest, at ${x.at(most)}${more}` : `${x.at(end)}${isOver ? `; at most ${read(most)}, at ${x.at(most)}` : ""}${more}`];
}

function overview(history, log) {
  const x = runAbscissa(history), load = history.last("load"), pascal = { name: "Pa", size: 1 };
  const list = [], turns = data.turning.filter((turn) => history.has(`${turn.name}.torque`)).slice(0, 1);
  for (const { name, degrees } of turns) {
    const torque = history.column(`${name}.torque`);
    list.push(figureTile(`Torque of ${name}`, torque, x, torqueUnit(largest(torque)), x.what === "angle" ? "" : `; ${short(degrees)}° at full load`));
  }
  for (const { label, values } of forcesOf(history).curves.slice(0, data.supports.length > 0 ? 2 : 1)) list.push(figureTile(`Force of ${label}`, values, x, forceUnit(largest(values))));
  for (const name of data.pressures.filter((one) => history.has(`${one}.pressure`)).slice(0, 1)) {
    const volume = history.column(`${name}.volume`), most = rowOfMost(volume);
    list.push([`Volume of ${name}`, `× ${short(volume[most] / volume[0])}`, `largest, at ${short(history.column(`${name}.pressure`)[most])} Pa, ${x.at(most)}`]);
  }
  for (const name of data.materials.filter((one) => !data.pressures.includes(one)).slice(0, 3)) {
    const mean = history.column(`${name}.von_mises_mean`);
    list.push(figureTile(`Mean von Mises, ${name}`, mean, x, pascal, `; anywhere up to ${short(Math.max(...history.column(`${name}.von_mises_max`)))} Pa`));
  }
  list.push(["Steps", String(history.last("step")), load < 1 ? `load ${short(load)} of 1 reached` : data.has_time ? "the end reached" : "full load reached"]);
  list.push(["Time until the last step was solved", `${short(history.last("wall_seconds"), 3)} s`, log.particles ? log.particles.replace(/,? on /, " particles, on ").replace(/^(\d+) particles/, (_, n) => `${Number(n).toLocaleString("en")} particles`) : null]);
  return tiles(list);
}

/** Notes of the run, and what its results themselves say. */
function checksSection(history, log) {
  const { list, tell } = checkList();
  const load = history.last("load"), x = runAbscissa(history), end = history.rows.length - 1;
  if (load >= 1) tell("good", `The run came to ${data.has_time ? `its end, ${x.at(end)},` : "full load"} in ${history.last("step")} steps.`);
  else tell("look", `The run ended at ${short(100 * load)} % of the load.`);
  if (log.rejected.length > 0) tell("look", `${log.rejected.length} step${log.rejected.length > 1 ? "s were" : " was"} rejected and halved; the first: ${log.rejected[0]}`);
  const residual = history.column("residual").slice(1);
  if (residual.length > 0) tell("good", `Balance: the residual is at most ${short(Math.max(...residual), 2)} of the forces.`);
  checkEnergy(history, tell);
  checkBounds(history, log, tell);
  checkLastStep(history, x, tell);
  for (const text of log.errors) tell("look", text.replace(/^stroma: /, ""));
  tellNotes(log, tell);
  return section("checks", "What to know of this run", list);
}

/** Whether a body in motion keeps its energy. */
function checkEnergy(history, tell) {
  if (!history.has("kinetic_energy")) return;
  const balance = energyBalance(history), strain = history.column("strain_energy");
  const most = Math.max(...history.column("kinetic_energy").map((e, row) => e + strain[row]), largest(history.column("external_work")));
  const drift = largest(balance.map((e) => e - balance[0])) / (most || 1);
  tell(drift <= 0.05 ? "good" : "look", `Energy: strain and kinetic energy, less the work of supports and loads, with what damping took, changes by at most ${short(100 * drift, 2)} % of the largest energy${drift <= 0.05 ? "." : "; shorter steps keep it better."}`);
}

/** Whether the step that the tables are of is one at which hardly anything is strained. */
function checkLastStep(history, x, tell) {
  const mean = meanStress(history), most = rowOfMost(mean), end = mean.length - 1;
  if (mean[end] >= 0.1 * mean[most] || Object.keys(data.tables).length === 0) return;
  tell("note", `Histograms, distances and objects are of the last step, at ${x.at(end)}, where little stress is left; it was largest at ${x.at(most)}. A run that ends there has tables of it.`);
}

/** Mean von Mises stress of the whole body, by volume, at each row [Pa]. */
function meanStress(history) {
  const of = data.materials.map((name) => [history.column(`${name}.volume`), history.column(`${name}.von_mises_mean`)]);
  return history.rows.map((_, row) => of.reduce((sum, [volume, mean]) => sum + volume[row] * mean[row], 0) / of.reduce((sum, [volume]) => sum + volume[row], 0));
}

/** The modulus by which a body resists a strain along one axis, of the bounds' moduli of one kind: with its sides free or between walls. */
function modulusAlong(axis, bounds) {
  const isFlat = /rollers/.test(bounds.at(-1)[0]), walls = [0, 1, 2].filter((d) => d !== axis && data.walls[d] && !(isFlat && d === 2)).length;
  if (walls === 0) return { name: isFlat ? "E', between rollers" : bounds.at(-1)[0], of: (G, K, E) => E };
  if (isFlat) return { name: "k + mu, of a body that cannot widen", of: (G, k) => k + G };
  if (walls === 1) return { name: "4 G (3 K + G) / (3 K + 4 G), of a body that can widen along one axis", of: (G, K) => (4 * G * (3 * K + G)) / (3 * K + 4 * G) };
  return { name: "K + 4/3 mu, of a body that cannot widen", of: (G, K) => K + (4 / 3) * G };
}

/** Whether the stiffness at small strain lies between the bounds, for a body that is stretched between faces and not loaded otherwise. */
function checkBounds(history, log, tell) {
  const bounds = boundsTable(log.bounds);
  if (bounds.length !== 3 || !data.stretch || data.has_time || history.rows.length < 3) return;
  const { axis, strain } = data.stretch, area = data.length.reduce((product, edge, d) => (d === axis ? product : product * edge), 1);
  const force = forceAlong(data.supports[0], history), load = history.column("load");
  const secant = (s) => force[s] / (area * Math.abs(strain) * load[s]);
  const small = secant(1) + ((secant(1) - secant(2)) * load[1]) / (load[2] - load[1]); // at no strain, by the first two steps
  const modulus = modulusAlong(axis, bounds), [reuss, voigt] = [1, 4].map((kind) => modulus.of(...bounds.map((row) => parseFloat(row[kind])))), { name } = modulus;
  data.small_strain = `Force per area and strain of this run, at small strain: ${short(small)} Pa. By Reuss ${short(reuss)} Pa, by Voigt ${short(voigt)} Pa, for ${name}.`;
  const where = `${short(small)} Pa at small strain`;
  if (small < 0.99 * reuss) tell("look", `Bounds: force per area and strain is ${where}, below Reuss's bound, ${short(reuss)} Pa, for ${name}: empty space, or a grip that does not hold, would explain it.`);
  else if (small > 1.01 * voigt && data.holds_sideways) tell("note", `Bounds: force per area and strain is ${where}, above Voigt's bound, ${short(voigt)} Pa, for ${name}, which is one for rollers: grips that hold sideways stiffen a body.`);
  else if (small > 1.01 * voigt) tell("look", `Bounds: force per area and strain is ${where}, above Voigt's bound, ${short(voigt)} Pa, for ${name}.`);
  else tell("good", `Bounds: force per area and strain is ${where}, between Reuss (${short(reuss)} Pa) and Voigt (${short(voigt)} Pa) for ${name}.`);
}

function boundsSection(log) {
  const rows = boundsTable(log.bounds);
  if (rows.length === 0) return null;
  return section("bounds", "Bounds of the mixture", h("p", { class: "quiet" }, `${log.bounds[0].replace(/^bounds\s+/, "")}: ${log.bounds[1].trim()}`),
    htmlTable("Bounds", ["", "Reuss", "Hashin-Shtrikman, lower", "Hashin-Shtrikman, upper", "Voigt"], rows.map((row) => row.map((text) => text.replace(/ ([+-]\S+ %)$/, " ($1)")))),
    data.small_strain ? h("p", { class: "note" }, data.small_strain) : null);
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
  const checks = checksSection(history, log); // first: it finds the stiffness that the bounds' section tells
  main.append(overview(history, log));
  let maps = null;
  if (data.maps) {
    maps = new Maps(data.maps, data.image, history);
    main.append(section("maps", "Specimen, stress and strain", maps.element()));
  } else main.append(section("maps", "Specimen, stress and strain", h("p", { class: "note" }, "There is no particles.e in the folder, of which maps could be made.")));
  const missing = ["histograms.csv", "wall_distance.csv", "objects.csv"].filter((name) => !data.tables[name]);
  const pair = (...sections) => h("div", { class: "sections-pair" }, sections.filter((one) => one !== null));
  const parts = [checks, pair(torqueSection(history), forceSection(history), energySection(history), pressureSection(history), costSection(history, log)),
    pair(histogramSection(), wallSection()), objectsSection(), boundsSection(log), provenanceSection(log),
    missing.length > 0 ? h("p", { class: "note" }, `Not in the folder, so not in this report: ${missing.join(", ")}.`) : null];
  main.append(...parts.filter((part) => part !== null));
  return async () => {
    if (maps) await maps.begin();
  };
}
