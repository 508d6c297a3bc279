# SPDX-License-Identifier: BSD-3-Clause
"""hexsweep check: judges the hexahedra of any file; and what both commands tell beside that.

Truth: hexahedra that are valid or not by how they were made; the size of a picture; JSON that
another parser reads.
"""

import json
import os
import pty
import shutil
import subprocess
import sys

from command_line import COARSE, SOLID, command, old_file, refused, run, temporary_folder
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (
    VTK_HEXAHEDRON,
    VTK_QUAD,
    VTK_TETRA,
    vtkUnstructuredGrid,
)
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter

CUBE = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
# Its corner 6 beyond the plane of its neighbours: the Jacobian there is negative.
DENTED = [*CUBE[:6], (0.2, 0.2, 0.2), CUBE[7]]
WITHOUT_DISPLAY = {key: value for key, value in os.environ.items() if key != "DISPLAY"}


def save(folder, name, cells):
    """@param cells: pairs of a VTK cell type and its points."""
    grid, points = vtkUnstructuredGrid(), vtkPoints()
    points.SetDataTypeToDouble()
    grid.SetPoints(points)
    for kind, corners in cells:
        first = points.GetNumberOfPoints()
        for corner in corners:
            points.InsertNextPoint(corner)
        grid.InsertNextCell(kind, len(corners), list(range(first, first + len(corners))))
    path = os.path.join(folder, name)
    writer = vtkXMLUnstructuredGridWriter()
    writer.SetInputData(grid)
    writer.SetFileName(path)
    writer.Write()
    return path


def test_valid_and_not(folder):
    cube, dented = (VTK_HEXAHEDRON, CUBE), (VTK_HEXAHEDRON, DENTED)
    good = run("check", save(folder, "good.vtu", [cube, (VTK_QUAD, CUBE[:4])]))
    assert good.returncode == 0 and good.stderr == "", good.stderr
    assert "1 hexahedra, 0 inverted, 0 not certified" in good.stdout, good.stdout
    assert f"0.9 to 1.0               1  100.0% {40 * '#'}" in good.stdout, good.stdout
    bad = run("check", save(folder, "bad.vtu", [cube, dented]))
    assert bad.returncode == 2, bad.returncode
    assert "2 hexahedra, 1 inverted, 1 not certified" in bad.stdout, bad.stdout
    assert f"0 and below              1   50.0% {20 * '#'}" in bad.stdout, bad.stdout
    lines = bad.stderr.splitlines()
    assert lines and all(line.startswith("hexsweep: warning: ") for line in lines), bad.stderr
    mixed = run("check", save(folder, "mixed.vtu", [cube, (VTK_TETRA, CUBE[:3] + CUBE[4:5])]))
    assert mixed.returncode == 2 and "Not judged: 1 other cells" in mixed.stdout, mixed.stdout


def test_refusals(folder):
    empty = save(folder, "empty.vtu", [])
    flat = save(folder, "flat.vtu", [(VTK_QUAD, CUBE[:4])])
    junk = [old_file(folder, "junk" + name) for name in (".vtu", ".vtk", ".inp", ".msh", ".e")]
    for name in junk:
        refused("check", name, part=f"{name}: ")
    for words, part in (
        ((flat,), "no hexahedra in it"),
        ((empty,), "no cells in it"),
        ((os.path.join(folder, "none.vtu"),), "does not exist"),
        ((__file__,), "only .vtk, .vtu"),
        ((), "required: mesh"),
        ((flat, "--json", flat), "is the same file as the input"),
        ((flat, "--threads", "0"), "--threads 0: give 1 to 4096"),
        ((flat, "--picture", "x.jpg"), "only .png"),
        ((flat, "--json", "x", "--picture", "./x"), "is the same file as the output x"),
        ((flat, "--json", os.path.join(folder, "none", "x")), "does not exist"),
    ):
        refused("check", *words, part=part)


