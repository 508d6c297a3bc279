# SPDX-License-Identifier: BSD-3-Clause
"""Second half of Utilities/walk.sh: a state file in a ParaView that was just started."""

import os

from hands import OUTPUT, Stumbled, choose, click, look, quiet, say, start, type_file, visible, welcome
from paraview import simple

STATE = os.environ["HEXSWEEP_WALK_STATE"]


def steps():
    yield from welcome("21_welcome")
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
