# SPDX-License-Identifier: BSD-3-Clause
"""Swept bars go to files of Abaqus and CalculiX.

Truth: what meshio reads, where the faces of a box lie; and the stress and the displacement of a bar
under tension, by CalculiX.
"""

import os
import re
import subprocess

import numpy as np
from command_line import temporary_folder
from hexsweep import vtkSweepAbaqusWriter
from swept_bar import SIZES, face_nodes, need, sweep, swept_sets

need("meshio", programs=("ccx",))
import meshio  # noqa: E402
from vtkmodules.util.numpy_support import vtk_to_numpy  # noqa: E402

LABELS = {1: "Clamp", 2: "Load", 3: "x___0", 4: "Wall_4", 5: "Y_0__u_en", 6: "wall_6"}
# Sides of C3D8 by their nodes, from the manuals, from 0 on.
SIDES = [(0, 1, 2, 3), (4, 5, 6, 7), (0, 1, 4, 5), (1, 2, 5, 6), (2, 3, 6, 7), (0, 3, 4, 7)]


def write(swept, name):
    writer = vtkSweepAbaqusWriter()
    sets = swept_sets(swept)
    writer.SetInputConnection(sets.GetOutputPort())
    writer.SetFileName(name)
    assert writer.Write() == 1 and writer.GetErrorCode() == 0


def surfaces_of(name):
    """Pairs of an element and its side, from 1 on, by name."""
    with open(name, encoding="ascii") as file:
        parts = re.split(r"^\*SURFACE, NAME=(.*), TYPE=ELEMENT$", file.read(), flags=re.M)
    sides = (re.findall(r"^(\d+), S(\d)$", part.split("*")[0], flags=re.M) for part in parts[2::2])
    return {key: [(int(e), int(s)) for e, s in own] for key, own in zip(parts[1::2], sides)}


def test_comes_back(folder):
    swept = sweep()
    name = os.path.join(folder, "bar.inp")
    write(swept, name)
    mesh = meshio.read(name)
    grid = swept.GetOutputDataObject(0)
    points = vtk_to_numpy(grid.GetPoints().GetData())
    hexes = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 8)
    # All digits, but for numbers that take more than 20 characters.
    assert np.allclose(mesh.points, points, rtol=1e-13, atol=0.0)
    assert [block.type for block in mesh.cells] == ["hexahedron"]
    assert np.array_equal(mesh.cells[0].data, hexes)
    surfaces = surfaces_of(name)
    for face, label in LABELS.items():
        nodes = face_nodes(points, face)
        assert set(mesh.point_sets[label].tolist()) == nodes, label
        behind = {h for h, own in enumerate(hexes) if len(nodes & set(own.tolist())) == 4}
        assert set(mesh.cell_sets[label][0].tolist()) == behind, label
        sides = surfaces[label]
        assert {element - 1 for element, _ in sides} == behind and len(sides) == len(behind)
        for element, side in sides:
            assert {int(hexes[element - 1][k]) for k in SIDES[side - 1]} <= nodes, (label, element)
    assert set(mesh.cell_sets) == {"Bar", *surfaces}
    assert set(surfaces) == {*LABELS.values(), "Source", "Target", "Sides"}


def test_bar_under_tension(folder):
    """Elements that are no boxes take constant stress exactly, whatever their shape."""
    mesh = os.path.join(folder, "mesh.inp")
    write(sweep(), mesh)
    young, pull = 210000.0, 150.0
    loads = "\n".join(f"{element}, P{side}, {-pull}" for element, side in surfaces_of(mesh)["Load"])
    with open(os.path.join(folder, "job.inp"), "w", encoding="ascii") as file:
        file.write(f"""*INCLUDE, INPUT=mesh.inp
*MATERIAL, NAME=STEEL
*ELASTIC
{young}, 0.3
*SOLID SECTION, ELSET=BAR, MATERIAL=STEEL
*STEP
*STATIC
*BOUNDARY
CLAMP, 3, 3
x___0, 1, 1
Y_0__u_en, 2, 2
*DLOAD
{loads}
*EL PRINT, ELSET=BAR
S
*NODE PRINT, NSET=LOAD
U
*SECTION PRINT, SURFACE=LOAD, NAME=PULL
SOF
*END STEP
""")
    done = subprocess.run(
        ["ccx", "job"], cwd=folder, capture_output=True, text=True, timeout=200, check=False
    )
    assert done.returncode == 0 and "ERROR" not in done.stdout, done.stdout[-2000:]
    with open(os.path.join(folder, "job.dat"), encoding="ascii") as file:
        told = file.read()
    nodes_and_stresses, _, section = told.partition("statistics for surface set LOAD")
    rows = [list(map(float, line.split())) for line in nodes_and_stresses.splitlines() if re.match(r"\s+\d", line)]
    stresses = np.array([row[2:] for row in rows if len(row) == 8])
    moves = np.array([row[1:] for row in rows if len(row) == 4])
    assert len(stresses) and len(moves)
    assert np.allclose(stresses[:, 2], pull, rtol=1e-6, atol=0.0)
    assert np.abs(np.delete(stresses, 2, axis=1)).max() < 1e-6 * pull
    assert np.allclose(moves[:, 2], pull / young * SIZES[2], rtol=1e-6, atol=0.0)
    # Of the surface: the force, which CalculiX integrates with few digits, the middle, the normal.
    force, middle = (list(map(float, section.split("\n\n")[i].split())) for i in (2, 4))
    area = SIZES[0] * SIZES[1]
    assert np.allclose(force[:3], [0, 0, pull * area], rtol=0.0, atol=1e-4 * pull * area), force
    assert np.allclose(middle, [SIZES[0] / 2, SIZES[1] / 2, SIZES[2], 0, 0, 1], rtol=0.0, atol=1e-6)


def test_numbers_have_no_more_characters_than_are_read(folder):
    name = os.path.join(folder, "small.inp")
    write(sweep(size=0.6e-7 / 3, scale=1e-7 / 3), name)
    points = meshio.read(name).points
    assert abs(points[:, 2].max() - 7e-7 / 3) < 1e-19
    with open(name, encoding="ascii") as file:
        rows = file.read().split("*NODE\n")[1].split("*")[0].splitlines()
    numbers = [word for row in rows for word in row.split(", ")[1:]]
    assert max(map(len, numbers)) == 20, max(numbers, key=len)


if __name__ == "__main__":
    for test in test_comes_back, test_bar_under_tension, test_numbers_have_no_more_characters_than_are_read:
        with temporary_folder() as output:
            test(output)
