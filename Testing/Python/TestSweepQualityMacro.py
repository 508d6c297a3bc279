# SPDX-License-Identifier: BSD-3-Clause
"""The macro "Sweep quality": what it shows is what the mesh has. Its picture is also the guide's."""

import os

import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

simple.LoadPlugin(os.environ["HEXSWEEP_PLUGIN"], remote=False, ns=globals())
MACRO = os.path.join(os.environ["HEXSWEEP_SOURCE_DIR"], "Plugin", "Macros", "sweep_quality.py")
with open(MACRO, encoding="utf-8") as file:
    CODE = compile(file.read(), MACRO, "exec")
OUTPUT = os.environ["HEXSWEEP_TEST_OUTPUT_DIR"]


def run():
    exec(CODE, {"__name__": "macro"})


def found(name):
    return servermanager.Fetch(simple.FindSource(name))


def refused(part):
    try:
        run()
    except RuntimeError as error:
        assert part in str(error), error
    else:
        raise AssertionError(f"no error: {part}")


def expect_what_the_mesh_has(values):
    """@param values: scaled Jacobian of each hexahedron."""
    worst = found("worst 10")
    told = vtk_to_numpy(worst.GetPointData().GetArray("ScaledJacobian"))
    assert np.array_equal(np.sort(values)[:10], np.sort(told)), told
    cells = vtk_to_numpy(worst.GetPointData().GetArray("vtkOriginalCellIds"))
    assert np.array_equal(values[cells], told)
    assert found("below 0.2").GetNumberOfCells() == (values < 0.2).sum()
    bars = vtk_to_numpy(found("histogram").GetRowData().GetArray("bin_values"))
    assert bars.sum() == len(values) and len(bars) == 20
    assert np.array_equal(bars, np.histogram(values, bins=20, range=(0.0, 1.0))[0]), bars


simple._DisableFirstRenderCameraReset()
refused("no source is active")
solid = simple.OpenDataFile(os.path.join(os.environ["HEXSWEEP_DATA_DIR"], "solids", "wing", "solid.vtu"))
simple.SetActiveSource(solid)
refused("no hexahedra")
assert len(simple.GetSources()) == 1, "nothing is left behind"

hexes = OneToOneSweep(Solid=solid, Size=3)  # noqa: F821
values = vtk_to_numpy(servermanager.Fetch(hexes).GetCellData().GetArray("ScaledJacobian"))
view = simple.GetActiveViewOrCreate("RenderView")
simple.SetActiveSource(hexes)
run()
expect_what_the_mesh_has(values)
assert simple.FindSource("HexValidity") is None, "a mesh that is judged is not judged again"
view.CameraPosition, view.CameraViewUp = [1, -2, 1.5], [0, 0, 1]
view.ResetCamera()
layout = simple.GetLayout(view)
layout.SetSize(1200, 600)
assert len(simple.GetViewsInLayout(layout)) == 2, "the histogram is beside the mesh"
simple.SaveScreenshot(os.path.join(OUTPUT, "sweep_quality.png"), layout)

# A mesh of somebody else: the same hexahedra without a verdict.
bare = simple.ProgrammableFilter(Input=hexes, Script="", CopyArrays=0)
for name in ("worst 10", "worst 10 cells", "below 0.2", "histogram"):
    simple.Delete(simple.FindSource(name))
simple.SetActiveSource(bare)
run()
assert simple.FindSource("HexValidity") is not None
expect_what_the_mesh_has(values)
