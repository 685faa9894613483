# SPDX-License-Identifier: BSD-3-Clause
"""Writes the small MetaImage, NRRD and NIfTI images of this folder, from which mutate_images.py starts."""
import bz2
import os
import struct
import zlib

os.chdir(os.path.dirname(os.path.abspath(__file__)))
SIZE = (6, 5, 4)
VALUES = [20 if y + 2 * z < 5 else 200 for z in range(4) for y in range(5) for x in range(6)]
U8 = bytes(VALUES)
U16 = struct.pack("<120H", *(17 * v for v in VALUES))


def write(name, *parts):
    folder = os.path.dirname(name)
    if folder:
        os.makedirs(folder, exist_ok=True)
    with open(name, "wb") as file:
        for part in parts:
            file.write(part.encode() if isinstance(part, str) else part)


def meta(type_name, file, more=""):
    return (f"ObjectType = Image\nNDims = 3\n{more}ElementSpacing = 1 1 2\nDistanceUnits = um\n"
            f"DimSize = 6 5 4\nElementType = {type_name}\nElementDataFile = {file}\n")


def nrrd(type_name, encoding, more=""):
    return (f"NRRD0005\ntype: {type_name}\ndimension: 3\nsizes: 6 5 4\nencoding: {encoding}\nendian: little\n"
            f"spacings: 1 1 2\nunits: \"um\" \"um\" \"um\"\n{more}")


def gzip(data):
    packer = zlib.compressobj(9, zlib.DEFLATED, 31)
    return packer.compress(data) + packer.flush()


def nifti1(offset=352, magic=b"n+1", slope=0.0):
    head = bytearray(352)
    struct.pack_into("<i", head, 0, 348)
    struct.pack_into("<8h", head, 40, 3, 6, 5, 4, 1, 1, 1, 1)
    struct.pack_into("<2h", head, 70, 512, 16)
    struct.pack_into("<8f", head, 76, 1, 1, 1, 2, 0, 0, 0, 0)
    struct.pack_into("<3f", head, 108, offset, slope, 1.5)
    head[123] = 3
    struct.pack_into("<2h", head, 252, 1, 1)
    struct.pack_into("<12f", head, 280, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 2, 0)
    head[344:347] = magic
    return bytes(head)


def nifti2():
    head = bytearray(544)
    struct.pack_into(">i", head, 0, 540)
    head[4:12] = b"n+2\0\r\n\x1a\n"
    struct.pack_into(">2h8q", head, 12, 2, 8, 3, 6, 5, 4, 1, 1, 1, 1)
    struct.pack_into(">8d", head, 104, 1, 1, 1, 2, 0, 0, 0, 0)
    struct.pack_into(">q2d", head, 168, 544, 0.5, -3)
    struct.pack_into(">i", head, 500, 3)
    return bytes(head)


write("raw.mha", meta("MET_USHORT", "LOCAL", "BinaryDataByteOrderMSB = False\n"), U16)
write("packed.mha", meta("MET_UCHAR", "LOCAL", "CompressedData = True\n"), zlib.compress(U8))
write("text.mha", meta("MET_UCHAR", "LOCAL", "BinaryData = False\n"), " ".join(map(str, VALUES)) + "\n")
write("slices_mhd/header.mhd", meta("MET_UCHAR", "s%d.raw 1 4 1"))
for z in range(4):
    write(f"slices_mhd/s{z + 1}.raw", U8[30 * z:30 * z + 30])
write("raw.nrrd", nrrd("uint16", "raw"), "\n", U16)
write("text.nrrd", nrrd("uchar", "ascii"), "\n", "\n".join(map(str, VALUES)) + "\n")
write("gzip.nrrd", nrrd("uint16", "gzip"), "\n", gzip(U16))
write("bzip2.nrrd", nrrd("uint8", "bzip2", "kinds: domain domain domain\n"), "\n", bz2.compress(U8))
write("list_nhdr/header.nhdr", nrrd("uint8", "raw", "data file: LIST\n"), "".join(f"n{z}.raw\n" for z in range(4)))
for z in range(4):
    write(f"list_nhdr/n{z}.raw", U8[30 * z:30 * z + 30])
write("one.nii", nifti1(), U16)
write("slope.nii.gz", gzip(nifti1(slope=0.25) + U16))
write("two.nii", nifti2(), U8)
write("pair_hdr/header.hdr", nifti1(offset=0, magic=b"ni1"))
write("pair_hdr/header.img", U16)
