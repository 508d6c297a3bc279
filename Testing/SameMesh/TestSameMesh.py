# SPDX-License-Identifier: BSD-3-Clause
"""One model by all four ways that lead to a mesh: a C++ program, pvpython, python3, the command line.

    TestSameMesh.py <program> <plugin or nothing> <command line> <part.step> <folder>
"""

import hashlib
import os
import subprocess
import sys

import hexsweep
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

SIZE = "0.4"


def checksums(mesh):
    """Of coordinates, bit for bit, and of the corners of cells, whatever the type of ids."""
    points = vtk_to_numpy(mesh.GetPoints().GetData())
    corners = vtk_to_numpy(mesh.GetCells().GetConnectivityArray()).astype("<i8")
    return [hashlib.sha256(data.tobytes()).hexdigest()[:16] for data in (points.astype("<f8"), corners)]


def read(name):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(name)
    reader.Update()
    return reader.GetOutput()


program, plugin, command_line, part, folder = sys.argv[1:]
here = os.path.dirname(os.path.abspath(__file__))
ways = {"C++": [program, part, SIZE], "command line": [command_line, part, "--size", SIZE, "-o"]}
if plugin:
    ways["pvpython"] = ["pvpython", "--force-offscreen-rendering", f"{here}/sweep_part.py", plugin, part, SIZE]
mesh = hexsweep.sweep(part, size=float(SIZE))
found = {"python3": (mesh.GetNumberOfCells(), *checksums(mesh))}
for way, words in ways.items():
    name = os.path.join(folder, f"same_mesh_{way.replace(' ', '_').replace('+', 'p')}.vtu")
    subprocess.run([*words, name], check=True, timeout=100)
    mesh = read(name)
    found[way] = (mesh.GetNumberOfCells(), *checksums(mesh))
for way, sums in found.items():
    print(f"{way:<12} {sums[0]} hexahedra, points {sums[1]}, cells {sums[2]}")
assert found["python3"][0] > 100, "a mesh"
assert len(set(found.values())) == 1, "the meshes differ"
