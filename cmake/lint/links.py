#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks what the Markdown files of the project point to, without a network: files and folders of relative links,
headings of anchors, and paths of the project between backquotes. Prints what is not there; exit status 1 if anything is."""
import functools
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
LINK = re.compile(r"\[[^\]]*\]\(\s*<?([^)\s>]+)>?[^)]*\)")
FOLDERS = sorted(entry.name for entry in ROOT.iterdir() if entry.is_dir() and entry.name not in ("build", ".git"))
PATH = re.compile(r"`((?:%s)/[\w./-]*)`" % "|".join(map(re.escape, FOLDERS)))


def project_files(*patterns):
    """Files that git has, or would have once they are added."""
    command = ["git", "-C", str(ROOT), "ls-files", "--cached", "--others", "--exclude-standard", "-z", *patterns]
    names = subprocess.run(command, check=True, capture_output=True, text=True).stdout.split("\0")
    return sorted(ROOT / name for name in set(names) if name and (ROOT / name).is_file())


def lines_outside_code(path):
    """(number, line) of what is text, not a block of code."""
    fence = None
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        mark = re.match(r"\s*(```+|~~~+)", line)
        if mark and (fence is None or line.strip().startswith(fence)):
            fence = None if fence else mark.group(1)
        elif fence is None and not line.startswith("    "):
            yield number, line


@functools.lru_cache(maxsize=None)
def anchors(path):
    """The anchors of a file's headings, made as GitHub makes them, and those that it states in HTML."""
    found, seen = set(), {}
    for _, line in lines_outside_code(path):
        found.update(re.findall(r'<a (?:id|name)="([^"]+)"', line))
        found.update(re.findall(r"^\(([\w-]+)\)=$", line))
        heading = re.match(r"#{1,6}\s+(.*?)\s*#*$", line)
        if not heading:
            continue
        text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading.group(1))
        slug = re.sub(r"[^\w\- ]", "", text.lower()).replace(" ", "-")
        count = seen.get(slug, 0)
        seen[slug] = count + 1
        found.add(slug if count == 0 else "%s-%d" % (slug, count))
    return found


def fault_of(link, source):
    """What is wrong with a link, or None."""
    if re.match(r"[a-zA-Z][\w+.-]*:", link):
        return None  # an address in the network
    name, _, anchor = link.partition("#")
    target = (source.parent / name).resolve() if name else source
    if target != ROOT and ROOT not in target.parents:
        return "leads out of the project"
    if not target.exists():
        return "is not there"
    if anchor and target.suffix == ".md" and anchor not in anchors(target):
        return "has no such heading"
    return None


def main():
    faults = []
    pages = project_files("*.md")
    for page in pages:
        for number, line in lines_outside_code(page):
            for path in PATH.findall(line):
                if not (ROOT / path).exists():
                    faults.append((page, number, path, "is not there"))
            for link in LINK.findall(re.sub(r"`[^`]*`", "", line)):
                fault = fault_of(link, page)
                if fault:
                    faults.append((page, number, link, fault))
    for page, number, link, fault in faults:
        print("%s:%d: %s %s" % (page.relative_to(ROOT), number, link, fault))
    if not pages:
        print("links.py: no page was found")
    return 1 if faults or not pages else 0


if __name__ == "__main__":
    sys.exit(main())
