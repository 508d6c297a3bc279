# SPDX-License-Identifier: BSD-3-Clause
"""First half of Utilities/walk.sh: from a CAD file to a state file, by mouse and keyboard."""

import os

from hands import (
    OUTPUT, Stumbled, apply, choose, colour_by, copy_selection, isometric, look, pick, quiet, say, start, type_file, welcome,
)
from paraview import simple

PART = os.environ["HEXSWEEP_WALK_PART"]
STATE = os.environ["HEXSWEEP_WALK_STATE"]


def hexes():
    return next((source for (name, _), source in simple.GetSources().items() if name.startswith("OneToOneSweep")), None)


def cells(source):
    return source.GetDataInformation().GetNumberOfCells()


def steps():
    yield from welcome("01_welcome")
    look("02_window")
    yield from choose("File", "Open")
    yield from type_file(PART, "03_open")
    look("04_opened")
    yield from apply()
    yield from quiet()
    look("05_solid")
    yield from colour_by("FaceId")
    look("06_faces")
    yield from isometric()
    yield from pick((0.42, 0.55))  # the face on the left
    look("07_picked")
    yield from choose("Filters", "Hex Sweep", "One To One Sweep")
    yield 1.0
    look("08_filter")
    yield from copy_selection()
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
