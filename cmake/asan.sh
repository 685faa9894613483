#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds tests with AddressSanitizer and UndefinedBehaviorSanitizer (preset asan) and runs them on 1 and 2 ranks:
#
#   cmake/asan.sh                              unit, verification and regression tests: hours on two cores
#   cmake/asan.sh unit                         those of a kind, or of two
#   cmake/asan.sh --tests REGEX [KIND...]      of these, those whose names match, as ctest -R has it
#   cmake/asan.sh --list [...]                 prints what would be run, and builds nothing
#
# A finding ends a program with status 99, which no test takes for an answer of Stroma's. Leaks count; those of libraries that keep
# what they allocate for the whole process are listed, each with its reason, in tests/leaks.supp.
set -euo pipefail
cd "$(dirname "$0")/.."

# Left out: what measures memory, of which sanitizers need several times as much; what builds programs against an installation,
# without the sanitizers' libraries; and a study of 36 large runs, of which each kind is run elsewhere.
left_out='^(regression\.memory|regression\.coupling|verification\.paper_study)\.'
tests=.
kinds=()
list=false
while [[ $# -gt 0 ]]; do
  case $1 in
    unit | verification | regression) kinds+=("$1") ;;
    --tests) tests=${2:?--tests asks for a regular expression}; shift ;;
    --list) list=true ;;
    *) sed -n '3,8s/^# \{0,1\}//p' "$0" >&2; exit 2 ;;
  esac
  shift
done
[[ ${#kinds[@]} -gt 0 ]] || kinds=(unit verification regression)

bash cmake/install_dependencies.sh test
cmake --preset asan -D STROMA_TESTS=ON >/dev/null
chosen=(--test-dir build/asan --label-regex "^($(IFS='|'; echo "${kinds[*]}"))$" --exclude-regex "$left_out")
# ctest takes one expression, but names of both: the ranks are looked for in what the other finds.
names=$(ctest "${chosen[@]}" --tests-regex "$tests" --show-only | sed -n 's/^ *Test *#[0-9]*: //p' | grep -E '\.np[12]$' || true)
if [[ -z $names ]]; then
  echo "asan.sh: no test on 1 or 2 ranks matches '$tests'" >&2
  exit 2
fi
if $list; then
  echo "$names"
  exit 0
fi
# unit.deck.np1 is run by test_unit_deck; what runs the program depends on it.
mapfile -t targets < <(sed -E 's/\.np[0-9]+$//; s/\./_/g; s/^/test_/' <<<"$names" | sort -u)
cmake --build build/asan --parallel "$(nproc)" --target "${targets[@]}"

# Whole stacks of allocations, for libraries without frame pointers: without them a leak cannot be told to be Open MPI's, with them
# tests take up to five times as long.
export ASAN_OPTIONS=exitcode=99:detect_leaks=1:fast_unwind_on_malloc=0:strict_string_checks=1:detect_stack_use_after_return=1
export LSAN_OPTIONS=exitcode=99:suppressions=$PWD/tests/leaks.supp:print_suppressions=0
export UBSAN_OPTIONS=exitcode=99:print_stacktrace=1:halt_on_error=1
expression="^($(paste -sd '|' <<<"${names//./\\.}"))\$"
ctest --test-dir build/asan --output-on-failure --parallel "$(nproc)" --tests-regex "$expression"
