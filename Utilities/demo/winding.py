# SPDX-License-Identifier: BSD-3-Clause
"""Draws a round bar with two holes that turn about each other; run by `Utilities/demo.sh --winding`.

The rim stays, the holes turn by half a turn on the way. Quads of the caps and hexes are coloured by
the half of the source cap that they come from, so that one sees how the mesh winds.
"""

import argparse
import os

import hexsweep
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdTypeArray, vtkLookupTable, vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_QUAD, VTK_TRIANGLE, vtkCellArray, vtkPlane
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid
from vtkmodules.vtkFiltersExtraction import vtkExtractGeometry
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkTextActor,
    vtkWindowToImageFilter,
)
import vtkmodules.vtkInteractionStyle  # noqa: F401
import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401

CELLS = 18  # across the square in the middle of the disk; its holes are three wide
LAYERS = 24
HEIGHT = 2.0  # the radius being 1
HALVES = [(0.55, 0.71, 0.85), (0.98, 0.75, 0.50)]
SIZE = (1800, 640)


def on_disk(q):
    """The square [-1, 1]^2 onto the unit disk, equal steps along its rim to equal angles."""
    size = np.abs(q).max(axis=1)
    with np.errstate(divide="ignore", invalid="ignore"):
        wide = np.abs(q[:, 0]) >= np.abs(q[:, 1])
        across = np.where(q[:, 0] > 0, 0, np.pi) + np.pi / 4 * q[:, 1] / q[:, 0]
        along = np.where(q[:, 1] > 0, 0.5, -0.5) * np.pi - np.pi / 4 * q[:, 0] / q[:, 1]
    angle = np.where(size > 0, np.where(wide, across, along), 0.0)
    return size[:, None] * np.column_stack([np.cos(angle), np.sin(angle)])


