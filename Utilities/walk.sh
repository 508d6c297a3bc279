#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Utilities/walk.sh [--installed] [CAD file]
#
# A new user's walk through ParaView, by mouse and keyboard on a display without a screen: opens a CAD file
# (default: Data/cad/named_block.step), picks its source cap in the view, sweeps, colours by scaled Jacobian,
# saves the state, ends; then loads the state in a ParaView that is started anew, and wants as many hexahedra.
# Leaves a picture of each step in build/walk; ends with an error where the user would not come further, or
# where Output Messages have something to say.
#
# Takes the plugin of the build, or with --installed the one that ParaView finds by itself: that of the Debian
# package. Needs paraview, xvfb, xdotool, and Qt's Python package: python3-pyqt5 on Debian 12, python3-pyqt6 on 13.

set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

plugin_options=()
if [[ ${1:-} == --installed ]]; then
  shift
else
  plugin=$(find "$build_dir/lib" -name HexSweep.so -type f | head -n 1)
  [[ -n $plugin ]] || { echo "walk.sh: build first (Utilities/demo.sh), or --installed" >&2; exit 1; }
  plugin_options=(--plugin-search-paths="$(dirname "$plugin")" --plugins=HexSweep)
fi
HEXSWEEP_WALK_PART=$(realpath "${1:-$source_dir/Data/cad/named_block.step}")
for program in paraview Xvfb xdotool; do
  command -v $program >/dev/null || { echo "walk.sh: $program is not installed" >&2; exit 1; }
done

HEXSWEEP_WALK_OUTPUT=$source_dir/build/walk
rm -rf "$HEXSWEEP_WALK_OUTPUT"
mkdir -p "$HEXSWEEP_WALK_OUTPUT"
start_display
scratch=$(mktemp -d)
chmod 700 "$scratch"
trap 'kill "$display_pid"; rm -rf "$scratch"' EXIT
# A home of its own, without settings: that of a new user.
export HOME=$scratch XDG_RUNTIME_DIR=$scratch XDG_CONFIG_HOME=$scratch/.config QT_QPA_PLATFORM=xcb
export PYTHONPATH=$source_dir/Utilities/walk PYTHONDONTWRITEBYTECODE=1
export HEXSWEEP_WALK_STATE=$scratch/state.pvsm
export HEXSWEEP_WALK_PART HEXSWEEP_WALK_OUTPUT

for script in sweep reopen; do
  say "walk: $script"
  timeout 600 paraview "${plugin_options[@]}" --script="$source_dir/Utilities/walk/$script.py"
done
say "walk: pictures in $HEXSWEEP_WALK_OUTPUT"
