#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Short runs of random decks: every shape function, law, rig and preconditioner, with reset and without, on 1 to 4 ranks.

    python3 tests/endurance/random_runs.py STROMA [--count 200] [--seed 1] [--first 0] [--minutes M] [--keep FOLDER] [--jobs 1]

Each deck (random_deck.py) is run on two numbers of ranks, within 120 s of processor time and 1 GiB of data a rank. It has to end
with exit status 0, nothing on standard error and a whole history, and what it finds is checked (check_run.py): convergence,
equilibrium, energy that is not negative, work against energy and the way back to rest where the deck is elastic, and the same
answer on both numbers of ranks. A run may end with status 1 and a proper message where its deck may be too much for a body
(may_fail() says which): such runs are counted, and more than one deck in twenty is a fault. Anything else is one.

A line is printed for each deck, and the deck of a fault kept in the folder. The tally says how many decks had which trait, and
how much of its tolerance each check used at most. The same seed makes the same decks; deck N is run again by --first N --count 1.
Needs python3 alone. Exit status 1 if there is a fault.
"""
import argparse
import collections
import concurrent.futures
import dataclasses
import os
import pathlib
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time

import check_run
from random_deck import random_deck, yaml

SECONDS, BYTES = 120, 1 << 30
FAILURE = re.compile(r"\A\n?stroma: (.+\n)+\Z")
OF_MPIRUN = re.compile(r"-{20,}\n(Primary job|mpirun detected)[^-]*(-[^-]+)*-{20,}\n")  # its own words on an exit status
BANNER = re.compile(r"MPI_ABORT|signal code|terminate called|Segmentation fault|Sanitizer|\*\*\*|---|Traceback|Assertion|what\(\)")


def limits():
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS + 5))
    resource.setrlimit(resource.RLIMIT_DATA, (BYTES, BYTES))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


@dataclasses.dataclass
class Run:
    status: int          # None: it was given up
    errors: str          # what it wrote to standard error
    folder: pathlib.Path

    def history(self):
        return check_run.read_history(self.folder / "history.csv")

    def log(self):
        return (self.folder / "log.txt").read_text(errors="replace")


def run(stroma, folder, ranks):
    out = f"on_{ranks}"
    words = [stroma, "run", "deck.yaml", "-o", out, "--quiet"]
    if ranks > 1:
        words = ["mpirun", "--oversubscribe", "--bind-to", "none", "-np", str(ranks)] + words
    environment = dict(os.environ, OMP_NUM_THREADS="1", OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                       OMPI_MCA_mpi_yield_when_idle="1", OMPI_MCA_btl="^tcp,ofi", LD_BIND_NOW="1", TMPDIR=str(folder))
    process = subprocess.Popen(words, cwd=folder, env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                               stderr=subprocess.PIPE, text=True, errors="replace", preexec_fn=limits, start_new_session=True)
    try:  # four ranks may share a processor with others
        errors = process.communicate(timeout=6 * SECONDS)[1]
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        return Run(None, process.communicate()[1], folder / out)
    return Run(process.returncode, OF_MPIRUN.sub("", errors), folder / out)


def may_fail(deck):
    """Why Newton's method may find no answer at the smallest step; empty where it has to."""
    reasons = []
    if deck.tree["Grid"]["Reset"] and deck.tree["Grid"]["Shape Functions"] == "Linear":
        reasons.append("hats with reset: stresses jump where particles cross")
    if any(family.get("Law") == "Buckling-Stiffening" for numbers in deck.tree["Materials"].values()
           for family in numbers.get("Fibers", {}).values()):
        reasons.append("fibres that buckle")
    return reasons


class Verdict:
    """Of a deck: its faults, the share of each check's tolerance that it used, and whether it failed as it may."""

    def __init__(self, deck, runs):
        self.faults, self.shares, self.failed_honestly, self.mebibytes = [], {}, False, 0
        for ranks, one in runs.items():
            self.look_at_end(deck, ranks, one)
        if self.faults or self.failed_honestly:
            return
        try:
            histories = {ranks: one.history() for ranks, one in runs.items()}
            for ranks, one in runs.items():
                self.look_at_results(deck, ranks, histories[ranks], one.log())
            (first, one), (second, other) = histories.items()
            share, column = check_run.same_on_other_ranks(deck, one, other)
            self.use("ranks", share, f"on {first} and {second}, {column}")
        except (OSError, ValueError) as error:
            self.faults.append(str(error))

    def use(self, check, share, where):
        if share is None:
            return
        self.shares[check] = max(share, self.shares.get(check, 0.0))
        if not share <= 1:
            self.faults.append(f"{check}: {share:.3g} of its tolerance, {where}")

    def look_at_end(self, deck, ranks, one):
        if one.status == 1 and FAILURE.match(one.errors) and not BANNER.search(one.errors) and may_fail(deck):
            self.failed_honestly = True
        elif one.status is None or one.status < 0 or one.status > 128:
            self.faults.append(f"on {ranks}: ended by a signal or by its limits, status {one.status}")
        elif one.status != 0:
            self.faults.append(f"on {ranks}: exit status {one.status}")
        elif one.errors:
            self.faults.append(f"on {ranks}: exit status 0, but on standard error: {one.errors[:200]!r}")

    def look_at_results(self, deck, ranks, history, log):
        where = f"on {ranks}"
        self.mebibytes = max(self.mebibytes, int(re.search(r"^memory +(\d+) MiB", log, re.MULTILINE).group(1)))
        check_run.step_ends(deck, history)
        self.use("convergence", check_run.convergence(deck, history, log), where)
        self.use("equilibrium", check_run.equilibrium(deck, history), where)
        self.use("sign of energy", check_run.energy_sign(history), where)
        if deck.is_elastic:
            stated = re.search(r"Stabilization adds ([-0-9.e+]+)", log)
            self.use("work", check_run.energy_balance(deck, history, float(stated.group(1)) if stated else 0.0), where)
        if deck.is_elastic and deck.returns:
            self.use("rest", check_run.return_to_rest(deck, history), where)


