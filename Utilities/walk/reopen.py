# SPDX-License-Identifier: BSD-3-Clause
"""Second half of Utilities/walk.sh: a state file in a ParaView that was just started."""

import os
import sys

sys.path.insert(0, os.environ["HEXSWEEP_WALK_SCRIPTS"])
from hands import OUTPUT, Stumbled, button, choose, click, look, messages, one, quiet, say, start, type_file, visible, welcome  # noqa: E402
from paraview import simple  # noqa: E402

STATE = os.environ["HEXSWEEP_WALK_STATE"]


def steps():
    yield from welcome("21")
    yield from choose("File", "Load State")
    yield from type_file(STATE, "22_load_state")
    look("23_options")
    for dialog in visible("QDialog"):  # which files to take: those of the state
        click(next(w for w in visible("QPushButton") if w.window() is dialog and w.text().strip("&") == "OK"))
    yield lambda: simple.GetSources()
    yield 3.0
    yield from quiet()
    look("24_loaded")
    names = [name for name, _ in simple.GetSources()]
    mesh = next(source for (name, _), source in simple.GetSources().items() if name.startswith("OneToOneSweep"))
    mesh.UpdatePipeline()
    with open(os.path.join(OUTPUT, "hexahedra"), encoding="utf-8") as file:
        wanted = int(file.read())
    count = mesh.GetDataInformation().GetNumberOfCells()
    say(f"{count} hexahedra after loading the state ({wanted} before), of {names}")
    if count != wanted:
        raise Stumbled("the state gives another mesh")
    yield from choose("File", "Exit")
    yield 3.0
    raise Stumbled("ParaView does not end")


start(steps())
