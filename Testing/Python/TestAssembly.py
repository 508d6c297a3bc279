# SPDX-License-Identifier: BSD-3-Clause
"""The command line on bodies that touch: one conforming mesh, plans, refusals."""

import json
import os
import subprocess
import sys
import tempfile

import hexsweep
from hexsweep.sweeps.assembly import gaps
from vtkmodules.vtkCommonCore import vtkIdTypeArray
from vtkmodules.vtkCommonDataModel import vtkPartitionedDataSetCollection
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkIOExodus import vtkExodusIIReader
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

DATA = os.environ["HEXSWEEP_DATA_DIR"]
TOOL = os.path.join(os.environ["HEXSWEEP_BINARY_DIR"], "bin", "hexsweep")


def run(*words):
    done = subprocess.run([TOOL, *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=200, check=False)
    return done.returncode, done.stdout, done.stderr


def read(path):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def arrays_of(grid):
    return grid.GetPoints().GetData(), grid.GetCells().GetConnectivityArray()


def face_uses(grid):
    """How often each face of a hexahedron is used, by its nodes."""
    corners = memoryview(grid.GetCells().GetConnectivityArray()).tolist()
    sides = ((0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7), (0, 3, 2, 1), (4, 5, 6, 7))
    uses = {}
    for start in range(0, len(corners), 8):
        for side in sides:
            key = tuple(sorted(corners[start + c] for c in side))
            uses[key] = uses.get(key, 0) + 1
    return uses


def cubes(start):
    """A unit cube and another one that begins at x = start."""
    collection = vtkPartitionedDataSetCollection()
    for number, left in enumerate((0.0, start)):
        cube = vtkCubeSource()
        cube.SetOutputPointsPrecision(vtkAlgorithm.DOUBLE_PRECISION)
        cube.SetBounds(left, left + 1, 0, 1, 0, 1)
        triangles = vtkTriangleFilter()
        triangles.SetInputConnection(cube.GetOutputPort())
        triangles.Update()
        collection.SetPartition(number, 0, triangles.GetOutput())
    return collection


def test_gaps():
    for start, expected in ((1.0005, 1), (1.00001, 1), (1.1, 0), (1.0, 0), (0.5, 0)):
        sentences = gaps(cubes(start))
        assert len(sentences) == expected, (start, sentences)
    assert "volume 1 and volume 2 are 0.0005" in gaps(cubes(1.0005))[0], gaps(cubes(1.0005))


def shared_quads(solids):
    """Of two cubes, and the ids of their volumes."""
    sweep = hexsweep.vtkAssemblySweep()
    sweep.SetInputDataObject(solids)
    sweep.SetSize(0.5)
    sweep.MergedOn()
    sweep.Update()
    volumes = sweep.GetOutputDataObject(1).GetCellData().GetArray("VolumeIds")
    grid = sweep.GetOutput().GetPartition(0, 0)
    assert set(face_uses(grid).values()) == {1, 2}
    ids = set(memoryview(grid.GetCellData().GetArray("VolumeId")))
    return sum(volumes.GetComponent(i, 1) > 0 for i in range(volumes.GetNumberOfTuples())), ids


def test_tolerance():
    """Points that differ by rounding are one; surfaces of two readers in one data set share what coincides."""
    for start in (1.0, 1.0 + 1e-13, 1.0 + 1e-9):
        quads, ids = shared_quads(cubes(start))
        assert quads > 0 and ids == {1, 2}, (start, quads, ids)
    both = vtkAppendPolyData()
    for number in (0, 1):
        both.AddInputData(cubes(1.0).GetPartition(number, 0))
    both.Update()
    quads, ids = shared_quads(both.GetOutput())
    assert quads > 0 and ids == {1, 2}, (quads, ids)
    numbers = vtkIdTypeArray()
    numbers.SetName("VolumeId")
    for cell in range(both.GetOutput().GetNumberOfCells()):
        numbers.InsertNextValue(cell // 12)  # from 0 on
    both.GetOutput().GetCellData().AddArray(numbers)
    quads, ids = shared_quads(both.GetOutput())
    assert quads > 0 and ids == {1, 2}, (quads, ids)


def main():
    test_gaps()
    test_tolerance()
    if not hasattr(hexsweep, "vtkCADReader"):
        return  # HexSweep was built without OpenCASCADE
    tee = os.path.join(DATA, "cad", "tee_blocks.step")
    with tempfile.TemporaryDirectory() as folder:
        out, plan = (os.path.join(folder, name) for name in ("tee.vtu", "tee.json"))
        status, told, _ = run(tee, "--size", "2", "-o", out, "--plan", plan)
        assert status == 0 and "0 not certified" in told, told
        grid = read(out)
        assert set(memoryview(grid.GetCellData().GetArray("VolumeId"))) == {1, 2}
        assert set(face_uses(grid).values()) == {1, 2}

        # Read again the plan is obeyed, and gives the same mesh.
        again = os.path.join(folder, "again.vtu")
        assert run(tee, "-o", again, "--plan", plan)[0] == 0
        for one, other in zip(arrays_of(grid), arrays_of(read(again))):
            assert memoryview(one).tobytes() == memoryview(other).tobytes()
        with open(plan, encoding="utf-8") as file:
            content = json.load(file)
        assert [volume["id"] for volume in content["volumes"]] == [1, 2]
        content["volumes"][0]["layers"] += 2
        edited = os.path.join(folder, "edited.json")
        with open(edited, "w", encoding="utf-8") as file:
            json.dump(content, file)
        status, told, complaint = run(tee, "-o", again, "--plan", edited)
        assert status == 0, complaint
        assert read(again).GetNumberOfCells() != grid.GetNumberOfCells()
        with open(edited, encoding="utf-8") as file:
            assert json.load(file) == content, "an edited plan was overwritten"
        with open(edited, "w", encoding="utf-8") as file:
            file.write('{"volumes": [{"source": 3}]}')
        status, _, complaint = run(tee, "-o", again, "--plan", edited)
        assert status == 1 and "is no plan" in complaint, complaint

        # Each by itself: no node is shared.
        assert run(tee, "--size", "2", "--separate", "-o", again)[0] == 0
        assert set(face_uses(read(again)).values()) == {1, 2}
        assert read(again).GetNumberOfPoints() > grid.GetNumberOfPoints()

        status, _, complaint = run(tee, "--layers", "4", "-o", again)
        assert status == 1 and "--layers" in complaint and "--separate" in complaint, complaint
        status, _, complaint = run(tee, "--source", "3", "-o", again)
        assert status == 1 and "face 3" in complaint, complaint

        # Sets by the names of both bodies, for solvers.
        inp = os.path.join(folder, "tee.inp")
        assert run(tee, "--size", "2", "-o", inp)[0] == 0
        with open(inp, encoding="utf-8") as file:
            text = file.read()
        assert text.count("*ELEMENT") == 2 and "*SURFACE" in text.upper()
        # Element blocks have the bodies' names.
        exodus = os.path.join(folder, "tee.ex2")
        status, _, complaint = run(tee, "--size", "2", "-o", exodus)
        assert status == 0 and complaint == "", complaint
        reader = vtkExodusIIReader()
        reader.SetFileName(exodus)
        reader.UpdateInformation()
        blocks = [reader.GetObjectName(reader.ELEM_BLOCK, i) for i in range(reader.GetNumberOfElementBlockArrays())]
        assert [name.split(" ID")[0] for name in blocks] == ["Solid 1", "Solid 2"], blocks
        assert run("check", exodus)[0] == 0
    print("assemblies by the command line")


if __name__ == "__main__":
    sys.exit(main())
