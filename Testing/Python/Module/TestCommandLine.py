# SPDX-License-Identifier: BSD-3-Clause
"""python3 -m hexsweep: lists the faces of a solid and meshes it, from file to file."""

import os
import shutil
import subprocess

import hexsweep
from command_line import (
    CASE,
    COARSE,
    SOLID,
    SOURCE,
    command,
    expect_only,
    old_file,
    refused,
    run,
    temporary_folder,
)
from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid
from vtkmodules.vtkFiltersVerdict import vtkMeshQuality
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader, vtkXMLUnstructuredGridWriter


def read(name):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(name)
    reader.Update()
    return reader.GetOutput()


def save(grid, name):
    writer = vtkXMLUnstructuredGridWriter()
    writer.SetInputData(grid)
    writer.SetFileName(name)
    writer.Write()


def table(text):
    """Rows of the list of faces, below its head."""
    lines = text.splitlines()
    head = next(i for i, line in enumerate(lines) if line.split()[:1] == ["face"])
    return [line.split() for line in lines[head + 1 :] if line.split()[:1][0].isdigit()]


def test_faces_are_listed():
    listed = run(SOLID)
    assert listed.returncode == 0 and listed.stderr == "", listed.stderr
    assert run("faces", SOLID).stdout == listed.stdout
    rows = table(listed.stdout)
    assert len(rows) == CASE["counts"]["faces"], listed.stdout
    assert sum(int(row[1]) for row in rows) == CASE["counts"]["solid_triangles"]
    caps = {int(row[0]) for row in rows if row[-1] == "yes"}
    assert caps == {*CASE["source_face_ids"], *CASE["target_face_ids"]}, "the two plane faces"
    ways = listed.stdout[listed.stdout.index("the best first:") :].splitlines()
    score, verdict, source, arrow, target = ways[2].rstrip(":").replace(": ", " ").split()[:5]
    assert float(score) > 0.5 and verdict == "fits" and arrow == "->", ways[2]
    assert {int(source), int(target)} == caps, ways[2]


def test_faces_by_angle_are_listed(folder):
    """Also of a file without ids, with ids that the sweep takes; and of a file called faces."""
    bare = vtkUnstructuredGrid()
    bare.CopyStructure(read(SOLID))
    name = os.path.join(folder, "bare.vtu")
    save(bare, name)
    listed = run("faces", name)
    assert listed.returncode == 0 and "angle" in listed.stdout, listed.stdout
    caps = [row[0] for row in table(listed.stdout) if row[-1] == "yes"]
    assert len(caps) == 2, listed.stdout
    mesh = os.path.join(folder, "bare_mesh.vtu")
    done = run(name, "--source", caps[0], "--layers", "2", "--quad-size", "6", "-o", mesh)
    assert done.returncode == 0 and os.path.getsize(mesh) > 0, done.stderr
    refused("./faces", cwd=folder, part="./faces: does not exist")
    refused("faces", part="required: solid")
    for made in (name, mesh):
        os.remove(made)


def test_meshes(folder):
    name = os.path.join(folder, "flange.vtu")
    done = run(SOLID, *COARSE, "-o", name)
    assert done.returncode == 0 and done.stderr == "", done.stderr
    assert "0 inverted, 0 not certified" in done.stdout, done.stdout
    hexes = read(name)
    assert hexes.GetNumberOfCells() > 0 and hexes.GetNumberOfCells() % 4 == 0
    for h in range(hexes.GetNumberOfCells()):
        assert vtkMeshQuality.HexScaledJacobian(hexes.GetCell(h)) > 0.0, h
    # Again over the old one, whose permissions stay.
    os.chmod(name, 0o640)
    assert run(SOLID, *COARSE, "--layers", "2", "-o", name).returncode == 0
    assert 2 * read(name).GetNumberOfCells() == hexes.GetNumberOfCells()
    assert os.stat(name).st_mode & 0o777 == 0o640
    assert os.listdir(folder) == ["flange.vtu"], os.listdir(folder)
    os.remove(name)


def test_needs_nothing_but_the_file(folder):
    """Caps and layers are found; Size sets quads and layers."""
    cells = []
    for words in (), ("--size", "4"), ("--size", "4", "--layers", "1"):
        name = os.path.join(folder, "flange.vtu")
        done = run(SOLID, *words, "-o", name)
        assert done.returncode == 0 and done.stderr == "", done.stderr
        hexes = read(name)
        cells.append(hexes.GetNumberOfCells())
        found = {
            int(hexes.GetFieldData().GetArray(f"SweepReport{cap}FaceIds").GetTuple1(0))
            for cap in ("Source", "Target")
        }
        assert found == {*CASE["source_face_ids"], *CASE["target_face_ids"]}, found
        os.remove(name)
    assert cells[0] > cells[1] > cells[2] > 0 and cells[1] % cells[2] == 0, cells


def test_link_is_followed(folder):
    below = os.path.join(folder, "below")
    os.mkdir(below)
    link = os.path.join(folder, "link.vtu")
    os.symlink(os.path.join("below", "mesh.vtu"), link)
    for _ in range(2):  # to a file that is not there yet, then to one that is
        assert run(SOLID, *COARSE, "-o", link).returncode == 0
        assert os.path.islink(link) and read(link).GetNumberOfCells() > 0
        assert os.listdir(below) == ["mesh.vtu"]
    shutil.rmtree(below)
    os.remove(link)


