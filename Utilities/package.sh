#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Utilities/package.sh
#
# Makes the Debian packages of this tree, for the release of Debian that it runs on, in build/packages:
#
#   hexsweep      command line, plugin (ParaView finds it by itself), Python package, libraries
#   hexsweep-dev  headers, CMake files, the library of the numerics
#
# and judges them with lintian where that is installed. Install them with
#
#   apt install ./build/packages/hexsweep*.deb
#
# Packages the build in build/release (HEXSWEEP_BUILD_DIR), where only what is missing is built.
# DEBFULLNAME and DEBEMAIL name who answers for the packages.

set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
packages_dir=$source_dir/build/packages

"$source_dir/Utilities/install-dependencies.sh"
# What is installed, and no tests.
configure_and_build HexSweep HexSweepPython HexSweepCore
if ! grep -q DEB "$build_dir/CPackConfig.cmake" 2>/dev/null; then
  echo "package.sh: $build_dir makes no packages: they need Debian, ParaView, Python and shared libraries" >&2
  exit 1
fi

say "package: $packages_dir"
rm -rf "$packages_dir"
(cd "$build_dir" && cpack -G DEB -B "$packages_dir")
rm -rf "$packages_dir/_CPack_Packages"
# dpkg-shlibdeps must have found the one ParaView whose libraries these are.
if ! dpkg-deb --field "$packages_dir"/hexsweep_*.deb Depends | grep -q 'paraview (>= [^,]*), paraview (<< '; then
  echo "package.sh: the packages do not depend on the ParaView that they were built with" >&2
  exit 1
fi
if command -v lintian >/dev/null; then
  say "lintian"
  lintian --allow-root --fail-on error "$packages_dir"/*.deb
fi
ls -l "$packages_dir"/*.deb
