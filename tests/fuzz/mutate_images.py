#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Mutates images of every format and looks how `stroma image` and `stroma check` take them.

  python3 tests/fuzz/mutate_images.py --program build/release/bin/stroma --count 500 --ranks 1,2 --seed 1 [FOLDER...]

FOLDER (default: tests/fuzz/images) holds sound images: files, and folders for images of several files, whose header is
called header.*; *.py and *.md are left alone. A run is at fault when it ends with another exit status than 0 or 2, takes
more than 20 s or 1 GB, says nothing with status 2, or prints a banner. Exit status 1 if one was; the inputs are kept
(--keep). Python's library is all it needs; the same seed makes the same images.
"""
import argparse
import collections
import os
import pathlib
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time

SECONDS = 20
KILOBYTES = 1 << 20
BANNERS = (b"MPI_ABORT", b"terminate called", b"Segmentation fault", b"Signal:", b"AddressSanitizer")
NUMBERS = ["-1", "0", "1", "2", "nan", "inf", "-inf", "1e308", "255", "65536", "100000", "2147483648", "4294967296",
           "99999999999", "9223372036854775807", "-9223372036854775808", "%d", "%n", "LIST", "True", ""]
DECK = """Stroma:
  Image:
    File: {file}
    Voxel Size [um]: [1.0, 1.0, 2.0]
    Segmentation: {{Method: Threshold, Threshold: 100.0}}
  Materials:
    gel: {{Label: 0, "Shear Modulus [Pa]": 500.0, Poisson Ratio: 0.4}}
    vessel: {{Label: 1, "Shear Modulus [Pa]": 1000.0, Poisson Ratio: 0.4}}
  Grid: {{Elements: [2, 2, 2]}}
  Boundary Conditions:
    bottom: {{Face: y-, Components: xyz}}
    top: {{Face: y+, Components: xyz, Strain: 0.1}}
