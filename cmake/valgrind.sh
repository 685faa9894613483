#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Runs a small deck on two ranks under valgrind's memcheck: cmake/valgrind.sh [DECK]. Exit status 1 if a use of memory that was
# never written, or is no longer the program's, has a function of Stroma in its stack; libraries' own are not counted.
#
# The build is its own (build/valgrind: release, lines of the sources, STROMA_NATIVE=OFF), because valgrind does not know AVX-512
# and ends what was compiled for it with "Illegal instruction".
set -euo pipefail
cd "$(dirname "$0")/.."
deck=${1:-tests/decks/small_reset.yaml}

bash cmake/install_dependencies.sh test
if ! command -v valgrind >/dev/null && [[ $(id -u) -eq 0 ]]; then
  echo "installing valgrind"
  DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends valgrind >/dev/null || true
fi
if ! command -v valgrind >/dev/null; then
  echo "valgrind.sh: valgrind is missing (Debian: valgrind)" >&2
  exit 1
fi
cmake --preset release -B build/valgrind -D STROMA_NATIVE=OFF -D STROMA_TESTS=OFF -D CMAKE_CXX_FLAGS=-g1 >/dev/null
cmake --build build/valgrind --parallel "$(nproc)" --target stroma

source cmake/mpi_here.sh
suppressions=(--suppressions=tests/valgrind.supp)
of_openmpi=/usr/share/openmpi/openmpi-valgrind.supp  # what it knows of itself
[[ -f $of_openmpi ]] && suppressions+=(--suppressions="$of_openmpi")
export HWLOC_COMPONENTS=-x86  # asks the processor for what valgrind does not know
out=build/valgrind/run
rm -rf "$out" build/valgrind/memcheck.*
status=0
"${mpirun[@]}" -np 2 valgrind --num-callers=50 --leak-check=no --error-limit=no "${suppressions[@]}" \
  --log-file=build/valgrind/memcheck.%p build/valgrind/bin/stroma run "$deck" -o "$out" --quiet || status=$?
if [[ $status -ne 0 ]]; then
  echo "valgrind.sh: the run ended with status $status" >&2
  exit 1
fi

# An error is a paragraph of the log; those with a function of Stroma are printed.
python3 - build/valgrind/memcheck.* <<'PYTHON'
import re, sys
ours = others = 0
for path in sys.argv[1:]:
    text = re.sub(r"^==\d+== ?", "", open(path).read(), flags=re.MULTILINE)
    for paragraph in re.split(r"\n\s*\n", text):
        if not re.search(r"^ +at 0x", paragraph, re.MULTILINE):
            continue
        if re.search(r"(at|by) 0x[0-9A-F]+: .*\bstroma::", paragraph):
            ours += 1
            print(paragraph, end="\n\n")
        else:
            others += 1
print(f"memcheck: {ours} errors with a function of Stroma in their stack, {others} of libraries alone")
sys.exit(1 if ours else 0)
PYTHON
