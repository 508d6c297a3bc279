# SPDX-License-Identifier: BSD-3-Clause
"""python3 -m hexsweep on a file with several bodies: lists and meshes them one by one."""

import os

from command_line import refused, run, temporary_folder
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter, vtkXMLUnstructuredGridReader


def boxes():
    """Two boxes without ids, the first one 1 x 1 x 1, the second one 1 x 2 x 3."""
    append = vtkAppendPolyData()
    for center, lengths in (((0.0, 0.0, 0.0), (1.0, 1.0, 1.0)), ((3.0, 0.0, 0.0), (1.0, 2.0, 3.0))):
        cube = vtkCubeSource()
        cube.SetCenter(center)
        cube.SetXLength(lengths[0])
        cube.SetYLength(lengths[1])
        cube.SetZLength(lengths[2])
        append.AddInputConnection(cube.GetOutputPort())
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(append.GetOutputPort())
    triangles.Update()
    bare = vtkPolyData()
    bare.CopyStructure(triangles.GetOutput())
    return bare


def save(data, name):
    writer = vtkXMLPolyDataWriter()
    writer.SetInputData(data)
    writer.SetFileName(name)
    writer.Write()


def volumes_of(name):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(name)
    reader.Update()
    ids = reader.GetOutput().GetCellData().GetArray("VolumeId")
    return [int(ids.GetTuple1(cell)) for cell in range(ids.GetNumberOfTuples())]


def test_bodies_are_listed(name):
    listed = run("faces", name)
    assert listed.returncode == 0 and listed.stderr == "", listed.stderr
    lines = [line.split() for line in listed.stdout.splitlines()]
    head = next(i for i, words in enumerate(lines) if words[:2] == ["volume", "face"])
    rows = lines[head + 1 : head + 13]
    assert [int(row[0]) for row in rows] == 6 * [1] + 6 * [2], listed.stdout
    assert len({row[1] for row in rows}) == 12, "faces found by angle are counted on"
    for volume, area in ((1, 6.0), (2, 22.0)):
        total = sum(float(row[3]) for row in rows if int(row[0]) == volume)
        assert abs(total - area) < 1e-6, (volume, total)
        assert f"Ways to sweep volume {volume}, the best first:" in listed.stdout, listed.stdout


def test_bodies_are_meshed(folder, name):
    mesh = os.path.join(folder, "boxes.vtu")
    done = run(name, "--size", "0.25", "-o", mesh)
    assert done.returncode == 0 and done.stderr == "", done.stderr
    volumes = volumes_of(mesh)
    assert set(volumes) == {1, 2}
    assert f"{len(volumes)} hexahedra, 0 inverted, 0 not certified" in done.stdout, done.stdout
    one = run(name, "--size", "0.25", "--volume", "2", "-o", mesh)
    assert one.returncode == 0, one.stderr
    assert volumes_of(mesh) == [2] * volumes.count(2), "the same hexahedra as before"
    exodus = os.path.join(folder, "boxes.ex2")
    assert run(name, "--size", "0.5", "-o", exodus).returncode == 0
    refused(name, "--volume", "5", "-o", mesh, part="no volume 5. It has volumes 1 and 2")
    os.remove(mesh)
    os.remove(exodus)


with temporary_folder() as temporary:
    file_name = os.path.join(temporary, "boxes.vtp")
    save(boxes(), file_name)
    test_bodies_are_listed(file_name)
    test_bodies_are_meshed(temporary, file_name)
    os.remove(file_name)
