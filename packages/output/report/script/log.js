// SPDX-License-Identifier: BSD-3-Clause
// What a run's log says.

/** What a run has said of itself. */
function readLog(text) {
  const lines = text.split("\n"), of = (name) => (lines.find((line) => line.startsWith(name)) || "").slice(name.length).trim();
  const bounds = [];
  const start = lines.findIndex((line) => line.startsWith("bounds "));
  for (let n = start; start >= 0 && n < lines.length && lines[n].trim() !== ""; ++n) bounds.push(lines[n]);
  const stages = [...of("time ").matchAll(/(\S.*?) ([\d.]+) s(?:\s{2}|$)/g)].map((found) => [found[1], Number(found[2])]);
  return {
    notes: lines.filter((line) => line.startsWith("note: ")).map((line) => line.slice(6)),
    rejected: lines.filter((line) => /^step to load \S+ rejected/.test(line)),
    errors: lines.filter((line) => /^stroma: /.test(line)),
    grid: of("grid "), particles: of("particles "), memory: of("memory "), bounds, stages,
  };
}

/** Adds the notes of a log to a list of checks. */
function tellNotes(log, tell) {
  const serious = /locking|few elements|rounding|pieces|does not resolve|under-integrates|finer than voxels|not in balance|not drawn|not written|contrast|removed|left out|held by nothing|grid joins|nothing strains|not in per cent|no particle is of|goes into/i;
  const isSerious = (text) => serious.test(text) || Number((/Stabilization adds (\S+) to/.exec(text) || [])[1]) > 1e-3;
  for (const text of [...new Set(log.notes)]) tell(isSerious(text) ? "look" : "note", text[0].toUpperCase() + text.slice(1));
}

/** The table of bounds: [["shear mu", {modulus, gain} x 4], ...]. */
function boundsTable(lines) {
  return lines.slice(3).map((line) => line.trim().split(/\s{2,}/)).filter((row) => row.length === 5);
}
