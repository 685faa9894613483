#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Random sponges by default settings: do they run, with what force, in how many iterations?

    python3 tests/endurance/sponges.py build/release/bin/stroma [--count 50] [--seed 1] [--work FOLDER]

Each sponge is Gaussian noise, smoothed over 1.6 voxels and cut at a quantile, so that 20 to 50 % of
the voxels are solid: struts of one or two voxels, elements of 2 x 2 x 2 voxels with a single
particle. Two thirds keep only their largest piece (6-connected), one third keeps its fragments. The
bottom is held, the top pulled by 0.1 %. Small ones (up to 32 voxels) are solved again by Direct
without stabilisation, where that finds an answer. A row of the table for each, then a tally.
Needs python3 and numpy; the same seed makes the same sponges.
"""
import argparse
import os
import re
import subprocess
import sys
import time

import numpy as np

DECK = """Stroma:
  Image:
    File: sponge.nrrd
    Segmentation:
      Method: Labels
  Materials:
    bone:
      Label: 0
      Shear Modulus [Pa]: 1000000000
      Poisson Ratio: 0.3
  Grid:
    Elements: [{n}, {n}, {n}]
  Boundary Conditions:
    bottom:
      Face: z-
      Components: xyz
    top:
      Face: z+
      Components: xyz
      Strain: 0.001
  Loading:
    Steps: 1
  Output:
    Pictures: false
