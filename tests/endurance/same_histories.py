#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Do two builds give the same histories, bit for bit?

    python3 tests/endurance/same_histories.py OLD/bin/stroma NEW/bin/stroma [DECK-FOLDER...] [--limit SECONDS]

Runs the input decks (or the given folders with a deck.xml, deck.yaml, or several decks each) with both builds on one
rank, in turn, and compares every column of history.csv but the time. A line for each deck: same bits, or the largest
difference, by the column's largest value. Studies are left out: their members are decks.
"""
import argparse
import csv
import os
import shutil
import subprocess
import sys
import tempfile
import time

PROJECT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")


def history(folder):
    with open(os.path.join(folder, "history.csv")) as file:
        return list(csv.reader(file))


def difference(old, new):
    """The largest difference of a value and its column; None where every bit is the same. Columns that only one build
    writes are left out."""
    if len(old) != len(new):
        return f"other rows: {len(old)} and {len(new)}"
    worst, where = 0.0, None
    for column, name in enumerate(old[0]):
        if name == "wall_seconds" or name not in new[0]:
            continue
        other_column = new[0].index(name)
        pairs = [(row[column], other[other_column]) for row, other in zip(old[1:], new[1:])]
        if all(a == b for a, b in pairs):
            continue
        scale = max(max(abs(float(a)), abs(float(b))) for a, b in pairs) or 1.0
        found = max(abs(float(a) - float(b)) for a, b in pairs) / scale
        if where is None or found > worst:
            worst, where = found, name
    return None if where is None else f"differs by {worst:.1e} in {where}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("old")
    parser.add_argument("new")
    parser.add_argument("folders", nargs="*")
    parser.add_argument("--limit", type=float, default=900, help="seconds for one run")
    arguments = parser.parse_args()
    decks = os.path.join(PROJECT, "input_decks")
    folders = arguments.folders or sorted(
        os.path.join(decks, name) for name in os.listdir(decks) if os.path.isdir(os.path.join(decks, name)))
    environment = dict(os.environ, OMP_NUM_THREADS="1", OMPI_ALLOW_RUN_AS_ROOT="1",
                       OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    differing = 0
    for folder in folders:
        with tempfile.TemporaryDirectory() as work:
            # Beside a copy of the decks lie, as in the project, the images that they read.
            here = os.path.join(work, "input_decks", os.path.basename(folder))
            shutil.copytree(folder, here)
            os.symlink(os.path.abspath(os.path.join(PROJECT, "tests")), os.path.join(work, "tests"))
            prepare = os.path.join(here, "prepare.sh")
            if os.path.exists(prepare):
                path = os.path.dirname(os.path.abspath(arguments.new)) + ":" + environment["PATH"]
                subprocess.run(["bash", prepare], cwd=here, env=dict(environment, PATH=path), check=True,
                               capture_output=True)
            for deck in sorted(os.listdir(here)):
                if not deck.endswith((".xml", ".yaml")) or deck.startswith("study"):
                    continue
                seconds, status = {}, {}
                for which, program in (("old", arguments.old), ("new", arguments.new)):
                    begin = time.time()
                    status[which] = subprocess.run(
                        [os.path.abspath(program), "run", deck, "-o", which, "--quiet"], cwd=here,
                        env=environment, capture_output=True, timeout=arguments.limit).returncode
                    seconds[which] = time.time() - begin
                name = f"{os.path.basename(folder)}/{deck}"
                if status["old"] or status["new"]:
                    verdict = f"exit {status['old']} and {status['new']}"
                    differing += 1  # what does not run is not compared
                elif not os.path.exists(os.path.join(here, "old", "history.csv")):
                    verdict = "writes no history"
                else:
                    found = difference(history(os.path.join(here, "old")), history(os.path.join(here, "new")))
                    verdict = found or "same bits"
                    differing += found is not None
                print(f"{name:45s} {verdict:40s} {seconds['old']:.1f} s, {seconds['new']:.1f} s", flush=True)
    return 1 if differing else 0


if __name__ == "__main__":
    sys.exit(main())
