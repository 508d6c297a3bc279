#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Utilities/demo.sh [model...]
# Utilities/demo.sh --compare
# Utilities/demo.sh --winding
# Utilities/demo.sh --assemblies
#
# Installs what is missing, builds HexSweep, sweeps models of Data/cases through the chained ParaView
# filters and CAD solids of Data/solids by OneToOneSweep (default: fig7 fig8 fig9, the three models of
# the paper, and the flange). Prints tables and leaves meshes (.vtu) and pictures in build/demo.
#
# A model is the name of a folder of Data/cases or the beginning of one, or that of a folder of
# Data/solids; "solids" are all of these.
# --compare sweeps all of them by several methods instead: one table, and pictures of the affine
# method beside HexSweep with caps that are not parallel, along a curved trajectory, round a growing
# hole (about a minute).
# --assemblies meshes the assemblies of Data/cad, each as one conforming mesh, and draws some.
# --winding draws a bar whose holes turn by half a turn about each other.
# HEXSWEEP_BUILD_DIR and HEXSWEEP_DEMO_DIR change where things go.

set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

models=("$@")
compare=no
drawn=no
if [[ ${1:-} == --compare ]]; then
  compare=yes
  models=()
elif [[ ${1:-} == --winding || ${1:-} == --assemblies ]]; then
  drawn=${1#--}
  models=()
elif ((${#models[@]} == 0)); then
  models=(fig7 fig8 fig9 flange)
elif [[ ${models[*]} == solids ]]; then
  models=($(ls "$source_dir/Data/solids"))
fi
cases=()
solids=()
for model in "${models[@]}"; do
  if [[ -d $source_dir/Data/solids/$model ]]; then solids+=("$model"); else cases+=("$model"); fi
done
demo_dir=${HEXSWEEP_DEMO_DIR:-$source_dir/build/demo}

"$source_dir/Utilities/install-dependencies.sh"
# Only what is run: the plugin for the pictures, the Python package for what the command line draws.
if [[ $drawn == no ]]; then configure_and_build HexSweep; else configure_and_build HexSweepPython; fi

start_display
run_script() { # script, data, models...
  pvpython "$source_dir/Utilities/demo/$1" \
    --plugin "$plugin" --data "$source_dir/Data/$2" --output "$demo_dir" "${@:3}"
}
if [[ $drawn != no ]]; then
  package=$(find "$build_dir/lib" -type d -path '*site-packages/hexsweep' | head -n 1)
  data=()
  [[ $drawn == assemblies ]] && data=(--data "$source_dir/Data/cad")
  PYTHONPATH=$(dirname "$package") /usr/bin/python3 "$source_dir/Utilities/demo/$drawn.py" \
    --output "$demo_dir" "${data[@]}"
  exit
fi
plugin=$(find "$build_dir/lib" -name HexSweep.so -type f | head -n 1)
if [[ -z $plugin ]]; then
  echo "demo.sh: the build left no HexSweep.so in $build_dir" >&2
  exit 1
fi

say "sweep: ${models[*]:-all cases}"
if [[ $compare == yes ]]; then run_script compare.py cases; fi
if ((${#cases[@]} > 0)); then run_script sweep_models.py cases "${cases[@]}"; fi
if ((${#solids[@]} > 0)); then run_script sweep_solids.py solids "${solids[@]}"; fi

# Pictures first: what they need is built first.
say "command line: $build_dir/bin/hexsweep"
cmake --build "$build_dir" --target HexSweepPython -j "$(job_count)"
