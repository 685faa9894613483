#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds and tests the committed state (HEAD) on a Debian of its own: makes a root with debootstrap, or takes the one that
# is there, clones into it and runs there what the README says. As root, with debootstrap installed.
#
#   cmake/try_on_debian.sh bookworm|trixie|sid [--root DIR] [--part demo|test|user|clang] [--ccache DIR]
#
#   --root DIR      where the root is; else build/roots/SUITE. It takes 8 GB and may lie outside the project
#   --part PART     demo: cmake/demo.sh only; test: the tests only; else both. On sid the tests are those of the preset
#                   release that are marked unit or verification, and the applications that couple. user: the demo by
#                   one who is not root and may not write to the clone. clang: the preset release by clang++, with
#                   the unit tests: on trixie, for the ITK of bookworm does not admit it
#   --ccache DIR    a folder of compiled objects to share between roots; else one inside the root
#
# Prints the time of each part and the number of tests. Mounts go away at the end, the root stays: rm -r removes it.
set -euo pipefail
project=$(cd "$(dirname "$0")/.." && pwd)
usage() { sed -n '3,15s/^# \{0,1\}//p' "$0" >&2; exit 2; }
suite=${1:-}
[[ $suite =~ ^(bookworm|trixie|sid)$ ]] || usage
shift
root=$project/build/roots/$suite part=both ccache=""
while [[ $# -gt 0 ]]; do
  case $1 in
    --root) root=$2; shift 2 ;;
    --part) part=$2; shift 2 ;;
    --ccache) ccache=$2; shift 2 ;;
    *) usage ;;
  esac
done
[[ $part =~ ^(demo|test|user|clang|both)$ ]] || usage
[[ $(id -u) -eq 0 ]] || { echo "try_on_debian.sh: chroot and mount need root" >&2; exit 1; }
command -v debootstrap >/dev/null || { echo "try_on_debian.sh: apt-get install debootstrap" >&2; exit 1; }
mkdir -p "$root"
root=$(cd "$root" && pwd)

# The mirror that apt of this machine uses, from either form of its lists.
mirror() {
  {
    cat /etc/apt/sources.list.d/*.sources 2>/dev/null | sed -n 's/^URIs: *\([^ ]*\).*/\1/p'
    grep -hs '^deb ' /etc/apt/sources.list /etc/apt/sources.list.d/*.list | sed 's/\[[^]]*\]//' | awk '{print $2}'
  } | grep '/debian/*$' | head -n 1
}

make_root() {
  debootstrap --variant=minbase --include=ca-certificates,git "$suite" "$root" "$(mirror)"
  # What apt of this machine is told about the network, and no waiting for a disk that is thrown away.
  apt-config dump | grep -E '^Acquire::(http|https|Check|Retries)' >"$root/etc/apt/apt.conf.d/90host" || true
  echo force-unsafe-io >"$root/etc/dpkg/dpkg.cfg.d/unsafe-io"
  touch "$root/complete"
}
[[ -e $root/complete ]] || make_root
cp /etc/resolv.conf /etc/hosts "$root/etc/"

# What MPI, apt and the compiler look for; what is mounted already is left to whoever did it.
mounted=()
mount_at() {
  mkdir -p "${!#}"
  mountpoint -q "${!#}" && return
  mount "$@"
  mounted=("${!#}" "${mounted[@]}")
}
unmount() {
  for folder in "${mounted[@]}"; do umount "$folder" || umount -l "$folder"; done
}
trap unmount EXIT
trap 'exit 130' INT TERM
mount_at -t proc proc "$root/proc"
mount_at --bind /sys "$root/sys"
mount_at -t tmpfs tmpfs "$root/dev/shm"
mount_at -t devpts -o newinstance,ptmxmode=0666 devpts "$root/dev/pts"  # terminals, for the line of progress
[[ -e $root/dev/ptmx ]] || ln -s pts/ptmx "$root/dev/ptmx"
if [[ -n $ccache ]]; then
  mkdir -p "$ccache"
  mount_at --bind "$ccache" "$root/var/cache/ccache"
fi

# The clone and its build folder stay, so that a second run compiles only what changed. A path with a space is
# part of what is tried.
clone="$root/srv/stroma clone"
[[ -d $clone ]] || git clone -q --no-local "$project" "$clone"
git -C "$clone" fetch -q "$project" HEAD
git -C "$clone" checkout -q --force --detach FETCH_HEAD
git -C "$clone" clean -fdq

# inside COMMAND [USER]
inside() {
  local user=${2:-root}
  chroot --userspec "$user" "$root" env -i PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
    HOME="/var/tmp/home of $user" LC_ALL=C.UTF-8 CCACHE_DIR=/var/cache/ccache CCACHE_BASEDIR=/srv CCACHE_UMASK=0 \
    ${http_proxy:+http_proxy="$http_proxy"} ${https_proxy:+https_proxy="$https_proxy"} \
    bash -ec "mkdir -p \"\$HOME\" && cd '/srv/stroma clone' && $1"
}
timed() {
  local begin=$SECONDS
  inside "${@:2}"
  echo "== $suite, $1: passed in $((SECONDS - begin)) s"
}
inside 'bash cmake/install_dependencies.sh demo'
inside '. /etc/os-release; echo "== $PRETTY_NAME, $(git rev-parse --short HEAD), GCC $(g++ -dumpfullversion)"
  dpkg-query -W -f "== \${Package} \${Version}\n" trilinos-all-dev libtiff-dev libhdf5-openmpi-dev libopenmpi-dev'
if [[ $part == user ]]; then
  timed 'demo as a user' 'bash cmake/demo.sh --build "$HOME/build"' nobody
  exit
fi
if [[ $part == clang ]]; then
  inside 'bash cmake/install_dependencies.sh test && apt-get install -qq -y clang >/dev/null'
  timed 'build by clang' 'cmake --preset release -B build/clang -D CMAKE_C_COMPILER=clang -D CMAKE_CXX_COMPILER=clang++ \
    -D STROMA_NATIVE=OFF -D STROMA_TESTS=ON && cmake --build build/clang --parallel "$(nproc)"'
  timed 'unit tests' 'ctest --test-dir build/clang --output-on-failure --label-regex unit'
  exit
fi
[[ $part == test ]] || timed demo 'bash cmake/demo.sh'
[[ $part != demo ]] || exit 0
if [[ $suite != sid ]]; then
  timed tests 'bash cmake/test.sh'
else
  inside 'bash cmake/install_dependencies.sh test'
  timed build 'cmake --preset release -D STROMA_TESTS=ON &&
    cmake --build --preset release --parallel "$(nproc)" --target stroma unit_tests verification_tests'
  timed 'unit and verification tests' "ctest --test-dir build/release --output-on-failure --parallel \"\$(nproc)\" \
    --label-regex 'unit|verification'"
  timed 'applications that couple' "ctest --test-dir build/release --output-on-failure --tests-regex coupling"
fi
