#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""How far does a contracting cell reach? Draws decay.png: displacement towards the cell's centre against the distance from
it, of one or several runs, and prints the exponent n of u ~ r^-n between two and four radii of the cell.

    python3 decay.py LABEL=RUN/particles.e [LABEL=RUN/particles.e ...]

Needs h5py, numpy and matplotlib (python3-h5py, python3-matplotlib).
"""
import sys

import h5py
import matplotlib
import numpy

matplotlib.use("Agg")
import matplotlib.pyplot as plot

RADIUS = 10.0  # of the cell, whose centre is the origin [um]


def displacement(path):
    """Distance from the cell and displacement towards it [um], of every particle, at the last step."""
    with h5py.File(path, "r") as file:
        x = numpy.array([file["coord" + axis][:] for axis in "xyz"])
        u = numpy.array([file[f"vals_nod_var{n}"][-1] for n in (1, 2, 3)])  # displacement_x, _y, _z
    r = numpy.sqrt((x ** 2).sum(axis=0))
    return r, -(u * x).sum(axis=0) / r


def mean_by_distance(r, u, edges):
    which = numpy.digitize(r, edges)
    return numpy.array([u[which == n].mean() for n in range(1, len(edges))])


figure, axes = plot.subplots(figsize=(5, 4))
for argument in sys.argv[1:]:
    label, path = argument.split("=", 1)
    r, u = displacement(path)
    edges = numpy.geomspace(RADIUS, 7 * RADIUS, 16)
    middle = numpy.sqrt(edges[1:] * edges[:-1])
    mean = mean_by_distance(r, u, edges)
    near = (middle > 2 * RADIUS) & (middle < 4 * RADIUS)
    n = -numpy.polyfit(numpy.log(middle[near]), numpy.log(mean[near]), 1)[0]
    print(f"{label}: u = {mean[0]:.3g} um at the cell, {numpy.interp(4 * RADIUS, middle, mean):.3g} um at four radii; "
          f"u ~ r^-{n:.2f} between two and four radii")
    axes.loglog(middle / RADIUS, mean / mean[0], "o-", label=f"{label}, n = {n:.2f}")
axes.set_xlabel("distance from the cell's centre / its radius")
axes.set_ylabel("displacement / that at the cell")
axes.legend()
axes.grid(True, which="both", alpha=0.3)
figure.tight_layout()
figure.savefig("decay.png", dpi=120)
