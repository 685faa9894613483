#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Mutates the decks of input_decks and tests/decks and gives them to the program.

    tests/fuzz/mutate_decks.py STROMA [--count 1000] [--seed 1] [--jobs 1] [--keep FOLDER]

Each mutant is checked on 1 and, every so often, on 2 ranks, and run where the check passed and the specimen is small.
`check` may end with exit status 0 or 2, `run` with 0, 1 or 2; each within 20 s of processor time and 1 GB of memory,
without a banner of MPI, a trace or a word of a sanitizer, and with one message when it fails. Anything else is a fault:
it is printed, and its deck kept. The same seed makes the same mutants. Exit status 1 if there is a fault.
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
import time

SOURCE = pathlib.Path(__file__).resolve().parents[2]
SECONDS, BYTES = 20, 1 << 30
BANNERS = re.compile(r"MPI_ABORT|signal code|terminate called|Segmentation fault|Sanitizer|\*\*\*|Traceback|\[\d+\] func:|Assertion")

USUAL = ["0", "1", "2", "3", "0.0", "0.5", "1.0", "2.0", "0.49", "0.01", "10.0", "-0.1", "0.3", "1e-3", "1e3", "1e6", "7"]
NUMBERS = ["0", "-1", "1", "2", "0.5", "1e300", "-1e300", "1e-300", "1e999", "nan", "inf", "-0.0", "2147483647", "2147483648",
           "-2147483649", "9223372036854775808", "0x10", "1,5", "1e", "", " ", "0.49999", "0.5000001", "1e6", "3.0000001"]
WORDS = ["", " ", "true", "false", "null", "~", "Linear", "GIMP", "CPDI", "Direct", "Jacobi", "Multigrid", "xyz", "y+", "{", "}",
         "[1, 2, 3]", "{1, 2, 3}", "\u00b5m", "a\x01b", "a\nb", "x" * 300, "%s%n", "../..", "/dev/null", "/", "'", '"', "&lt;", "*a", "&a b",
         "!!int 3", "|", "<!--", "]]>"]
VALUE = re.compile(r'value="([^"\n]*)"|^[^\n#:]*: +([^\n#{]+)', re.MULTILINE)  # of a parameter, in XML and in YAML
TOKEN = re.compile(r'"[^"\n]*"|[-+]?\d[\d.eE+-]*|[A-Za-z_][A-Za-z_ ]*[A-Za-z_]|\S')


def seeds():
    """(text, ending, folder) of the decks that are in order, and of those that are not."""
    found = []
    for patterns in (("input_decks/*/deck.*", "tests/data/cases/*/*.yaml", "tests/data/cases/*/*.xml"),
                     ("tests/decks/bad/*.xml", "tests/decks/bad/*.yaml")):
        paths = [path for pattern in patterns for path in sorted(SOURCE.glob(pattern)) if path.name not in ("study.yaml", "fit.yaml")]
        found.append([(path.read_text(errors="surrogateescape"), path.suffix, path.parent) for path in paths])
    return found


def small(text):
    """Small parts of the images, and one at hand in place of that which a prepare.sh makes, so that most mutants can be run."""
    images = SOURCE / "tests" / "data" / "images"
    parameter = '<Parameter name="{}" type="Array({})" value="{}"/>'.format
    voxel, region = parameter("Voxel Size [um]", "double", "{1.05, 1.05, 1.0}"), parameter("Region", "int", "{0, 0, 0, 24, 24, 24}")
    file = '<Parameter name="File" type="string" value="{}"/>'.format
    text = text.replace(file("../../tests/data/images/slice25_vessels.tif"), file(images / "slice25_vessels.tif") + region.replace("24, 24, 24", "64, 64, 1"))
    text = text.replace(file("microvessels.tif"), file(images / "endo_block.tif") + region + voxel)
    text = text.replace(file("../../tests/data/images/endo_block.tif"), file(images / "endo_block.tif") + region)
    return text.replace("{50, 50, 33}", "{12, 12, 12}")


