# SPDX-License-Identifier: BSD-3-Clause
"""hexsweep.sweep() and hexsweep.check(): the same meshes and words as the command line's."""

import ast
import contextlib
import inspect
import json
import os
import pathlib
import re
import subprocess
import sys
import warnings

import hexsweep
import numpy as np
from command_line import COARSE, SOLID, SOURCE, run, temporary_folder
from hexsweep.commandline import arguments
from swept_bar import VOLUME, solid as bar
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON, vtkUnstructuredGrid
from vtkmodules.vtkFiltersSources import vtkCellTypeSource, vtkSphereSource
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

_CAD = os.path.join(os.environ["HEXSWEEP_DATA_DIR"], "cad")
_PACKAGE = os.path.dirname(hexsweep.__file__)


def read(name):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(name)
    reader.Update()
    return reader.GetOutput()


def arrays(mesh):
    return [
        vtk_to_numpy(data).tobytes() for data in (mesh.GetPoints().GetData(), mesh.GetCells().GetConnectivityArray())
    ]


@contextlib.contextmanager
def refused(*parts):
    """Within it a SweepError is raised that says all of `parts`, and nothing is told elsewhere."""
    try:
        yield
    except hexsweep.SweepError as error:
        text = str(error)
        assert all(part in text for part in parts), (parts, text)
        assert text.endswith(".") and "--" not in text, text
        assert ".cxx" not in text and "0x" not in text, text
    else:
        raise AssertionError(f"no error: {parts}")


def expect_same_as_command_line(words, solid, **keywords):
    with temporary_folder() as folder:
        name = os.path.join(folder, "mesh.vtu")
        done = run(solid, *words, "-o", name)
        assert done.returncode == 0, done.stderr
        mesh = hexsweep.sweep(solid, **keywords)
        assert arrays(mesh) == arrays(read(name)), words
        assert str(hexsweep.check(mesh)) in done.stdout, done.stdout
    return mesh


def test_same_mesh_as_by_the_command_line():
    source = [int(face) for face in SOURCE]
    mesh = expect_same_as_command_line(COARSE, SOLID, source=source, layers=4, quad_size=5)
    assert mesh.IsA("vtkUnstructuredGrid") and mesh.GetCellType(0) == VTK_HEXAHEDRON
    several = os.path.join(_CAD, "stepped_shaft.step")
    assembly = os.path.join(_CAD, "pin_in_plate.step")
    if hasattr(hexsweep, "vtkCADReader"):
        mesh = expect_same_as_command_line(["--size", "6"], several, size=6)
        assert mesh.GetFieldData().HasArray("SweepReportRegions"), "between several caps"
        mesh = expect_same_as_command_line(["--size", "3"], assembly, size=3)
        assert mesh.GetFieldData().HasArray("SweepReportPlannedSources"), "as an assembly"
        mesh = expect_same_as_command_line(
            ["--size", "3", "--separate", "--volume", "2"], pathlib.Path(assembly).as_posix(), size=3, separate=True, volume=2
        )
        assert mesh.GetCellData().GetArray("VolumeId").GetRange() == (2.0, 2.0)


def test_numpy_and_boundary():
    mesh, boundary = hexsweep.sweep(bar(), size=0.5, boundary=True)
    points = vtk_to_numpy(mesh.GetPoints().GetData())
    corners = vtk_to_numpy(mesh.GetCells().GetConnectivityArray()).reshape(-1, 8)
    box = points[corners]
    # Layers lie across the bar, so that faces are flat and six tetrahedra make a hexahedron.
    volume = 0.0
    for tetrahedron in ((0, 1, 2, 6), (0, 2, 3, 6), (0, 3, 7, 6), (0, 7, 4, 6), (0, 4, 5, 6), (0, 5, 1, 6)):
        a, b, c, d = (points[corners[:, i]] for i in tetrahedron)
        volume += np.einsum("ij,ij->", np.cross(b - a, c - a), d - a) / 6.0
    assert abs(volume - VOLUME) < 1e-9, volume
    faces = vtk_to_numpy(boundary.GetCellData().GetArray("BoundaryId"))
    assert set(faces.tolist()) == {1, 2, 3, 4, 5, 6}


