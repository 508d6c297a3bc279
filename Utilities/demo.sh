#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Utilities/demo.sh [model...]
# Utilities/demo.sh --compare
#
# Installs what is missing, builds HexSweep and sweeps models of Data/cases (default: fig7 fig8
# fig9, the three models of the paper) through the chained ParaView filters. Prints one table and
# leaves a mesh (.vtu), a picture and a quality histogram of each model in build/demo.
#
# A model is the name of a folder of Data/cases or the beginning of one.
# --compare sweeps all of them by several methods instead: one table, and pictures of the affine
# method beside HexSweep with caps that are not parallel, along a curved trajectory, round a growing
# hole (about a minute).
# HEXSWEEP_BUILD_DIR and HEXSWEEP_DEMO_DIR change where things go.

set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

script=sweep_models.py
models=("$@")
if [[ ${1:-} == --compare ]]; then
  script=compare.py
  models=()
elif ((${#models[@]} == 0)); then
  models=(fig7 fig8 fig9)
fi
demo_dir=${HEXSWEEP_DEMO_DIR:-$source_dir/build/demo}

"$source_dir/Utilities/install-dependencies.sh"
configure_and_build HexSweep

plugin=$(find "$build_dir" -name HexSweep.so -type f | head -n 1)
if [[ -z $plugin ]]; then
  echo "demo.sh: the build left no HexSweep.so in $build_dir" >&2
  exit 1
fi

start_display
say "sweep: ${models[*]:-all cases}"
pvpython "$source_dir/Utilities/demo/$script" \
  --plugin "$plugin" --data "$source_dir/Data/cases" --output "$demo_dir" "${models[@]}"
