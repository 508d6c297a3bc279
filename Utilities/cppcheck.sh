#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Utilities/cppcheck.sh
#
# cppcheck (Debian 12: 2.10) on the sources of Filters, IO and Plugin; the exit status is 1 where it finds anything that is
# not in Utilities/cppcheck.txt with its reason. About two minutes of a processor.

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
if ! command -v cppcheck >/dev/null; then
  echo "cppcheck.sh: cppcheck is missing; on Debian: apt-get install cppcheck" >&2
  exit 2
fi
cppcheck --quiet --force --error-exitcode=1 --enable=warning,performance,portability --language=c++ --std=c++17 \
  -I Filters -I IO/CAD -I IO/Mesh '-DvtkTemplateMacro(call)=case 1: call' --suppressions-list=Utilities/cppcheck.txt \
  --template='{file}:{line}: {severity}: {id}: {message}' Filters IO Plugin
echo "== cppcheck: nothing found"
