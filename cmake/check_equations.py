#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Holds what comments of the code say of docs/theory.md against the page: each equation of `docs/theory.md, eq. (4.3)` has its
number there, and each heading of `docs/theory.md, "Heading"` stands there. Exit status 1 if not."""

import re
import sys
from pathlib import Path

project = Path(__file__).resolve().parent.parent
page = (project / "docs" / "theory.md").read_text()
equations = set(re.findall(r"\\tag\{([\d.]+)\}", page))
headings = set(re.findall(r"^#+ (?:\d+\. )?(.*)$", page, flags=re.MULTILINE))
mistakes = []

for folder in ("packages", "src", "tests"):
    for path in sorted((project / folder).rglob("*.[hc]pp")):
        text = re.sub(r"\n\s*///?\s*", " ", path.read_text())
        for numbers in re.findall(r"docs/theory\.md, eq\. ((?:\([^)]*\)(?:,| to| and)? ?)+)", text):
            for number in re.findall(r"\((.*?)\)", numbers):
                if number not in equations:
                    mistakes.append(f"{path.relative_to(project)}: there is no equation ({number})")
        for heading in re.findall(r'docs/theory\.md, "([^"]*)"', text):
            if heading not in headings:
                mistakes.append(f'{path.relative_to(project)}: there is no heading "{heading}"')

for mistake in mistakes:
    print(mistake, file=sys.stderr)
sys.exit(1 if mistakes else 0)