"""


def change(data, others, chance):
    """One change of the bytes; most fall into the first part, where headers are."""
    data = bytearray(data)
    if not data:
        return bytes(chance.randbytes(chance.randint(0, 20)))
    place = chance.randrange(len(data) if chance.random() < 0.3 else min(len(data), 700))
    end = min(len(data), place + chance.choice([1, 2, 4, 8, 40, 400]))
    kind = chance.randrange(9)
    if kind == 0:
        data[place] ^= 1 << chance.randrange(8)
    elif kind == 1:
        data[place:end] = bytes([chance.choice([0, 1, 0x7F, 0x80, 0xFF])]) * (end - place)
    elif kind == 2:
        data[place:end] = chance.randbytes(end - place)
    elif kind == 3:
        del data[place:end]
    elif kind == 4:
        del data[place:]
    elif kind == 5:
        data[place:place] = data[place:end] * chance.choice([1, 1, 50])
    elif kind == 6:  # a piece of another image
        other = chance.choice(others)
        data[place:end] = other[place:end]
    else:  # a number or a line of a text header, if there are any
        numbers = list(re.finditer(rb"[-+0-9.eE]+|True|False", bytes(data[:4000])))
        lines = list(re.finditer(rb"[^\n]*\n", bytes(data[:4000])))
        if kind == 7 and numbers:
            found = chance.choice(numbers)
            data[found.start():found.end()] = chance.choice(NUMBERS).encode()
        elif lines:
            found = chance.choice(lines)
            data[found.start():found.end()] = found.group() * chance.choice([0, 2])
    return bytes(data)


class Seed:
    def __init__(self, path):
        self.name = path.name
        self.files = {path.name: path.read_bytes()} if path.is_file() else {
            file.name: file.read_bytes() for file in sorted(path.iterdir())}
        self.header = path.name if path.is_file() else next(name for name in self.files if name.startswith("header"))

    def write(self, folder, others, chance):
        for name, data in self.files.items():
            (folder / name).write_bytes(data)
        # Of several files, the header is changed most of the time.
        name = self.header if chance.random() < 0.8 else chance.choice(sorted(self.files))
        data = self.files[name]
        for _ in range(chance.choice([1, 1, 1, 2, 3, 5])):
            data = change(data, others, chance)
        (folder / name).write_bytes(data)


def run(command, folder):
    """Exit status (None: too slow), seconds, kilobytes, output."""

    def limits():
        os.setsid()
        resource.setrlimit(resource.RLIMIT_AS, (16 << 30, 16 << 30))  # against harm; judged is what was resident
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))

    began = time.time()
    with open(folder / "output", "wb") as output:
        process = subprocess.Popen(command, cwd=folder, stdout=output, stderr=subprocess.STDOUT,
                                   stdin=subprocess.DEVNULL, preexec_fn=limits)
        late = threading.Event()

        def end():
            late.set()
            os.killpg(process.pid, signal.SIGKILL)

        alarm = threading.Timer(SECONDS, end)
        alarm.start()
        _, status, usage = os.wait4(process.pid, 0)
        alarm.cancel()
        process.returncode = 0  # waited for above
    code = None if late.is_set() else os.WEXITSTATUS(status) if os.WIFEXITED(status) else -os.WTERMSIG(status)
    return code, time.time() - began, usage.ru_maxrss, (folder / "output").read_bytes()


def fault(code, kilobytes, output):
    if code is None:
        return f"took more than {SECONDS} s"
    if code not in (0, 2):
        return f"exit status {code}"
    if kilobytes > KILOBYTES:
        return f"took {kilobytes / 1024:.0f} MB"
    if any(banner in output for banner in BANNERS):
        return "printed a banner"
    if code == 2 and not output.strip():
        return "said nothing"
    return None


def main():
    here = pathlib.Path(__file__).resolve().parent
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folders", nargs="*", type=pathlib.Path, default=[here / "images"])
    parser.add_argument("--program", type=pathlib.Path, default=here.parents[1] / "build/release/bin/stroma")
    parser.add_argument("--count", type=int, default=200, help="images to make")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--first", type=int, default=0, help="number of the first image")
    parser.add_argument("--ranks", default="1", help="such as 1,2")
    parser.add_argument("--keep", type=pathlib.Path, default=pathlib.Path("mutated_images"))
    options = parser.parse_args()

    os.environ.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1", OMP_NUM_THREADS="1",
                      OMPI_MCA_hwloc_base_binding_policy="none", OMPI_MCA_mpi_yield_when_idle="1")
    seeds = [Seed(path) for folder in options.folders for path in sorted(folder.iterdir())
             if path.suffix not in (".py", ".md")]
    others = [data for seed in seeds for data in seed.files.values()]
    program = str(options.program.resolve())
    tally = collections.Counter()
    by_seed = collections.defaultdict(collections.Counter)
    slowest = largest = 0
    for number in range(options.first, options.first + options.count):
        chance = random.Random(f"{options.seed} {number}")
        seed = seeds[number % len(seeds)]
        folder = pathlib.Path(tempfile.mkdtemp(prefix="stroma_mutant_"))
        faults = []
        seed.write(folder, others, chance)
        (folder / "deck.yaml").write_text(DECK.format(file=seed.header))
        arguments = ["check", "deck.yaml"] if number // len(seeds) % 2 else ["image", seed.header]
        for ranks in map(int, options.ranks.split(",")):
            launcher = [] if ranks == 1 else ["mpirun", "--oversubscribe", "-np", str(ranks)]
            code, seconds, kilobytes, output = run(launcher + [program] + arguments, folder)
            slowest, largest = max(slowest, seconds), max(largest, kilobytes)
            trouble = fault(code, kilobytes, output)
            outcome = "at fault" if trouble else f"exit {code}"
            tally[f"{ranks} ranks, {outcome}"] += 1
            by_seed[seed.name][outcome] += 1
            if trouble:
                faults.append(trouble)
                print(f"image {number} ({seed.name}), {' '.join(arguments)}, {ranks} ranks: {trouble}", flush=True)
        if faults:
            kept = options.keep / f"{options.seed}_{number}"
            shutil.rmtree(kept, ignore_errors=True)
            shutil.copytree(folder, kept)
        shutil.rmtree(folder)

    for name, counts in sorted(by_seed.items()):
        print(f"{name:24}", "  ".join(f"{outcome}: {counts[outcome]}" for outcome in sorted(counts)))
    print(f"seed {options.seed}, {options.count} images from {options.first}, {sum(tally.values())} runs:",
          ", ".join(f"{outcome}: {tally[outcome]}" for outcome in sorted(tally)) +
          f"; slowest {slowest:.1f} s, largest {largest / 1024:.0f} MB")
    return 1 if any(outcome.endswith("at fault") for outcome in tally) else 0


if __name__ == "__main__":
    sys.exit(main())
