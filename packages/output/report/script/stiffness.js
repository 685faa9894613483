// SPDX-License-Identifier: BSD-3-Clause
// The page of a stiffness.

const pascalUnit = (most) => unitFor(most, [["Pa", 1], ["kPa", 1e3], ["MPa", 1e6], ["GPa", 1e9]]);
const percent = (share, digits = 3) => `${short(100 * share, digits)} %`;
/** A stiffness in Kelvin's notation, whose eigenvalues are those of the tensor. */
const kelvin = (C) => C.map((row, i) => row.map((c, j) => c * (i < 3 ? 1 : Math.SQRT2) * (j < 3 ? 1 : Math.SQRT2)));

/** Moduli of the closest isotropic tensor [Pa]. */
function isotropicOf(C) {
  const K = [0, 1, 2].reduce((sum, i) => sum + C[i][0] + C[i][1] + C[i][2], 0) / 9;
  const G = (kelvin(C).reduce((sum, row, i) => sum + row[i], 0) - 3 * K) / 10;
  return { K, G, E: (9 * K * G) / (3 * K + G), nu: (3 * K - 2 * G) / (6 * K + 2 * G) };
}

/** Whether all strains cost at least as much with a as with b, but for rounding: Cholesky's factors of the difference exist. */
function isStiffer(a, b) {
  const [p, q] = [kelvin(a), kelvin(b)], size = Math.hypot(...q.flat()), d = p.map((row, i) => row.map((v, j) => v - q[i][j] + (i === j ? 1e-9 * size : 0)));
  for (let k = 0; k < 6; ++k) {
    if (!(d[k][k] > 0)) return false;
    for (let i = k + 1; i < 6; ++i) for (let j = k + 1; j < 6; ++j) d[i][j] -= (d[i][k] * d[k][j]) / d[k][k];
  }
  return true;
}

/** All tensors, the stiffest first: [{name, stiffness, compliance, isBound}]. */
function tensors() {
  const found = Object.entries(data.found.stiffness).map(([name, one]) => ({ name, stiffness: one.stiffness, compliance: one.compliance, isBound: false }));
  const bound = (name) => ({ name, stiffness: data.found[name], compliance: data.compliances[name], isBound: true });
  return [bound("Voigt"), ...found, bound("Reuss")].filter(({ stiffness }) => stiffness);
}

function stiffnessTiles() {
  const { found } = data, all = Object.entries(found.stiffness), cases = all.flatMap(([, one]) => Object.values(one["load cases"]));
  const list = all.map(([name, { closest }]) => {
    const { K, G, E, nu } = closest.isotropic.moduli, unit = pascalUnit(E);
    return [`Young's modulus, ${name.toLowerCase()}`, `${short(E / unit.size)} ${unit.name}`, `closest isotropic: ν ${short(nu, 3)}, K ${short(K / unit.size)}, G ${short(G / unit.size)} ${unit.name}; ${percent(closest.isotropic.distance)} away`];
  });
  list.push(["Solid share", percent(found["solid share"], 4), `of ${found["box [um]"].map((edge) => short(edge)).join(" × ")} µm`]);
  list.push(["Load cases", String(cases.length), `${cases.reduce((sum, one) => sum + one.iterations, 0)} iterations`]);
  return tiles(list);
}

function stiffnessChecks(log) {
  const { list, tell } = checkList(), ordered = tensors(), all = Object.entries(data.found.stiffness);
  const residual = Math.max(...all.flatMap(([, one]) => Object.values(one["load cases"]).map((of) => of.residual)));
  tell("good", `Every load case is solved to a residual of at most ${short(residual, 2)} of its load.`);
  const wrong = ordered.slice(1).map((softer, n) => [ordered[n], softer]).filter(([a, b]) => !isStiffer(a.stiffness, b.stiffness));
  if (wrong.length === 0) tell("good", `For every strain: ${ordered.map(({ name }) => name).join(" ≥ ")}.`);
  for (const [a, b] of wrong) tell([a.name, b.name].includes("Mixed") ? "note" : "look", `Some strain costs more with ${b.name} than with ${a.name}${[a.name, b.name].includes("Mixed") ? "; nothing forbids it where the specimen is not its own mirror image" : ""}.`);
  for (const [name, one] of all) {
    if (!one.compliance) tell("look", `${name}: nothing holds the specimen together, since some strain costs no energy. There are no moduli.`);
    if (one["symmetry error"] > 1e-6) tell("note", `${name} departs from symmetry by ${percent(one["symmetry error"], 2)}: the specimen is not its own mirror image. The symmetric part is shown.`);
  }
  tellNotes(log, tell);
  return section("checks", "What to know of this stiffness", list);
}

