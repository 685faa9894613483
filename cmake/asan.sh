#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds the unit tests with AddressSanitizer and UndefinedBehaviorSanitizer (preset asan) and runs them:
# cmake/asan.sh [TEST...], such as "deck image"; all of them if not told otherwise. Leaks count; those of libraries that
# keep what they allocate for the whole process are listed, each with its reason, in tests/leaks.supp.
set -euo pipefail
cd "$(dirname "$0")/.."

bash cmake/install_dependencies.sh test
cmake --preset asan -D STROMA_TESTS=ON >/dev/null
targets=(unit_tests)
expression='^unit\.'
if [[ $# -gt 0 ]]; then
  targets=("${@/#/test_unit_}")
  expression="^unit\.($(IFS='|'; echo "$*"))\."
fi
cmake --build build/asan --parallel "$(nproc)" --target "${targets[@]}"

# Open MPI and its helpers run past the end of main() in ways that the checker of leaks does not follow: ranks are told
# apart in the log by their number.
export ASAN_OPTIONS=detect_leaks=1:strict_string_checks=1:detect_stack_use_after_return=1
export LSAN_OPTIONS=suppressions=$PWD/tests/leaks.supp:print_suppressions=0
export UBSAN_OPTIONS=print_stacktrace=1:halt_on_error=1
ctest --test-dir build/asan --output-on-failure --parallel "$(nproc)" --tests-regex "$expression" --timeout 3000