def test_files_are_written():
    with temporary_folder() as folder:
        folder = pathlib.Path(folder)
        seen = []
        mesh = hexsweep.sweep(
            bar(), size=0.5, output=folder / "bar.inp", json=folder / "bar.json", set_ids={"Clamp": 12},
            role_sets=False, progress=seen.append,
        )
        deck = (folder / "bar.inp").read_text(encoding="utf-8")
        assert "*ELSET, ELSET=Clamp" in deck and "Source" not in deck, deck[:2000]
        report = json.loads((folder / "bar.json").read_text(encoding="utf-8"))
        assert report["hexahedra"] == mesh.GetNumberOfCells() and report["certified"]
        assert {entry["name"]: entry["id"] for entry in report["sets"]}["Clamp"] == 12
        assert seen == sorted(seen) and seen[-1] == 1.0 and len(seen) > 3, seen
        (folder / "bar.inp").unlink()
        (folder / "bar.json").unlink()
        with refused("bar.abc", ".inp"):
            hexsweep.sweep(bar(), output=folder / "bar.abc")
        assert not list(folder.iterdir()), "nothing else is left"


def test_errors_are_exceptions():
    """With the words of the command line, and options as keywords."""
    with refused("nowhere.step", "does not exist"):
        hexsweep.sweep("nowhere.step")
    done = run(SOLID, "--source", "99", "-o", os.path.join(os.environ["HEXSWEEP_TEST_OUTPUT_DIR"], "no.vtu"))
    with refused(done.stderr.split("error: ", 1)[1].strip()):
        hexsweep.sweep(SOLID, source=99)
    with refused("solid", "3"):
        hexsweep.sweep(3)
    with refused("layers", "2.5", "whole number"):
        hexsweep.sweep(SOLID, layers=2.5)
    with refused("size", "'big'"):
        hexsweep.sweep(SOLID, size="big")
    with refused("threads 0", "1 or more"):
        hexsweep.sweep(SOLID, threads=0)
    with refused("direction, draft and imprint_tolerance", "both_ends"):
        hexsweep.sweep(SOLID, direction=(0, 0, 1), source=3)
    with refused("direction", "three numbers"):
        hexsweep.sweep(SOLID, direction=(0, 1))
    with refused("method", "'magic'", "layer-march"):
        hexsweep.sweep(SOLID, method="magic")
    with refused("set_ids['Inlet']"):
        hexsweep.sweep(SOLID, set_ids={"Inlet": "x"})
    with refused("no bodies that touch"):
        hexsweep.sweep(SOLID, plan="plan.json")
    ball = vtkSphereSource()
    ball.Update()
    with refused("hexahedra"):
        hexsweep.check(ball.GetOutput())
    with refused("hexahedra"):
        hexsweep.check(SOLID)


def test_messages_of_others_are_left_alone():
    """A call takes VTK's messages for itself while it lasts, and no longer."""
    window = vtkOutputWindow.GetInstance()
    hexsweep.check(block())
    with refused("does not exist"):
        hexsweep.sweep("nowhere.step")
    assert vtkOutputWindow.GetInstance() is window
    script = (
        "import hexsweep\n"
        "from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid\n"
        "try:\n"
        "    hexsweep.sweep(vtkUnstructuredGrid())\n"
        "except hexsweep.SweepError as error:\n"
        "    assert str(error), 'no words'\n"
        "own = hexsweep.vtkHexValidity()\n"
        "own.SetInputDataObject(vtkUnstructuredGrid())\n"
        "own.Update()\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", script], check=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
    )
    lines = [line for line in done.stdout.replace("\x1b[0m", "").splitlines() if line]
    assert len(lines) == 1 and "vtkHexValidity" in lines[0], done.stdout


def block():
    source = vtkCellTypeSource()
    source.SetCellType(VTK_HEXAHEDRON)
    source.SetBlocksDimensions(3, 3, 3)
    source.Update()
    return source.GetOutput()


