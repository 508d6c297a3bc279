#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Utilities/valgrind.sh [filter]
#
# Runs tests of the numerics (HEXSWEEP_BUILD_DIR, build/release) under valgrind: those of the filter, in GoogleTest's words,
# or those below, which go through every room in some minutes. The exit status is 1 where memory is read before it is
# written or beyond its end, or is lost. Debian: apt-get install valgrind.

set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
cd "$source_dir"
if ! command -v valgrind >/dev/null; then
  echo "valgrind.sh: valgrind is missing; on Debian: apt-get install valgrind" >&2
  exit 2
fi
filter=${1:-'HexQuality.*:HexCertificate.*:HexUntangling.*:HexDescent.*:LowHexes.*:ConjugateGradients*:MultifrontalSolver.*:PrismSolver.*:DirichletSolver.*:NestedDissection.*:SurfaceTopology.*:QuadUntangling.*:QuadProjection.*:TrianglePairing.*:CommonDiskMap.*:LinkingSides.*:BlendInterior.*:LayerMarch.*:SolidSurface.*:SweepChoice.*:IntervalProgramme.*:StackSweep.*:RingStack.*'}
tests=$build_dir/bin/HexSweepCoreTests
IFS=: read -ra suites <<<"$filter"
for suite in "${suites[@]}"; do
  if [[ -z $("$tests" --gtest_list_tests --gtest_filter="$suite" | sed 1d) ]]; then
    echo "valgrind.sh: no test is called $suite" >&2
    exit 2
  fi
done
valgrind --quiet --error-exitcode=1 --leak-check=full --show-leak-kinds=definite --errors-for-leak-kinds=definite \
  "$tests" --gtest_brief=1 --gtest_filter="$filter"
