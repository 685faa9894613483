# SPDX-License-Identifier: BSD-3-Clause
"""Draws rigs.png: what each rig holds and moves, seen along z. /usr/bin/python3 docs/pictures/rigs.py"""

from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.patches import Circle, Polygon, Rectangle

GEL, HELD, MOVED = "#dfe9f3", "#555555", "#c0392b"


def plate(axes, side, color, rollers):
    """A plate along a side of the unit square: clamped (hatched) or on rollers."""
    gap, thick = (0.1 if rollers else 0.0), 0.1
    box = {"y-": (0, -gap - thick, 1, thick), "y+": (0, 1 + gap, 1, thick), "x-": (-gap - thick, 0, thick, 1), "x+": (1 + gap, 0, thick, 1)}[side]
    axes.add_patch(Rectangle(box[:2], box[2], box[3], facecolor="white", edgecolor=color, hatch="////", linewidth=1))
    for n in range(5 if rollers else 0):
        along, across = 0.1 + 0.2 * n, {"-": -0.05, "+": 1.05}[side[1]]
        axes.add_patch(Circle((along, across) if side[0] == "y" else (across, along), 0.05, facecolor="white", edgecolor=color))


def arrow(axes, start, end):
    axes.annotate("", end, start, arrowprops={"arrowstyle": "-|>", "color": MOVED, "linewidth": 1.8})


def draw(axes, name, plates, arrows, shape=None):
    axes.add_patch(Polygon([(0, 0), (1, 0), (1, 1), (0, 1)], facecolor=GEL, edgecolor="#8aa2b8"))
    if shape:
        axes.add_patch(Polygon(shape, fill=False, edgecolor=MOVED, linestyle="--"))
    for side, color, rollers in plates:
        plate(axes, side, color, rollers)
    for one in arrows:
        arrow(axes, *one)
    axes.set_title(name, fontsize=9)
    axes.set(xlim=(-0.45, 1.65), ylim=(-0.45, 1.65), aspect="equal")
    axes.axis("off")


def main():
    figure, all_axes = plt.subplots(2, 4, figsize=(9, 5))
    bottom, top = ("y-", HELD, False), ("y+", MOVED, False)
    rolling_bottom, rolling_top = ("y-", HELD, True), ("y+", MOVED, True)
    walls = [("x-", HELD, True), ("x+", HELD, True)]
    up, down = ((0.5, 1.22), (0.5, 1.6)), ((0.5, 1.6), (0.5, 1.22))
    rigs = [
        ("Clamped Extension", [bottom, top], [up]),
        ("Roller Extension", [rolling_bottom, rolling_top], [up]),
        ("Confined Compression", [rolling_bottom, rolling_top, *walls], [down]),
        ("Unconfined Compression", [rolling_bottom, rolling_top], [down]),
        ("Simple Shear", [bottom, top], [((0.3, 1.3), (0.8, 1.3))], [(0, 0), (1, 0), (1.25, 1), (0.25, 1)]),
        ("Biaxial", [rolling_bottom, rolling_top, ("x-", HELD, True), ("x+", MOVED, True)], [up, ((1.22, 0.5), (1.6, 0.5))]),
        ("Torsion", [bottom, top], []),
    ]
    for axes, rig in zip(all_axes.flat, rigs):
        draw(axes, *rig)
    twist = all_axes.flat[6]
    twist.annotate("", (0.75, 1.27), (0.25, 1.27), arrowprops={"arrowstyle": "-|>", "color": MOVED, "linewidth": 1.8, "connectionstyle": "arc3,rad=0.6"})
    twist.plot([0.5, 0.5], [-0.3, 1.55], color=HELD, linestyle="-.", linewidth=0.8)
    all_axes.flat[7].axis("off")
    figure.tight_layout()
    figure.savefig(Path(__file__).with_name("rigs.png"), dpi=110)


if __name__ == "__main__":
    main()
