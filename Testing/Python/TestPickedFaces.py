# SPDX-License-Identifier: BSD-3-Clause
"""Caps that are picked in the view: the selections that Copy Active Selection makes."""

import os

from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

simple.LoadPlugin(os.environ["HEXSWEEP_PLUGIN"], remote=False, ns=globals())
DATA = os.environ["HEXSWEEP_DATA_DIR"]


def caps(hexes):
    hexes.UpdatePipeline()
    return [int(hexes.FieldData["SweepReport" + name].GetRange()[0]) for name in ("SourceFaceIds", "TargetFaceIds")]


def cell_on(data, face):
    """The last cell of a face."""
    return int((vtk_to_numpy(data.GetCellData().GetArray("FaceId")) == face).nonzero()[0][-1])


# A single solid: cells picked in the view come as ids of process and cell.
solid = simple.OpenDataFile(os.path.join(DATA, "solids", "flange", "solid.vtu"))
data = servermanager.Fetch(solid)
picked = simple.IDSelectionSource(FieldType="CELL", IDs=[0, cell_on(data, 2)])
hexes = OneToOneSweep(Solid=solid, SourceSelection=picked, Size=6)  # noqa: F821
assert caps(hexes) == [2, 3], caps(hexes)
picked.IDs = [0, cell_on(data, 3)]
assert caps(hexes) == [3, 2], "the filter follows the selection"

# A CAD file is a collection: an id of the block, too. The flat index of a solid's data set is 2: below the
# root and its partitioned data set.
part = simple.OpenDataFile(os.path.join(DATA, "cad", "named_block.step"))
part.UpdatePipeline()
block = part.GetClientSideObject().GetOutputDataObject(0).GetPartition(0, 0)
picked = simple.CompositeDataIDSelectionSource(FieldType="CELL", IDs=[2, 0, cell_on(block, 5)])
hexes = OneToOneSweep(Solid=part, TargetSelection=picked, Size=0.5)  # noqa: F821
assert caps(hexes) == [6, 5], caps(hexes)

# What the view itself selects of a surface that it shows.
view = simple.GetActiveViewOrCreate("RenderView")
view.ViewSize = [300, 300]
simple.Show(part, view)
view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [-9.0, 1.0, 1.5], [0.0, 1.0, 1.5], [0, 0, 1]
simple.Render(view)  # it looks at face 1, where x is 0
simple.SelectSurfaceCells(Rectangle=[140, 140, 160, 160], View=view)
selection = part.GetSelectionInput(part.Port)
assert selection, "the view has selected nothing"
hexes = OneToOneSweep(Solid=part, SourceSelection=selection, Size=0.5)  # noqa: F821
assert caps(hexes) == [1, 2], caps(hexes)

# Several caps: either end of a stepped shaft, picked as the source, is where the sweep begins.
shaft = simple.OpenDataFile(os.path.join(DATA, "cad", "stepped_shaft.step"))
shaft.UpdatePipeline()
block = shaft.GetClientSideObject().GetOutputDataObject(0).GetPartition(0, 0)
found = ManyToManySweep(Solid=shaft, Size=6)  # noqa: F821
found.UpdatePipeline()


def ends(hexes, name):
    hexes.UpdatePipeline()
    return {int(face) for face in vtk_to_numpy(servermanager.Fetch(hexes).GetFieldData().GetArray("SweepReport" + name))}


for name in "SourceFaceIds", "TargetFaceIds":
    end = min(ends(found, name))
    picked = simple.CompositeDataIDSelectionSource(FieldType="CELL", IDs=[2, 0, cell_on(block, end)])
    hexes = ManyToManySweep(Solid=shaft, SourceSelection=picked, Size=6)  # noqa: F821
    assert ends(hexes, "SourceFaceIds") == ends(found, name), (end, ends(hexes, "SourceFaceIds"))
