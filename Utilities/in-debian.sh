#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Utilities/in-debian.sh RELEASE [ROOT [COMMAND...]]
#
# Tries this tree on a bare Debian 12 or 13, as a newcomer would: makes one in the folder ROOT (default:
# /var/tmp/hexsweep-debian-RELEASE; kept as it is if there is one), copies the tree in, and runs the
# README's two commands there, Utilities/test.sh and Utilities/demo.sh, or the COMMANDs given. Prints
# what they print, which is kept in build/debian-RELEASE.log, and how long each took. What is mounted
# is gone at the end. Needs root and debootstrap; an hour on two processors.

set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
source "$(dirname "${BASH_SOURCE[0]}")/debian_root.sh"

declare -A suites=([12]=bookworm [13]=trixie)
release=${1:-}
if [[ -z ${suites[$release]:-} ]]; then
  sed -n 's/^# \{0,1\}//; 3,12p' "${BASH_SOURCE[0]}" >&2
  exit 2
fi
# A name space of our own: whatever happens, nothing stays mounted.
if [[ -z ${HEXSWEEP_UNSHARED:-} ]]; then
  HEXSWEEP_UNSHARED=yes exec unshare --mount --propagation private "${BASH_SOURCE[0]}" "$@"
fi

log=$source_dir/build/debian-$release.log
mkdir -p "$(dirname "$log")"
exec > >(tee "$log") 2>&1
make_debian_root "${2:-/var/tmp/hexsweep-debian-$release}" "${suites[$release]}" "$(debian_mirror)"
mount -t proc proc "$root/proc"
mount --rbind /sys "$root/sys"
mount --rbind /dev "$root/dev"
mount -t tmpfs tmpfs "$root/dev/shm" 2>/dev/null || true

say "copy the tree"
copy_tree
shift $(($# < 2 ? $# : 2))
if (($# == 0)); then set -- Utilities/test.sh Utilities/demo.sh; fi
failed=()
for command in "$@"; do
  say "Debian $release: $command"
  begin=$(date +%s)
  inside bash -c "cd $source_inside/source && $command" || failed+=("$command")
  say "Debian $release: $command took $(($(date +%s) - begin)) s"
done
if ((${#failed[@]} > 0)); then
  say "Debian $release: failed: ${failed[*]}"
  exit 1
fi
say "Debian $release: all went well"
