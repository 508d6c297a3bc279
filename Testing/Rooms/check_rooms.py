# SPDX-License-Identifier: BSD-3-Clause
"""Reads the includes of Filters/Core and says where they break the order of its rooms.

    python3 check_rooms.py FILTERS_CORE

A room may include the rooms that `ALLOWED` names and itself; units within a room must not include
each other in a circle; nothing may include VTK. Documentation/Architecture.md says what each room
is for.
"""
import re
import sys
from pathlib import Path

# From the lowest room to the highest.
ALLOWED = {
    "Common": [],
    "Geometry": ["Common"],
    "Surfaces": ["Common", "Geometry"],
    "Solvers": ["Common", "Geometry", "Surfaces"],
    "Linking": ["Common", "Geometry", "Surfaces", "Solvers"],
    "DiskMaps": ["Common", "Geometry", "Surfaces", "Solvers", "Linking"],
    "CapQuads": ["Common", "Geometry", "Surfaces", "Solvers", "Linking", "DiskMaps"],
    "Hexahedra": ["Common", "Geometry", "Solvers"],
    "Interior": ["Common", "Geometry", "Surfaces", "Solvers", "Linking", "Hexahedra"],
    "Solids": ["Common", "Geometry", "Surfaces", "Solvers", "Linking", "CapQuads", "Interior"],
    "Stacks": ["Common", "Geometry", "Surfaces", "CapQuads", "Hexahedra", "Solids"],
    "Assemblies": [
        "Common",
        "Geometry",
        "Surfaces",
        "Solvers",
        "Linking",
        "CapQuads",
        "Hexahedra",
        "Interior",
        "Solids",
        "Stacks",
    ],
}
INCLUDE = re.compile(r'^\s*#\s*include\s+(["<])([^">]+)[">]', re.MULTILINE)


def problems_of(core):
    """What is wrong, a line each; an empty list is a house in order."""
    problems = []
    units = {}  # (room, unit) -> units that its header or source includes
    for path in sorted(core.rglob("*")):
        if path.suffix not in (".h", ".cxx"):
            continue
        place = path.relative_to(core)
        if len(place.parts) != 2 or place.parts[0] not in ALLOWED:
            problems.append(f"{place}: not in a room ({', '.join(ALLOWED)})")
            continue
        room, unit = place.parts[0], path.stem
        seen = units.setdefault((room, unit), {})
        text = path.read_text(encoding="utf-8")
        for include in INCLUDE.finditer(text):
            quote, name = include.groups()
            line = text.count("\n", 0, include.start(1)) + 1
            if name.startswith("vtk"):
                problems.append(f"{place}:{line}: includes {name}; Core knows no VTK")
            if quote == "<":
                continue
            parts = name.split("/")
            if len(parts) != 3 or parts[0] != "Core" or not (core / parts[1] / parts[2]).is_file():
                problems.append(f'{place}:{line}: "{name}" is no "Core/Room/Unit.h"')
                continue
            other = parts[1]
            if other != room and other not in ALLOWED[room]:
                problems.append(
                    f"{place}:{line}: {room} must not include {other} ({name}), only "
                    f"{', '.join(ALLOWED[room]) or 'itself'}: see Documentation/Architecture.md, Rooms")
            if (other, Path(name).stem) != (room, unit):
                seen[(other, Path(name).stem)] = None
    return problems + circles_of(units)


def circles_of(units):
    """Circles of units that include each other, one line each."""
    problems = []
    state = {}

    def visit(unit, way):
        state[unit] = "open"
        for other in units.get(unit, {}):
            if state.get(other) == "open":
                circle = way[way.index(other):] + [other]
                problems.append("circle: " + " -> ".join("/".join(u) for u in circle))
            elif other not in state:
                visit(other, way + [other])
        state[unit] = "done"

    for unit in units:
        if unit not in state:
            visit(unit, [unit])
    return problems


def main():
    core = Path(sys.argv[1])
    if not any(core.rglob("*.h")):
        print(f"check_rooms.py: no headers in {core}", file=sys.stderr)
        return 2
    problems = problems_of(core)
    for problem in problems:
        print(problem, file=sys.stderr)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
