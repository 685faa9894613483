#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Kills runs at random moments, lets them go on, and compares them with undisturbed ones.

    kills.py STROMA [--count 40] [--seed 1] [--first 0] [--keep DIR]

Every run has two ranks. It is ended by SIGKILL of one rank, SIGKILL of all, or SIGTERM to mpirun; every other run
while a file of results is being written. What it left must be whole: each row of history.csv, each step of particles.e
and grid.e. It then goes on, on 1, 2 or 3 ranks, as often as it takes. The final history must equal that of a run which
nobody disturbed to 1e-10 of the largest value of each column, and, on a grid that is not reset, to the last bit on the same ranks. Prints a line for
each run and a tally; exit status 1 if anything was lost.
"""
import argparse
import csv
import glob
import os
import random
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time

MPIRUN = ["mpirun", "--oversubscribe"]
SAME_PATH = ("wall_seconds",)
OTHER_RANKS = ("wall_seconds", "linear_iterations", "newton_iterations", "residual")

DECKS = {  # name: (grid, what is changed of the gel, steps)
    "linear": ("{Element Size [um]: [2, 2, 2]}", "", 8),
    "reset": ("{Element Size [um]: [2, 2, 2], Reset: true}", "", 6),
    "viscous": ("{Element Size [um]: [2, 2, 2]}", "viscous", 8),
    "viscous_reset": ("{Element Size [um]: [2, 2, 2], Reset: true, Shape Functions: CPDI}", "viscous", 5),
    "splines_reset": ("{Element Size [um]: [2, 2, 2], Reset: true, Shape Functions: Quadratic B-Spline}", "", 4),
    "gimp": ("{Element Size [um]: [2, 2, 2], Shape Functions: GIMP}", "", 5),
}


def deck(name, size):
    grid, law, steps = DECKS[name]
    viscosity = "\n      Viscosity: {Moduli: [0.6, 0.3], 'Relaxation Times [s]': [0.5, 5]}" if law == "viscous" else ""
    return f"""Stroma:
  Title: {name}
  Image:
    Phantom: {{Kind: Vessels, Size: [{size}, {size}, {size}], 'Voxel Size [um]': [1.0, 1.0, 1.0], Volume Fraction: 0.2}}
  Materials:
    gel:
      Label: 0
      Model: Mooney-Rivlin
      'C1 [Pa]': 200
      'C2 [Pa]': 60
      Poisson Ratio: 0.4{viscosity}
    vessel: {{Label: 1, Model: Neo-Hookean, 'Shear Modulus [Pa]': 1041.6, Poisson Ratio: 0.4}}
  Grid: {grid.replace("Element Size [um]", "'Element Size [um]'")}
  Boundary Conditions:
    bottom: {{Face: y-, Components: xyz, 'Displacement [um]': [0, 0, 0]}}
    top: {{Face: y+, Components: xyz, Strain: 0.1}}
  Loading: {{'Duration [s]': 2.0, Steps: {steps}}}
  Solver: {{Newton Tolerance: 1.0e-12}}
  Output: {{Checkpoint Every: 1, Pictures: false}}