function specimenFacts(log) {
  const { found } = data, list = h("dl", { class: "facts beside" }), add = (name, text) => list.append(h("dt", {}, name), h("dd", {}, text));
  add("Box", `${found["box [um]"].map((edge) => short(edge)).join(" × ")} µm`);
  if (log.grid) add("Grid", log.grid.replaceAll(" x ", " × ").replaceAll("um", "µm"));
  if (log.particles) add("Particles", log.particles);
  list.append(h("hr"));
  for (const [name, share] of Object.entries(found["share of materials"])) add(name, `${percent(share, 4)} of the box`);
  if (found["solid share"] < 1 - 1e-9) {
    add("empty", percent(1 - found["solid share"], 4));
    list.append(h("hr"));
    for (const [face, share] of Object.entries(found["solid share of faces"])) add(`Face ${face}`, `${percent(share, 4)} solid`);
  }
  return list;
}

const isDownwards = (a, b) => a === 0 && b === 1 && data.y_downwards;
const planes = [[0, 1], [0, 2], [1, 2]], axisNames = "xyz";
/** Young's modulus along n: 1 / (s . S s), s = (nx nx, ny ny, nz nz, ny nz, nx nz, nx ny). */
function youngAlong(S, n) {
  const s = [n[0] * n[0], n[1] * n[1], n[2] * n[2], n[1] * n[2], n[0] * n[2], n[0] * n[1]];
  return 1 / S.reduce((sum, row, i) => sum + s[i] * row.reduce((part, v, j) => part + v * s[j], 0), 0);
}

/** Young's modulus of all tensors along the directions of three planes. */
function directionSection() {
  const drawn = tensors().filter(({ compliance }) => compliance), count = 180;
  if (drawn.every(({ isBound }) => isBound)) return null;
  const directions = planes.map(([a, b]) => Array.from({ length: count }, (_, i) => {
    // The second axis points up, but for y where maps have it downwards.
    const n = [0, 0, 0], angle = (2 * Math.PI * i) / count;
    n[a] = Math.sin(angle);
    n[b] = Math.cos(angle) * (isDownwards(a, b) ? -1 : 1);
    return n;
  }));
  const curves = directions.map((of) => drawn.map(({ compliance }) => of.map((n) => youngAlong(compliance, n)))), most = 1.04 * Math.max(...curves.flat(2)), unit = pascalUnit(most);
  const figures = planes.map(([a, b], p) => {
    const [first, second] = [axisNames[a], axisNames[b]], upright = [second, `-${second}`], [up, down] = isDownwards(a, b) ? upright.reverse() : upright;
    const series = drawn.map(({ name, isBound }, n) => ({ label: name, n: isBound ? 4 : n, dash: isBound ? (name === "Voigt" ? 1 : 2) : 0, values: curves[p][n].map((E) => E / unit.size) }));
    const description = `Young's modulus along the directions of the plane ${first}${second}: ${series.map(({ label, values }) => `${label} from ${short(Math.min(...values))} to ${short(Math.max(...values))} ${unit.name}`).join(", ")}`;
    return h("div", {}, h("h3", {}, `Plane ${first}${second}`), polarChart(`young-${first}${second}`, description, unit.name, most / unit.size, series, [up, first, down, `-${first}`],
      (i) => `along (${directions[p][i].map((v) => short(Math.abs(v) < 1e-9 ? 0 : v, 2)).join(", ")})`));
  });
  const legend = h("ul", { class: "legend" }, drawn.map(({ name, isBound }, n) => h("li", {}, h("i", { class: "line" + (!isBound ? "" : name === "Voigt" ? " dashed" : " dotted"), style: `color: var(--s${isBound ? 4 : n % 7})` }), name)));
  return section("directions", "Young's modulus against direction", h("div", { class: "triple" }, figures), legend,
    h("p", { class: "note" }, `In ${unit.name}: the stress that strains the specimen by 1 along a direction, if it acts along it alone. Dashed: Voigt's bound${drawn.at(-1).name === "Reuss" ? "; dotted: Reuss's" : ""}.`));
}

