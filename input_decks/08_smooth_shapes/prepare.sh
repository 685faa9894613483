#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# slice.tif: the paper's own slice (512 x 512 pixels, 19.4 % vessels) where it is at hand, else a drawn one of
# the same size and volume fraction.    bash prepare.sh [STROMA [SLICE]]
set -euo pipefail
stroma=${1:-stroma}
slice=${2:-../../tests/data/images/slice25_vessels.tif}
if [ -f "$slice" ]; then
  cp "$slice" slice.tif
  echo "slice.tif: the paper's slice, from $slice"
else
  "$stroma" phantom -o slice.tif --size 512,512,1 --voxel 1.05,1.05,1.0 --fraction 0.1936 --seed 25
fi