"""


def history(path):
    """Names and whole rows of a history.csv."""
    with open(path) as file:
        lines = file.read().split("\n")
    rows = [[float(number) for number in row] for row in csv.reader(lines[1:-1])]
    return next(csv.reader(lines[:1])), rows


def difference(one, other, left_out):
    """The largest difference of two histories, of the largest value of each column, or of the largest force."""
    names, rows = history(one)
    others, other_rows = history(other)
    if names != others or len(rows) != len(other_rows):
        return float("inf")
    worst = 0.0
    force = max(abs(row[column]) for row in rows for column, name in enumerate(names) if ".reaction_" in name)
    for column, name in enumerate(names):
        if name in left_out:
            continue
        scale = force if ".reaction_" in name else max(abs(row[column]) for row in rows) or 1.0
        worst = max([worst] + [abs(a[column] - b[column]) / scale for a, b in zip(rows, other_rows)])
    return worst


class ClassicFile:
    """The head of a netCDF file with 64-bit offsets, and its times. Raises when the file is not whole."""

    def __init__(self, path):
        with open(path, "rb") as file:
            self.data = file.read()
        assert self.data[:4] == b"CDF\x02", f"{path} is no CDF-2 file"
        self.at = 4
        self.steps = self.number()
        self.list_of(self.dimension)
        self.list_of(self.attribute)
        self.dimensions_unlimited = [i for i, length in enumerate(self.lengths) if length == 0]
        variables = self.list_of(self.variable)
        records = [v for v in variables if v["dimensions"] and v["dimensions"][0] in self.dimensions_unlimited]
        record = sum(v["size"] for v in records)
        first = min(v["begin"] for v in records)
        # The last variable's padding may not have been written.
        assert self.steps == 0 or len(self.data) >= first + self.steps * record - 3, f"{path} ends within a step"
        place = next(v["begin"] for v in records if v["name"] == "time_whole")
        self.times = [struct.unpack_from(">d", self.data, place + s * record)[0] for s in range(self.steps)]

    lengths = ()

    def number(self, kind=">i"):
        value = struct.unpack_from(kind, self.data, self.at)[0]
        self.at += struct.calcsize(kind)
        return value

    def name(self):
        length = self.number()
        text = self.data[self.at:self.at + length].decode()
        self.at += (length + 3) // 4 * 4
        return text

    def list_of(self, entry):
        self.number()  # its tag
        return [entry() for _ in range(self.number())]

    def dimension(self):
        self.name()
        self.lengths = (*self.lengths, self.number())

    def attribute(self):
        self.name()
        size = {1: 1, 2: 1, 3: 2, 4: 4, 5: 4, 6: 8}[self.number()]
        count = self.number()
        self.at += (size * count + 3) // 4 * 4

    def variable(self):
        name = self.name()
        dimensions = [self.number() for _ in range(self.number())]
        self.list_of(self.attribute)
        self.number()
        return {"name": name, "dimensions": dimensions, "size": self.number(), "begin": self.number(">q")}


def check_whole(folder, times):
    """Whether what a killed run left can be read, and holds nothing but accepted steps."""
    for path in glob.glob(f"{folder}/*.e") + glob.glob(f"{folder}/*.e[.-]*"):
        if os.path.getsize(path) == 0 or os.path.getmtime(path) == 0:
            continue
        try:
            found = ClassicFile(path).times
        except (AssertionError, ValueError, struct.error, IndexError) as problem:
            if not times:  # killed while it was made
                continue
            return f"{os.path.basename(path)}: {problem}"
        for one in found:
            if min((abs(one - t) for t in times), default=1.0) > 1e-12:
                return f"{os.path.basename(path)} holds a step at {one}, which is none of the run's"
    return ""


def marks(folder):
    found = {}
    for entry in os.scandir(folder) if os.path.isdir(folder) else []:
        if entry.name.endswith((".new", ".e.2.0", ".e.2.1")) or ".e-s" in entry.name:
            try:
                found[entry.name] = entry.stat().st_mtime_ns
            except OSError:
                pass
    return found


def ranks_of(mpirun):
    with open(f"/proc/{mpirun}/task/{mpirun}/children") as file:
        return [int(pid) for pid in file.read().split()]


def disturb(command, folder, kind, while_writing, chance, usual):
    """Starts a run and ends it. Returns its exit status."""
    run = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    begin = time.time()
    after = usual * chance.uniform(0.1, 0.95)
    while run.poll() is None and time.time() < begin + after:
        time.sleep(0.002)
    if while_writing:
        before = marks(folder)
        while run.poll() is None and marks(folder) == before:
            pass
        time.sleep(chance.uniform(0.0, 0.004))
    if run.poll() is None:
        try:
            if kind == "SIGTERM":
                run.terminate()
            else:
                ranks = ranks_of(run.pid)
                for pid in ranks if kind == "all" else ranks[-1:]:
                    os.kill(pid, signal.SIGKILL)
        except (OSError, IndexError):
            pass
    return run.wait(timeout=120)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("stroma")
    parser.add_argument("--count", type=int, default=40)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--size", type=int, default=24, help="voxels along each axis")
    parser.add_argument("--keep", help="folder for what went wrong")
    options = parser.parse_args()
    os.environ.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1", OMP_NUM_THREADS="1")
    work = tempfile.mkdtemp(prefix="stroma_kills_")
    tally = {"begun anew": 0, "bits": 0, "to 1e-10": 0, "faults": 0}
    worst = 0.0
    whole = {}
    for name in DECKS:
        path = f"{work}/{name}.yaml"
        with open(path, "w") as file:
            file.write(deck(name, options.size))
        begin = time.time()
        subprocess.run([*MPIRUN, "-np", "2", options.stroma, "run", path, "-o", f"{work}/{name}", "--quiet"], check=True)
        whole[name] = time.time() - begin
    for number in range(options.first, options.first + options.count):
        chance = random.Random(f"{options.seed}/{number}")
        name = list(DECKS)[number % len(DECKS)]
        kind = chance.choice(["one", "all", "SIGTERM"])
        while_writing = number % 2 == 0
        folder = f"{work}/run{number}"
        base = [options.stroma, "run", f"{work}/{name}.yaml", "-o", folder, "--quiet"]
        command = [*MPIRUN, "-np", "2", *base]
        what, same_path, fault = "", True, ""
        status = disturb(command, folder, kind, while_writing, chance, whole[name])
        try:
            times = [row[2] for row in history(f"{folder}/history.csv")[1]]
        except (OSError, StopIteration):
            times = []
        fault = check_whole(folder, times) if status != 0 else ""
        if status != 0 and not fault:
            ranks = chance.choice([1, 2, 3])
            go_on = [*MPIRUN, "-np", str(ranks), *base]
            if os.path.exists(f"{folder}/checkpoint.h5"):
                go_on.append("--restart")
                what = f"on {ranks}"
            else:
                what = f"anew on {ranks}"
                tally["begun anew"] += 1
            same_path = ranks == 2 and "reset" not in name
            done = subprocess.run(go_on, capture_output=True, text=True, timeout=600)
            if done.returncode != 0:
                fault = f"exit {done.returncode} on {ranks} ranks: {done.stderr.strip()[:500]}"
        if not fault:
            fault = check_whole(folder, [row[2] for row in history(f"{folder}/history.csv")[1]])
        apart = 0.0
        if not fault:
            apart = difference(f"{work}/{name}/history.csv", f"{folder}/history.csv",
                               SAME_PATH if same_path else OTHER_RANKS)
            worst = max(worst, apart)
            if apart > (0.0 if same_path else 1e-10):
                fault = f"history differs by {apart:.1e}"
            elif apart == 0.0:
                tally["bits"] += 1
            else:
                tally["to 1e-10"] += 1
        tally["faults"] += bool(fault)
        print(f"{number:3d} {name:14s} {kind:8s} {'writing' if while_writing else 'working'} exit {status:4d} "
              f"steps {max(len(times) - 1, 0)} {what:12s} {apart:.1e} {fault}", flush=True)
        if fault and options.keep:
            shutil.copytree(folder, f"{options.keep}/run{number}", dirs_exist_ok=True)
        shutil.rmtree(folder, ignore_errors=True)
    print(f"seed {options.seed}: {options.count} runs, " + ", ".join(f"{n} {what}" for what, n in tally.items())
          + f"; largest difference {worst:.1e}")
    shutil.rmtree(work)
    return 1 if tally["faults"] else 0


if __name__ == "__main__":
    sys.exit(main())
