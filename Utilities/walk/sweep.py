# SPDX-License-Identifier: BSD-3-Clause
"""First half of Utilities/walk.sh: from a CAD file to a state file, by mouse and keyboard."""

import os
import sys

sys.path.insert(0, os.environ["HEXSWEEP_WALK_SCRIPTS"])
from hands import (  # noqa: E402
    OUTPUT, Stumbled, QtWidgets, button, choose, choose_item, click, drag, look, messages, one, plain, quiet, reveal, say, start, type_file,
    view_widget, visible, welcome, xdotool,
)
from paraview import simple  # noqa: E402

PART = os.environ["HEXSWEEP_WALK_PART"]
STATE = os.environ["HEXSWEEP_WALK_STATE"]


def hexes():
    return next((source for (name, _), source in simple.GetSources().items() if name.startswith("OneToOneSweep")), None)


def cells(source):
    return source.GetDataInformation().GetNumberOfCells()


def apply():
    click(button("Apply"))
    yield lambda: not button("Apply").isEnabled()
    yield 1.5


def colour_by(array):
    box = one("QComboBox", lambda w: w.objectName() == "Variables" and not w.visibleRegion().isEmpty(), "list of arrays")
    yield from choose_item(box, array)
    yield 1.0


def pick_face():
    """The face that looks at the user from the left, as it is seen along (-1, -1, -1)."""
    click(one("QToolButton", lambda w: w.defaultAction() and "isometric" in w.defaultAction().text().lower(), "button for the isometric view"))
    yield 1.0
    view = view_widget()
    click(view, 0.02, 0.02)
    yield 0.5
    xdotool("key", "s")
    yield 0.5
    drag(view, (0.42, 0.55), (0.44, 0.57))
    yield 2.0


def steps():
    yield from welcome("01")
    look("02_window")
    yield from choose("File", "Open")
    yield from type_file(PART, "03_open")
    look("04_opened")
    yield from apply()
    yield from quiet()
    look("05_solid")
    yield from colour_by("FaceId")
    look("06_faces")
    yield from pick_face()
    look("07_picked")
    yield from choose("Filters", "Hex Sweep", "One To One Sweep")
    yield 1.0
    look("08_filter")
    copy = sorted(visible("QAbstractButton", lambda w: plain(w.text()) == "Copy Active Selection"), key=lambda w: w.mapToGlobal(w.pos()).y())
    if not copy:
        look("09_no_button")
        raise Stumbled("no button Copy Active Selection")
    yield from reveal(copy[0])
    click(copy[0])
    yield 1.0
    look("09_copied")
    yield from apply()
    yield from quiet()
    look("10_swept")
    yield from colour_by("ScaledJacobian")
    look("11_scaled_jacobian")
    mesh = hexes()
    caps = [int(mesh.FieldData["SweepReport" + name].GetRange()[0]) for name in ("SourceFaceIds", "TargetFaceIds")]
    say(f"{cells(mesh)} hexahedra from face {caps[0]} to face {caps[1]}")
    with open(os.path.join(OUTPUT, "hexahedra"), "w", encoding="utf-8") as file:
        file.write(str(cells(mesh)))
    yield from choose("File", "Save State")
    yield from type_file(STATE, "12_save_state")
    yield lambda: os.path.exists(STATE)
    yield from quiet()
    look("13_saved")
    yield from choose("File", "Exit")
    yield 3.0
    raise Stumbled("ParaView does not end")


start(steps())
