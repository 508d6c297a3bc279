# SPDX-License-Identifier: BSD-3-Clause
"""Runs a script of Testing/Plugin/Window in ParaView's window, as a user who has never started it.

    python3 in_window.py PARAVIEW PLUGIN SCRIPT

77: skipped, as xdotool or Qt's Python package is not installed.
"""

import os
import shutil
import subprocess
import sys
import tempfile

paraview, plugin, script = sys.argv[1:]
if not shutil.which("xdotool"):
    print("xdotool is not installed")
    sys.exit(77)
with tempfile.TemporaryDirectory() as home:  # only its owner may enter it: Qt asks for that
    environment = dict(
        os.environ, HOME=home, XDG_RUNTIME_DIR=home, XDG_CONFIG_HOME=os.path.join(home, ".config"), QT_QPA_PLATFORM="xcb",
        HEXSWEEP_WALK_OUTPUT=os.environ["HEXSWEEP_TEST_OUTPUT_DIR"],
    )
    done = subprocess.run(
        [paraview, f"--plugin-search-paths={os.path.dirname(plugin)}", "--plugins=HexSweep", f"--script={script}"],
        env=environment, check=False,
    )
sys.exit(done.returncode)
