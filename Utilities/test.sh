#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Utilities/test.sh [ctest option...]
#
# Installs what is missing, builds HexSweep and runs all its tests. Those that draw share one
# virtual display, which ctest starts first and stops last. Options are ctest's, e.g.
# Utilities/test.sh -R Validity.

set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

# Beside what building needs: Sphinx for the guide, mypy for the type stubs.
"$source_dir/Utilities/install-dependencies.sh" python3-sphinx python3-myst-parser mypy
configure_and_build all
say "test"
# One test after the other: those that draw share the processors with the software renderer.
ctest --test-dir "$build_dir" --output-on-failure "$@"
