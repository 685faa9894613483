#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Installs what is missing, builds everything (preset release), runs all tests. Then, where a Trilinos with threads is
# at hand, builds the preset threads and runs the unit and verification tests on it, with 2 threads.
#
#   cmake/test.sh [--build DIR] [CTEST-OPTION...]      what is built lies below DIR; else below build
set -euo pipefail
project=$(cd "$(dirname "$0")/.." && pwd)
build=$project/build
if [[ ${1:-} == --build ]]; then
  mkdir -p "$2"
  build=$(cd "$2" && pwd)
  shift 2
fi
cd "$project"

bash cmake/install_dependencies.sh test
cmake --preset release -B "$build/release" -D STROMA_TESTS=ON
cmake --build "$build/release" --parallel "$(nproc)"
# Each test occupies as many processors as it has ranks; four ranks share two cores where there are no more.
ctest --test-dir "$build/release" --output-on-failure --parallel "$(nproc)" "$@"

if ! bash cmake/unpack_threads_toolchain.sh; then
  echo "test.sh: no Trilinos with threads: the tests with threads are SKIPPED"
  exit 0
fi
cmake --preset threads -B "$build/threads" -D STROMA_TESTS=ON
cmake --build "$build/threads" --parallel "$(nproc)" --target stroma unit_tests verification_tests
ctest --test-dir "$build/threads" --output-on-failure --parallel "$(nproc)" --label-regex 'unit|verification' "$@"
