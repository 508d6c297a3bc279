# SPDX-License-Identifier: BSD-3-Clause
"""The command line on CAD files."""

import os
import sys

import hexsweep
from command_line import refused, run, temporary_folder
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

_ASSEMBLY = os.path.join(os.environ["HEXSWEEP_DATA_DIR"], "cad", "pin_in_plate.step")


def read(name):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(name)
    reader.Update()
    return reader.GetOutput()


def test_faces_have_their_kinds_of_surface():
    listed = run("faces", _ASSEMBLY)
    assert listed.returncode == 0 and listed.stderr == "", listed.stderr
    assert "cylinder" in listed.stdout and "plane" in listed.stdout, listed.stdout
    assert listed.stdout.startswith("volume 1: "), listed.stdout


def test_all_solids_are_meshed_with_their_nodes_on_the_surfaces():
    with temporary_folder() as folder:
        name = os.path.join(folder, "pin.vtu")
        done = run(_ASSEMBLY, "-o", name, "--size", "3", "--separate")
        assert done.returncode == 0 and done.stderr == "", done.stderr
        mesh = read(name)
        data = mesh.GetFieldData()
        for body in range(2):
            assert data.GetArray("SweepReportNotCertified").GetTuple1(body) == 0
            assert data.GetArray("SweepReportSnappedNodes").GetTuple1(body) > 0
            assert data.GetArray("SweepReportUnsnappedNodes").GetTuple1(body) == 0
        assert mesh.GetCellData().GetArray("VolumeId").GetRange() == (1.0, 2.0)
        assert not data.HasArray("CADGeometry")


def test_names_of_faces_arrive_in_the_sets():
    """In a process of its own, where the CAD kernel has read and written nothing before."""
    named = os.path.join(os.environ["HEXSWEEP_DATA_DIR"], "cad", "named_block.step")
    listed = run("faces", named).stdout
    assert "Inlet" in listed, listed
    with temporary_folder() as folder:
        for extension, part in (
            (".inp", "*SURFACE, NAME=Inlet, TYPE=ELEMENT"), (".inp", "ELSET=Bracket"), (".msh", '"Inlet"'), (".ex2", "Inlet")
        ):
            name = os.path.join(folder, "block" + extension)
            done = run(named, "-o", name, "--size", "0.3")
            assert done.returncode == 0, done.stderr
            with open(name, "rb") as file:
                assert part.encode() in file.read(), (extension, part)


def test_bodies_with_several_caps_are_meshed():
    shaft = os.path.join(os.environ["HEXSWEEP_DATA_DIR"], "cad", "stepped_shaft.step")
    with temporary_folder() as folder:
        name = os.path.join(folder, "shaft.vtu")
        done = run(shaft, "-o", name)
        assert done.returncode == 0 and done.stderr == "", done.stderr
        assert read(name).GetFieldData().GetArray("SweepReportRegions").GetTuple1(0) > 1
        # The other ways to sweep the plate with slopes: along its direction of several caps, named.
        slopes = os.path.join(os.environ["HEXSWEEP_DATA_DIR"], "cad", "sloped_steps.step")
        done = run(slopes, "-o", name, "--direction", "0", "0", "1")
        assert done.returncode == 0, done.stderr
        found = read(name).GetFieldData().GetArray("SweepReportSweepDirection")
        assert [abs(found.GetValue(i)) for i in range(3)] == [0.0, 0.0, 1.0]
        refused(
            slopes, "-o", name, "--direction", "0", "0", "1", "--source", "1", part="several caps"
        )


def test_bad_files_are_refused_in_one_line():
    with temporary_folder() as folder:
        cut = os.path.join(folder, "cut.step")
        with open(_ASSEMBLY, "rb") as whole, open(cut, "wb") as file:
            file.write(whole.read(4000))
        refused(cut, "-o", os.path.join(folder, "x.vtu"), part="cut short")
        noise = os.path.join(folder, "noise.igs")
        with open(noise, "w", encoding="ascii") as file:
            file.write("nothing\n" * 10)
        refused(noise, "-o", os.path.join(folder, "x.vtu"), part="IGES")
        assert sorted(os.listdir(folder)) == ["cut.step", "noise.igs"]


if not hasattr(hexsweep, "vtkCADReader"):
    print("skipped: HexSweep was built without OpenCASCADE")
    sys.exit(77)
for test_name, test in list(globals().items()):
    if test_name.startswith("test_"):
        test()
