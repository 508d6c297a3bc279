# SPDX-License-Identifier: BSD-3-Clause
"""The plugin loads, and HexValidity judges a wavelet (voxels) and hexahedra cut out of it."""

import os

from paraview import servermanager, simple

simple.LoadPlugin(os.environ["HEXSWEEP_PLUGIN"], remote=False, ns=globals())

CERTIFIED = 0


def report(output, name):
    return output.GetFieldData().GetArray("SweepReport" + name).GetTuple1(0)


def check(source, cells, volume):
    judged = HexValidity(Input=source, FailIfInvalid=1)  # noqa: F821 (from the plugin)
    output = servermanager.Fetch(judged)
    assert output.GetNumberOfCells() == cells
    assert report(output, "Hexes") == cells
    assert report(output, "Inverted") == 0
    assert abs(report(output, "MinScaledJacobian") - 1) < 1e-12
    # The cells are boxes, whose Jacobian is their volume everywhere.
    assert abs(report(output, "MinJacobianLowerBound") - volume) < 1e-6 * volume
    assert report(output, "NotCertified") == 0
    validity = judged.CellData["Validity"].GetRange()
    assert validity == (CERTIFIED, CERTIFIED), validity


wavelet = simple.Wavelet(WholeExtent=[0, 3, 0, 4, 0, 5])
check(wavelet, 3 * 4 * 5, 1)
grid = simple.UnstructuredCellTypes(CellType="Hex", BlocksDimensions=[2, 3, 4])
check(grid, 2 * 3 * 4, 1)
