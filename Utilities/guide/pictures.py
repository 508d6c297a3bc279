# SPDX-License-Identifier: BSD-3-Clause
"""Draws the pictures of the guide that no demo draws, into Documentation/guide/pictures.

    xvfb-run -a python3 Utilities/guide/pictures.py     # with the Python package on the path
"""

import sys
from pathlib import Path

import hexsweep
import numpy as np
import vtkmodules.vtkInteractionStyle  # noqa: F401
import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkFiltersCore import vtkAppendFilter, vtkThreshold
from vtkmodules.vtkFiltersExtraction import vtkExtractGeometry
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkBillboardTextActor3D, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter,
)

ROOT = Path(__file__).resolve().parent.parent.parent
DATA, OUTPUT = ROOT / "Data", ROOT / "Documentation" / "guide" / "pictures"
FACES = [(0.55, 0.71, 0.85), (0.98, 0.75, 0.50), (0.66, 0.84, 0.60), (0.96, 0.65, 0.65),
         (0.79, 0.70, 0.87), (0.98, 0.90, 0.55), (0.60, 0.85, 0.82), (0.86, 0.80, 0.74)]
INK, PLAIN = (0.15, 0.17, 0.20), (0.86, 0.88, 0.91)
VIEW = (-0.5, -0.8, 0.55)


def read(path):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def solids(name):
    reader = hexsweep.vtkCADReader()
    reader.SetFileName(str(DATA / "cad" / f"{name}.step"))
    reader.SetLinearDeflection(2e-4)
    reader.SetAngularDeflection(4.0)
    reader.Update()
    return reader


def joined(collection):
    """All data sets of a composite as one grid."""
    append = vtkAppendFilter()
    walk = collection.NewIterator()
    while not walk.IsDoneWithTraversal():
        append.AddInputData(walk.GetCurrentDataObject())
        walk.GoToNextItem()
    append.Update()
    return append.GetOutput()


def actor(grid, edges=True, array=None, colors=None, color=PLAIN):
    """@param array: of cells: whole numbers, in the colours of faces, or with `colors`, a vtkLookupTable."""
    skin = vtkGeometryFilter()
    skin.SetInputData(grid)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(skin.GetOutputPort())
    shown = vtkActor()
    shown.SetMapper(mapper)
    if array:
        mapper.SetScalarModeToUseCellFieldData()
        mapper.SelectColorArray(array)
        mapper.SetLookupTable(colors or face_colors(grid, array))
        mapper.UseLookupTableScalarRangeOn()
    else:
        mapper.ScalarVisibilityOff()
        shown.GetProperty().SetColor(color)
    look = shown.GetProperty()
    look.SetInterpolationToFlat()
    look.SetAmbient(0.55)
    look.SetDiffuse(0.5)
    look.SetEdgeVisibility(edges)
    look.SetEdgeColor(INK)
    look.SetLineWidth(1.0)
    return shown


def face_colors(grid, array):
    ids = vtk_to_numpy(grid.GetCellData().GetArray(array))
    table = vtkLookupTable()
    table.SetNumberOfTableValues(int(ids.max() - ids.min()) + 1)
    table.SetTableRange(ids.min() - 0.5, ids.max() + 0.5)
    for i in range(table.GetNumberOfTableValues()):
        table.SetTableValue(i, *FACES[(i + int(ids.min())) % len(FACES)], 1.0)
    return table


def quality_colors():
    table = vtkLookupTable()
    table.SetNumberOfTableValues(256)
    table.SetTableRange(0.0, 1.0)
    stops = np.array([(0.75, 0.15, 0.15), (0.98, 0.75, 0.40), (0.99, 0.98, 0.80), (0.45, 0.72, 0.75), (0.20, 0.35, 0.60)])
    for i in range(256):
        rgb = [np.interp(i / 255.0, np.linspace(0, 1, len(stops)), stops[:, k]) for k in range(3)]
        table.SetTableValue(i, *rgb, 1.0)
    return table


def scale(table):
    bar = vtkScalarBarActor()
    bar.SetLookupTable(table)
    bar.SetNumberOfLabels(5)
    bar.SetLabelFormat("%.2f")
    bar.SetMaximumWidthInPixels(70)
    bar.SetPosition(0.86, 0.15)
    bar.SetHeight(0.7)
    bar.SetWidth(0.1)
    bar.UnconstrainedFontSizeOn()
    text = bar.GetLabelTextProperty()
    text.SetColor(INK)
    text.SetFontSize(18)
    text.ItalicOff()
    text.BoldOff()
    text.ShadowOff()
    return bar


