#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Utilities/lint.sh [revision]
#
# clang-format and clang-tidy 14 (Debian 12: clang-format clang-tidy) on all sources, or on those that
# were changed since a revision. Needs a configured build: HEXSWEEP_BUILD_DIR, default build/release.
# clang-tidy reads the sources of Filters, Filters/Core and IO, ten seconds of CPU a file; a changed header
# is read with the source of its name, or with one that includes it.
# HEXSWEEP_LINT_SECONDS=n begins no file after n seconds, and says which were not read.

set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
cd "$source_dir"

revision=${1:-}
database=$build_dir/compile_commands.json
if [[ ! -f $database ]]; then
  echo "lint.sh: no $database; configure first: cmake --preset release -B $build_dir" >&2
  exit 2
fi
for tool in clang-format clang-tidy; do
  if ! command -v $tool >/dev/null; then
    echo "lint.sh: $tool is missing; on Debian 12: apt-get install clang-format clang-tidy" >&2
    exit 2
  fi
done

if [[ -n $revision ]]; then
  mapfile -t files < <(git diff --name-only --diff-filter=d "$revision" -- '*.h' '*.cxx')
else
  mapfile -t files < <(git ls-files '*.h' '*.cxx')
fi
if ((${#files[@]} == 0)); then
  say "lint: no source changed since $revision"
  exit 0
fi

say "clang-format: ${#files[@]} file(s)"
clang-format --dry-run -Werror "${files[@]}"

# The source that shows a header to the compiler.
source_of() {
  local header=$1
  if [[ -f ${header%.h}.cxx ]]; then
    echo "${header%.h}.cxx"
  else
    header=${header#Filters/}
    # Read to the end: a reader that leaves early would fail the whole list.
    { git grep -l -F "${header#IO/*/}\"" -- 'Filters/*.cxx' 'IO/*.cxx' || true; } | sed -n 1p
  fi
}

mapfile -t sources < <(
  for file in "${files[@]}"; do
    case $file in
      Filters/*.cxx | IO/*.cxx) echo "$file" ;;
      Filters/*.h | IO/*.h) source_of "$file" ;;
    esac
  done | sort -u
)
if ((${#sources[@]} == 0)); then
  say "clang-tidy: nothing of Filters or IO changed"
  exit 0
fi

# Without what only GCC knows: its warnings, and a precompiled header of its own. Sources that are
# compiled together are read one by one, so that each includes what it needs.
commands=$(mktemp -d)
trap 'rm -rf "$commands"' EXIT
python3 - "$database" "$commands/compile_commands.json" <<'PYTHON'
import json, re, sys

with open(sys.argv[1], encoding="utf-8") as file:
    entries = json.load(file)
first = {}  # some sources are compiled for the tests as well
for entry in entries:
    command = re.sub(r" -include \S*cmake_pch\.hxx", "", entry["command"])
    command = re.sub(r" -W(?!l,)\S+", "", command)
    sources = [entry["file"]]
    if "/Unity/unity_" in entry["file"]:
        with open(entry["file"], encoding="utf-8") as file:
            sources = re.findall(r'^#include "(.*)"$', file.read(), re.MULTILINE)
    for source in sources:
        alone = command.replace(entry["file"], source)
        first.setdefault(source, {**entry, "file": source, "command": alone})
with open(sys.argv[2], "w", encoding="utf-8") as file:
    json.dump(list(first.values()), file)
PYTHON

lint() {
  if ((HEXSWEEP_LINT_SECONDS > 0 && $(date +%s) - begin > HEXSWEEP_LINT_SECONDS)); then
    echo "not read, time is up: $1"
  else
    clang-tidy -p "$commands" --quiet "$1" 2> >(grep -v 'warnings generated' >&2)
  fi
}
export -f lint
begin=$(date +%s)
export commands begin HEXSWEEP_LINT_SECONDS=${HEXSWEEP_LINT_SECONDS:-0}
say "clang-tidy: ${#sources[@]} source(s)"
printf '%s\0' "${sources[@]}" | xargs -0 -n 1 -P "$(job_count)" bash -c 'lint "$1"' lint
say "lint: nothing to mend"
