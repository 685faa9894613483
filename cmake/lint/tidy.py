#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs clang-tidy on the sources of packages/ and src/ that a compile database names; their headers are looked at through them.

    tidy.py BUILD [--headers] [--tests] [--jobs N]

A source that passed is not looked at again until something it is made of has changed: itself, a header of the project that it
includes (over any number of headers), its options, .clang-tidy, the version of clang-tidy or the Debian release. What passed is
kept as empty files, named by a hash of all that, in the folder STROMA_TIDY_CACHE, else in ~/.cache/stroma-tidy. Headers of
Debian's libraries are no part of the hash: after an upgrade of one, remove the folder.

--headers takes a few sources that include all headers between them; --tests adds the sources of tests/. Exit status 1 if clang-tidy finds anything."""
import argparse
import concurrent.futures
import functools
import hashlib
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
TIDY = os.environ.get("CLANG_TIDY", "clang-tidy-22")
# Headers of these packages hold a template that clang refuses since version 19 (Trilinos 13.2, KokkosSparse_spadd_handle.hpp).
# Nobody instantiates it: templates are looked at where they are instantiated only.
REFUSED = re.compile(rb"#include <(Ifpack2|MueLu)_")
INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"', re.MULTILINE)


@functools.lru_cache(maxsize=None)
def content(path):
    return path.read_bytes()


@functools.lru_cache(maxsize=None)
def included(path, folders):
    """Files of the project that a file includes directly."""
    found = []
    for name in INCLUDE.findall(content(path).decode("utf-8", "replace")):
        for folder in (path.parent, *folders):
            if (folder / name).is_file():
                header = (folder / name).resolve()
                if ROOT in header.parents:
                    found.append(header)
                break
    return found


def made_of(source, entry):
    """The source and all headers of the project below it, by its entry in the compile database."""
    arguments = shlex.split(entry["command"])
    folders = tuple(pathlib.Path(argument[2:]) for argument in arguments if argument.startswith("-I"))
    seen, waiting = set(), [source]
    while waiting:
        path = waiting.pop()
        if path not in seen:
            seen.add(path)
            waiting += included(path, folders)
    return sorted(seen)


def key(entry, files, common):
    """A hash of all that decides what clang-tidy says of a source, which is made of these files."""
    hashed = hashlib.sha256(common)
    hashed.update(" ".join(word for word in shlex.split(entry["command"]) if str(ROOT) not in word).encode())
    for path in files:
        hashed.update(str(path.relative_to(ROOT)).encode() + b"\0" + content(path) + b"\0")
    return hashed.hexdigest()


def few_with_all_headers(files):
    """Sources that include between them what all include: again and again the one that adds most. files: of each source"""
    left = set().union(*files.values()) - set(files)
    chosen = []
    while left:
        chosen.append(max(sorted(files), key=lambda source: len(left.intersection(files[source]))))
        left.difference_update(files[chosen[-1]])
    return chosen


def look_at(source, build, passed):
    """What clang-tidy finds in a source; where that is nothing, makes the file `passed`."""
    command = [TIDY, "-p", str(build), "--quiet", "--warnings-as-errors=*", str(source)]
    if REFUSED.search(content(source)):
        command.append("--extra-arg=-fdelayed-template-parsing")
    done = subprocess.run(command, capture_output=True, text=True, cwd=ROOT)
    found = done.stdout if done.returncode else ""
    if done.returncode and not found.strip():
        found = "%s: clang-tidy ended with %d\n%s\n" % (source, done.returncode, done.stderr)
    if not found:
        passed.touch()
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--headers", action="store_true")
    parser.add_argument("--tests", action="store_true")
    parser.add_argument("--jobs", type=int, default=len(os.sched_getaffinity(0)))
    options = parser.parse_args()
    options.build = options.build.resolve()
    database = json.loads((options.build / "compile_commands.json").read_text())
    folders = ["packages", "src"] + (["tests"] if options.tests else [])
    cache = pathlib.Path(os.environ.get("STROMA_TIDY_CACHE", pathlib.Path.home() / ".cache" / "stroma-tidy"))
    cache.mkdir(parents=True, exist_ok=True)

    common = subprocess.run([TIDY, "--version"], check=True, capture_output=True).stdout + content(ROOT / ".clang-tidy")
    release = pathlib.Path("/etc/debian_version")
    common += release.read_bytes() if release.exists() else b""
    entries = {(pathlib.Path(entry["directory"]) / entry["file"]).resolve(): entry for entry in database}
    files = {source: made_of(source, entry) for source, entry in entries.items()
             if any(ROOT / folder in source.parents for folder in folders)}
    if not files:
        sys.exit("tidy.py: %s names no source of this project" % (options.build / "compile_commands.json"))
    wanted = few_with_all_headers(files) if options.headers else list(files)
    keys = {source: key(entries[source], files[source], common) for source in wanted}
    changed = sorted(source for source in wanted if not (cache / keys[source]).exists())
    print("clang-tidy: %d of %d sources to look at, of %d" % (len(changed), len(wanted), len(files)), flush=True)

    begin, printed, failed = time.monotonic(), set(), 0
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for found in pool.map(lambda source: look_at(source, options.build, cache / keys[source]), changed):
            failed += bool(found)
            # A fault of a header is met by each source that includes it, and printed once.
            for message in re.split(r"(?m)^(?=\S+:\d+:\d+: (?:warning|error))", found):
                place = message.split(" ", 1)[0]
                if message.strip() and place not in printed:
                    printed.add(place)
                    message = message.replace(str(options.build) + "/include/stroma/", "packages/")
                    print(message.replace(str(ROOT) + "/", ""), end="", flush=True)
    print("clang-tidy: faults in %d sources, %.0f s" % (failed, time.monotonic() - begin))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
