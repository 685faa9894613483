#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the HDF5 seeds of mutate_images.py beside itself (python3-h5py, python3-numpy of Debian)."""
import json
import pathlib

import h5py
import numpy as np

folder = pathlib.Path(__file__).parent
z, y, x = np.indices((6, 10, 14))
grey = (x + 14 * y + 140 * z).astype("u2")
mask = (x - 6) ** 2 + (y - 5) ** 2 + (z - 3) ** 2 < 12


def axistags(keys):
    axes = [{"key": key, "typeFlags": 2, "resolution": 0, "description": ""} for key in keys]
    return json.dumps({"axes": axes})


def letters(text):
    return np.array([c.encode() for c in text], "S1")


with h5py.File(folder / "plain.h5", "w") as file:
    file.create_dataset("raw", data=grey).attrs["element_size_um"] = [2.0, 0.5, 0.5]

with h5py.File(folder / "latest.h5", "w", libver="latest") as file:
    file.create_dataset("raw", data=grey, chunks=(3, 5, 7)).attrs["element_size_um"] = [2.0, 0.5, 0.5]

with h5py.File(folder / "chunked.h5", "w") as file:
    filters = {"compression": "gzip", "shuffle": True, "fletcher32": True}
    file.create_dataset("mask", data=mask, chunks=(3, 5, 7), **filters)

with h5py.File(folder / "ilastik.h5", "w") as file:
    data = np.stack([grey, grey + 1], axis=-1)[None]
    dataset = file.create_dataset("exported_data", data=data, chunks=(1, 3, 5, 7, 2), compression="gzip")
    dataset.attrs["axistags"] = axistags("tzyxc")

with h5py.File(folder / "imaris.ims", "w") as file:
    group = file.create_group("DataSet/ResolutionLevel 0/TimePoint 0/Channel 0")
    group.create_dataset("Data", data=np.pad(grey, ((0, 2), (0, 6), (0, 2))), chunks=(8, 16, 16), compression="gzip")
    for axis, size in zip("XYZ", ("14", "10", "6")):
        group.attrs["ImageSize" + axis] = letters(size)
    info = file.create_group("DataSetInfo/Image")
    for axis, end in enumerate(("7", "2.5", "12")):
        info.attrs[f"ExtMin{axis}"] = letters("0")
        info.attrs[f"ExtMax{axis}"] = letters(end)
    info.attrs["Unit"] = letters("um")

with h5py.File(folder / "view.h5", "w") as file:
    file.create_dataset("t00000/s00/0/cells", data=(grey + 40000).view("i2"), chunks=(3, 5, 7), compression="gzip")
    file.create_dataset("s00/resolutions", data=[[1.0, 1.0, 1.0]])
(folder / "view.xml").write_text(
    "<SpimData><SequenceDescription><ViewSetups><ViewSetup><id>0</id><voxelSize><unit>micron</unit>"
    "<size>0.5 0.5 2.0</size></voxelSize></ViewSetup></ViewSetups></SequenceDescription></SpimData>\n"
)
