#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""How often the 95 % interval of `stroma fit` holds the truth (V-FIT-3): fits the vessels' modulus to noisy draws of a
force that was computed with it, and prints the tally.

    tests/verification/fit/coverage.py build/release/bin/stroma FOLDER [draws, 100]

FOLDER is made. Exit status 1 unless the truth is held in 90 to 99 of 100 draws."""

import csv
import random
import subprocess
import sys
from pathlib import Path

TRUTH, NOISE = 1041.6, 0.01
program, folder = Path(sys.argv[1]).resolve(), Path(sys.argv[2])
draws = int(sys.argv[3]) if len(sys.argv) > 3 else 100
folder.mkdir(parents=True)
example = Path(__file__).resolve().parents[3] / "input_decks" / "14_fit_vessel_modulus"
deck = (example / "deck.xml").read_text()
elements = "{4.2, 4.2, 1.0}"
assert elements in deck
(folder / "deck.xml").write_text(deck.replace(elements, "{8.4, 8.4, 1.0}"))
(folder / "fit.yaml").write_text((example / "fit.yaml").read_text())


def stroma(*words):
    subprocess.run([program, *words, "--quiet"], cwd=folder, check=True)


def rows(name):
    with open(folder / name, newline="") as file:
        return list(csv.DictReader(file))


stroma("run", "deck.xml", "-o", "truth")
forces = [(0.1 * float(row["load"]), float(row["top.reaction_y"])) for row in rows("truth/history.csv")[1:]]
random.seed(1)
held, runs, normal = 0, 0, []
for draw in range(draws):
    with open(folder / "force.csv", "w") as file:
        file.write("strain,force,error\n")
        for strain, force in forces:
            file.write(f"{strain:.17g},{random.gauss(force, NOISE * force):.17g},{NOISE * force:.17g}\n")
    stroma("fit", "fit.yaml")
    found = rows("fit/estimates.csv")[0]
    held += float(found["low"]) <= TRUTH <= float(found["high"])
    normal.append((float(found["value"]) - TRUTH) / float(found["standard_deviation"]))
    runs += len(rows("fit/fit.csv"))
mean = sum(normal) / draws
spread = (sum((x - mean) ** 2 for x in normal) / max(1, draws - 1)) ** 0.5
print(f"the 95 % interval holds the truth in {held} of {draws} draws; (value - truth) / standard deviation has mean "
      f"{mean:.3f} and standard deviation {spread:.3f}; {runs / draws:.2f} runs a fit")
sys.exit(0 if 0.90 * draws <= held <= 0.99 * draws else 1)