"""


def smoothed(values, sigma):
    reach = int(4 * sigma + 0.5)
    kernel = np.exp(-0.5 * (np.arange(-reach, reach + 1) / sigma) ** 2)
    kernel /= kernel.sum()
    for axis in range(3):
        padded = np.pad(values, [(reach, reach) if a == axis else (0, 0) for a in range(3)], "symmetric")
        values = sum(w * np.take(padded, np.arange(m, m + values.shape[axis]), axis)
                     for m, w in enumerate(kernel))
    return values


def largest_piece(solid):
    """The largest face-connected piece, by the least number that reaches each voxel."""
    number = np.where(solid, np.arange(1, solid.size + 1).reshape(solid.shape), 0)
    while True:
        before = number.copy()
        for axis in range(3):
            for flip in (False, True):
                a = np.moveaxis(np.flip(number, axis) if flip else number, axis, 0)
                for i in range(1, a.shape[0]):  # sweeps carry a number along a whole line
                    both = (a[i] > 0) & (a[i - 1] > a[i])
                    a[i][both] = a[i - 1][both]
        if np.array_equal(before, number):
            break
    counts = np.bincount(number[solid])
    return number == np.argmax(counts)


def sponge(rng, size, share, keeps_fragments):
    """Solid voxels [z, y, x] of a sponge whose largest piece reaches from grip to grip."""
    while True:
        noise = smoothed(rng.standard_normal((size, size, size)), 1.6)
        solid = noise > np.quantile(noise, 1.0 - share)
        piece = largest_piece(solid)
        if piece[0].any() and piece[-1].any() and piece.mean() > 0.9 * share:
            return solid if keeps_fragments else piece


def write_nrrd(path, solid):
    size = solid.shape[0]
    with open(path, "wb") as file:
        file.write((f"NRRD0004\ntype: int8\ndimension: 3\nsizes: {size} {size} {size}\n"
                    "spacings: 60 60 60\nspace units: \"um\" \"um\" \"um\"\nencoding: raw\n\n")
                   .replace("space units", "units").encode())
        file.write(np.where(solid, 0, -1).astype(np.int8).tobytes())


class Run:
    def __init__(self, stroma, folder, name, ranks, settings, limit):
        out = os.path.join(folder, name)
        command = [stroma, "run", os.path.join(folder, "deck.yaml"), "-o", out]
        for setting in settings:
            command += ["--set", setting]
        if ranks > 1:
            command = ["mpirun", "--oversubscribe", "-np", str(ranks)] + command
        environment = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                           OMP_NUM_THREADS="1", OMPI_MCA_hwloc_base_binding_policy="none")
        begin = time.time()
        try:
            done = subprocess.run(command, capture_output=True, text=True, timeout=limit, env=environment)
            self.status, text = done.returncode, done.stdout + done.stderr
        except subprocess.TimeoutExpired:
            self.status, text = -1, ""
        self.seconds = time.time() - begin
        self.text = text
        self.force = None
        if self.status == 0:
            with open(os.path.join(out, "history.csv")) as file:
                rows = [line.strip().split(",") for line in file]
            column = rows[0].index("top.reaction_z")
            self.force = float(rows[-1][column])
        # The log counts the linear iterations of a step; a solve's are what it adds.
        counts = [int(n) for n in re.findall(r"Newton +\d+ .* (\d+) linear iterations", text)]
        self.solves = [n - (counts[i - 1] if i else 0) for i, n in enumerate(counts)]
        self.rejected = text.count(" rejected: ")
        share = re.search(r"Stabilization adds ([-0-9.e+]+)", text)
        self.stated = float(share.group(1)) if share else None


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("stroma")
    parser.add_argument("--count", type=int, default=50)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--first", type=int, default=0, help="number of the first sponge to run")
    parser.add_argument("--largest", type=int, default=96, help="voxels along an edge, at most")
    parser.add_argument("--direct", type=int, default=32, help="largest edge that Direct is tried on")
    parser.add_argument("--work", default="sponges")
    arguments = parser.parse_args()
    stroma = os.path.abspath(arguments.stroma)
    print("  no  voxels  solid  pieces  ranks | status rejected  largest solve  seconds |"
          " stated    measured against Direct")
    runs = failures = compared = 0
    departures, most, above = [], [], 0
    for number in range(arguments.first, arguments.count):
        rng = np.random.default_rng([arguments.seed, number])
        size = [24, 24, 24, 32, 24, 40, 32, 24, 48, 64][number % 10]
        if number % 20 == 19:
            size = 96
        size = min(size, arguments.largest)
        keeps, ranks = number % 3 == 2, 1 + number % 2
        solid = sponge(rng, size, rng.uniform(0.2, 0.5), keeps)
        folder = os.path.join(arguments.work, f"{number:03d}")
        os.makedirs(folder, exist_ok=True)
        write_nrrd(os.path.join(folder, "sponge.nrrd"), solid)
        with open(os.path.join(folder, "deck.yaml"), "w") as file:
            file.write(DECK.format(n=size // 2))
        run = Run(stroma, folder, "default", ranks, [], 900)
        runs += 1
        failures += run.status != 0
        largest = max(run.solves) if run.solves else 0
        most.append(largest)
        above += largest > 40
        against = "-"
        if size <= arguments.direct and run.status == 0:
            direct = Run(stroma, folder, "direct", 1,
                         ["Grid|Stabilization=0", "Solver|Preconditioner=Direct"], 300)
            if direct.status == 0:
                departure = run.force / direct.force - 1.0
                compared += 1
                departures.append(abs(departure))
                against = f"{departure:9.1e}"
            else:
                against = "Direct finds none"
        stated = "-" if run.stated is None else f"{run.stated:8.1e}"
        print(f"{number:4d} {size:5d}^3   {solid.mean():.2f}  {'all' if keeps else 'one':>5}  {ranks:4d}   |"
              f" {run.status:4d} {run.rejected:6d} {largest:12d} {run.seconds:11.1f}   | {stated}  {against}",
              flush=True)
        if run.status != 0:
            print("       " + run.text.strip().split("\n")[-1][:150])
    print(f"{runs} sponges, {runs - failures} run by default; largest solve {max(most)} iterations, "
          f"{above} above 40; {compared} compared to Direct"
          + (f", largest departure {max(departures):.1e}, {sum(d > 1e-3 for d in departures)} above 1e-3"
             if departures else ""))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