def test_check_counts_what_is_wrong():
    quality = hexsweep.check(block())
    assert quality.certified and quality.hexes == 27 and quality.inverted == 0
    assert abs(quality.least - 1) < 1e-12 and abs(quality.mean - 1) < 1e-12
    assert quality.shares == [0] * 10 + [27]
    assert quality.grid.GetCellData().HasArray("Validity")
    bent = vtkUnstructuredGrid()
    bent.DeepCopy(block())
    points = vtkPoints()
    points.DeepCopy(bent.GetPoints())
    inner = next(i for i in range(64) if all(abs(x - 1) < 1e-6 for x in points.GetPoint(i)))
    points.SetPoint(inner, 2.4, 1.0, 1.0)  # behind the next node, of eight hexahedra
    bent.SetPoints(points)
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        quality = hexsweep.check(bent)
    # Of the eight around it those four beyond it have a corner that is turned over.
    assert not quality.certified and quality.inverted >= 4 and quality.least < 0
    assert "inverted" in str(quality) and str(quality.inverted) in str(quality)
    assert len(told) == 1 and told[0].category is hexsweep.SweepWarning, told
    assert told[0].filename == __file__, "the warning is about the caller's line"


def test_help_and_command_line_know_all_keywords():
    parameters = list(inspect.signature(hexsweep.sweep).parameters)
    text = inspect.getdoc(hexsweep.sweep)
    missing = [name for name in parameters if not re.search(rf"^\s+(\w+, )*{name}(, \w+)*:", text, re.M)]
    assert missing == [], missing
    words = {
        action.dest: action.option_strings for action in arguments._mesh_parser()._actions
    }
    options = {name.replace("--", "").replace("-", "_") for names in words.values() for name in names if name[:2] == "--"}
    ours = set(parameters) - {"solid", "boundary", "progress", "set_ids", "role_sets"}
    theirs = options - {"help", "version", "set", "no_role_sets"}
    assert ours == theirs, ours ^ theirs


def test_stubs_have_the_same_parameters():
    with open(os.path.join(_PACKAGE, "api.pyi"), encoding="utf-8") as file:
        stubs = [node for node in ast.parse(file.read()).body if isinstance(node, ast.FunctionDef)]
    assert [stub.name for stub in stubs] == ["sweep", "sweep", "check"]
    for stub in stubs:
        signature = inspect.signature(getattr(hexsweep, stub.name))
        own = [(p.name, None if p.default is p.empty else repr(p.default)) for p in signature.parameters.values()]
        given = [(argument.arg, None) for argument in stub.args.args] + [
            (argument.arg, default and repr(ast.literal_eval(default)))
            for argument, default in zip(stub.args.kwonlyargs, stub.args.kw_defaults)
        ]
        differ = [(a, b) for a, b in zip(own, given) if a != b]
        assert len(own) == len(given) and all(a[0] == "boundary" for a, _ in differ), differ


def test_stubs_are_what_a_type_checker_asks_for():
    try:
        import mypy.api
    except ImportError:
        return  # not installed
    with temporary_folder() as folder:
        name = os.path.join(folder, "script.py")
        with open(name, "w", encoding="utf-8") as file:
            file.write(
                "import hexsweep\n"
                "mesh = hexsweep.sweep('part.step', size=2.0, source=[3])\n"
                "count: int = mesh.GetNumberOfCells()\n"
                "both, boundary = hexsweep.sweep(mesh, boundary=True)\n"
                "certified: bool = hexsweep.check(mesh).certified\n"
                "hexsweep.vtkHexValidity().SetFailIfInvalid(True)\n"
                "hexsweep.sweep('part.step', sice=2.0)\n"
            )
        told, errors, _ = mypy.api.run(["--cache-dir", os.path.join(folder, "cache"), "--follow-imports", "silent", name])
    lines = [line for line in told.splitlines() if "error:" in line]
    assert len(lines) == 1 and ":7:" in lines[0], told + errors


for test_name, test in list(globals().items()):
    if test_name.startswith("test_"):
        test()
