# SPDX-License-Identifier: BSD-3-Clause
"""python3 -m hexsweep --threads: VTK's threads, and the same mesh with any number of them."""

import os
import types

from command_line import COARSE, SOLID, run, temporary_folder
from hexsweep.sweeps import threads
from hexsweep.errors import SweepError
from vtkmodules import vtkCommonCore
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

POLISHED = os.path.join(os.path.dirname(os.path.dirname(SOLID)), "loft", "solid.vtu")


def content(name):
    """Bytes of points, cells and arrays; the report has seconds in it."""
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(name)
    reader.Update()
    grid = reader.GetOutput()
    found = {
        "points": grid.GetPoints().GetData(),
        "corners": grid.GetCells().GetConnectivityArray(),
        "offsets": grid.GetCells().GetOffsetsArray(),
    }
    for kind in grid.GetPointData(), grid.GetCellData():
        found.update((kind.GetArrayName(i), kind.GetArray(i)) for i in range(kind.GetNumberOfArrays()))
    method = grid.GetFieldData().GetAbstractArray("SweepReportMethod").GetValue(0)
    return method, {name: bytes(memoryview(array)) for name, array in found.items()}


def test_the_mesh_is_the_same(folder):
    for solid, words, step in (SOLID, COARSE, ""), (POLISHED, ["--size", "2"], "polish"):
        meshes = []
        for count in (), ("--threads", "1"), ("--threads", "2"), ("--threads", "7"):
            name = os.path.join(folder, "mesh.vtu")
            done = run(solid, *words, *count, "-o", name)
            assert done.returncode == 0 and done.stderr == "", done.stderr
            meshes.append(content(name))
        assert step in meshes[0][0], meshes[0][0]
        assert all(mesh == meshes[0] for mesh in meshes), (solid, words)


def test_vtk_uses_them():
    tools = vtkCommonCore.vtkSMPTools
    threads.use(2)
    # No more than the machine has.
    assert tools.GetEstimatedNumberOfThreads() == min(2, len(os.sched_getaffinity(0)))
    threads.use(1)
    assert tools.GetEstimatedNumberOfThreads() == 1


def test_refused_without_threads():
    """As if VTK had been built so."""
    for bare in (
        types.SimpleNamespace(vtkSMPTools=vtkCommonCore.vtkSMPTools, VTK_SMP_ENABLE_STDTHREAD=0),
        types.SimpleNamespace(),
    ):
        threads.vtkCommonCore = bare
        try:
            threads.use(1)
            threads.use(2)
        except SweepError as refusal:
            assert str(refusal).startswith("--threads 2: this VTK was built without threads"), refusal
        else:
            raise AssertionError("not refused")
        finally:
            threads.vtkCommonCore = vtkCommonCore


if __name__ == "__main__":
    with temporary_folder() as output:
        test_the_mesh_is_the_same(output)
    if hasattr(vtkCommonCore, "vtkSMPTools"):
        test_vtk_uses_them()
    test_refused_without_threads()
