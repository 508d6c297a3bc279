#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Utilities/demo.sh [model...]
#
# Installs what is missing, builds HexSweep and sweeps models of Data/cases (default: fig7 fig8
# fig9, the three models of the paper) through the chained ParaView filters. Prints one table and
# leaves a mesh (.vtu), a picture and a quality histogram of each model in build/demo.
#
# A model is the name of a folder of Data/cases or the beginning of one.
# HEXSWEEP_BUILD_DIR and HEXSWEEP_DEMO_DIR change where things go.

set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

models=("$@")
((${#models[@]})) || models=(fig7 fig8 fig9)
demo_dir=${HEXSWEEP_DEMO_DIR:-$source_dir/build/demo}

"$source_dir/Utilities/install-dependencies.sh"
configure_and_build HexSweep

plugin=$(find "$build_dir" -name HexSweep.so -type f | head -n 1)
if [[ -z $plugin ]]; then
  echo "demo.sh: the build left no HexSweep.so in $build_dir" >&2
  exit 1
fi

start_display
say "sweep: ${models[*]}"
pvpython "$source_dir/Utilities/demo/sweep_models.py" \
  --plugin "$plugin" --data "$source_dir/Data/cases" --output "$demo_dir" "${models[@]}"
