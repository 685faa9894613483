#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Submits a scaling study of the ladder's load step to Slurm, one job for each number of nodes.
#
#   submit_scaling.sh strong|weak [--nodes "1 2 4 8"] [--ranks N] [--threads N] [--grid NX,NY,NZ]
#                     [--output DIR] [--stroma FILE] [--time H:MM:SS] [--local] [-- SBATCH-OPTION...]
#
#   strong     the same grid on all numbers of nodes (default: the full specimen, 256,256,26)
#   weak       the same grid for each rank (default: 32,32,32): the grid grows with the ranks
#   --ranks    ranks a node (default 64);  --threads  threads a rank (default 1)
#   --stroma   the program (default: build/threads/bin/stroma, or build/release/bin/stroma for 1 thread)
#   --local    no Slurm: each job runs here and now under mpirun, a "node" being --ranks ranks
#
# When the jobs are done: scaling_table.sh DIR.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
project=$(cd "$here/../../.." && pwd)

usage() { sed -n '3,14s/^# \{0,1\}//p' "$0" >&2; exit 2; }
kind=${1:-}
case $kind in
  strong) grid=256,256,26 ;;
  weak) grid=32,32,32 ;;
  *) usage ;;
esac
shift
nodes="1 2 4 8" ranks=64 threads=1 output=$PWD/scaling_$kind stroma="" time=1:00:00 local=no
while [[ $# -gt 0 ]]; do
  case $1 in
    --nodes) nodes=$2; shift 2 ;;
    --ranks) ranks=$2; shift 2 ;;
    --threads) threads=$2; shift 2 ;;
    --grid) grid=$2; shift 2 ;;
    --output) output=$2; shift 2 ;;
    --stroma) stroma=$2; shift 2 ;;
    --time) time=$2; shift 2 ;;
    --local) local=yes; shift ;;
    --) shift; break ;;
    *) usage ;;
  esac
done
if [[ -z $stroma ]]; then
  stroma=$project/build/threads/bin/stroma
  [[ $threads -gt 1 || -x $stroma ]] || stroma=$project/build/release/bin/stroma
fi
[[ -x $stroma ]] || { echo "submit_scaling.sh: no program $stroma" >&2; exit 1; }
mkdir -p "$output"
output=$(cd "$output" && pwd)

# Factors of the number of ranks for x, y and z, each prime factor given to the direction with the fewest.
spread() {
  local number=$1 factor=2 times=(1 1 1) least d
  while [[ $number -gt 1 ]]; do
    while [[ $((number % factor)) -ne 0 ]]; do factor=$((factor + 1)); done
    least=0
    for d in 1 2; do [[ ${times[d]} -ge ${times[least]} ]] || least=$d; done
    times[least]=$((times[least] * factor))
    number=$((number / factor))
  done
  echo "${times[@]}"
}

IFS=, read -r nx ny nz <<<"$grid"
for count in $nodes; do
  size=($nx $ny $nz)
  if [[ $kind == weak ]]; then
    read -r -a times <<<"$(spread $((count * ranks)))"
    size=($((nx * times[0])) $((ny * times[1])) $((nz * times[2])))
  fi
  job=$output/nodes$count
  export STROMA=$stroma DECK=$project/tests/benchmark/ladder.xml JOB=$job
  export ELEMENTS=${size[0]},${size[1]},${size[2]} NODES=$count RANKS=$((count * ranks)) THREADS=$threads
  mkdir -p "$job"
  if [[ $local == yes ]]; then
    source "$project/cmake/mpi_here.sh"
    LAUNCH="${mpirun[*]} -np $RANKS" bash "$here/scaling.sbatch"
  else
    sbatch --job-name="stroma-$kind-$count" --nodes="$count" --ntasks-per-node="$ranks" \
      --cpus-per-task="$threads" --time="$time" --output="$job/slurm.log" --export=ALL "$@" "$here/scaling.sbatch"
  fi
done
