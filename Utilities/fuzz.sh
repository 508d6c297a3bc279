#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Utilities/fuzz.sh [seconds] [build directory]
#
# Builds the fuzz targets of the numerics with clang, AddressSanitizer and UndefinedBehaviorSanitizer and runs each for
# some seconds (60) on the inputs of Testing/Fuzz/Corpus and on what earlier runs found in the build directory.
# Findings are in <build directory>/findings; the exit status is 1 where there are any. Then mutated inputs go through the
# filters of build/release, if it is there, from where the last run ended.

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
seconds=${1:-60}
build=${2:-build/fuzz}

cmake -S . -B "$build" -G Ninja -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_CXX_FLAGS_RELEASE="-O2 -g1" -DHEXSWEEP_CORE_ONLY=ON -DBUILD_TESTING=OFF -DHEXSWEEP_BUILD_FUZZERS=ON \
  -DHEXSWEEP_UNITY_BUILD=ON >/dev/null
cmake --build "$build"

mkdir -p "$build/findings"
failed=0
for target in "$build"/bin/HexSweepFuzz*; do
  name=${target##*/HexSweepFuzz}
  mkdir -p "$build/corpus/$name" "Testing/Fuzz/Corpus/$name"
  echo "== $name: $seconds s"
  if ! "$target" -max_total_time="$seconds" -timeout=60 -rss_limit_mb=4096 -max_len=512 -print_final_stats=1 \
    -artifact_prefix="$build/findings/$name-" "$build/corpus/$name" "Testing/Fuzz/Corpus/$name" \
    >"$build/$name.log" 2>&1; then
    tail -n 40 "$build/$name.log"
    failed=1
  fi
  executions=$(sed -n 's/^stat::number_of_executed_units: //p' "$build/$name.log")
  total=$(($(cat "$build/$name.total" 2>/dev/null || echo 0) + ${executions:-0}))
  echo "$total" >"$build/$name.total"
  echo "   ${executions:-0} executions, $total in all"
done

if [[ -x build/release/bin/HexSweepMutateFilters ]]; then
  next=$(cat "$build/mutations.next" 2>/dev/null || echo 0)
  echo "== mutated inputs from $next on: $seconds s"
  build/release/bin/HexSweepMutateFilters "$next" 100000000 "$seconds" | tee "$build/mutations.log" || failed=1
  runs=$(sed -n 's/^\([0-9]*\) runs from .*/\1/p' "$build/mutations.log")
  echo $((next + ${runs:-0})) >"$build/mutations.next"
fi
exit "$failed"
