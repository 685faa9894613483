#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Writes microvessels.tif, the stack that deck.xml reads, into the current folder.
# Usage: prepare.sh [STROMA]     (STROMA: the program, default: stroma)
set -euo pipefail
"${1:-stroma}" phantom -o microvessels.tif --size 128,128,32 --voxel 1.05,1.05,1.0 --fraction 0.194 --seed 1
