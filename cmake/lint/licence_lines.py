#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that each source file says in its first lines under which licence it stands. Prints those that do not."""
import sys

from links import ROOT, project_files

LINE = "SPDX-License-Identifier: BSD-3-Clause"
SOURCES = ("*.hpp", "*.cpp", "*.py", "*.sh", "*.cmake", "*CMakeLists.txt", ".ci/run")


def main():
    sources = project_files(*SOURCES)
    lacking = [path for path in sources if LINE not in "".join(path.open(encoding="utf-8").readlines()[:3])]
    for path in lacking:
        print("%s:1: no line %s" % (path.relative_to(ROOT), LINE))
    return 1 if lacking or not sources else 0


if __name__ == "__main__":
    sys.exit(main())
