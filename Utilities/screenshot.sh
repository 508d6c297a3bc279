#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Utilities/screenshot.sh [case [picture.png]]
#
# Takes the picture of ParaView's window with the chain on a case (default: fig7_growing_hole), or with
# One To One Sweep on a solid of Data/solids or a file of Data/cad, that the documentation shows. For maintainers: needs the build of demo.sh, and the packages
# imagemagick and xdotool.

set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

case_name=${1:-fig7_growing_hole}
script=gui_chain.py
folder=$source_dir/Data/cases/$case_name
picture=${2:-$source_dir/Documentation/pictures/paraview_chain.png}
if [[ -d $source_dir/Data/solids/$case_name ]]; then
  script=gui_solid.py
  folder=$source_dir/Data/solids/$case_name
  picture=${2:-$source_dir/Documentation/pictures/paraview_solid.png}
fi
if [[ -f $source_dir/Data/cad/$case_name.step ]]; then
  script=gui_solid.py
  folder=$source_dir/Data/cad/$case_name.step
  picture=${2:-$source_dir/Documentation/pictures/paraview_cad.png}
fi
plugin=$(find "$build_dir/lib" -name HexSweep.so -type f | head -n 1)
[[ -n $plugin ]] || { echo "screenshot.sh: build first (Utilities/demo.sh)" >&2; exit 1; }

start_display
scratch=$(mktemp -d)
chmod 700 "$scratch"
# A home of its own: no settings of the user are seen in the picture, none are changed.
export HOME=$scratch XDG_RUNTIME_DIR=$scratch QT_QPA_PLATFORM=xcb
export HEXSWEEP_CASE=$folder HEXSWEEP_READY=$scratch/ready
paraview --dr --plugin-search-paths="$(dirname "$plugin")" --plugins=HexSweep \
  --script="$source_dir/Utilities/demo/$script" &
paraview_pid=$!
trap 'kill -KILL "$paraview_pid"; kill "$display_pid"; rm -rf "$scratch"' EXIT

for ((second = 0; second < 180; ++second)); do
  [[ -e $HEXSWEEP_READY ]] && break
  kill -0 "$paraview_pid" 2>/dev/null || { echo "screenshot.sh: ParaView ended early" >&2; exit 1; }
  sleep 1
done
[[ -e $HEXSWEEP_READY ]] || { echo "screenshot.sh: the chain was not drawn in time" >&2; exit 1; }

# Without a window manager the window keeps the size it likes: make it fill the screen.
window=$(xdotool search --onlyvisible --name 'ParaView' | tail -n 1)
xdotool windowmove "$window" 0 0 windowsize "$window" 1920 1200
sleep 5
if [[ $script == gui_chain.py ]]; then
  # The whole chain must be seen: drag the lower edge of the Pipeline Browser down.
  xdotool mousemove 150 507 mousedown 1 mousemove 150 800 sleep 0.5 mouseup 1
else
  # The properties must be seen: drag the right edge of their panel.
  xdotool mousemove 296 900 mousedown 1 mousemove 500 900 sleep 0.5 mouseup 1
fi
sleep 5
mkdir -p "$(dirname "$picture")"
import -window "$window" "$picture"
say "screenshot: $picture"
