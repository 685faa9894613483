#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Holds docs/verification.md against the tests: each claim (a heading "### V-...") has a line "- **Test:**"; each file
named there exists below tests/ or in the project, each Suite.Name stands in one of them, and each test file names the
claim. Exit status 1 if not."""

import re
import sys
from pathlib import Path

project = Path(__file__).resolve().parent.parent
page = (project / "docs" / "verification.md").read_text()
mistakes = []

for claim in re.split(r"^### (?=V-)", page, flags=re.MULTILINE)[1:]:
    title = claim.split(":")[0]
    test = re.search(r"^- \*\*Test:\*\* (.*)$", claim, flags=re.MULTILINE)
    if not test:
        mistakes.append(f"{title} names no test")
        continue
    names = re.findall(r"`([^`]+)`", test[1])
    code = ""
    for name in (name for name in names if "/" in name):
        files = [path for path in (project / "tests" / name, project / name) if path.is_file()]
        if not files:
            mistakes.append(f"{title}: there is no {name}")
        code += "".join(path.read_text() for path in files)
        if name.endswith("Test.cpp") and not any(re.search(rf"{title}(?![\w-])", path.read_text()) for path in files):
            mistakes.append(f"{title}: {name} does not name it")
    if not code:
        mistakes.append(f"{title} names no file")
    for suite, name in (name.split(".") for name in names if "/" not in name):
        if not re.search(rf"TEST(_F|_P)?\({suite},\s*{name}\)", code):
            mistakes.append(f"{title}: there is no test {suite}.{name}")

for mistake in mistakes:
    print(f"docs/verification.md: {mistake}", file=sys.stderr)
sys.exit(1 if mistakes else 0)
