#!/usr/bin/env bash
# Installs what is missing, builds everything (preset release), runs all tests. Then, where a Trilinos with threads is
# at hand, builds the preset threads and runs the unit and verification tests on it, with 1 and 2 threads.
set -euo pipefail
cd "$(dirname "$0")/.."

bash cmake/install_dependencies.sh
cmake --preset release
cmake --build --preset release --parallel "$(nproc)"
# Each test occupies as many processors as it has ranks; four ranks share two cores where there are no more.
ctest --test-dir build/release --output-on-failure --parallel "$(nproc)" "$@"

if ! bash cmake/unpack_threads_toolchain.sh; then
  echo "test.sh: no Trilinos with threads: the tests with threads are SKIPPED"
  exit 0
fi
cmake --preset threads
cmake --build --preset threads --parallel "$(nproc)" --target stroma unit_tests verification_tests
ctest --test-dir build/threads --output-on-failure --parallel "$(nproc)" --label-regex 'unit|verification' "$@"
