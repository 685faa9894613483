#!/usr/bin/env bash
# Installs what Stroma needs from Debian 12, and only what is missing; silent when there is nothing to do.
# As root, or through sudo.
set -euo pipefail

packages=(
  # compiler and build
  g++ cmake ninja-build ccache
  # solvers, MPI
  trilinos-all-dev libptscotch-dev libopenmpi-dev openmpi-bin
  # files
  libhdf5-openmpi-dev libexodusii-dev libinsighttoolkit5-dev libtiff-dev zlib1g-dev
  libyaml-cpp-dev libexpat1-dev
  # command line, pictures
  libcli11-dev gnuplot-nox fonts-dejavu-core
  # tests and benchmarks
  libgtest-dev libbenchmark-dev nlohmann-json3-dev
)

missing=()
for package in "${packages[@]}"; do
  status=$(dpkg-query -W -f='${Status}' "$package" 2>/dev/null || true)
  [[ $status == "install ok installed" ]] || missing+=("$package")
done
[[ ${#missing[@]} -eq 0 ]] && exit 0

as_root=()
if [[ $(id -u) -ne 0 ]]; then
  if ! command -v sudo >/dev/null; then
    echo "install_dependencies.sh: missing packages: ${missing[*]}" >&2
    echo "run this script as root, or install sudo" >&2
    exit 1
  fi
  as_root=(sudo)
fi

echo "installing ${missing[*]}"
export DEBIAN_FRONTEND=noninteractive
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get update -qq
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
  apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
