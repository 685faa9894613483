#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds Trilinos with Kokkos' OpenMP back end from Debian's own source package, for the preset `threads`: with the
# packages that Stroma uses and no others. About 1,240 objects: an hour and more on 2 cores, and 8 GB of disk.
#
#   cmake/build_trilinos_openmp.sh [--prefix DIR] [--build DIR] [--jobs N] [--arch NAME] [--configure-only]
#
#   --prefix DIR       where to install it; else STROMA_TRILINOS_OPENMP, else /opt/trilinos-openmp
#   --build DIR        where to work; else build/trilinos-openmp. What is there already is not done again
#   --jobs N           compilers at a time; else one a processor. Each takes up to 2 GB
#   --arch NAME        instruction set; else native. x86-64-v3 suits all machines since 2013
#   --configure-only   stop before compiling
set -euo pipefail
cd "$(dirname "$0")/.."

prefix=${STROMA_TRILINOS_OPENMP:-/opt/trilinos-openmp}
build=$PWD/build/trilinos-openmp
jobs=$(nproc)
arch=native
configure_only=no
while [[ $# -gt 0 ]]; do
  case $1 in
    --prefix) prefix=$2; shift 2 ;;
    --build) build=$2; shift 2 ;;
    --jobs) jobs=$2; shift 2 ;;
    --arch) arch=$2; shift 2 ;;
    --configure-only) configure_only=yes; shift ;;
    *) sed -n '3,13s/^# \{0,1\}//p' "$0" >&2; exit 2 ;;
  esac
done
mkdir -p "$build"
build=$(cd "$build" && pwd)

# The source package, through a list of sources of this script's own: the system's stays as it is.
fetch_source() {
  command -v dpkg-source >/dev/null || { echo "build_trilinos_openmp.sh: install dpkg-dev first" >&2; exit 1; }
  local apt=$build/apt
  mkdir -p "$apt/parts" "$apt/lists/partial"
  cat /etc/apt/sources.list.d/*.sources 2>/dev/null | sed 's/^Types: .*/Types: deb-src/' >"$apt/parts/source.sources"
  grep -hs '^deb ' /etc/apt/sources.list /etc/apt/sources.list.d/*.list | sed 's/^deb /deb-src /' >"$apt/source.list" || true
  local options=(-o Dir::Etc::SourceList="$apt/source.list" -o Dir::Etc::SourceParts="$apt/parts"
    -o Dir::State::Lists="$apt/lists" -o APT::Sandbox::User=)
  apt-get "${options[@]}" -qq update
  (cd "$build" && apt-get "${options[@]}" -qq source trilinos)
}
source_folder() { find "$build" -mindepth 1 -maxdepth 1 -type d -name 'trilinos-*' | sort | tail -n 1; }
[[ -n $(source_folder) ]] || fetch_source
trilinos=$(source_folder)
[[ -f $trilinos/CMakeLists.txt ]] || { echo "build_trilinos_openmp.sh: no sources in $build" >&2; exit 1; }

wanted=(Teuchos Kokkos KokkosKernels TpetraCore Belos Ifpack2 Amesos2 MueLu Xpetra Thyra ThyraTpetraAdapters
  Stratimikos NOX Zoltan Zoltan2Core)
# What would come along as an optional part of these; the older linear algebra (Epetra) among it.
unwanted=(Epetra ThyraEpetraAdapters ML Ifpack AztecOO Amesos Anasazi Piro)
options=(
  -D CMAKE_INSTALL_PREFIX="$prefix"
  -D CMAKE_BUILD_TYPE=Release
  -D CMAKE_CXX_STANDARD=17
  -D CMAKE_CXX_FLAGS="-march=$arch -w"
  -D BUILD_SHARED_LIBS=ON
  # Threads, and one node type: objects for Serial as well would double the time.
  -D Trilinos_ENABLE_OpenMP=ON
  -D Kokkos_ENABLE_OPENMP=ON
  -D Kokkos_ENABLE_SERIAL=ON
  -D Tpetra_INST_OPENMP=ON
  -D Tpetra_INST_SERIAL=OFF
  -D Tpetra_INST_DOUBLE=ON
  -D Tpetra_INST_INT_LONG_LONG=ON
  -D Trilinos_ENABLE_EXPLICIT_INSTANTIATION=ON
  # Libraries: MPI, BLAS and LAPACK are all it takes.
  -D TPL_ENABLE_MPI=ON
  -D TPL_ENABLE_BLAS=ON
  -D TPL_ENABLE_LAPACK=ON
  -D TPL_ENABLE_DLlib=ON
  -D TPL_ENABLE_Boost=OFF
  -D TPL_ENABLE_HDF5=OFF
  -D TPL_ENABLE_Netcdf=OFF
  # Packages: those below and what they need.
  -D Trilinos_ENABLE_ALL_OPTIONAL_PACKAGES=OFF
  -D Trilinos_ASSERT_MISSING_PACKAGES=OFF
  -D Trilinos_ENABLE_Fortran=OFF
  -D Trilinos_ENABLE_TESTS=OFF
  -D Trilinos_ENABLE_EXAMPLES=OFF
  -D TpetraCore_ENABLE_Epetra=OFF
  -D NOX_ENABLE_LOCA=OFF
  -D NOX_ENABLE_ABSTRACT_IMPLEMENTATION_THYRA=ON
  -D NOX_ENABLE_ABSTRACT_IMPLEMENTATION_EPETRA=OFF
)
for package in "${wanted[@]}"; do options+=(-D "Trilinos_ENABLE_$package=ON"); done
for package in "${unwanted[@]}"; do options+=(-D "Trilinos_ENABLE_$package=OFF"); done
if command -v ccache >/dev/null; then
  options+=(-D CMAKE_C_COMPILER_LAUNCHER=ccache -D CMAKE_CXX_COMPILER_LAUNCHER=ccache)
fi

cmake -G Ninja -S "$trilinos" -B "$build/objects" "${options[@]}"
[[ $configure_only == no ]] || exit 0
cmake --build "$build/objects" --parallel "$jobs"
cmake --install "$build/objects" >/dev/null
echo "Trilinos with OpenMP in $prefix: cmake --preset threads finds it there" \
  "(elsewhere than in /opt/trilinos-openmp: export STROMA_TRILINOS_OPENMP=$prefix)"
