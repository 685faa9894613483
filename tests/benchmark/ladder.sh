#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The ladder: one load step of 1 % (of the ten to 10 %) on a vessel phantom, 2 x 2 x 2 voxels an element, for each
# grid, preconditioner and number of ranks; each linear solve to 1e-6. A Markdown table, and below it the STREAM triad and
# the products K v, measured right after. Usage: tests/benchmark/ladder.sh [--write] [GRID...], a grid being NX,NY,NZ; the
# preconditioners are those of the variable PRECONDITIONERS, separated by commas (default: all three).
# With --write, the section "The ladder" of docs/performance.md is replaced by the result.
set -euo pipefail
cd "$(dirname "$0")/../.."
source cmake/mpi_here.sh
export OMP_NUM_THREADS=1
stroma=$PWD/build/release/bin/stroma
product=$PWD/build/release/tests/benchmark_product
if [[ ${1:-} == --write ]]; then
  shift
  section=$(mktemp)
  bash "$0" "$@" | tee "$section"
  awk -v section="$section" '
    /<!-- ladder begins -->/ { print; while ((getline line < section) > 0) print line; skip = 1 }
    /<!-- ladder ends -->/ { skip = 0 }
    !skip' docs/performance.md >docs/performance.md.new
  mv docs/performance.md.new docs/performance.md
  rm "$section"
  exit
fi
IFS=, read -r -a preconditioners <<<"${PRECONDITIONERS:-Jacobi,Multigrid,Geometric Multigrid}"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
grids=("$@")
[[ ${#grids[@]} -gt 0 ]] || grids=(32,32,32 64,64,64 128,128,26)

echo "Made by \`tests/benchmark/ladder.sh\` on $(date +%F): $(sed -n 's/^model name\s*: //p' /proc/cpuinfo | head -n 1), $(nproc --all) cores."
echo
echo "| elements | preconditioner | ranks | time (s) | peak memory per rank (MB) | Newton | linear | set-up (s) | linear solve (s) |"
echo "| --- | --- | --- | --- | --- | --- | --- | --- | --- |"
for grid in "${grids[@]}"; do
  IFS=, read -r nx ny nz <<<"$grid"
  for preconditioner in "${preconditioners[@]}"; do
    # Minutes, or more memory than there is, beyond these; LIMIT=none runs them all the same.
    elements=$((nx * ny * nz))
    if [[ ${LIMIT:-} != none ]]; then
      [[ $preconditioner == Jacobi && $elements -gt 300000 ]] && continue
      [[ $preconditioner == Multigrid && $elements -gt 500000 ]] && continue
    fi
    for ranks in 1 2; do
      "${mpirun[@]}" -np "$ranks" /usr/bin/time -f '%M' -o "$work/memory" -a \
        "$stroma" run tests/benchmark/ladder.xml -o "$work/run" \
        --set "Image|Phantom|Size={$((2 * nx)),$((2 * ny)),$((2 * nz))}" \
        --set "Solver|Preconditioner=$preconditioner" --set "Solver|Forcing=Constant" >"$work/log"
      seconds=$(sed -n 's/^\([0-9.]*\) s on .*/\1/p' "$work/log")
      memory=$(sort -n "$work/memory" | tail -n 1)
      rm "$work/memory"
      newton=$(tail -n 1 "$work/run/history.csv" | cut -d, -f3)
      linear=$(tail -n 1 "$work/run/history.csv" | cut -d, -f4)
      setup=$(sed -n 's/^time .*preconditioner \([0-9.]*\) s.*/\1/p' "$work/log")
      solve=$(sed -n 's/^time .*linear solve \([0-9.]*\) s.*/\1/p' "$work/log")
      echo "| $nx x $ny x $nz | $preconditioner | $ranks | $seconds | $((memory / 1024)) | $newton | $linear | $setup | $solve |"
    done
  done
done
echo
for grid in "${grids[@]}"; do
  for ranks in 1 2; do
    "${mpirun[@]}" -np "$ranks" "$product" ${grid//,/ } 9 | sed 's/^/    /'
  done
done
