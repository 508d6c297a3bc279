# SPDX-License-Identifier: BSD-3-Clause
"""What a user does in ParaView's window, by mouse and keyboard. One window for all: it takes longest to come up."""

import os

from hands import (
    Stumbled, apply, button, choose, click, copy_selection, end, isometric, messages, pick, quiet, say, type_file, visible, welcome,
)
from paraview import simple
from pictures import expect_picture


def ids(mesh, name):
    return int(mesh.FieldData["SweepReport" + name].GetRange()[0])


def picked_faces():
    """A STEP file, its source cap picked by the mouse: the mesh stands on that face."""
    yield from choose("File", "Open")
    yield from type_file(os.path.join(os.environ["HEXSWEEP_DATA_DIR"], "cad", "named_block.step"))
    yield from apply()
    yield from isometric()
    yield from pick((0.42, 0.55))
    yield from choose("Filters", "Hex Sweep", "One To One Sweep")
    yield 0.5
    yield from copy_selection()
    mesh = simple.GetActiveSource()
    mesh.Size = 0.25
    yield from apply()
    yield from quiet()
    caps = [ids(mesh, "SourceFaceIds"), ids(mesh, "TargetFaceIds")]
    if caps != [2, 1]:  # by itself the sweep goes from face 5 to 6
        raise Stumbled(f"the sweep is between faces {caps}")
    expect_picture(simple.GetActiveView(), "TestWindowPickedFaces")


def quality_macro():
    """The macro is imported and run in the menu, on the mesh that is there."""
    view = simple.GetActiveView()
    yield from choose("Macros", "Import new macro")
    yield from type_file(os.path.join(os.environ["HEXSWEEP_SOURCE_DIR"], "Plugin", "Macros", "sweep_quality.py"))
    yield from choose("Macros", "sweep_quality")
    yield lambda: simple.FindSource("histogram")
    yield 1.0
    yield from quiet()
    if len(simple.GetViews()) != 2:
        raise Stumbled("the histogram is not beside the mesh")
    if simple.GetActiveView() != view:
        raise Stumbled("the chart is active: eyes and colours are not those of the mesh")
    simple.ClearSelection(simple.FindSource("worst 10"))  # labels: letters look different where the fonts are others
    expect_picture(view, "TestWindowQualityMacro")


def error_once():
    """A cap that is not there: Output Messages open by themselves, and say it once."""
    simple.SetActiveSource(simple.FindSource("named_block.step"))
    yield 0.5
    yield from choose("Filters", "Hex Sweep", "One To One Sweep")
    yield 0.5
    simple.GetActiveSource().SourceFaceIds = [99]
    yield 0.5
    click(button("Apply"))
    yield lambda: visible("pqOutputWidget")
    yield 1.0
    told = messages()
    heads = [line for line in told if line.lower().startswith(("error", "warn", "critical"))]
    if len(heads) != 1 or sum("face id 99 does not exist" in line for line in told) != 1:
        raise Stumbled(f"not one message: {told}")


def steps():
    yield from welcome()
    for part in picked_faces, quality_macro, error_once:
        say(part.__name__)
        yield from part()
    end()
