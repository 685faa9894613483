#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# From an image stack to pictures of stress: makes a stack of microvessels in collagen as a confocal microscope
# would show it, reads it back as a user's stack, stretches it by 10 %.
#
#   cmake/demo.sh [--build DIR]      what is built and written lies below DIR; else below build
set -euo pipefail
project=$(cd "$(dirname "$0")/.." && pwd)
build=$project/build
case ${1:-} in
  "") ;;
  --build) mkdir -p "$2"; build=$(cd "$2" && pwd) ;;
  *) sed -n '3,6s/^# \{0,1\}//p' "$0" >&2; exit 2 ;;
esac

bash "$project/cmake/install_dependencies.sh" demo
cd "$project"
cmake --preset release -B "$build/release" >/dev/null
cmake --build "$build/release" --target stroma --parallel "$(nproc)"

stroma=$build/release/bin/stroma
demo=$build/demo
rm -rf "$demo"
mkdir -p "$demo"
cp input_decks/02_microvessel_stack/* "$demo"
source cmake/mpi_here.sh
export OMP_NUM_THREADS=1
cd "$demo"

echo "== a stack of microvessels: microvessels.tif"
bash prepare.sh "$stroma"
echo "== stroma image: what is in it"
"$stroma" image microvessels.tif
echo "== stroma run, on 2 ranks: 10 % extension"
"${mpirun[@]}" -np 2 "$stroma" run deck.xml -o results

echo
echo "Left in $demo:"
for file in microvessels.tif results/vessels.png results/von_mises.png results/force.png \
  results/particles.e.2.0 results/grid.e.2.0 results/history.csv; do
  if [[ ! -s $file ]]; then
    echo "demo.sh: $file was not written" >&2
    exit 1
  fi
  echo "  $file"
done
echo "ParaView opens particles.e.2.0 and grid.e.2.0 (each with its partner .2.1) as they are."
