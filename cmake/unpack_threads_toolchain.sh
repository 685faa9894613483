#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Makes a Trilinos with OpenMP ready for the preset `threads`, and prints its folder. In this order: the folder in
# STROMA_TRILINOS_OPENMP, /opt/trilinos-openmp, the archive that lies beside the project, which is unpacked
# to /opt. Fails, saying why, when there is none: build_trilinos_openmp.sh makes one.
set -euo pipefail
cd "$(dirname "$0")/.."

prefix=${STROMA_TRILINOS_OPENMP:-/opt/trilinos-openmp}
archive=$PWD/../shared/toolchain/trilinos-13.2-openmp.tar.xz

is_ready() { [[ -f $prefix/lib/cmake/Trilinos/TrilinosConfig.cmake ]]; }
fail() {
  echo "unpack_threads_toolchain.sh: $1; cmake/build_trilinos_openmp.sh builds a Trilinos with OpenMP" >&2
  exit 1
}

if ! is_ready; then
  [[ -z ${STROMA_TRILINOS_OPENMP:-} ]] || fail "STROMA_TRILINOS_OPENMP=$prefix holds no Trilinos"
  [[ -f $archive ]] || fail "there is no Trilinos in $prefix and no archive $archive"
  # The archive's paths are fixed: its libraries know each other by the folder they were built for. It is
  # unpacked beside that folder first, so that an interrupted unpacking leaves nothing that looks ready.
  part=$(mktemp -d "$(dirname "$prefix")/trilinos-openmp.XXXXXX") || fail "cannot write to $(dirname "$prefix")"
  trap 'rm -rf "$part"' EXIT
  tar -xJf "$archive" -C "$part"
  # Another process may have been faster.
  mv -T "$part/trilinos-openmp" "$prefix" 2>/dev/null || is_ready || fail "cannot write $prefix"
fi
echo "$prefix"
