#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds the fuzz targets (preset fuzz) and runs each for so many seconds: cmake/fuzz.sh [SECONDS [TARGET...]], 600 seconds
# and all targets if not told otherwise. Exit status 1 if one of them crashed, hung or took too much memory: what did it
# lies in build/fuzz/crashes. What is found new is kept in build/fuzz/corpus for the next time.
set -euo pipefail
cd "$(dirname "$0")/.."

seconds=${1:-600}
shift || true
if [[ ! $seconds =~ ^[1-9][0-9]*$ ]]; then
  echo "fuzz.sh: '$seconds' is no number of seconds" >&2
  exit 2
fi

bash cmake/install_dependencies.sh test
# clang is wanted here only; without root it must be there.
if ! command -v clang++ >/dev/null && [[ $(id -u) -eq 0 ]]; then
  echo "installing clang"
  DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends clang libclang-rt-dev >/dev/null || true
fi
has_fuzzer() {
  local trial
  trial=$(mktemp -d) || return 1
  echo 'extern "C" int LLVMFuzzerTestOneInput(const unsigned char*, unsigned long) { return 0; }' >"$trial/a.cpp"
  clang++ -fsanitize=fuzzer,address "$trial/a.cpp" -o "$trial/a" 2>"$trial/messages"
  local result=$?
  rm -rf "$trial"
  return $result
}
if ! command -v clang++ >/dev/null || ! has_fuzzer; then
  echo "fuzz.sh: no clang++ with libFuzzer (Debian: clang, libclang-rt-dev): the fuzz targets are SKIPPED"
  exit 0
fi

cmake --preset fuzz >/dev/null
cmake --build --preset fuzz --parallel "$(nproc)"

targets=("$@")
if [[ ${#targets[@]} -eq 0 ]]; then
  for folder in tests/fuzz/seeds/*/; do targets+=("$(basename "$folder")"); done
fi
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
mkdir -p build/fuzz/crashes build/fuzz/logs
# One target: a line of what it did, and of a crash its messages.
run() {
  local target=$1 corpus=build/fuzz/corpus/$1 log=build/fuzz/logs/$1.log result=clean
  mkdir -p "$corpus"
  # An input that takes longer than 10 s, or more than 1 GB, counts as a crash.
  "build/fuzz/fuzz/$target" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=1024 -max_len=16384 \
    -artifact_prefix="build/fuzz/crashes/$target-" -print_final_stats=1 "$corpus" "tests/fuzz/seeds/$target" \
    >"$log" 2>&1 || result=CRASHED
  printf '%-20s %12s executions in %s s: %s\n' "$target" \
    "$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")" "$seconds" "$result"
  [[ $result == clean ]] && return
  grep -E -A 12 'ERROR|SUMMARY|ALARM' "$log" | head -n 40 || tail -n 20 "$log"
  return 1
}
export -f run
export seconds
# xargs ends with 123 where one of them did with 1. As many at once as there are processors.
printf '%s\n' "${targets[@]}" | xargs -P "$(nproc)" -I '{}' bash -c 'run {}' || exit 1