def fold_a_quad(quads):
    """Moves a node that four quads share beyond the opposite corner of one of them."""
    quads.BuildLinks()
    cells = vtkIdList()
    for point in range(quads.GetNumberOfPoints()):
        quads.GetPointCells(point, cells)
        if cells.GetNumberOfIds() == 4:
            corners = quads.GetCell(cells.GetId(0)).GetPointIds()
            ids = [corners.GetId(i) for i in range(4)]
            opposite = quads.GetPoint(ids[(ids.index(point) + 2) % 4])
            place = [a + 1.5 * (b - a) for a, b in zip(quads.GetPoint(point), opposite)]
            quads.GetPoints().SetPoint(point, place)
            return
    raise AssertionError("no node inside")


def test_not_certified_is_status_2(folder):
    """A folded source quad: hexahedra on it are inverted; written all the same, with warnings."""
    folded = os.path.join(folder, "folded.vtu")
    quads = read(os.path.join(os.path.dirname(SOLID), "source_quads.vtu"))
    fold_a_quad(quads)
    save(quads, folded)
    name = os.path.join(folder, "bad.vtu")
    done = run(SOLID, *COARSE, "--quads", folded, "-o", name)
    report = read(name).GetFieldData()
    assert report.GetArray("SweepReportInverted").GetTuple1(0) > 0, done.stdout
    assert done.returncode == 2, (done.returncode, done.stdout)
    lines = done.stderr.splitlines()
    assert lines and all(line.startswith("hexsweep: warning: ") for line in lines), done.stderr
    assert "returned failure" not in done.stderr
    for made in (folded, name):
        os.remove(made)


def test_refusals(folder):
    """Each with one line and status 1, and with what was there before."""
    name = os.path.basename(old_file(folder, "old.vtu"))
    junk = old_file(folder, "junk.vtu")
    stl = old_file(folder, "junk.stl")
    legacy = old_file(folder, "junk.vtk")
    old = os.path.join(folder, name)
    for words, part in (
        ((SOLID, "--source", "99", "-o", old), "99 does not exist: the solid has faces 1, 2"),
        ((SOLID, *COARSE), "name the file to write"),
        ((SOLID, *COARSE, "-o", old + ".txt"), "only .vtu, .vtk"),
        ((SOLID, *COARSE, "-o", old, "--layers", "x"), "invalid int value"),
        ((SOLID, *COARSE, "-o", old, "--layers", "-1"), "number of layers is -1"),
        ((SOLID, *COARSE, "-o", old, "--threads", "0"), "--threads 0: give 1 to 4096"),
        ((SOLID, *COARSE, "-o", old, "--threads", "-2"), "--threads -2: give 1 to 4096"),
        ((SOLID, *COARSE, "-o", old, "--threads", "9" * 12), "--threads 999999999999: give 1 to 4096"),
        ((SOLID, *COARSE, "-o", old, "--layers", "9" * 30), "--layers: 9999999999999999999"),
        ((SOLID, *COARSE, "-o", old, "--source", str(2**63)), "9223372036854775808 is too large a number"),
        ((SOLID, *COARSE, "-o", old, "--volume", str(-(2**63) - 1)), "is too large a number"),
        ((SOLID, *COARSE, "-o", old, "--set", "Any=" + "9" * 30), "is too large a number"),
        ((SOLID, *COARSE, "-o", old, "--layers", "1000000000"), "gigabytes: more than there are"),
        ((SOLID, "--source", *SOURCE, "-o", old, "--size", "1e-300"), "gigabytes: more than there are"),
        ((SOLID, *COARSE, "-o", old, "--size", "1e400"), "the size is inf"),
        ((SOLID, *COARSE, "-o", old, "--threads", "x"), "--threads: invalid int value"),
        ((SOLID, *COARSE, "-o", old, "--lay", "3"), "unrecognized arguments: --lay"),
        ((SOLID, *COARSE, "-o", old, "--faces", "Nix"), 'no cell array "Nix"'),
        (("faces", SOLID, "--faces", "Nix"), 'no cell array "Nix"'),
        ((), "required: solid"),
        (("nix.vtu", *COARSE, "-o", old), "nix.vtu: does not exist"),
        ((folder, *COARSE, "-o", old), "is no file"),
        ((__file__, *COARSE, "-o", old), "only .vtk, .vtu"),
        ((SOLID, *COARSE, "--quads", junk, "-o", old), "junk.vtu: cannot be read"),
        ((junk, *COARSE, "-o", old), "junk.vtu: cannot be read"),
        ((stl, *COARSE, "-o", old), "junk.stl: cannot be read"),
        (("faces", legacy), "junk.vtk: cannot be read"),
    ):
        refused(*words, part=part)
    expect_only(folder, "old.vtu", "junk.vtu", "junk.stl", "junk.vtk")
    for made in (old, junk, stl, legacy):
        os.remove(made)


def test_tells_what_it_is():
    version = run("--version")
    assert version.returncode == 0 and version.stderr == ""
    assert version.stdout.startswith(f"hexsweep {hexsweep.__version__} (VTK "), version.stdout
    helped = run("--help")
    assert helped.returncode == 0 and "Exit status: 0 certified" in helped.stdout
    # A reader of the list that has seen enough is no failure.
    listing = subprocess.Popen(
        command("faces", SOLID), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )
    listing.stdout.close()
    assert listing.stderr.read() == "" and listing.wait() == 0
    listing.stderr.close()


if __name__ == "__main__":
    test_faces_are_listed()
    test_tells_what_it_is()
    for test in (
        test_faces_by_angle_are_listed, test_meshes, test_needs_nothing_but_the_file,
        test_link_is_followed, test_not_certified_is_status_2, test_refusals,
    ):
        with temporary_folder() as output:
            test(output)
