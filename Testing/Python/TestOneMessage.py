# SPDX-License-Identifier: BSD-3-Clause
"""What goes wrong in pvpython is said once: no print of the executive's request follows.

Truth: what another pvpython writes to its streams.
"""

import os
import subprocess
import sys

SCRIPT = """
import os
from paraview import simple
simple.LoadPlugin(os.environ["HEXSWEEP_PLUGIN"], remote=False, ns=vars(simple))
solid = simple.XMLUnstructuredGridReader(
    FileName=[os.path.join(os.environ["HEXSWEEP_DATA_DIR"], "solids", "flange", "solid.vtu")])
sweep = simple.OneToOneSweep(Solid=solid, SourceFaceIds=[99])
simple.Show(sweep)
simple.Render()
sets = simple.SweepSets(Hexes=sweep, Boundary=simple.OutputPort(sweep, 1))
simple.Show(sets)
simple.Render()
sweep.UpdatePipeline()
sets.UpdatePipeline()
filter = sweep.GetClientSideObject()
print("error code", filter.GetErrorCode(), "cells", filter.GetOutput().GetNumberOfCells())
"""

done = subprocess.run(
    ["pvpython", "--force-offscreen-rendering", "-c", SCRIPT], timeout=300, check=False,
    stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
)
print(done.stdout)
said = done.stdout.splitlines()
# A print of vtkInformation has its members in lines of their own.
problems = [line for line in said if "ERR|" in line or "WARN|" in line or line.startswith("  ")]
wrong = (
    done.returncode != 0
    or len(problems) != 1
    or "face id 99 does not exist" not in problems[0]
    or "error code 40000 cells 0" not in said
)
sys.exit(1 if wrong else 0)