/** A tensor as a table of six rows, tinted by size. */
function tensorTable(C, unit) {
  const most = largest(C.flat()), decimals = Math.max(0, 4 - Math.floor(Math.log10(most / unit.size))), { order } = data.found;
  return h("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": "Stiffness tensor" },
    h("table", { id: "tensor" }, h("thead", {}, h("tr", {}, ["", ...order].map((name) => h("th", { scope: "col" }, name)))),
      h("tbody", {}, C.map((row, i) => h("tr", {}, h("th", { scope: "row" }, order[i]), row.map((v) => h("td", { style: tint(v / most) }, (v / unit.size).toFixed(decimals).replace(/^-(0\.?0*)$/, "$1"))))))));
}

/** The closest tensors of more symmetry. */
function closestTable(closest, unit) {
  const modulus = (moduli, name, alone) => (moduli ? short((moduli[name] ?? moduli[alone]) / unit.size) : "–"), axis = (axes, a) => (axes ? axes[a].map((v) => short(Math.abs(v) < 5e-5 ? 0 : v, 3)).join(", ") : "–");
  const rows = Object.keys(closest).map((name) => {
    const { distance, axes, moduli, "distance along the specimen's axes": along } = closest[name];
    return [name, percent(distance), along === undefined ? "–" : percent(along), ...["E_1", "E_2", "E_3"].map((E) => modulus(moduli, E, "E")), ...["G_23", "G_13", "G_12"].map((G) => modulus(moduli, G, "G")), ...[0, 1, 2].map((a) => axis(axes, a))];
  });
  return htmlTable("Closest tensors of more symmetry", ["symmetry", "away by", "along x, y, z", ...["E₁", "E₂", "E₃", "G₂₃", "G₁₃", "G₁₂"].map((name) => `${name} (${unit.name})`), "axis 1", "axis 2", "axis 3"], rows);
}

/** One tensor at a time, with those that are closest to it. */
function tensorSection() {
  const all = tensors(), unit = pascalUnit(Math.max(...all.map(({ stiffness }) => largest(stiffness.flat())))), place = h("div"), first = (all.find(({ name }) => name === "Mixed") || all[1]).name;
  const show = (name) => {
    const one = data.found.stiffness[name];
    place.replaceChildren(tensorTable(all.find((of) => of.name === name).stiffness, unit), h("p", { class: "note" }, `In ${unit.name}; rows are stresses, columns strains, shears engineering ones. Orange above zero, blue below.`),
      ...(one ? [h("h3", { class: "below" }, "Closest tensors of more symmetry"), closestTable(one.closest, unit), h("p", { class: "note" }, "Distances by the Euclidean norm, of the tensor's own. Moduli along axes 1, 2, 3, which are those that make it least; the third is that of transverse isotropy.")] : []));
  };
  show(first);
  return section("tensor-section", "Stiffness tensors", h("div", { class: "controls" }, choice("boundary", "Boundary", all.map(({ name }) => [name, name]), first, show)), place);
}

/** Engineering moduli along the axes of the image, a column for each boundary. */
function moduliSection() {
  const all = Object.entries(data.found.stiffness).filter(([, one]) => one.moduli);
  if (all.length === 0) return null;
  const names = Object.keys(all[0][1].moduli), unit = pascalUnit(Math.max(...all.flatMap(([, { moduli }]) => names.map((name) => moduli[name]))));
  const isRatio = (name) => name.startsWith("nu");
  return section("moduli", "Engineering moduli", htmlTable("Engineering moduli", ["modulus", ...all.map(([name]) => name)],
    names.map((name) => [isRatio(name) ? name.replace("nu", "ν") : `${name} (${unit.name})`, ...all.map(([, { moduli }]) => short(moduli[name] / (isRatio(name) ? 1 : unit.size)))])),
    h("p", { class: "note" }, "Along the axes of the image; ν_xy is the contraction along y by an extension along x."));
}

