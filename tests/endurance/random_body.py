# SPDX-License-Identifier: BSD-3-Clause
"""A random specimen: phantoms of every kind, and an image file that is written for it."""
import struct

from random_materials import three_digits


def phantom(r, size, voxel, is_plane):
    """(image section, labels in it, bytes of body.nrrd)"""
    kind = r.choice(["Uniform", "Shapes"] if is_plane else ["Uniform", "Vessels", "Shapes", "Shapes", "File"])
    edges = [n * h for n, h in zip(size, voxel)]
    if kind == "File":
        section = {"File": "body.nrrd", "Segmentation": {"Method": r.choice(["Threshold", "Otsu"])}}
        if section["Segmentation"]["Method"] == "Threshold":
            section["Segmentation"]["Threshold"] = 128
        return section, 2, nrrd(r, size, voxel)
    section = {"Kind": kind, "Size": size, "Voxel Size [um]": voxel}
    if kind == "Vessels":
        section.update({"Volume Fraction": three_digits(r.uniform(0.1, 0.3)), "Seed": r.randint(1, 1000)})
    if kind == "Shapes":
        section["Shapes"] = {f"shape{n}": shape(r, edges, n) for n in range(r.randint(1, 3))}
    return {"Phantom": section}, 1 if kind == "Uniform" else 2, b""


def shape(r, edges, number):
    """Of label 1; a second or third may be a hole."""
    center = [three_digits(edge * r.uniform(0.3, 0.7)) for edge in edges]
    numbers = {"Kind": r.choice(["Ball", "Cylinder", "Box"]), "Center [um]": center,
               "Label": -1 if number > 0 and r.random() < 0.4 else 1}
    size = min(edges[:2])
    if numbers["Kind"] == "Box":
        numbers["Size [um]"] = [three_digits(edge * r.uniform(0.2, 0.5)) for edge in edges]
    else:
        numbers["Radius [um]"] = three_digits(size * r.uniform(0.15, 0.3))
    if numbers["Kind"] == "Cylinder":
        numbers["Axis"] = r.choice([[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 0.5]])
        if numbers["Label"] == -1:  # a channel through the body may cut it in two
            numbers["Length [um]"] = three_digits(size * 0.5)
    return numbers


def nrrd(r, size, voxel):
    """Intensities 0 to 255 that wander from voxel to voxel."""
    header = ("NRRD0004\ntype: uint8\ndimension: 3\nsizes: {} {} {}\nspacings: {} {} {}\nunits: \"um\" \"um\" \"um\"\n"
              "encoding: raw\n\n").format(*size, *voxel)
    value, values = 128.0, []
    for _ in range(size[0] * size[1] * size[2]):
        value = min(255.0, max(0.0, value + r.gauss(0, 40)))
        values.append(int(value))
    return header.encode() + struct.pack(f"{len(values)}B", *values)
