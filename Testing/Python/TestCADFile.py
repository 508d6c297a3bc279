# SPDX-License-Identifier: BSD-3-Clause
"""A CAD file opened and swept in ParaView, and the state of it reopened."""

import os

import hexsweep
from paraview import servermanager, simple

PLUGIN = os.environ["HEXSWEEP_PLUGIN"]
FILE = os.path.join(os.environ["HEXSWEEP_DATA_DIR"], "cad", "pin_in_plate.step")
STATE = os.path.join(os.environ["HEXSWEEP_TEST_OUTPUT_DIR"], "cad_file.pvsm")


def fetched(proxy):
    grid = servermanager.Fetch(proxy)
    data = grid.GetFieldData()
    assert data.GetArray("SweepReportUnsnappedNodes").GetRange() == (0.0, 0.0)
    assert data.GetArray("SweepReportNotCertified").GetRange() == (0.0, 0.0)
    return [grid.GetPoint(i) for i in range(grid.GetNumberOfPoints())]


def main():
    simple.LoadPlugin(PLUGIN, remote=False, ns=vars(simple))
    if not hasattr(hexsweep, "vtkCADReader"):
        assert not hasattr(servermanager.sources, "CADReader")
        return  # HexSweep was built without OpenCASCADE
    solid = simple.OpenDataFile(FILE)
    assert solid is not None and solid.GetXMLName() == "CADReader", "no reader of CAD files was found"
    hexes = simple.OneToOneSweep(Solid=solid, Size=3.0)
    simple.RenameSource("Hexes", hexes)
    hexes.UpdatePipeline()
    before = fetched(hexes)
    simple.SaveState(STATE)
    simple.ResetSession()
    assert not simple.GetSources()
    simple.LoadPlugin(PLUGIN, remote=False, ns=vars(simple))
    simple.LoadState(STATE)
    again = simple.FindSource("Hexes")
    again.UpdatePipeline()
    assert fetched(again) == before, "the reopened state gives another mesh"


main()
