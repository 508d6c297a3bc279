# SPDX-License-Identifier: BSD-3-Clause
"""The wrapped module in a plain interpreter, and the check of the VTK that it meets."""

import subprocess
import sys

from hexsweep import vtkHexValidity
from vtkmodules.vtkFiltersSources import vtkCellTypeSource

HEXAHEDRON = 12


def report(output, name):
    return output.GetFieldData().GetArray("SweepReport" + name).GetTuple1(0)


def test_filter_runs():
    block = vtkCellTypeSource()
    block.SetCellType(HEXAHEDRON)
    block.SetBlocksDimensions(2, 2, 2)
    validity = vtkHexValidity()
    validity.SetInputConnection(block.GetOutputPort())
    validity.Update()
    output = validity.GetOutput()
    assert report(output, "Hexes") == 8
    assert report(output, "Inverted") == 0
    assert abs(report(output, "MinScaledJacobian") - 1) < 1e-12
    assert output.GetCellData().GetArray("Validity").GetRange() == (0, 0)


def test_other_vtk_is_refused():
    """With another VTK in memory the import must fail cleanly, not crash."""
    script = (
        "import vtkmodules.vtkCommonCore as core\n"
        "class Other:\n"
        "    GetVTKVersion = staticmethod(lambda: '1.2.3')\n"
        "core.vtkVersion = Other\n"
        "try:\n"
        "    import hexsweep\n"
        "except ImportError as error:\n"
        "    assert '1.2.3' in str(error)\n"
        "else:\n"
        "    raise SystemExit('another VTK was accepted')\n"
    )
    subprocess.run([sys.executable, "-c", script], check=True)


if __name__ == "__main__":
    test_filter_runs()
    test_other_vtk_is_refused()
