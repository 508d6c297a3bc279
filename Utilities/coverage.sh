#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Utilities/coverage.sh [build directory]
#
# Builds the numerics and their tests with gcc's coverage (build/coverage), runs the tests and writes which lines of
# Filters/Core they reach: <build directory>/coverage.txt, the last line for all; the exit status is 1 below 95 %.
# Debian: apt-get install gcovr. About half an hour on two processors.

set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
cd "$source_dir"
build=${1:-build/coverage}
least=95
if ! command -v gcovr >/dev/null; then
  echo "coverage.sh: gcovr is missing; on Debian: apt-get install gcovr" >&2
  exit 2
fi

cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE="-O1 --coverage -fprofile-update=atomic" \
  -DHEXSWEEP_CORE_ONLY=ON -DHEXSWEEP_UNITY_BUILD=ON >/dev/null
cmake --build "$build" -j "$(job_count)"
find "$build" -name '*.gcda' -delete
ctest --test-dir "$build" -L core -j "$(job_count)" --output-on-failure >"$build/tests.log" || {
  tail -n 40 "$build/tests.log" >&2
  exit 1
}
gcovr --root . --object-directory "$build" --filter 'Filters/Core/' --exclude-throw-branches \
  --gcov-ignore-parse-errors --output "$build/coverage.txt" --fail-under-line "$least" "$build"
tail -n 3 "$build/coverage.txt"