def disk_with_holes():
    """Points (n x 2) and quads: a square with two square holes, in a ring of quads."""
    n = CELLS
    ids = -np.ones((n + 1, n + 1), dtype=int)
    quads = []
    points = []

    def node(i, j):
        if ids[i, j] < 0:
            ids[i, j] = len(points)
            points.append((2 * i / n - 1, 2 * j / n - 1))
        return ids[i, j]

    for j in range(n):
        for i in range(n):
            left, right = 2 * n // 9, n - 2 * n // 9 - n // 6
            low = (n - n // 6) // 2
            inside = any(begin <= i < begin + n // 6 for begin in (left, right))
            if not (inside and low <= j < low + n // 6):
                quads.append([node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)])
    square = np.array(points)
    points = [0.6 * (0.6 * square + 0.4 * on_disk(square))]
    rim = [(k, 0) for k in range(n)] + [(n, k) for k in range(n)]
    rim += [(n - k, n) for k in range(n)] + [(0, n - k) for k in range(n)]
    inner = [ids[place] for place in rim]
    start = points[0][inner]
    circle = on_disk(2 * np.array(rim) / n - 1.0)
    for layer in range(1, n // 3 + 1):
        outer = [len(square) + (layer - 1) * len(rim) + k for k in range(len(rim))]
        points.append(start + layer / (n // 3) * (circle - start))
        for k in range(len(rim)):
            m = (k + 1) % len(rim)
            quads.append([inner[k], outer[k], outer[m], inner[m]])
        inner = outer
    return np.concatenate(points), np.array(quads)


def turned(points, angle):
    c, s = np.cos(angle), np.sin(angle)
    return points @ np.array([[c, s], [-s, c]])


def grid(points, cells, kind):
    mesh = vtkUnstructuredGrid()
    coordinates = vtkPoints()
    coordinates.SetData(numpy_to_vtk(np.ascontiguousarray(points, dtype=float), deep=True))
    mesh.SetPoints(coordinates)
    offsets, corners = vtkIdTypeArray(), vtkIdTypeArray()
    for array, values in (
        (offsets, np.arange(0, cells.size + 1, cells.shape[1])),
        (corners, cells.ravel()),
    ):
        array.SetNumberOfValues(len(values))
        vtk_to_numpy(array)[:] = values
    table = vtkCellArray()
    table.SetData(offsets, corners)
    mesh.SetCells(kind, table)
    return mesh


def sides(points, quads, degrees):
    """Linking quads: the rim stays, the loops of the holes turn."""
    edges = {(q[c], q[(c + 1) % 4]) for q in quads.tolist() for c in range(4)}
    border = sorted(edge for edge in edges if edge[::-1] not in edges)
    nodes = sorted({node for edge in border for node in edge})
    row = {node: k for k, node in enumerate(nodes)}
    at = points[nodes]
    stays = np.hypot(*at.T) > 1 - 1e-9
    layers = []
    for k in range(LAYERS + 1):
        place = np.where(stays[:, None], at, turned(at, np.radians(degrees) * k / LAYERS))
        layers.append(np.column_stack([place, np.full(len(at), HEIGHT * k / LAYERS)]))
    m = len(nodes)
    cells = [
        [k * m + row[a], k * m + row[b], (k + 1) * m + row[b], (k + 1) * m + row[a]]
        for k in range(LAYERS)
        for a, b in border
    ]
    return grid(np.concatenate(layers), np.array(cells), VTK_QUAD)


def sweep(degrees):
    """Source quads, target quads, hexes."""
    points, quads = disk_with_holes()
    flat = np.column_stack([points, np.zeros(len(points))])
    source = grid(flat, quads, VTK_QUAD)
    middles = points[quads].mean(axis=1)
    half = numpy_to_vtk((middles[:, 0] > 0).astype("uint8"), deep=True)
    half.SetName("Half")
    source.GetCellData().AddArray(half)
    # The holes' places are those of the source cap, turned.
    cap = np.column_stack([turned(points, np.radians(degrees)), np.full(len(points), HEIGHT)])
    target = grid(cap, np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]]), VTK_TRIANGLE)
    linking = sides(points, quads, degrees)
    projector = hexsweep.vtkSweepQuadProjector()
    projector.SetInputData(0, source)
    projector.SetInputData(1, target)
    projector.SetInputData(2, linking)
    interior = hexsweep.vtkCageHexInterior()
    interior.SetInputData(0, source)
    interior.SetInputConnection(1, projector.GetOutputPort())
    interior.SetInputData(2, linking)
    interior.Update()
    return source, projector.GetOutput(), interior.GetOutput()


def actor_of(mesh):
    surface = vtkGeometryFilter()
    surface.SetInputData(mesh)
    colors = vtkLookupTable()
    colors.SetNumberOfTableValues(2)
    for k, color in enumerate(HALVES):
        colors.SetTableValue(k, *color)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(surface.GetOutputPort())
    mapper.SetScalarModeToUseCellFieldData()
    mapper.SetColorModeToMapScalars()  # bytes would be taken as colours
    mapper.SelectColorArray("Half")
    mapper.SetLookupTable(colors)
    mapper.SetScalarRange(0, 1)
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().EdgeVisibilityOn()
    actor.GetProperty().SetEdgeColor(0.25, 0.27, 0.30)
    actor.GetProperty().SetAmbient(0.45)
    actor.GetProperty().SetDiffuse(0.6)
    return actor


def panel(window, number, mesh, title, direction, scale):
    view = vtkRenderer()
    view.SetViewport(number / 3, 0, (number + 1) / 3, 1)
    view.SetBackground(1, 1, 1)
    view.AddActor(actor_of(mesh))
    text = vtkTextActor()
    text.SetInput(title)
    text.GetTextProperty().SetColor(0.1, 0.1, 0.1)
    text.GetTextProperty().SetFontSize(22)
    text.GetTextProperty().SetJustificationToCentered()
    text.SetPosition(SIZE[0] / 6, SIZE[1] - 44)
    view.AddViewProp(text)
    window.AddRenderer(view)
    camera = view.GetActiveCamera()
    camera.ParallelProjectionOn()
    middle = np.array(mesh.GetCenter())
    camera.SetFocalPoint(*middle)
    camera.SetPosition(*(middle + 10 * np.array(direction)))
    camera.SetViewUp(0, 1, 0) if direction[2] == 1 else camera.SetViewUp(0, 0, 1)
    view.ResetCamera()
    camera.SetParallelScale(scale)


def opened(hexes):
    """Whole hexes behind a plane along the axis."""
    plane = vtkPlane()
    plane.SetOrigin(0, 0, 0)
    plane.SetNormal(0, -1, 0)
    cut = vtkExtractGeometry()
    cut.SetInputData(hexes)
    cut.SetImplicitFunction(plane)
    cut.SetExtractInside(True)
    cut.ExtractBoundaryCellsOn()
    cut.Update()
    return cut.GetOutput()


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--output", required=True)
    parser.add_argument("--degrees", type=float, default=180.0, help="a multiple of 5")
    arguments = parser.parse_args()
    os.makedirs(arguments.output, exist_ok=True)
    source, target, hexes = sweep(arguments.degrees)
    for mesh, name in ((target, "quads"), (hexes, "hexes")):
        quality = vtk_to_numpy(mesh.GetCellData().GetArray("ScaledJacobian"))
        print(f"{len(quality)} {name}: {np.sum(quality <= 0)} inverted, scaled Jacobian "
              f"{quality.min():.3f} at the least, {quality.mean():.3f} on the mean")
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(*SIZE)
    panel(window, 0, source, "Source quads", (0, 0, 1), 1.18)
    panel(window, 1, target, "On the target cap", (0, 0, 1), 1.18)
    panel(window, 2, opened(hexes), "Hexes cut open", (0.25, -0.87, 0.43), 1.45)
    window.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetInputConnection(image.GetOutputPort())
    writer.SetFileName(os.path.join(arguments.output, "winding_holes.png"))
    writer.Write()


if __name__ == "__main__":
    main()
