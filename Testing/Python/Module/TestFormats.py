# SPDX-License-Identifier: BSD-3-Clause
"""hexsweep writes every format that it names, and judges what it reads back.

Truth: what vtkExodusIIReader, meshio and VTK's readers find; where the faces of a box lie.
"""

import json
import os

import numpy as np
from command_line import COARSE, SOLID, refused, run, temporary_folder
from swept_bar import PARTS, SETS, SIZES, face_nodes, need, solid
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOExodus import vtkExodusIIReader
from vtkmodules.vtkIOLegacy import vtkUnstructuredGridReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter, vtkXMLUnstructuredGridReader

need("meshio", "h5py")
import meshio  # noqa: E402

# By meshio, with its array of ids: of faces 1 to 6, and 1 of the hexahedra.
IDS = {".xdmf": "SetId", ".su2": "su2:tag", ".bdf": "nastran:ref", ".mesh": "medit:ref"}
FORMATS = (".vtu", ".vtk", ".ex2", ".inp", ".msh", ".med", *IDS)


def bar(folder):
    name = os.path.join(folder, "bar.vtp")
    writer = vtkXMLPolyDataWriter()
    writer.SetInputData(solid())
    writer.SetFileName(name)
    assert writer.Write() == 1
    return name


def mesh(folder, extension, *words):
    """The bar as a file of that kind, and the one line about it."""
    name = os.path.join(folder, "mesh" + extension)
    done = run(bar(folder), "--source", "1", "--size", "0.8", *words, "-o", name)
    assert done.returncode == 0 and done.stderr == "", (extension, done.stderr)
    assert set(os.listdir(folder)) <= {"bar.vtp", "mesh" + extension}, os.listdir(folder)
    return name, done.stdout.splitlines()[0].partition(": ")[2]


def test_every_format_is_certified_again(folder):
    for extension in FORMATS:
        name, line = mesh(folder, extension)
        report = os.path.join(folder, "report.json")
        done = run("check", name, "--json", report)
        assert done.returncode == 0 and done.stderr == "", (extension, done.stderr)
        found = done.stdout.splitlines()[0]
        assert found == f"{name}: {line}", (extension, found, line)
        with open(report, encoding="utf-8") as file:
            assert json.load(file)["certified"] is True
        if extension in IDS:
            expect_ids(meshio.read(name), IDS[extension])
        elif extension == ".med":
            expect_groups(meshio.read(name))
        elif extension == ".vtk":
            expect_grid(name, line)
        for path in os.listdir(folder):
            os.remove(os.path.join(folder, path))


def expect_ids(read, key):
    assert np.ptp(read.points, axis=0).round(4).tolist() == list(SIZES)
    found = set()
    for block, ids in zip(read.cells, read.cell_data[key]):
        if block.type == "quad":
            for face in np.unique(ids):
                nodes = face_nodes(read.points.round(6), int(face))
                assert set(block.data[ids == face].ravel().tolist()) == nodes, (key, face)
                found.add(int(face))
    assert found == set(SETS), key


def expect_groups(read):
    groups = {}
    for block, families in zip(read.cells, read.cell_data["cell_tags"]):
        for family in np.unique(families):
            (group,) = read.cell_tags[int(family)]
            groups[group] = block.type, block.data[families == family]
    names = {face: "".join(c if c.isascii() else "_" for c in name) for face, name in SETS.items()}
    assert set(groups) == {"Bar", *names.values()}, set(groups)
    assert groups["Bar"][0] == "hexahedron"
    for face, name in names.items():
        kind, cells = groups[name]
        assert kind == "quad" and set(cells.ravel().tolist()) == face_nodes(read.points, face), name


def expect_grid(name, line):
    reader = vtkUnstructuredGridReader()
    reader.SetFileName(name)
    reader.ReadAllScalarsOn()
    reader.Update()
    grid = reader.GetOutput()
    assert line.startswith(f"{grid.GetNumberOfCells()} hexahedra, ")
    assert np.ptp(vtk_to_numpy(grid.GetPoints().GetData()), axis=0).tolist() == list(SIZES)
    assert grid.GetCellData().HasArray("Validity")


def test_names_and_ids_in_exodus(folder):
    name, _ = mesh(folder, ".ex2", "--set", "Clamp=30", "--set", "Sides=1")
    reader = vtkExodusIIReader()
    reader.SetFileName(name)
    reader.UpdateInformation()

    def found(kind):
        numbers = range(reader.GetNumberOfObjects(kind))
        return {reader.GetObjectName(kind, i): reader.GetObjectId(kind, i) for i in numbers}

    expected = {text: face for face, text in SETS.items()}
    expected.update({"Clamp": 30, "Source": 31, "Target": 32, "Sides": 1})
    assert found(reader.SIDE_SET) == expected, found(reader.SIDE_SET)
    assert found(reader.NODE_SET) == {f"{text} nodes": 100 + i for text, i in expected.items()}
    assert found(reader.ELEM_BLOCK) == {"Bar": 1}


def test_single_precision(folder):
    name, _ = mesh(folder, ".vtu", "--precision", "single")
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(name)
    reader.Update()
    assert reader.GetOutput().GetPoints().GetData().GetDataTypeAsString() == "float"


def test_numbers_fit_in_nastran(folder):
    """Coordinates below zero, and near it: their signs and exponents take of 16 characters."""
    name = os.path.join(folder, "flange.bdf")
    done = run(SOLID, *COARSE, "-o", name)
    assert done.returncode == 0 and done.stderr == "", done.stderr
    assert meshio.read(name).points.min() < -1.0
    assert run("check", name).returncode == 0


def test_gmsh_choices(folder):
    starts = {}
    for words in (), ("--msh-version", "2.2"), ("--binary",), ("--msh-version", "2.2", "--binary"):
        name, _ = mesh(folder, ".msh", *words)
        with open(name, "rb") as file:
            starts[words] = file.read().split(b"\n")[1]
        assert set(meshio.read(name).field_data) == {"Bar", *SETS.values()} | (
            set() if "2.2" in words else set(PARTS.values())
        )
    assert list(starts.values()) == [b"4.1 0 8", b"2.2 0 8", b"4.1 1 8", b"2.2 1 8"], starts


def test_wrong_choices_are_refused(folder):
    part = bar(folder)
    name = os.path.join(folder, "mesh.inp")
    for words, said in (
        (("--set", "Nobody=3", "-o", name), 'no set is called "Nobody"'),
        (("--set", "Load=1", "-o", name), "both have the id 1"),
        (("--set", "Load", "-o", name), "is not NAME=ID"),
        (("--set", "Load=-1", "-o", name), "is not NAME=ID"),
        (("--set", "Load=9", "-o", os.path.join(folder, "mesh.vtu")), "has no sets"),
        (("--msh-version", "3", "-o", name), "invalid choice"),
    ):
        refused(part, "--source", "1", "--size", "0.8", *words, part=said)
    assert os.listdir(folder) == ["bar.vtp"], os.listdir(folder)


if __name__ == "__main__":
    for test in (
        test_every_format_is_certified_again, test_names_and_ids_in_exodus, test_single_precision,
        test_numbers_fit_in_nastran, test_gmsh_choices, test_wrong_choices_are_refused,
    ):
        with temporary_folder() as output:
            test(output)
