# SPDX-License-Identifier: BSD-3-Clause
"""Swept bars go to files of gmsh, as text and binary, of both versions.

Truth: what gmsh itself and meshio read; areas and volume of a box.
"""

import itertools
import os
import subprocess

import numpy as np
from command_line import temporary_folder
from hexsweep import vtkSweepGmshWriter
from swept_bar import AREAS, PARTS, SETS, VOLUME, face_nodes, need, sweep, swept_sets

need("meshio", programs=("gmsh",))
import meshio  # noqa: E402
from vtkmodules.util.numpy_support import vtk_to_numpy  # noqa: E402


def write(swept, name, version, binary):
    writer = vtkSweepGmshWriter()
    sets = swept_sets(swept)
    writer.SetInputConnection(sets.GetOutputPort())
    writer.SetFileName(name)
    writer.SetFileVersion(version)
    writer.SetBinary(binary)
    assert writer.Write() == 1 and writer.GetErrorCode() == 0


def read_by_gmsh(name, folder):
    """The mesh as gmsh writes it anew, with all that it has understood."""
    again = os.path.join(folder, "again.msh")
    done = subprocess.run(
        ["gmsh", name, "-save", "-format", "msh41", "-o", again],
        capture_output=True, text=True, timeout=100, check=False,
    )
    said = done.stdout + done.stderr
    assert done.returncode == 0 and "Error" not in said and "Warning" not in said, said
    return meshio.read(again)


def tetrahedra_volume(points, hexes):
    """Of boxes and prisms with parallel ends, six tetrahedra each."""
    volume = 0.0
    for a, b in ((1, 2), (2, 3), (3, 7), (7, 4), (4, 5), (5, 1)):
        edges = [points[hexes[:, k]] - points[hexes[:, 0]] for k in (a, b, 6)]
        volume += np.einsum("ij,ij->i", np.cross(edges[0], edges[1]), edges[2]) / 6
    return volume


def area_vectors(points, quads):
    diagonals = [points[quads[:, k + 2]] - points[quads[:, k]] for k in (0, 1)]
    return np.cross(*diagonals) / 2


def groups_of(mesh):
    """Cells of each physical group, by dimension and id."""
    found = {}
    tags = mesh.cell_data["gmsh:physical"]
    for block, own in zip(mesh.cells, tags):
        dimension = {"quad": 2, "hexahedron": 3}[block.type]
        for tag in np.unique(own):
            found.setdefault((dimension, int(tag)), []).append(block.data[own == tag])
    return {key: np.concatenate(cells) for key, cells in found.items()}


def expect_bar(mesh, swept, parts, by_gmsh=False):
    grid = swept.GetOutputDataObject(0)
    points = vtk_to_numpy(grid.GetPoints().GetData())
    hexes = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 8)
    # The nodes may stand in another order: they are known by their places. gmsh writes 16 digits.
    number = {tuple(point): i for i, point in enumerate(points.round(12).tolist())}
    ours = np.array([number[tuple(point)] for point in mesh.points.round(12).tolist()])
    assert np.abs(mesh.points - points[ours]).max() <= (1e-15 if by_gmsh else 0.0)
    assert sorted(ours) == list(range(len(points)))
    groups = groups_of(mesh)
    assert sorted(map(tuple, ours[groups[3, 1]])) == sorted(map(tuple, hexes))
    volumes = tetrahedra_volume(mesh.points, groups[3, 1])
    assert volumes.min() > 0 and abs(volumes.sum() - VOLUME) < 1e-9 * VOLUME
    flux = 0.0
    for face, area in AREAS.items():
        quads = groups[2, face]
        assert {int(i) for i in ours[quads].ravel()} == face_nodes(points, face), face
        vectors = area_vectors(mesh.points, quads)
        assert abs(np.linalg.norm(vectors, axis=1).sum() - area) < 1e-9 * area, face
        flux += np.einsum("ij,ij->", mesh.points[quads].mean(axis=1), vectors) / 3
    assert abs(flux - VOLUME) < 1e-9 * VOLUME, "quads face outward"
    names = {name: tuple(int(i) for i in own) for name, own in mesh.field_data.items()}
    expected = {name: (face, 2) for face, name in {**SETS, **(PARTS if parts else {})}.items()}
    assert names == {**expected, "Bar": (1, 3)}, names


def test_comes_back(folder):
    swept = sweep()
    for version, binary in itertools.product((22, 41), (False, True)):
        name = os.path.join(folder, f"bar{version}{binary}.msh")
        write(swept, name, version, binary)
        expect_bar(meshio.read(name), swept, version == 41)
        expect_bar(read_by_gmsh(name, folder), swept, version == 41, by_gmsh=True)


def test_parts_are_groups_of_the_faces_surfaces(folder):
    """In version 4.1 source, target and sides are groups of the same surfaces, by their entries."""
    name = os.path.join(folder, "bar.msh")
    write(sweep(), name, 41, False)
    with open(name, encoding="utf-8") as file:
        rows = file.read().split("$Entities\n")[1].split("$EndEntities")[0].splitlines()
    assert rows[0] == "0 0 6 1"
    groups = {}
    for row in rows[1:7]:
        words = row.split()
        groups[int(words[0])] = [int(word) for word in words[8 : 8 + int(words[7])]]
    assert groups == {1: [1, 7], 2: [2, 8], **{face: [face, 9] for face in (3, 4, 5, 6)}}, groups
    assert rows[7].split()[-7:] == ["6", "1", "2", "3", "4", "5", "6"], rows[7]


if __name__ == "__main__":
    for test in test_comes_back, test_parts_are_groups_of_the_faces_surfaces:
        with temporary_folder() as output:
            test(output)
