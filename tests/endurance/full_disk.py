#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs into a full disk, makes room, and goes on. As root, since it mounts a tmpfs of each size.

    full_disk.py STROMA [--kib 200 700 1500 ...]

Every run has two ranks. It must end with exit status 1, leave files that can be read, and go on (from its checkpoint,
where there was room for one) to the history of an undisturbed run. Prints a line for each size; exit status 1 if one
did not.
"""
import argparse
import os
import subprocess
import sys
import tempfile

from kills import MPIRUN, OTHER_RANKS, check_whole, deck, difference, history


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("stroma")
    parser.add_argument("--kib", type=int, nargs="+", default=[100, 200, 500, 700, 1500, 2500, 4000, 6000, 8000, 10000])
    options = parser.parse_args()
    os.environ.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1", OMP_NUM_THREADS="1")
    faults = 0
    with tempfile.TemporaryDirectory(prefix="stroma_full_") as work:
        path, disk = f"{work}/gel.yaml", f"{work}/disk"
        with open(path, "w") as file:
            file.write(deck("linear", 24))
        run = [*MPIRUN, "-np", "2", options.stroma, "run", path, "--quiet", "-o"]
        subprocess.run([*run, f"{work}/whole"], check=True)
        os.mkdir(disk)
        for kib in options.kib:
            subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={kib}k", "tmpfs", disk], check=True)
            try:
                full = subprocess.run([*run, f"{disk}/out"], capture_output=True, text=True, timeout=600)
                told = full.stderr.split("\n")[0]
                try:
                    times = [row[2] for row in history(f"{disk}/out/history.csv")[1]]
                except (OSError, StopIteration):
                    times = []
                fault = "" if full.returncode == 1 else f"exit {full.returncode} "
                fault += "" if "No space left on device" in told else "another message "
                fault += check_whole(f"{disk}/out", times)
                subprocess.run(["mount", "-o", "remount,size=1g", disk], check=True)
                goes_on = os.path.exists(f"{disk}/out/checkpoint.h5")
                again = subprocess.run([*run, f"{disk}/out"] + ["--restart"] * goes_on, capture_output=True, text=True)
                if again.returncode == 0:
                    apart = difference(f"{work}/whole/history.csv", f"{disk}/out/history.csv", OTHER_RANKS)
                    fault += check_whole(f"{disk}/out", [row[2] for row in history(f"{disk}/out/history.csv")[1]])
                else:
                    apart = float("inf")
                    fault += again.stderr[:300]
                if apart > 1e-10:
                    fault += " another history"
                print(f"{kib:6d} KiB: exit {full.returncode}, {max(len(times) - 1, 0)} steps, "
                      f"{'goes on' if goes_on else 'begins anew'}, {apart:.1e}: {told} {'FAULT: ' + fault if fault else ''}",
                      flush=True)
                faults += bool(fault)
            finally:
                subprocess.run(["umount", disk], check=True)
    print(f"{len(options.kib)} sizes, {faults} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