def judge(stroma, seed, number, keep):
    """(deck, verdict, seconds); a faulty deck is kept with its results."""
    deck, start = random_deck(seed, number), time.monotonic()
    folder = pathlib.Path(tempfile.mkdtemp(prefix="stroma_endurance_"))
    try:
        (folder / "deck.yaml").write_text(yaml({"Stroma": deck.tree}) + "\n")
        if deck.image:
            (folder / "body.nrrd").write_bytes(deck.image)
        runs = {ranks: run(stroma, folder, ranks) for ranks in deck.ranks}
        verdict = Verdict(deck, runs)
        if verdict.faults:
            kept = keep / f"{seed}.{number}"
            shutil.rmtree(kept, ignore_errors=True)
            shutil.copytree(folder, kept, ignore=shutil.ignore_patterns("ompi.*", "*.e*"))
            (kept / "faults.txt").write_text("\n".join(verdict.faults + [one.errors for one in runs.values()]))
        return deck, verdict, time.monotonic() - start
    finally:
        shutil.rmtree(folder, ignore_errors=True)


class Tally:
    """What was run, and what came of it."""

    def __init__(self):
        self.decks, self.faulty, self.failed = 0, [], []
        self.traits, self.shares = collections.Counter(), {}
        self.slowest, self.largest = (0.0, None), (0, None)

    def add(self, number, deck, verdict, seconds):
        self.decks += 1
        self.slowest = max(self.slowest, (seconds, number))
        self.largest = max(self.largest, (verdict.mebibytes, number))
        self.traits.update((kind, word) for kind, words in deck.traits.items() for word in sorted(set(words)))
        for check, share in verdict.shares.items():
            count, worst, at = self.shares.get(check, (0, -1.0, None))
            self.shares[check] = (count + 1, *max((worst, at), (share, number), key=lambda pair: pair[0]))
        if verdict.failed_honestly:
            self.failed.append(number)
        if verdict.faults:
            self.faulty.append(number)
        words = [word for kind in ("shape", "reset", "law", "rig", "preconditioner") for word in deck.traits[kind]]
        outcome = f"failed, as it may: {'; '.join(may_fail(deck))}" if verdict.failed_honestly else "; ".join(verdict.faults)
        print(f"{number:4d} {' '.join(map(str, deck.ranks))} ranks {seconds:5.1f} s  {', '.join(words)}  {outcome}".rstrip(), flush=True)

    def print(self, options, seconds):
        for kind in dict.fromkeys(kind for kind, _ in self.traits):
            counts = (f"{word} {count}" for (of, word), count in sorted(self.traits.items()) if of == kind)
            print(f"{kind:>15}: " + ", ".join(counts))
        for check, (count, worst, at) in self.shares.items():
            print(f"{check:>15}: {count} decks, at most {worst:.2g} of the tolerance (deck {at})")
        print(f"{self.decks} random decks, seed {options.seed}, from number {options.first}, each on two numbers of ranks, in "
              f"{seconds:.0f} s: {len(self.faulty)} with faults, {len(self.failed)} failed as they may")
        print(f"deck {self.slowest[1]} took longest, {self.slowest[0]:.0f} s; deck {self.largest[1]} most memory, {self.largest[0]} MiB a rank")

    def is_clean(self):
        return 0 < self.decks and not self.faulty and 20 * len(self.failed) <= max(self.decks, 20)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("stroma", type=pathlib.Path)
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--first", type=int, default=0, help="number of the first deck")
    parser.add_argument("--minutes", type=float, default=float("inf"), help="begin no deck after so many minutes")
    parser.add_argument("--jobs", type=int, default=1, help="decks at once")
    parser.add_argument("--keep", type=pathlib.Path, default=pathlib.Path("endurance_faults"))
    options = parser.parse_args()
    stroma, begin, tally = str(options.stroma.resolve()), time.monotonic(), Tally()

    def one(number):
        if time.monotonic() - begin > 60 * options.minutes:
            return None
        return number, *judge(stroma, options.seed, number, options.keep)

    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for outcome in pool.map(one, range(options.first, options.first + options.count)):
            if outcome is not None:
                tally.add(*outcome)
    tally.print(options, time.monotonic() - begin)
    sys.exit(0 if tally.is_clean() else 1)


if __name__ == "__main__":
    main()
