# SPDX-License-Identifier: BSD-3-Clause
"""Save Data writes swept sets for Abaqus, CalculiX and gmsh, with ids that were chosen.

That such files are right is tested with those who read them (Module/TestAbaqusFiles.py,
Module/TestGmshFiles.py); here, that ParaView finds the writers and hands on their properties.
"""

import os

from chain_testing import DATA_DIR, OUTPUT_DIR, check, finish, simple

solid = simple.XMLUnstructuredGridReader(
    FileName=[os.path.join(DATA_DIR, "solids", "elbow", "solid.vtu")]
)
sweep = simple.OneToOneSweep(Solid=solid, NumberOfLayers=3, QuadSize=8.0)
sets = simple.SweepSets(
    Hexes=sweep, Boundary=simple.OutputPort(sweep, 1), SetIds=["Face 1", "21", "Target", "22"]
)


def saved(name, **options):
    path = os.path.join(OUTPUT_DIR, name)
    simple.SaveData(path, proxy=sets, **options)
    with open(path, "rb") as file:
        content = file.read()
    os.remove(path)
    return content


abaqus = saved("saved.inp")
check(abaqus.startswith(b"*HEADING\n"), "an input file of Abaqus")
for keyword in (b"*NSET, NSET=", b"*ELSET, ELSET=", b"*SURFACE, NAME="):
    check(keyword + b"Target" in abaqus, f"{keyword} Target")
for version, binary in (("4.1", 0), ("2.2", 1)):
    content = saved("saved.msh", FileVersion=version, Binary=binary)
    first = f"$MeshFormat\n{version} {binary} 8\n".encode()
    check(content.startswith(first), f"a file of gmsh begins with {content[:30]}")
    check(b'\n2 21 "Face 1"\n' in content, f"{version}: the id of face 1 is 21")
    check((b'\n2 22 "Target"\n' in content) == (version == "4.1"), f"{version}: the target")
finish()
