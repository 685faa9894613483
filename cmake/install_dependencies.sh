#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Installs what Stroma needs from Debian's packages, and only what is missing; silent when there is nothing to do.
# As root, or through sudo; where neither will do, prints the line that an administrator has to run.
#
#   cmake/install_dependencies.sh [demo|test|docs|lint]      for the program alone, or (default) for the tests as well; for the
#                                                            docs; for cmake/lint.sh
set -euo pipefail

packages=(
  # compiler and build
  g++ cmake ninja-build
  # solvers, MPI
  trilinos-all-dev libptscotch-dev libopenmpi-dev openmpi-bin
  # files
  libhdf5-openmpi-dev libexodusii-dev libtiff-dev zlib1g-dev libbz2-dev libzstd-dev libblosc-dev
  libyaml-cpp-dev libexpat1-dev libssl-dev nlohmann-json3-dev
  # least squares
  libceres-dev
  # command line, pictures, charts of reports
  libcli11-dev gnuplot-nox fonts-dejavu-core libjs-chart.js
)
docs=(
  # the docs as a site, with its equations; the pages of the code
  python3-sphinx python3-myst-parser furo libjs-katex fonts-katex doxygen
)
lint=(
  # formatting and spelling; clang-tidy, from Debian 12's security updates: those before 22 take four times as long
  git python3 clang-format-14 codespell clang-tidy-22 cppcheck
)
case ${1:-test} in
  demo) ;;
  test) packages+=(ccache libgtest-dev chromium chromium-driver python3-selenium python3-tifffile python3-zarr
                   python3-paraview xvfb) ;;
  docs) packages=("${docs[@]}") ;;
  lint) packages=("${lint[@]}") ;;
  *) sed -n '3,7s/^# \{0,1\}//p' "$0" >&2; exit 2 ;;
esac

if ! command -v dpkg-query >/dev/null; then
  echo "install_dependencies.sh: this is no Debian; there, these would be installed: ${packages[*]}" >&2
  exit 0
fi

missing=()
for package in "${packages[@]}"; do
  status=$(dpkg-query -W -f='${Status}' "$package" 2>/dev/null || true)
  [[ $status == "install ok installed" ]] || missing+=("$package")
done
[[ ${#missing[@]} -eq 0 ]] && exit 0

install=(apt-get install -y --no-install-recommends "${missing[@]}")
as_root=()
[[ $(id -u) -eq 0 ]] || as_root=(sudo)
if [[ $(id -u) -ne 0 ]] && ! { command -v sudo >/dev/null && sudo true; }; then
  echo "install_dependencies.sh: packages are missing. As administrator:" >&2
  echo "  apt-get update && ${install[*]}" >&2
  exit 1
fi

echo "installing ${missing[*]}"
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get update -qq
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive "${install[@]}" -qq >/dev/null
