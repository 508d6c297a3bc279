#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes random solids that can be swept: make_solids.py OUTPUT FIRST LAST [FAMILY...]

Writes OUTPUT/<family><seed>/{solid.geo, solid.vtu, case.json} for every family (see families.py) and
every seed from FIRST to LAST. The solids are made and tessellated by the program gmsh, which is run
as a process of its own; nothing of HexSweep needs it. A seed always gives the same solid, with the
same gmsh; those that are there already are left out. Where gmsh makes no closed surface with both caps, the next attempt takes its place.
"""

import json
import random
import subprocess
import sys
from pathlib import Path

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray

sys.path.insert(0, str(Path(__file__).resolve().parent))
from families import FAMILIES
from profiles import Geo

ATTEMPTS = 20


def read_msh(path):
    """Points, triangles and the CAD face of each triangle of a .msh file, version 2."""
    lines = path.read_text().split("\n")
    at = lines.index("$Nodes")
    count = int(lines[at + 1])
    nodes = np.array([line.split() for line in lines[at + 2:at + 2 + count]], float)
    ids = nodes[:, 0].astype(int)
    row = np.full(ids.max() + 1, -1)
    row[ids] = np.arange(count)
    at = lines.index("$Elements")
    triangles, faces = [], []
    for line in lines[at + 2:at + 2 + int(lines[at + 1])]:
        numbers = [int(word) for word in line.split()]
        if numbers[1] == 2:
            triangles.append(numbers[-3:])
            faces.append(numbers[4])
    if not triangles:
        raise ValueError("no triangles")
    triangles = row[np.array(triangles)]
    used, compact = np.unique(triangles, return_inverse=True)
    return nodes[used, 1:4], compact.reshape(-1, 3), np.array(faces)


def check_closed(triangles):
    edges = np.sort(np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]), axis=1)
    _, counts = np.unique(edges, axis=0, return_counts=True)
    if (counts != 2).any():
        raise ValueError("the surface is not closed")


def faces_on(points, triangles, faces, test):
    """Ids of the faces all of whose points lie on the cap."""
    on = test(points)
    return [int(f) for f in np.unique(faces) if on[triangles[faces == f]].all()]


def loops_of(triangles):
    """How many closed borders these triangles have."""
    edges = np.sort(np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]), axis=1)
    edges, counts = np.unique(edges, axis=0, return_counts=True)
    beside = {}
    for one, other in edges[counts == 1]:
        beside.setdefault(one, []).append(other)
        beside.setdefault(other, []).append(one)
    loops = 0
    while beside:
        loops += 1
        ahead = [next(iter(beside))]
        while ahead:
            ahead += beside.pop(ahead.pop(), [])
    return loops


def check_swept(triangles, faces, source, target):
    """A sweep has as many handles as its caps have holes: a feature that fills a hole spoils it."""
    loops = [loops_of(triangles[np.isin(faces, cap)]) for cap in (source, target)]
    # A closed surface of triangles has half as many again edges; Euler: V - E + F = 2 - 2 handles.
    handles = 1 - (len(np.unique(triangles)) - len(triangles) // 2) // 2
    if loops != [handles + 1, handles + 1]:
        raise ValueError(f"the caps have {loops[0]} and {loops[1]} loops, the surface {handles} handles")


def write_vtu(path, points, triangles, faces):
    grid = vtk.vtkUnstructuredGrid()
    vtk_points = vtk.vtkPoints()
    vtk_points.SetDataType(vtk.VTK_DOUBLE)
    vtk_points.SetData(numpy_to_vtk(np.ascontiguousarray(points), deep=True))
    grid.SetPoints(vtk_points)
    cells = vtk.vtkCellArray()
    rows = np.hstack([np.full((len(triangles), 1), 3), triangles]).astype(np.int64).ravel()
    cells.SetCells(len(triangles), numpy_to_vtkIdTypeArray(rows, deep=True))
    grid.SetCells(vtk.VTK_TRIANGLE, cells)
    ids = numpy_to_vtkIdTypeArray(faces.astype(np.int64), deep=True)
    ids.SetName("FaceId")
    grid.GetCellData().AddArray(ids)
    writer = vtk.vtkXMLUnstructuredGridWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(grid)
    writer.Write()


def attempt(folder, family, seed, number):
    r = random.Random(f"{family}/{seed}/{number}")
    geo = Geo()
    solid = FAMILIES[family](geo, r)
    if solid is None:
        raise ValueError("left out by its family")
    coarse = solid.size / r.uniform(6, 25)
    curvature, algorithm, scale = r.choice([8, 12, 16, 24]), r.choice([1, 5, 6]), r.choice([0.001, 1.0, 1.0, 1000.0])
    for line in ("outer() = CombinedBoundary{ Volume{solid()}; };",
                 "For i In {0 : #outer() - 1}", "  Physical Surface(i + 1) = {Fabs(outer(i))};", "EndFor",
                 f"Mesh.CharacteristicLengthMax = {coarse!r};", f"Mesh.CharacteristicLengthFromCurvature = 1;",
                 f"Mesh.MinimumElementsPerTwoPi = {curvature};", f"Mesh.Algorithm = {algorithm};",
                 "Mesh.SaveAll = 0;", "Mesh.MshFileVersion = 2.2;"):
        geo.add(line)
    folder.mkdir(parents=True, exist_ok=True)
    script = folder / "solid.geo"
    script.write_text("\n".join(geo.lines) + "\n")
    mesh = folder / "solid.msh"
    done = subprocess.run(["gmsh", "-2", str(script), "-o", str(mesh), "-v", "2", "-nt", "1"],
                          capture_output=True, text=True, timeout=120)
    if not mesh.exists():
        raise ValueError("gmsh: " + (done.stdout + done.stderr).strip()[-200:])
    points, triangles, faces = read_msh(mesh)
    mesh.unlink()
    check_closed(triangles)
    source = faces_on(points, triangles, faces, solid.source)
    target = faces_on(points, triangles, faces, solid.target)
    if not source or not target or set(source) & set(target):
        raise ValueError("a cap is missing")
    corners = [set(triangles[np.isin(faces, cap)].ravel()) for cap in (source, target)]
    if corners[0] & corners[1]:
        raise ValueError("the caps touch, there is no side between them")
    check_swept(triangles, faces, source, target)
    if len(triangles) > 40000:
        raise ValueError("too many triangles")
    write_vtu(folder / "solid.vtu", scale * points, triangles, faces)
    (folder / "case.json").write_text(json.dumps({
        "family": family, "what": solid.what, "tags": solid.tags, "seed": seed, "attempt": number,
        "source_face_ids": source, "target_face_ids": target, "triangles": len(triangles),
        "faces": len(np.unique(faces)), "scale": scale, "curvature": curvature, "algorithm": algorithm}) + "\n")


def make(folder, family, seed):
    problems = []
    for number in range(ATTEMPTS):
        try:
            attempt(folder, family, seed, number)
            return problems
        except (ValueError, IndexError, subprocess.TimeoutExpired) as problem:
            problems.append(str(problem))
    raise RuntimeError(f"{family}{seed}: " + " | ".join(problems))


def main():
    output, first, last = Path(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3])
    for family in sys.argv[4:] or FAMILIES:
        for seed in range(first, last + 1):
            if (output / f"{family}{seed}" / "case.json").exists():
                continue
            problems = make(output / f"{family}{seed}", family, seed)
            print(f"{family}{seed}", *(f"({p})" for p in problems), flush=True)


if __name__ == "__main__":
    main()
