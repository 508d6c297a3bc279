# SPDX-License-Identifier: BSD-3-Clause
"""Runs the pvpython script of the guide's page about ParaView and lets Verdict judge the files that it writes."""

import os
import subprocess
import sys
import tempfile

SOURCE_DIR = os.environ["HEXSWEEP_SOURCE_DIR"]
sys.path.insert(0, os.path.join(SOURCE_DIR, "Testing", "Guide"))
from run_page import blocks  # noqa: E402

PAGE = os.path.join(SOURCE_DIR, "Documentation", "guide", "paraview.md")

with tempfile.TemporaryDirectory(dir=os.environ["HEXSWEEP_TEST_OUTPUT_DIR"]) as folder:
    # The reader stands in the clone, where demo.sh has built in build/release.
    os.symlink(os.path.join(SOURCE_DIR, "Data"), os.path.join(folder, "Data"))
    os.mkdir(os.path.join(folder, "build"))
    os.symlink(os.environ["HEXSWEEP_BINARY_DIR"], os.path.join(folder, "build", "release"))
    with open(os.path.join(folder, "sweep.py"), "w", encoding="utf-8") as file:
        (script,) = blocks(PAGE, "python")
        file.write(script)
    done = subprocess.run(
        ["pvpython", "sweep.py"], cwd=folder, timeout=300, check=False,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
    )
    print(done.stdout)
    assert done.returncode == 0, "the script ends with an error"
    assert "ERR|" not in done.stdout and "WARN|" not in done.stdout, "a filter complains"

    from paraview import servermanager, simple

    for name, hexes in (("flange", None), ("c_open", 11440)):
        mesh = simple.OpenDataFile(os.path.join(folder, name + ".vtu"))
        quality = simple.MeshQuality(Input=mesh, HexQualityMeasure="Scaled Jacobian")
        judged = servermanager.Fetch(quality)
        count = judged.GetNumberOfCells()
        assert count == hexes if hexes else count > 1000 and count % 6 == 0, f"{name}: {count} hexes"
        least = judged.GetCellData().GetArray("Quality").GetRange()[0]
        assert least > 0, f"{name}: Verdict's least scaled Jacobian is {least}"
