#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Utilities/install-dependencies.sh [package...]
#
# Installs the packages of Debian 12 or 13 that HexSweep needs to be built, run and tested, and those that are named.
# Asks dpkg first: when all is there it changes nothing and needs neither network nor root.

set -euo pipefail

packages=(
  # the tools
  g++ cmake ninja-build
  # ParaView with its VTK, its Python and what its CMake files ask for
  paraview-dev python3-paraview python3-dev
  libdouble-conversion-dev libglew-dev libx11-dev
  # what the rendering and image modules of that VTK name as their targets
  libfreetype-dev libpng-dev libjpeg-dev libtiff-dev liblz4-dev liblzma-dev libutfcpp-dev
  # the numerics and their tests
  libeigen3-dev libopenmesh-dev coinor-libcbc-dev libgtest-dev libboost-dev
  # the CAD kernel, and TBB and fontconfig, which its CMake files name
  libocct-data-exchange-dev libocct-modeling-algorithms-dev libtbb-dev libfontconfig-dev
  # programs and packages that read what is written, for tests: gmsh, meshio
  gmsh python3-meshio python3-h5py
  # a display without a screen and its mouse, and mpirun for the parallel test
  xvfb xauth xdotool openmpi-bin libopenmpi-dev
  # what packages are made with
  dpkg-dev file
  "$@"
)
# Debian 12 has ParaView 5.11 on Qt 5, and CalculiX, which tests run where it is; 13 has 5.13 on Qt 6, no CalculiX.
if [[ $(. /etc/os-release 2>/dev/null && echo "${VERSION_ID:-}") == 12 ]]; then
  packages+=(qttools5-dev qtxmlpatterns5-dev-tools libqt5svg5 python3-pyqt5 calculix-ccx)
else
  packages+=(qt6-base-dev qt6-tools-dev qt6-svg-dev qt6-svg-plugins python3-pyqt6 qt6-5compat-dev)
fi

say() { printf '== %s\n' "$*"; }

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
  echo "install-dependencies.sh: this is not Debian (no apt-get); install by hand what matches:" >&2
  printf '  %s\n' "${packages[@]}" >&2
  exit 1
fi

missing=()
for package in "${packages[@]}"; do
  status=$(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null || true)
  # A package of several architectures is listed once for each: one that is installed will do.
  [[ $status == *installed && $status != *not-installed ]] || missing+=("$package")
done

if ((${#missing[@]} == 0)); then
  say "dependencies: all ${#packages[@]} packages are installed"
  exit 0
fi

say "dependencies: ${#missing[@]} of ${#packages[@]} packages are missing: ${missing[*]}"

as_root=()
if ((EUID != 0)); then
  if ! command -v sudo >/dev/null; then
    echo "install-dependencies.sh: neither root nor sudo; as root run:" >&2
    echo "  apt-get install --no-install-recommends ${missing[*]}" >&2
    exit 1
  fi
  say "dependencies: not root, so apt-get runs through sudo"
  as_root=(sudo)
fi

apt() { "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get "$@"; }

say "dependencies: apt-get update"
apt -q update
say "dependencies: apt-get install (some minutes on a bare system)"
apt -q -y --no-install-recommends -o Dpkg::Use-Pty=0 install "${missing[@]}"
say "dependencies: installed"
