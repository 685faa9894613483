#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the sound TIFF and PIC files of this folder (numpy and tifffile; already here)."""
import struct

import numpy as np
import tifffile

a = (np.arange(4 * 6 * 8).reshape(4, 6, 8) % 251).astype("u1")
imagej = "ImageJ=1.53t\nimages=4\nslices=4\nunit=um\nspacing=2.0\n"


def write(name, data, **options):
    options = {"photometric": "minisblack", "metadata": None, **options}
    tifffile.imwrite(name, data, **options)


write("plain.tif", a.astype("u2"), byteorder=">")
write("big.tif", a.astype("i8"), bigtiff=True)
write("float16.tif", a.astype("f2"))
write("bits.tif", (a > 100).astype(bool))
write("palette.tif", a, photometric="palette", colormap=np.zeros((3, 256), "u2"))
write("tiles.tif", a, tile=(16, 16))
write("deflate.tif", a, compression="zlib", predictor=True)
write("volumetric.tif", np.resize(a, (16, 16, 16)), volumetric=True, tile=(16, 16, 16))
write("signed.tif", a.astype("u2"), resolution=(2, 2), resolutionunit="none",
      description=imagej + "cf=0\nc0=-32768.0\nc1=1.0\nvunit=Gray Value\n")
write("frames.tif", a, description="ImageJ=1.53t\nimages=4\nchannels=2\nslices=1\nframes=2\nhyperstack=true\n")
ome = ('<?xml version="1.0"?><OME xmlns="http://www.openmicroscopy.org/Schemas/OME/2016-06" UUID="urn:uuid:1"><Image>'
       '<Pixels DimensionOrder="XYCZT" Type="uint8" SizeX="8" SizeY="6" SizeZ="2" SizeC="1" SizeT="2" '
       'PhysicalSizeX="0.5" PhysicalSizeY="0.5" PhysicalSizeZ="2.0"><TiffData IFD="0" PlaneCount="4">'
       '<UUID FileName="frames.ome.tif">urn:uuid:1</UUID></TiffData></Pixels></Image></OME>')
write("frames.ome.tif", a, description=ome)


def directory(values, more):
    """A TIFF of one page of 8 x 6 bytes whose directory follows the values."""
    entries = {256: (4, 1, 8), 257: (4, 1, 6), 258: (4, 1, 8), 259: (4, 1, 1), 262: (4, 1, 1), 273: (4, 1, 8),
               277: (4, 1, 1), 278: (4, 1, 6), 279: (4, 1, 48), **more}
    start, behind = 8 + len(values), b""
    text = struct.pack("<H", len(entries))
    for tag, (kind, count, value) in sorted(entries.items()):
        if isinstance(value, bytes):
            at = start + 2 + 12 * len(entries) + 4 + len(behind)
            behind += value
            value = at
        text += struct.pack("<HHII", tag, kind, count, value)
    return b"II*\0" + struct.pack("<I", start) + values + text + struct.pack("<I", 0) + behind


values = a.tobytes()
at = 8 + len(values)
settings = struct.pack("<6I", 4, at, 5, at, 6, at + 8)
planes = b"".join(struct.pack("<6I", 3, 2, 0, 0, 0, 0) for _ in range(4))
with open("metamorph.stk", "wb") as f:
    f.write(directory(values + struct.pack("<3I", 1, 4, 3) + b"um\0\0",
                      {33628: (4, 3, settings), 33629: (5, 4, planes)}))
with open("zeiss.lsm", "wb") as f:
    zeiss = struct.pack("<2I8i3d", 0x0400494C, 100, 8, 6, 1, 1, 1, 1, 0, 0, 5e-7, 5e-7, 2e-6) + bytes(36)
    f.write(directory(values[:48], {34412: (1, len(zeiss), zeiss)}))
with open("stack.pic", "wb") as f:
    header = struct.pack("<3H", 8, 6, 4) + bytes(4) + struct.pack("<I", 1) + struct.pack("<H", 1)
    f.write(header.ljust(54, b"\0") + struct.pack("<H", 12345) + bytes(20) + values)
    for more, text in ((1, "AXIS_2 257 0.0 0.5 microns"), (1, "AXIS_3 257 0.0 0.5"), (0, "AXIS_4 257 0.0 2.0 um")):
        f.write(struct.pack("<HIIHH", 0, more, 0, 20, 0).ljust(16, b"\0") + text.encode().ljust(80, b"\0"))