def test_report(folder):
    name, report = (os.path.join(folder, own) for own in ("mesh.ex2", "report.json"))
    done = run(SOLID, *COARSE, "--set", "Face 3=33", "-o", name, "--json", report)
    assert done.returncode == 0 and done.stderr == "", done.stderr
    with open(report, encoding="utf-8") as file:
        told = json.load(file)
    assert told["certified"] is True and told["inverted"] == told["not_certified"] == 0
    assert done.stdout.startswith(f"{name}: {told['hexahedra']} hexahedra, "), done.stdout
    assert sum(told["scaled_jacobian"]["tenths"]) == told["hexahedra"]
    assert told["report"]["SweepReportHexes"] == [told["hexahedra"]]
    assert told["report"]["SweepReportMethod"] and told["hexsweep"] and told["vtk"]
    assert told["settings"]["NumberOfLayers"] == 4 and told["settings"]["SetIds"] == {"Face 3": 33}
    sets = {own["name"]: own for own in told["sets"]}
    assert sets["Face 3"]["id"] == 33 and sets["Face 3"]["node_set_id"] == 133
    assert {"Source", "Target", "Sides"} < set(sets)
    checked = os.path.join(folder, "checked.json")
    assert run("check", name, "--json", checked).returncode == 0
    with open(checked, encoding="utf-8") as file:
        again = json.load(file)
    quality, once_more = told["scaled_jacobian"], again["scaled_jacobian"]
    # A file of Exodus II has the hexahedra in another order, in which they are added up.
    assert abs(quality.pop("mean") - once_more.pop("mean")) < 1e-12 and quality == once_more
    # A mesh that is refused leaves no report.
    os.remove(report)
    refused(SOLID, "--source", "99", "-o", name, "--json", report, part="99 does not exist")
    assert not os.path.exists(report)


def test_picture_needs_a_display(folder):
    """Before any work, in one line: or VTK would end the process after it."""
    name, picture = (os.path.join(folder, own) for own in ("mesh.vtu", "mesh.png"))
    words = [SOLID, *COARSE, "-o", name, "--picture", picture]
    if run(*words, env=WITHOUT_DISPLAY).returncode == 1:  # a VTK with EGL needs none
        refused(*words, part="needs a display or EGL", env=WITHOUT_DISPLAY)
        assert os.listdir(folder) == [], os.listdir(folder)
    if not shutil.which("xvfb-run"):
        return
    done = subprocess.run(
        ["xvfb-run", "-a", *command(*words)], env=WITHOUT_DISPLAY, timeout=200, check=False,
        capture_output=True, text=True,
    )
    assert done.returncode == 0 and done.stderr == "", done.stderr
    reader = vtkPNGReader()
    reader.SetFileName(picture)
    reader.Update()
    image = reader.GetOutput()
    assert image.GetDimensions() == (1600, 1200, 1)
    pixels = memoryview(image.GetPointData().GetScalars()).tobytes()
    shades = {pixels[i : i + 3] for i in range(0, len(pixels), 3)}
    assert len(shades) > 50, "hexahedra in colours, on white"


def test_bar_on_a_terminal_only(folder):
    name = os.path.join(folder, "mesh.vtu")
    end, start = pty.openpty()
    with subprocess.Popen(
        command(SOLID, *COARSE, "-o", name), stdout=subprocess.PIPE, stderr=start, text=True
    ) as process:
        os.close(start)
        drawn = b""
        while True:
            try:
                piece = os.read(end, 4096)
            except OSError:  # the other end is closed
                break
            if not piece:
                break
            drawn += piece
        said = process.stdout.read()
    os.close(end)
    assert process.returncode == 0
    assert b"%" in drawn and drawn.endswith(b"\r\x1b[K"), drawn[-200:]
    assert "%" not in said.splitlines()[0]


def test_methods(folder):
    name = os.path.join(folder, "mesh.vtu")
    report = os.path.join(folder, "report.json")
    done = run(SOLID, *COARSE, "--method", "layer-march", "-o", name, "--json", report)
    assert done.returncode == 0, done.stderr
    with open(report, encoding="utf-8") as file:
        told = json.load(file)
    assert told["settings"]["Method"] == 5 and "LayerMarch" in told["report"]["SweepReportMethod"][0]
    refused(SOLID, "--method", "magic", "-o", name, part="invalid choice: 'magic'")


if __name__ == "__main__":
    assert sys.platform != "win32"
    for test in (
        test_valid_and_not, test_refusals, test_report, test_picture_needs_a_display,
        test_bar_on_a_terminal_only, test_methods,
    ):
        with temporary_folder() as output:
            test(output)
