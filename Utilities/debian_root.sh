#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# A bare Debian in a folder, for scripts that try this tree there: sourced, after common.sh.

source_inside=/srv/hexsweep

# The mirror that this system's apt uses.
debian_mirror() {
  apt-get indextargets --format '$(SITE)' 'Created-By: Packages' 'Origin: Debian' | head -n 1
}

# make_debian_root ROOT SUITE MIRROR: leaves $root set; a root that is there is kept as it is.
make_debian_root() {
  root=$1
  if [[ ! -x $root/usr/bin/apt-get ]]; then
    if ((EUID != 0)) || ! command -v debootstrap >/dev/null; then
      echo "a Debian in $root can be made by root alone, with debootstrap (Debian: debootstrap)" >&2
      return 1
    fi
    say "debootstrap: $2 from $3 into $root"
    debootstrap --variant=minbase "$2" "$root" "$3"
    # What is lost in a power cut is made anew: no file is waited for.
    echo force-unsafe-io >"$root/etc/dpkg/dpkg.cfg.d/hexsweep"
  fi
}

# inside COMMAND...: in $root, without anything of this system's environment.
inside() {
  chroot "$root" env -i HOME=/root PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
    DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8 "$@"
}

# copy_tree: this tree, with what is not committed yet, in place of the one that was there; a build in
# it stays, so that only what changed is built anew.
copy_tree() {
  local old=$root$source_inside/source new=$root$source_inside/source.new
  rm -rf "$new"
  mkdir -p "$new"
  (cd "$source_dir" && git ls-files -z --cached --others --exclude-standard |
    tar --create --null --files-from=- --ignore-failed-read 2>/dev/null) |
    tar --extract --no-same-owner --directory="$new"
  if [[ -d $old/build ]]; then mv "$old/build" "$new/build"; fi
  rm -rf "$old"
  mv "$new" "$old"
}
