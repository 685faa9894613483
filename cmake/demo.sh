#!/usr/bin/env bash
# From an image stack to pictures of stress, in build/demo: makes a stack of microvessels in collagen as a
# confocal microscope would show it, reads it back as a user's stack, stretches it by 10 %.
set -euo pipefail
cd "$(dirname "$0")/.."

bash cmake/install_dependencies.sh
cmake --preset release >/dev/null
cmake --build --preset release --target stroma --parallel "$(nproc)"

stroma=$PWD/build/release/bin/stroma
demo=$PWD/build/demo
rm -rf "$demo"
mkdir -p "$demo"
cp input_decks/02_microvessel_stack/* "$demo"
cd "$demo"

# Open MPI refuses root unless told twice; harmless for others.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMP_NUM_THREADS=1
export OMPI_MCA_hwloc_base_binding_policy=none

echo "== a stack of microvessels: microvessels.tif"
bash prepare.sh "$stroma"
echo "== stroma image: what is in it"
"$stroma" image microvessels.tif
echo "== stroma run, on 2 ranks: 10 % extension"
mpirun --oversubscribe -np 2 "$stroma" run deck.xml -o results

echo
echo "Left in build/demo:"
for file in microvessels.tif results/vessels.png results/von_mises.png results/force.png \
  results/particles.e.2.0 results/grid.e.2.0 results/history.csv; do
  if [[ ! -s $file ]]; then
    echo "demo.sh: $file was not written" >&2
    exit 1
  fi
  echo "  build/demo/$file"
done
echo "ParaView opens particles.e.2.0 and grid.e.2.0 (each with its partner .2.1) as they are."
