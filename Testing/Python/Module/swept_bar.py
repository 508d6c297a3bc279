# SPDX-License-Identifier: BSD-3-Clause
"""A bar with names for its faces, swept, for the tests of formats; and what is known of it."""

import importlib.util
import shutil
import sys

from hexsweep import vtkOneToOneSweep, vtkSweepSets
from vtkmodules.vtkCommonCore import vtkIdTypeArray, vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

SIZES = 3.0, 2.0, 7.0
# Of the faces 1 to 6: two share a name, one has characters that not every format takes, one has none.
NAMES = ["", "Clamp", "Load", "x = 0", "Wall", "Y,0 \u00e4u\u00dfen", "wall"]
SETS = {1: "Clamp", 2: "Load", 3: "x = 0", 4: "Wall 4", 5: "Y,0 \u00e4u\u00dfen", 6: "wall 6"}
PARTS = {7: "Source", 8: "Target", 9: "Sides"}
# Corners, facing outward: z = 0, z = 7, x = 0, x = 3, y = 0, y = 2.
_FACES = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3)]
AREAS = {1: 6.0, 2: 6.0, 3: 14.0, 4: 14.0, 5: 21.0, 6: 21.0}
# Where a face lies: axis and coordinate.
PLANES = {1: (2, 0.0), 2: (2, 7.0), 3: (0, 0.0), 4: (0, 3.0), 5: (1, 0.0), 6: (1, 2.0)}
VOLUME = 42.0


def solid(names=NAMES, scale=1.0):
    points = vtkPoints()
    points.SetDataTypeToDouble()
    for i in range(8):
        points.InsertNextPoint([scale * (i >> k & 1) * SIZES[k] for k in range(3)])
    triangles, faces = vtkCellArray(), vtkIdTypeArray()
    faces.SetName("FaceId")
    for number, (a, b, c, d) in enumerate(_FACES, start=1):
        for corners in (a, b, c), (a, c, d):
            triangles.InsertNextCell(3, corners)
            faces.InsertNextValue(number)
    surface = vtkPolyData()
    surface.SetPoints(points)
    surface.SetPolys(triangles)
    surface.GetCellData().AddArray(faces)
    add_texts(surface, "FaceNames", names)
    add_texts(surface, "VolumeName", ["Bar"])
    return surface


def add_texts(data, name, texts):
    array = vtkStringArray()
    array.SetName(name)
    for text in texts:
        array.InsertNextValue(text)
    data.GetFieldData().AddArray(array)


def sweep(size=0.6, **options):
    algorithm = vtkOneToOneSweep()
    algorithm.SetSolidData(solid(**options))
    algorithm.AddSourceFaceId(1)
    algorithm.SetSize(size)
    algorithm.Update()
    return algorithm


def swept_sets(swept):
    sets = vtkSweepSets()
    sets.SetHexesConnection(swept.GetOutputPort(0))
    sets.SetBoundaryConnection(swept.GetOutputPort(1))
    return sets


def face_nodes(points, face, scale=1.0):
    """Numbers of those that lie on a face, from where it lies."""
    axis, place = PLANES[face]
    return {i for i, point in enumerate(points) if abs(point[axis] - scale * place) < 1e-9 * scale}


def need(*modules, programs=()):
    """Ends the test as skipped where one is missing."""
    missing = [name for name in modules if importlib.util.find_spec(name) is None]
    missing += [name for name in programs if shutil.which(name) is None]
    if missing:
        print(f"skipped: {', '.join(missing)} not installed (Utilities/install-dependencies.sh)")
        sys.exit(77)
