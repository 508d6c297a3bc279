#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Utilities/benchmark.sh [option of Utilities/benchmark/whole_job.py...]
#
# Builds HexSweep and runs the whole job of a user, from the file of a solid to the file of its mesh, in
# turns with gmsh as a process: CPU seconds, memory, quality, one thread and two. Writes
# Documentation/Benchmarks.md and its pictures. Default: 100 000 and a million hexahedra, five runs each
# (some five minutes); `--sizes 100000 1000000 10000000` takes half an hour and 8 GB.
#
# The stages against their peers are Testing/Benchmarks (Google Benchmark), see the README there.

set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

"$source_dir/Utilities/install-dependencies.sh" gmsh python3-matplotlib
configure_and_build HexSweep HexSweepPython
package=$(find "$build_dir/lib" -type d -path '*site-packages/hexsweep' | head -n 1)
# As the packages install it.
/usr/bin/python3 -m compileall -q "$package"
PYTHONPATH=$(dirname "$package") /usr/bin/python3 "$source_dir/Utilities/benchmark/whole_job.py" \
  --output "$source_dir/build/benchmark" "$@"
