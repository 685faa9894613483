#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Ranks against threads on 2 cores: the ladder's load step on 1 rank, 2 ranks, and 1 rank of 2 threads, all with
# the program of the preset threads. Prints a Markdown table of medians of three runs, taken in turn, because the
# machines are noisy. Usage: tests/benchmark/ranks_and_threads.sh [GRID...], a grid being NX,NY,NZ; the
# variable PRECONDITIONER names another preconditioner than the default.
set -euo pipefail
cd "$(dirname "$0")/../.."
source cmake/mpi_here.sh
export OMP_WAIT_POLICY=${OMP_WAIT_POLICY:-passive}
stroma=$PWD/build/threads/bin/stroma
preconditioner=${PRECONDITIONER:-Geometric Multigrid}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
grids=("$@")
[[ ${#grids[@]} -gt 0 ]] || grids=(32,32,32 64,64,64)

stage() { sed -n "s/^time .*  $1 \([0-9.]*\) s.*/\1/p" "$2"; }
median() { sort -n | sed -n '2p'; }

echo "| elements | ranks x threads | time (s) | tangent (s) | set-up (s) | linear solve (s) | peak memory per rank (MB) |"
echo "| --- | --- | --- | --- | --- | --- | --- |"
for grid in "${grids[@]}"; do
  IFS=, read -r nx ny nz <<<"$grid"
  for turn in 1 2 3; do
    for pair in 1x1 2x1 1x2; do
      ranks=${pair%x*} threads=${pair#*x}
      log=$work/$pair.$turn
      OMP_NUM_THREADS=$threads "${mpirun[@]}" -np "$ranks" /usr/bin/time -f '%M' -o "$log.memory" -a \
        "$stroma" run tests/benchmark/ladder.xml -o "$work/run" \
        --set "Image|Phantom|Size={$((2 * nx)),$((2 * ny)),$((2 * nz))}" \
        --set "Solver|Preconditioner=$preconditioner" >"$log"
    done
  done
  for pair in 1x1 2x1 1x2; do
    column() { for turn in 1 2 3; do stage "$1" "$work/$pair.$turn"; done | median; }
    seconds=$(for turn in 1 2 3; do sed -n 's/^\([0-9.]*\) s on .*/\1/p' "$work/$pair.$turn"; done | median)
    memory=$(cat "$work/$pair".*.memory | sort -n | tail -n 1)
    echo "| $nx x $ny x $nz | ${pair/x/ x } | $seconds | $(column tangent) | $(column preconditioner) |" \
      "$(column 'linear solve') | $((memory / 1024)) |"
  done
  rm -f "$work"/*.memory
done
