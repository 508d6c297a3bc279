# SPDX-License-Identifier: BSD-3-Clause
"""python3 -m hexsweep: lists the faces of a solid and meshes it, from file to file."""

import json
import os
import subprocess
import sys
import tempfile

from vtkmodules.vtkFiltersVerdict import vtkMeshQuality
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

folder = os.path.join(os.environ["HEXSWEEP_DATA_DIR"], "solids", "flange")
solid = os.path.join(folder, "solid.vtu")
with open(os.path.join(folder, "case.json"), encoding="utf-8") as file:
    case = json.load(file)


def run(*arguments):
    return subprocess.run(
        [sys.executable, "-m", "hexsweep", solid, *arguments], timeout=100, check=False,
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
    )


listed = run()
assert listed.returncode == 0, listed.stderr
lines = listed.stdout.splitlines()[1:]
assert len(lines) == case["counts"]["faces"], listed.stdout
assert sum(int(line.split()[1]) for line in lines) == case["counts"]["solid_triangles"]
caps = {int(line.split()[0]) for line in lines if line.endswith("yes")}
assert caps == {*case["source_face_ids"], *case["target_face_ids"]}, "the two plane faces"

with tempfile.TemporaryDirectory(dir=os.environ["HEXSWEEP_TEST_OUTPUT_DIR"]) as output:
    name = os.path.join(output, "flange.vtu")
    source = [str(i) for i in case["source_face_ids"]]
    done = run("--source", *source, "--layers", "4", "--quad-size", "5", "-o", name)
    assert done.returncode == 0, done.stderr
    assert "0 inverted, 0 not certified" in done.stdout, done.stdout
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(name)
    reader.Update()
    hexes = reader.GetOutput()
    assert hexes.GetNumberOfCells() > 0 and hexes.GetNumberOfCells() % 4 == 0
    for h in range(hexes.GetNumberOfCells()):
        assert vtkMeshQuality.HexScaledJacobian(hexes.GetCell(h)) > 0.0, h

    for arguments, part in (
        (("--source", "99", "-o", name + "x.vtu"), "does not exist"),
        (("--source", *source), "name the file to write"),
        (("--source", *source, "-o", os.path.join(output, "flange.txt")), "cannot write .txt"),
    ):
        failed = run(*arguments)
        assert failed.returncode != 0 and part in failed.stderr, (arguments, failed.stderr)
    assert not os.path.exists(name + "x.vtu")
