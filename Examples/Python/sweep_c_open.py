# SPDX-License-Identifier: BSD-3-Clause
"""Sweeps a C section that opens, step by step, in ParaView's Python.

    pvpython sweep_c_open.py <HexSweep.so> <Data> <hexes.vtu>

The affine method runs beside, for comparison.
"""
import os
import sys

from paraview import servermanager
from paraview.simple import LoadPlugin, OpenDataFile, SaveData

plugin, data, output = sys.argv[1:]
LoadPlugin(os.path.abspath(plugin), remote=False, ns=globals())

case = os.path.join(data, "cases", "c_open")
quads, source, target, sides = (
    OpenDataFile(os.path.join(case, name + ".vtu"))
    for name in ("source_quads", "source_surface", "target_surface", "linking_quads")
)


def sweep(method, **settings):
    """The chain from quads to hexes; prints how many are inverted and returns the last filter."""
    far_quads = SweepQuadProjector(  # noqa: F821, the plugin's
        SourceQuads=quads, TargetSurface=target, LinkingSides=sides, SourceSurface=source, Method=method
    )
    far_quads.EnsureValid = far_quads.ImproveQuality = settings.get("EnsureValid", 1)
    hexes = CageHexInterior(  # noqa: F821
        SourceQuads=quads, TargetQuads=far_quads, LinkingSides=sides, **settings
    )
    report = servermanager.Fetch(hexes).GetFieldData()
    count = int(report.GetArray("SweepReportHexes").GetTuple1(0))
    inverted = int(report.GetArray("SweepReportInverted").GetTuple1(0))
    print(f"{method}: {inverted} of {count} hexes are inverted")
    return hexes


sweep("AffineLeastSquares", Method="AffineBoundaryError", EnsureValid=0, ImproveQuality=0)
SaveData(output, proxy=sweep("Harmonic"), DataMode="Binary")