def other_value(value, random_numbers):
    """A value in the place of one, mostly of its type, so that what it means is met and not only how it is read."""
    r = random_numbers
    numbers = list(re.finditer(r"[-+]?\d[\d.eE+-]*", value))
    if not numbers:
        return r.choice(WORDS) if r.random() < 0.5 else r.choice(NUMBERS)
    number = r.choice(numbers)
    kind = r.randrange(8)
    if kind <= 2:
        new = r.choice(NUMBERS)
    elif kind >= 6:
        new = r.choice(USUAL)
    elif kind == 3:  # of another size
        try:
            new = repr(float(number.group()) * 10.0 ** r.choice((-300, -12, -3, -1, 1, 3, 12, 300)))
        except ValueError:
            new = r.choice(NUMBERS)
        new = new if "." in number.group() else new.split(".")[0]
    elif kind == 4:  # one more or one less in a list
        new = number.group() + ", " + number.group() if r.random() < 0.5 else ""
    else:
        return r.choice(WORDS)
    return value[:number.start()] + new + value[number.end():]


def mutate(text, random_numbers):
    r = random_numbers
    # Every other mutant changes but one value, so that many are still decks that can be run.
    is_gentle = r.random() < 0.5
    for _ in range(1 if is_gentle else r.choice((1, 1, 1, 2, 3, 5))):
        kind = 9 if is_gentle else r.randrange(16)
        tokens = list(TOKEN.finditer(text))
        lines = text.split("\n")
        if not tokens or len(lines) < 2:
            return text
        if kind <= 3:  # another value or word in the place of one
            token = r.choice(tokens)
            is_number = re.match(r"[-+]?\d", token.group().strip('"'))
            new = r.choice(NUMBERS if is_number and r.random() < 0.8 else WORDS)
            if token.group().startswith('"'):
                new = '"' + new + '"'
            text = text[:token.start()] + new + text[token.end():]
        elif kind == 4:  # a token of elsewhere
            token, other = r.choice(tokens), r.choice(tokens)
            text = text[:token.start()] + other.group() + text[token.end():]
        elif kind == 5:  # a line goes
            del lines[r.randrange(len(lines))]
            text = "\n".join(lines)
        elif kind == 6:  # a line, or some, twice or elsewhere
            first = r.randrange(len(lines))
            part = lines[first:first + r.randint(1, 5)]
            place = r.randrange(len(lines))
            text = "\n".join(lines[:place] + part + lines[place:])
        elif kind == 7:  # cut short
            text = text[:r.randrange(len(text))] if r.random() < 0.3 else text
        elif kind == 8:  # a byte
            place = r.randrange(len(text))
            text = text[:place] + r.choice("\x00\x01\t\n<>\"'&:{}[]#-%\xff") + text[place + 1:]
        else:  # what a parameter is set to
            found = [match.span(1 if match.group(2) is None else 2) for match in VALUE.finditer(text)]
            if found:
                start, end = r.choice(found)
                text = text[:start] + other_value(text[start:end], r) + text[end:]
    return text


def limits():
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS + 5))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    os.setsid()


def peak_bytes(group):
    """Resident bytes of the largest process of a group."""
    largest = 0
    for entry in os.scandir("/proc"):
        if not entry.name.isdigit():
            continue
        try:
            with open(f"/proc/{entry.name}/stat") as stat:
                fields = stat.read().rsplit(")", 1)[1].split()
            if int(fields[2]) == group:
                largest = max(largest, int(fields[21]) * resource.getpagesize())
        except (OSError, IndexError, ValueError):
            pass
    return largest


