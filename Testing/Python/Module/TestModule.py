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


def test_failure_is_one_message():
    """In a plain interpreter too no print of the executive's request follows."""
    script = (
        "from hexsweep import vtkHexValidity\n"
        "from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid\n"
        "validity = vtkHexValidity()\n"
        "validity.SetInputDataObject(vtkUnstructuredGrid())\n"
        "validity.Update()\n"
        "validity.Update()\n"
        "assert validity.GetErrorCode() == 40000\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", script], check=True, stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT, text=True,
    )
    lines = [line for line in done.stdout.replace("\x1b[0m", "").splitlines() if line]
    assert len(lines) == 1 and "no cells" in lines[0], done.stdout


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


def test_python_without_vtk_is_told():
    """As a Python of one's own that has none: -S leaves the system's packages out."""
    done = subprocess.run(
        [sys.executable, "-S", "-c", "import hexsweep"], check=False, stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT, text=True,
    )
    last = done.stdout.strip().splitlines()[-1]
    assert done.returncode == 1 and last.startswith("ImportError: hexsweep needs"), done.stdout
    assert "there is no module vtkmodules in" in last and "python3-paraview" in last, last


if __name__ == "__main__":
    test_filter_runs()
    test_failure_is_one_message()
    test_other_vtk_is_refused()
    test_python_without_vtk_is_told()
