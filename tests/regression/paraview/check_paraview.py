#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What ParaView makes of the files of a run on 1 and 2 ranks, Exodus and VTKHDF, by the macro of the docs: times, names of blocks,
stress and volumes against history.csv, displacements against the load, pictures without a seam. Claims V-PARAVIEW-1 and -2,
docs/verification.md.

    check_paraview.py STROMA MACRO MPIRUN...
"""
import os
import shutil
import subprocess
import sys
import tempfile

STROMA, MACRO, MPIRUN = sys.argv[1], sys.argv[2], sys.argv[3:]
DECK = """
Stroma:
  Image:
    Phantom:
      Kind: Shapes
      Size: [24, 16, 24]
      Voxel Size [um]: [1.0, 1.5, 1.0]
      Shapes:
        vessel: {Kind: Cylinder, Label: 1, "Center [um]": [9, 12, 10], Axis: [1, 2, 1], "Radius [um]": 4}
  Materials:
    gel: {Label: 0, "Shear Modulus [Pa]": 500, Poisson Ratio: 0.3}
    vessel: {Label: 1, "Shear Modulus [Pa]": 2000, Poisson Ratio: 0.3}
  Grid:
    Element Size [um]: [2.0, 3.0, 2.0]
  Boundary Conditions:
    all: {Face: all, Components: xyz, Displacement Gradient: [0.1, 0, 0, 0, 0.2, 0, 0, 0, -0.05]}
  Loading: {"Times [s]": [0.5, 2.0]}
  Output: {Pictures: false, Report: false, VTKHDF: true}
"""


def make_runs():
    with open("gel.yaml", "w", encoding="utf-8") as deck:
        deck.write(DECK)
    run = [STROMA, "run", "gel.yaml", "--quiet", "-o"]
    subprocess.run([*MPIRUN, "2", *run, "reset", "--set", "Grid|Reset=true", "--set", "Output|VTKHDF=false"], check=True)
    for name, start in (("single", []), ("spread", [*MPIRUN, "2"])):
        subprocess.run([*start, *run, name], check=True)
        os.mkdir("vtkhdf_" + name)
        for file in os.listdir(name):
            if not file.startswith(("particles.e", "grid.e", ".")):
                shutil.copy(os.path.join(name, file), "vtkhdf_" + name)


def screen():
    """A screen in memory, where Debian's ParaView draws; nothing where there is none."""
    if not shutil.which("Xvfb"):
        return None
    number, written = os.pipe()
    server = subprocess.Popen(["Xvfb", "-displayfd", str(written), "-screen", "0", "1280x1024x24", "-noreset", "-nolisten", "tcp"],
                              pass_fds=[written], stderr=subprocess.DEVNULL)
    os.close(written)
    with os.fdopen(number) as told:
        os.environ["DISPLAY"] = ":" + told.readline().strip()
    return server


def look(*what):
    """In a ParaView of its own: version 5.13 dies of the second window that a process draws in without a graphics card."""
    script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "look.py")
    ended = subprocess.run(["pvpython", "--force-offscreen-rendering", script, MACRO, os.getcwd(), *what], check=False).returncode
    if ended != 0:
        sys.exit(f"look.py {' '.join(what)}: exit status {ended}")


def look_at_runs():
    for shape in ("boxes", "discs"):
        for prefix in ("", "vtkhdf_"):
            look("pictures", prefix + "single", shape)
            look("pictures", prefix + "spread", shape, prefix + "single")
    look("grids", "reset")
    look("points", "spread")


def main():
    if not shutil.which("pvpython"):
        print("skipped: there is no pvpython; cmake/install_dependencies.sh test installs it")
        sys.exit(77)
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(os.environ.get("STROMA_KEEP", folder))
        make_runs()
        server = screen()
        try:
            look_at_runs()
        finally:
            if server:
                server.terminate()
                server.wait()


main()
