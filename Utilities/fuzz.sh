#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Utilities/fuzz.sh [seconds] [build directory] [name ...]
#
# Builds the fuzz targets of the numerics with clang, AddressSanitizer and UndefinedBehaviorSanitizer and runs each, or
# those that are named (Certificate, Cap, ...; Mutations), for some seconds (60) on the inputs of Testing/Fuzz/Corpus and
# on what earlier runs found in the build directory. Findings are in <build directory>/findings; the exit status is 1
# where there are any. Then mutated inputs go through the filters of build/release, if it is there, from the number where
# the last run ended. Every run adds a line to Testing/Fuzz/Log.csv: commit it where the run is to count.

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
seconds=${1:-60}
build=${2:-build/fuzz}
names=("${@:3}")
log=Testing/Fuzz/Log.csv
commit=$(git rev-parse --short=9 HEAD 2>/dev/null || echo none)

# Whether a target is to run.
isWanted() {
  [[ ${#names[@]} == 0 || " ${names[*]} " == *" $1 "* ]]
}

# record <what> <seed or first number> <executions> <seconds> <findings>
record() {
  echo "$(date -u +%F),$commit,$1,$2,$3,$4,$5" >>"$log"
  echo "   $3 executions, $(awk -F, -v what="$1" '$3 == what { sum += $5 } END { print sum }' "$log") in all"
}

cmake -S . -B "$build" -G Ninja -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_CXX_FLAGS_RELEASE="-O2 -g1" -DHEXSWEEP_CORE_ONLY=ON -DBUILD_TESTING=OFF -DHEXSWEEP_BUILD_FUZZERS=ON \
  -DHEXSWEEP_UNITY_BUILD=ON >/dev/null
cmake --build "$build"

# Little is allocated for one input: a small quarantine still holds all that it freed. Stacks of allocations, and weights
# by how rare a feature is, took more time than the inputs; a finding is run again with the former.
export ASAN_OPTIONS=quarantine_size_mb=32:malloc_context_size=1
mkdir -p "$build/findings"
failed=0
for target in "$build"/bin/HexSweepFuzz*; do
  name=${target##*/HexSweepFuzz}
  isWanted "$name" || continue
  corpus=("$build/corpus/$name" "Testing/Fuzz/Corpus/$name")
  schedule=(-entropic=0)
  if [[ $name == Certificate ]]; then
    # From nothing, slow inputs rarely: kept ones are those that take exact numbers, a twentieth as fast.
    rm -rf "$build/corpus/$name"
    schedule=(-entropic=1 -entropic_scale_per_exec_time=1)
  fi
  mkdir -p "${corpus[@]}"
  echo "== $name: $seconds s"
  findings=0
  if ! "$target" "${schedule[@]}" -max_total_time="$seconds" -timeout=60 -rss_limit_mb=4096 -max_len=512 -print_final_stats=1 \
    -artifact_prefix="$build/findings/$name-" "${corpus[@]}" \
    >"$build/$name.log" 2>&1; then
    tail -n 40 "$build/$name.log"
    findings=1
    failed=1
  fi
  seed=$(sed -n 's/^INFO: Seed: //p' "$build/$name.log")
  executions=$(sed -n 's/^stat::number_of_executed_units: //p' "$build/$name.log")
  record "$name" "${seed:-0}" "${executions:-0}" "$seconds" "$findings"
done

if isWanted Mutations && [[ -x build/release/bin/HexSweepMutateFilters ]]; then
  next=$(awk -F, '$3 == "Mutations" && $4 + $5 > next_ { next_ = $4 + $5 } END { print next_ + 0 }' "$log")
  echo "== Mutations from $next on: $seconds s"
  build/release/bin/HexSweepMutateFilters "$next" 100000000 "$seconds" | tee "$build/mutations.log" || failed=1
  runs=$(sed -n 's/^\([0-9]*\) runs from .*/\1/p' "$build/mutations.log")
  wrong=$(sed -n 's/.* s, \([0-9]*\) of them wrong$/\1/p' "$build/mutations.log")
  record Mutations "$next" "${runs:-0}" "$seconds" "${wrong:-1}"
fi
exit "$failed"
