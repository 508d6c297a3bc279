# SPDX-License-Identifier: BSD-3-Clause
"""A state that ParaView saved with version 0.1.0 of the plugin opens, and makes the same mesh or a better one.

state_0.1.0.pvsm has the flange by One To One Sweep with given quads, and the case c_open through projector, interior
and validity; @DATA@ stands for the folder Data. The connectivity is that of then, places are those of today's methods.
"""

import os

from paraview import servermanager, simple

simple.LoadPlugin(os.environ["HEXSWEEP_PLUGIN"], remote=False, ns=globals())
HERE = os.path.join(os.environ["HEXSWEEP_SOURCE_DIR"], "Testing", "Python")
# Of version 0.1.0: hexahedra, points, least scaled Jacobian.
MADE = {"sweep": (11592, 13986, 0.7353890843313362), "validity": (11440, 13671, 0.7308322478986982)}

with open(os.path.join(HERE, "state_0.1.0.pvsm"), encoding="utf-8") as file:
    state = file.read()
assert "@DATA@/" in state
path = os.path.join(os.environ["HEXSWEEP_TEST_OUTPUT_DIR"], "state_0.1.0.pvsm")
with open(path, "w", encoding="utf-8") as file:
    file.write(state.replace("@DATA@", os.environ["HEXSWEEP_DATA_DIR"]))

simple.LoadState(path)
for name, (hexes, points, least) in MADE.items():
    source = simple.FindSource(name)
    assert source, name
    source.UpdatePipeline()
    mesh = servermanager.Fetch(source)
    assert (mesh.GetNumberOfCells(), mesh.GetNumberOfPoints()) == (hexes, points), (name, mesh.GetNumberOfCells())
    told = lambda report: mesh.GetFieldData().GetArray("SweepReport" + report).GetTuple1(0)
    assert told("NotCertified") == 0, name
    assert told("MinScaledJacobian") >= least, (name, told("MinScaledJacobian"))
# What was set then is set now.
sweep = simple.FindSource("sweep")
assert list(sweep.SourceFaceIds) == [3] and list(sweep.TargetFaceIds) == [2] and sweep.NumberOfLayers == 8
