#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# What can be checked without running the program.
#
#   cmake/lint.sh text             formatting, spelling, links of the pages, licence lines: seconds
#   cmake/lint.sh tidy             clang-tidy over the sources of packages/ and src/: minutes, but what has not changed since it
#                                  passed is not looked at again
#   cmake/lint.sh tidy-headers     the same over a few sources that include all headers between them
#   cmake/lint.sh cppcheck         cppcheck over packages/ and src/: half a minute on two cores
#   cmake/lint.sh                  text, cppcheck and tidy
#   cmake/lint.sh format           formats the sources in place
#
# `cmake/install_dependencies.sh lint` installs what is needed. CLANG_FORMAT and CLANG_TIDY name other programs: clang-format has to
# be of version 14, for each version formats in its own way, and clang-tidy of 22 or later, for those before spend
# most of their time on the headers of Trilinos.
set -euo pipefail
cd "$(dirname "$0")/.."

need() {
  command -v "$1" >/dev/null && return
  echo "lint.sh: $1 is missing: $2" >&2
  exit 1
}
clang_format=${CLANG_FORMAT:-clang-format-14}
export CLANG_TIDY=${CLANG_TIDY:-clang-tidy-22}
debian="bash cmake/install_dependencies.sh lint, on Debian 12"

format() { # format OPTION...
  need "$clang_format" "$debian; elsewhere pip install clang-format==14.0.6 and CLANG_FORMAT=clang-format"
  git ls-files -z --cached --others --exclude-standard '*.hpp' '*.cpp' | xargs -0 "$clang_format" "$@"
}
spelling() {
  need codespell "$debian"
  git ls-files -z --cached --others --exclude-standard '*.md' '*.hpp' '*.cpp' '*.py' '*.sh' '*.cmake' '*.txt' '*.yaml' '*.yml' \
    '*.xml' '*.cff' '.ci/run' | xargs -0 codespell
}

text() {
  local failed=0
  for check in "format --dry-run --Werror" spelling "python3 cmake/lint/links.py" "python3 cmake/check_claims.py" \
    "python3 cmake/check_equations.py" \
    "python3 cmake/lint/licence_lines.py"; do
    $check || { failed=1; echo "lint.sh: FAILED: $check" >&2; }
  done
  return $failed
}
tidy() { # tidy OPTION...
  local build=build/lint  # where each file is an object, as clang-tidy wants it
  need "$CLANG_TIDY" "$debian; elsewhere CLANG_TIDY=..."
  cmake --preset release -B "$build" -D STROMA_TESTS=ON -D CMAKE_UNITY_BUILD=OFF >/dev/null
  python3 cmake/lint/tidy.py "$build" "$@"
}
# Errors, and what is slow or of one compiler only; not style, which clang-tidy sees to. cmake/lint/cppcheck.txt lists what is left
# out, and why. A folder with packages/ under the name stroma shows it the headers.
by_cppcheck() {
  need cppcheck "$debian"
  local include status=0
  include=$(mktemp -d)
  ln -s "$PWD/packages" "$include/stroma"
  cppcheck --quiet --error-exitcode=1 -j "$(nproc)" --language=c++ --std=c++17 \
    --enable=warning,performance,portability --suppressions-list=cmake/lint/cppcheck.txt \
    -I "$include" -I src packages src || status=1
  rm -r "$include"
  return $status
}

case ${1:-all} in
  text) text ;;
  tidy) tidy ;;
  tidy-headers) tidy --headers ;;
  cppcheck) by_cppcheck ;;
  all) text && by_cppcheck && tidy ;;
  format) format -i ;;
  *) sed -n '3,16s/^# \{0,1\}//p' "$0" >&2; exit 2 ;;
esac