def execute(words, folder):
    """(status, output, largest memory [bytes], wall seconds); status None when it hangs."""
    environment = {"PATH": os.environ["PATH"], "HOME": str(folder), "OMP_NUM_THREADS": "1", "OMPI_ALLOW_RUN_AS_ROOT": "1",
                   "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_hwloc_base_binding_policy": "none",
                   "OMPI_MCA_mpi_yield_when_idle": "1", "TMPDIR": str(folder)}
    if words[0] != "mpirun":
        environment.update(OMPI_MCA_ess_singleton_isolated="1", OMPI_MCA_orte_create_session_dirs="0", OMPI_MCA_pml="ob1",
                           OMPI_MCA_btl="self")
    start = time.monotonic()
    with open(folder / "output", "wb") as output:
        process = subprocess.Popen(words, cwd=folder, env=environment, stdin=subprocess.DEVNULL, stdout=output,
                                   stderr=subprocess.STDOUT, preexec_fn=limits)
        largest, status = 0, None
        while time.monotonic() - start < 6 * SECONDS:  # the machine may be busy; what counts is time on the processor
            status = process.poll()
            if status is not None:
                break
            largest = max(largest, peak_bytes(process.pid))
            time.sleep(0.05)
        else:
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()
    return status, (folder / "output").read_bytes().decode(errors="replace"), largest, time.monotonic() - start


def fault_of(status, output, largest, admitted):
    if status is None:
        return "hangs"
    if status not in admitted:
        return f"exit status {status}"
    if BANNERS.search(output):
        return "banner"
    if largest > BYTES:
        return f"{largest >> 20} MiB"
    if status != 0 and output.count("stroma: ") != 1:
        return f"{output.count('stroma: ')} messages"
    return ""


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("stroma", type=pathlib.Path)
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--first", type=int, default=0, help="number of the first mutant")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--two-ranks-every", type=int, default=4)
    parser.add_argument("--run-every", type=int, default=3)
    parser.add_argument("--keep", type=pathlib.Path, default=pathlib.Path("mutant_faults"))
    options = parser.parse_args()
    stroma = str(options.stroma.resolve())
    sound, mistaken = seeds()
    tally, faults, slowest, most = collections.Counter(), [], 0.0, 0
    for number in range(options.first, options.first + options.count):
        r = random.Random(f"{options.seed}.{number}")
        text, ending, origin = r.choice(sound if r.random() < 0.8 else mistaken)
        text = mutate(small(text), r)
        folder = pathlib.Path(tempfile.mkdtemp(prefix="stroma_mutant_"))
        try:
            for image in list(origin.glob("*.tif")) + list(origin.glob("*.h5")) + list(origin.glob("*.mh?")):
                shutil.copy(image, folder)
            (folder / ("deck" + ending)).write_bytes(text.encode(errors="surrogateescape"))
            jobs = [("check", 1)]
            if number % options.two_ranks_every == 0:
                jobs.append(("check", 2))
            if number % options.run_every == 0:
                jobs.append(("run", 1 + number // options.run_every % 2))
            for command, ranks in jobs:
                words = [stroma, command, "deck" + ending]
                if command == "run":
                    words += ["-o", "out", "--set", "Output|Pictures=false", "--set", "Loading|Steps=2"]
                if ranks > 1:
                    words = ["mpirun", "--oversubscribe", "-np", str(ranks)] + words
                status, output, largest, seconds = execute(words, folder)
                fault = fault_of(status, output, largest, (0, 1, 2) if command == "run" else (0, 2))
                tally[f"{command} on {ranks}: {fault or 'exit status ' + str(status)}"] += 1
                slowest, most = max(slowest, seconds), max(most, largest)
                if fault:
                    faults.append(number)
                    options.keep.mkdir(parents=True, exist_ok=True)
                    (options.keep / f"{options.seed}.{number}{ending}").write_bytes(text.encode(errors="surrogateescape"))
                    print(f"mutant {number}: {command} on {ranks}: {fault}\n{output[-600:]}", flush=True)
        finally:
            shutil.rmtree(folder, ignore_errors=True)
    print(f"{options.count} mutants of {len(sound) + len(mistaken)} decks, seed {options.seed}: {len(faults)} faults; "
          f"the slowest took {slowest:.1f} s, the largest {most >> 20} MiB")
    for what, count in sorted(tally.items()):
        print(f"  {count:5d}  {what}")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
