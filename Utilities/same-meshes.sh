#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Utilities/same-meshes.sh OLD NEW
#
# Tells whether two states of HexSweep make the same meshes, bit for bit: all of Data/cases through
# the chained filters, all of Data/solids by OneToOneSweep. OLD and NEW are build directories that
# hold the plugin (nothing is built then), or git revisions, each built in a scratch worktree, e.g.
#
#   Utilities/same-meshes.sh main build/release
#
# Data and scripts are those beside this one. Prints a line a mesh; a difference is told by array,
# tuple and values, and makes the script fail. An array that only NEW has, and the text of warnings,
# are said but are no difference. About a minute on two processors.

set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

if (($# != 2)); then
  sed -n 's/^# \{0,1\}//; 3,14p' "${BASH_SOURCE[0]}" >&2
  exit 2
fi
scratch=$(mktemp -d)
remove_scratch() {
  local tree
  for tree in "$scratch"/tree_*; do
    if [[ -d $tree ]]; then git -C "$source_dir" worktree remove --force "$tree"; fi
  done
  rm -rf "$scratch"
}
trap remove_scratch EXIT

# build_revision NAME REVISION: leaves the build in $scratch/tree_NAME/build/release.
build_revision() {
  local tree=$scratch/tree_$1 options=()
  git -C "$source_dir" worktree add --quiet --detach "$tree" "$2" || return
  if command -v ccache >/dev/null; then options=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi
  export CCACHE_BASEDIR=$tree CCACHE_NOHASHDIR=1
  (cd "$tree" && cmake --preset release -B build/release -DBUILD_TESTING=OFF \
    -DPython3_EXECUTABLE=/usr/bin/python3 "${options[@]}") || return
  cmake --build "$tree/build/release" --target HexSweep -j "$(job_count)"
}

# plugin_of NAME ARGUMENT: prints where the plugin of OLD or NEW is; builds it if need be.
plugin_of() {
  local directory=$2 plugin
  if [[ ! -d $directory ]]; then
    directory=$scratch/tree_$1/build/release
    say "build $2" >&2
    if ! build_revision "$1" "$2" >"$scratch/$1.log" 2>&1; then
      tail -n 30 "$scratch/$1.log" >&2
      echo "same-meshes.sh: $2 is neither a directory nor a revision that builds" >&2
      return 1
    fi
  fi
  plugin=$(find "$(cd "$directory" && pwd)"/lib* -name HexSweep.so -type f | head -n 1)
  if [[ -z $plugin ]]; then
    echo "same-meshes.sh: no HexSweep.so below $directory/lib; build the target HexSweep" >&2
    return 1
  fi
  echo "$plugin"
}

write_meshes() { # name, plugin
  PYTHONDONTWRITEBYTECODE=1 pvpython --force-offscreen-rendering \
    "$source_dir/Utilities/same_meshes/write_meshes.py" \
    --plugin "$2" --data "$source_dir/Data" --output "$scratch/$1"
}

old_plugin=$(plugin_of old "$1")
new_plugin=$(plugin_of new "$2")
say "meshes of $1 and $2"
write_meshes old "$old_plugin" &
old_process=$!
write_meshes new "$new_plugin"
wait "$old_process"
say "compare"
/usr/bin/python3 "$source_dir/Utilities/same_meshes/compare_meshes.py" "$scratch/old" "$scratch/new"