def labels(surface, array):
    """The ids of faces as text, before those of their triangles that look at the eye."""
    points = vtk_to_numpy(surface.GetPoints().GetData())
    ids = vtk_to_numpy(surface.GetCellData().GetArray(array))
    triangles = np.array([[surface.GetCell(c).GetPointId(k) for k in range(3)] for c in range(surface.GetNumberOfCells())])
    corners = points[triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    middles, towards = corners.mean(axis=1), normals @ np.array(VIEW)
    for face in np.unique(ids):
        weights = np.where((ids == face) & (towards > 0.3 * np.linalg.norm(normals, axis=1)), towards, 0.0)
        if not weights.any():
            continue
        middle = (middles * weights[:, None]).sum(axis=0) / weights.sum()
        if np.linalg.norm(middles[weights > 0] - middle, axis=1).min() > 0.1 * np.ptp(points, axis=0).max():
            middle = middles[np.argmax(weights)]  # the middle of a ring is no place on it
        text = vtkBillboardTextActor3D()
        text.SetInput(str(face))
        # Far before the surface, where nothing hides it; the projection is parallel.
        text.SetPosition(*(middle + np.array(VIEW) * np.ptp(points, axis=0).max()))
        look = text.GetTextProperty()
        look.SetFontSize(24)
        look.SetColor(INK)
        look.BoldOn()
        look.SetJustificationToCentered()
        look.SetVerticalJustificationToCentered()
        yield text


def opened(grid, normal):
    """The cells behind a plane through the middle."""
    box = grid.GetBounds()
    plane = vtkPlane()
    plane.SetOrigin(*((box[2 * k] + box[2 * k + 1]) / 2 for k in range(3)))
    plane.SetNormal(*normal)
    cut = vtkExtractGeometry()
    cut.SetInputData(grid)
    cut.SetImplicitFunction(plane)
    cut.ExtractInsideOff()
    cut.Update()
    return cut.GetOutput()


def draw(name, panels, size=(900, 560), direction=VIEW, up=(0, 0, 1), zoom=1.0):
    """@param panels: lists of actors, side by side."""
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(*size)
    for i, actors in enumerate(panels):
        renderer = vtkRenderer()
        renderer.SetBackground(1, 1, 1)
        renderer.SetViewport(i / len(panels), 0, (i + 1) / len(panels), 1)
        for one in actors:
            one.SetUseBounds(isinstance(one, vtkActor))  # labels float before the surface
            renderer.AddViewProp(one)
        camera = renderer.GetActiveCamera()
        camera.SetPosition(*direction)
        camera.SetFocalPoint(0, 0, 0)
        camera.SetViewUp(*up)
        camera.ParallelProjectionOn()
        renderer.ResetCamera()
        camera.Zoom(zoom)
        camera.SetClippingRange(0.01 * camera.GetDistance(), 10.0 * camera.GetDistance())
        window.AddRenderer(renderer)
    window.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetFileName(str(OUTPUT / f"{name}.png"))
    writer.SetInputConnection(image.GetOutputPort())
    writer.SetCompressionLevel(9)
    writer.Write()
    print(name)


def parts_of(grid, array, numbers):
    """The cells whose array has one of some numbers."""
    ids = vtk_to_numpy(grid.GetCellData().GetArray(array))
    chosen = numpy_to_vtk(np.isin(ids, numbers).astype(np.int8), deep=1)
    chosen.SetName("chosen")
    copy = grid.NewInstance()
    copy.ShallowCopy(grid)
    copy.GetCellData().AddArray(chosen)
    threshold = vtkThreshold()
    threshold.SetInputData(copy)
    threshold.SetInputArrayToProcess(0, 0, 0, 1, "chosen")
    threshold.SetLowerThreshold(1)
    threshold.SetThresholdFunction(vtkThreshold.THRESHOLD_UPPER)
    threshold.SetUpperThreshold(1)
    threshold.Update()
    return threshold.GetOutput()


def first_mesh():
    block = joined(solids("named_block").GetOutputDataObject(0))
    draw("first_faces", [[actor(block, edges=False, array="FaceId"), *labels(block, "FaceId")]], size=(640, 480))
    table = quality_colors()
    mesh = hexsweep.sweep(str(DATA / "cad" / "named_block.step"), size=0.1)
    draw("first_mesh", [[actor(mesh, array="ScaledJacobian", colors=table), scale(table)]], size=(760, 520))


def cad_reader():
    reader = solids("bolted_joint")
    lines = actor(joined(reader.GetOutputDataObject(1)), edges=False, color=INK)
    lines.GetProperty().SetLineWidth(2.0)
    draw("filter_CADReader", [[actor(joined(reader.GetOutputDataObject(0)), edges=False, array="FaceId"), lines]], zoom=1.3)


def faces():
    flange = read(DATA / "solids" / "flange" / "solid.vtu")
    draw("filter_SolidFaces", [[actor(flange, edges=False, array="FaceId"), *labels(flange, "FaceId")]], zoom=1.3)


def candidates():
    bracket = read(DATA / "solids" / "bracket" / "solid.vtu")
    ways = hexsweep.vtkSweepCandidates()
    ways.SetInputData(bracket)
    ways.Update()
    caps = [
        [int(word) for word in ways.GetOutput().GetValueByName(0, name).ToString().split()]
        for name in ("SourceFaceIds", "TargetFaceIds")
    ]
    rest = sorted(set(vtk_to_numpy(bracket.GetCellData().GetArray("FaceId")).tolist()) - set(sum(caps, [])))
    shown = [actor(parts_of(bracket, "FaceId", ids), edges=False, color=color)
             for ids, color in ((caps[0], FACES[1]), (caps[1], FACES[0]), (rest, PLAIN))]
    shown[2].GetProperty().SetOpacity(0.35)
    draw("filter_SweepCandidates", [shown], zoom=1.2)


def validity():
    table = quality_colors()
    mesh = hexsweep.check(hexsweep.sweep(str(DATA / "solids" / "loft" / "solid.vtu"), size=3.0)).grid
    pieces = [[actor(mesh, array="ScaledJacobian", colors=table)],
              [actor(opened(mesh, (0, 1, 0)), array="ScaledJacobian", colors=table), scale(table)]]
    draw("filter_HexValidity", pieces, size=(1100, 520))


def sets():
    flange = str(DATA / "solids" / "flange" / "solid.vtu")
    _, boundary = hexsweep.sweep(flange, source=3, layers=6, boundary=True)
    draw("filter_SweepSets", [[actor(boundary, array="BoundaryId")]], zoom=1.3)


def disk_map():
    cap = hexsweep.vtkHarmonicDiskMap()
    cap.SetInputData(read(DATA / "cases" / "gear_round" / "source_surface.vtu"))
    cap.SetOutputDisk(False)
    disk = hexsweep.vtkHarmonicDiskMap()
    disk.SetInputData(read(DATA / "cases" / "gear_round" / "source_surface.vtu"))
    disk.SetOutputDisk(True)
    for one in (cap, disk):
        one.Update()
    draw("filter_HarmonicDiskMap", [[actor(cap.GetOutput())], [actor(disk.GetOutput())]], size=(1100, 560),
         direction=(0, 0, 1), up=(0, 1, 0), zoom=1.3)


def sides():
    flange = DATA / "solids" / "flange"
    mesher = hexsweep.vtkLinkingSideMesher()
    mesher.SetSourceQuadsData(read(flange / "source_quads.vtu"))
    mesher.SetLinkingSurfaceData(parts_of(read(flange / "solid.vtu"), "FaceId", [1, *range(4, 11)]))
    mesher.SetNumberOfLayers(6)
    mesher.Update()
    draw("filter_LinkingSideMesher", [[actor(mesher.GetOutput(), array="LoopId")]], zoom=1.3)


def layers():
    mesh = hexsweep.sweep(str(DATA / "solids" / "flange" / "solid.vtu"), source=3, layers=6, growth=1.4, both_ends=True)
    draw("sizes_layers", [[actor(opened(mesh, (0, 1, 0)))]], zoom=1.3)


if __name__ == "__main__":
    OUTPUT.mkdir(parents=True, exist_ok=True)
    known = (first_mesh, cad_reader, faces, candidates, validity, sets, disk_map, sides, layers)
    for picture in known:
        if len(sys.argv) < 2 or picture.__name__ in sys.argv[1:]:
            picture()