/** Moduli of the closest isotropic tensors between the bounds. */
function boundaryOrder() {
  const { bounds } = data.found, of = (kind, name) => (bounds ? { name, moduli: bounds[kind] } : null);
  const found = tensors().filter(({ isBound }) => !isBound).map(({ name, stiffness }) => ({ name: name.replace("Uniform ", "").toLowerCase(), moduli: isotropicOf(stiffness) })).reverse();
  const voigt = { name: "Voigt", moduli: isotropicOf(data.found.Voigt) };
  const all = [of("Reuss", "Reuss"), of("Hashin-Shtrikman -", "H.-S., lower"), ...found, of("Hashin-Shtrikman +", "H.-S., upper"), voigt].filter((one) => one !== null), unit = pascalUnit(voigt.moduli.K);
  const series = [["bulk K", "K"], ["shear G", "G"], ["Young's E", "E"]].map(([label, letter], n) => ({ label, n, points: all.map(({ moduli }, x) => ({ x, y: moduli[letter] / unit.size })) }));
  const description = `Bounds and boundaries: ${all.map(({ name, moduli }) => `${name} K ${short(moduli.K / unit.size)}, G ${short(moduli.G / unit.size)} ${unit.name}`).join("; ")}`;
  return section("bounds", "Between the bounds", lineChart("order-chart", description, "", `modulus (${unit.name})`, series, { yFromZero: true, xNames: all.map(({ name }) => name) }),
    lazyDetails("As numbers", () => htmlTable("Moduli between bounds", ["", `K (${unit.name})`, `G (${unit.name})`, `E (${unit.name})`], all.map(({ name, moduli }) => [name, ...["K", "G", "E"].map((letter) => short(moduli[letter] / unit.size, 5))]))),
    h("p", { class: "note" }, `Of boundaries and Voigt's tensor, the closest isotropic one. ${bounds ? "Hashin and Shtrikman's bounds (H.-S.) are those of a large mixture that is isotropic: of a small piece, uniform tractions may lie below and uniform displacements above." : "The other bounds are those of isotropic materials, and here are fibres."}`));
}

function casesSection(log) {
  const all = Object.entries(data.found.stiffness), seconds = log.stages.reduce((most, [, spent]) => Math.max(most, spent), 0);
  return section("cases", "How it was solved",
    htmlTable("Load cases", ["load case", ...all.flatMap(([name]) => [`${name}: iterations`, "residual"])], data.found.order.map((unit) => [unit, ...all.flatMap(([, one]) => [String(one["load cases"][unit].iterations), short(one["load cases"][unit].residual, 3)])])),
    log.stages.length === 0 ? null : h("div", {}, h("h3", { class: "below" }, "Where the time went"), stageBars(log.stages.filter(([name]) => name !== "stiffness"), seconds)), log.memory ? h("p", { class: "note" }, `Memory: ${log.memory}.`) : null);
}

function showStiffness(main) {
  data.found = JSON.parse(data.found); // a text until now, so that names keep their order
  const log = readLog(data.log), checks = stiffnessChecks(log), maps = data.maps ? new Maps(data.maps, data.image, null) : null;
  document.getElementById("subtitle").textContent = `${data.folder}: the stiffness of a specimen as a whole, in small strain`;
  const pair = (...sections) => h("div", { class: "sections-pair" }, sections.filter((one) => one !== null));
  const specimen = maps ? maps.element(specimenFacts(log)) : [specimenFacts(log), h("p", { class: "note" }, typeof data.image === "string" ? data.image : "There is no image.")];
  const parts = [stiffnessTiles(), section("maps", "Specimen", specimen), checks, directionSection(), tensorSection(), pair(moduliSection(), boundaryOrder()), casesSection(log), provenanceSection(log)];
  main.append(...parts.filter((part) => part !== null));
  return async () => {
    if (maps) await maps.begin();
  };
}
