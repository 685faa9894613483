#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A BigTIFF beyond 4 GB, written by benchmark_big_stack on 1 or 2 ranks, and read back with tifffile and by the program itself.
Takes 5 GB of disk for a minute.

    big_tiff.py BUILD_FOLDER [RANKS]
"""
import os
import subprocess
import sys
import tempfile
import time

import numpy as np
import tifffile

SIZE, CHANNELS = (2048, 1536, 90), 4  # 4.53 GB


def plane(z, channel):
    x, y = np.arange(SIZE[0]), np.arange(SIZE[1])
    return (x[None, :] + 31 * y[:, None] + 1009 * z + 100003 * channel) % 2**24


def main():
    build, ranks = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 1
    with tempfile.TemporaryDirectory() as folder:
        path = f"{folder}/big.ome.tif"
        start = time.time()
        subprocess.run(["mpirun", "--oversubscribe", "-np", str(ranks), f"{build}/tests/benchmark_big_stack", path, *map(str, SIZE), str(CHANNELS)], check=True)
        print(f"{os.path.getsize(path) / 1e9:.2f} GB, written in {time.time() - start:.1f} s on {ranks} rank(s)")
        with tifffile.TiffFile(path) as file:
            assert file.is_bigtiff and file.is_ome and file.is_imagej
            series = file.series[0]
            assert series.axes == "ZCYX" and series.shape == (SIZE[2], CHANNELS, SIZE[1], SIZE[0]), (series.axes, series.shape)
            beyond = 0
            for n, page in enumerate(file.pages):
                z, channel = divmod(n, CHANNELS)
                np.testing.assert_array_equal(page.asarray(), plane(z, channel), err_msg=f"page {n}")
                beyond += page.dataoffsets[0] > 2**32
        print(f"tifffile: {SIZE[2] * CHANNELS} pages are as written, {beyond} of them beyond 4 GiB")
        assert beyond > 0
        print(subprocess.run([f"{build}/bin/stroma", "image", path], check=True, capture_output=True, text=True).stdout)


main()
