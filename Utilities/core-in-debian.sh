#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Utilities/core-in-debian.sh ROOT [MIRROR [SUITE]]
#
# Proves that Core needs neither VTK nor ParaView: makes a bare Debian in the folder ROOT (kept as it
# is if there is one), installs compiler, Eigen, OpenMesh and GoogleTest there, builds and tests this
# tree with HEXSWEEP_CORE_ONLY, installs it, and builds and runs Examples/Core against that.
# Needs root and debootstrap; mounts nothing. MIRROR and SUITE are those of the system's apt unless
# given. A quarter of an hour on two processors.

set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
source "$(dirname "${BASH_SOURCE[0]}")/debian_root.sh"

if (($# < 1 || $# > 3)); then
  sed -n 's/^# \{0,1\}//; 3,12p' "${BASH_SOURCE[0]}" >&2
  exit 2
fi
make_debian_root "$1" "${3:-$(. /etc/os-release && echo "$VERSION_CODENAME")}" "${2:-$(debian_mirror)}"
say "packages"
inside apt-get update -q
inside apt-get install -q -y --no-install-recommends \
  g++ cmake ninja-build libeigen3-dev libopenmesh-dev libgtest-dev libboost-dev
if inside find / -xdev -name 'VTKConfig.cmake' -o -xdev -iname 'vtk-config.cmake' | grep .; then
  echo "core-in-debian.sh: there is a VTK in $root, so this would prove nothing" >&2
  exit 1
fi

say "build, test, install"
copy_tree
inside cmake -S $source_inside/source -B $source_inside/build -G Ninja \
  -DCMAKE_BUILD_TYPE=Release -DHEXSWEEP_CORE_ONLY=ON -DHEXSWEEP_WERROR=ON
inside cmake --build $source_inside/build -j "$(job_count)"
inside ctest --test-dir $source_inside/build --output-on-failure -j "$(nproc)"
inside cmake --install $source_inside/build --prefix /usr/local

say "the example, against what is installed"
rm -rf "$root$source_inside/example"
inside cmake -S $source_inside/source/Examples/Core -B $source_inside/example -G Ninja \
  -DCMAKE_BUILD_TYPE=Release
inside cmake --build $source_inside/example
inside $source_inside/example/sweep_frame
