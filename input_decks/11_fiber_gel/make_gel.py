#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws gel.nrrd: a stack of 96 x 96 x 24 voxels of 0.5 x 0.5 x 1 um in which collagen fibres are bright.

Fibres are curves that start anywhere and run at 30 degrees to x, with a spread of 12 degrees from fibre to fibre and a
slow turn along each; they are blurred as by a confocal microscope (0.4 um across, 0.8 um along z), and voxels are noisy.
The same picture each time. Takes a few seconds; needs nothing but Python.
"""
import gzip
import math
import random

NX, NY, NZ = 96, 96, 24
HX, HY, HZ = 0.5, 0.5, 1.0
ACROSS, ALONG_Z = 0.5, 0.9  # standard deviations of a fibre's picture [um]
STEP = 0.5  # between points of a fibre [um]


def points_of(fiber):
    """A fibre from one end of the stack to the other."""
    x, y, z = fiber.uniform(0, NX * HX), fiber.uniform(0, NY * HY), fiber.uniform(0, NZ * HZ)
    heading = math.radians(fiber.gauss(30, 12))
    tilt = math.radians(fiber.gauss(0, 5))
    turn = math.radians(fiber.gauss(0, 1))
    for sense in (1, -1):
        px, py, pz, angle = x, y, z, heading
        while -2 < px < NX * HX + 2 and -2 < py < NY * HY + 2 and -2 < pz < NZ * HZ + 2:
            yield px, py, pz
            px += sense * STEP * math.cos(angle) * math.cos(tilt)
            py += sense * STEP * math.sin(angle) * math.cos(tilt)
            pz += sense * STEP * math.sin(tilt)
            angle += sense * turn * STEP


def draw():
    image = [0.0] * (NX * NY * NZ)
    for number in range(170):
        for x, y, z in points_of(random.Random(number)):
            i0, j0, k0 = int(x / HX), int(y / HY), int(z / HZ)
            for k in range(max(k0 - 2, 0), min(k0 + 3, NZ)):
                dz = ((k + 0.5) * HZ - z) / ALONG_Z
                for j in range(max(j0 - 3, 0), min(j0 + 4, NY)):
                    dy = ((j + 0.5) * HY - y) / ACROSS
                    for i in range(max(i0 - 3, 0), min(i0 + 4, NX)):
                        dx = ((i + 0.5) * HX - x) / ACROSS
                        image[i + NX * (j + NY * k)] += math.exp(-0.5 * (dx * dx + dy * dy + dz * dz))
    noise = random.Random("noise")
    return bytes(min(255, max(0, round(20 + 55 * value + noise.gauss(0, 5)))) for value in image)


HEADER = f"""NRRD0004
type: unsigned char
dimension: 3
sizes: {NX} {NY} {NZ}
spacings: {HX} {HY} {HZ}
units: "um" "um" "um"
encoding: gzip

"""

with open("gel.nrrd", "wb") as file:
    file.write(HEADER.encode())
    file.write(gzip.compress(draw(), mtime=0))
