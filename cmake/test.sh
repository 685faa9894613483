#!/usr/bin/env bash
# Installs what is missing, builds everything (preset release), runs all tests.
set -euo pipefail
cd "$(dirname "$0")/.."

bash cmake/install_dependencies.sh
cmake --preset release
cmake --build --preset release --parallel "$(nproc)"
# Each test occupies as many processors as it has ranks; four ranks share two cores where there are no more.
ctest --test-dir build/release --output-on-failure --parallel "$(nproc)" "$@"
