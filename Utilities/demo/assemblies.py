# SPDX-License-Identifier: BSD-3-Clause
"""Meshes the assemblies of Data/cad, nothing named; run by `Utilities/demo.sh --assemblies`.

Prints a table in the form of Documentation/Results.md and draws some of them: whole, and pulled apart
and cut open, coloured by volume.
"""

import argparse
import os
import time

import hexsweep
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkFiltersExtraction import vtkExtractGeometry
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter
import vtkmodules.vtkInteractionStyle  # noqa: F401
import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401

NAMES = ("bolted_joint", "flanged_pipe", "headed_bolt", "lined_elbow", "pad_on_plate", "pin_in_plate", "sector_ring",
         "tee_blocks", "three_blocks")
# Name, size of the hexahedra, direction from which one looks, normal of the cut, how far volumes are pulled apart.
PICTURES = (
    ("bolted_joint", 1.6, (0.55, -0.75, 0.35), (0.0, -1.0, 0.0), 0.9),
    ("headed_bolt", 1.3, (0.5, -0.75, 0.45), (0.0, -1.0, 0.0), 0.0),
    ("lined_elbow", 2.2, (0.35, -0.9, 0.3), (0.0, -1.0, 0.0), 0.0),
    ("sector_ring", 2.5, (0.3, -0.6, 0.75), None, 0.45),
)
COLORS = [(0.55, 0.71, 0.85), (0.98, 0.75, 0.50), (0.66, 0.84, 0.60), (0.96, 0.65, 0.65), (0.79, 0.70, 0.87),
          (0.98, 0.90, 0.55)]
SIZE = (1800, 760)


def sweep(data, name, size=0.0):
    """The filter, merged off, and the CPU seconds that it took."""
    reader = hexsweep.vtkCADReader()
    reader.SetFileName(os.path.join(data, name + ".step"))
    reader.Update()
    assembly = hexsweep.vtkAssemblySweep()
    assembly.SetInputDataObject(reader.GetOutputDataObject(0))
    assembly.SetSize(size)
    begin = time.process_time()
    assembly.Update()
    return assembly, time.process_time() - begin


def grids_of(assembly):
    volumes = assembly.GetOutputDataObject(0)
    return [volumes.GetPartition(v, 0) for v in range(volumes.GetNumberOfPartitionedDataSets())]


def print_table(data):
    print("| assembly (`Data/cad`) | volumes | shared faces | hexes | not certified | SJ min / mean | CPU s |")
    print("|---|---:|---:|---:|---:|---:|---:|")
    for name in NAMES:
        assembly, seconds = sweep(data, name)
        grids = grids_of(assembly)
        quality = np.concatenate([vtk_to_numpy(grid.GetCellData().GetArray("ScaledJacobian")) for grid in grids])
        bad = sum(int(grid.GetFieldData().GetArray("SweepReportNotCertified").GetValue(0)) for grid in grids)
        quads = assembly.GetOutputDataObject(1).GetCellData()
        shared = vtk_to_numpy(quads.GetArray("BoundaryId"))[vtk_to_numpy(quads.GetArray("VolumeIds"))[:, 1] > 0]
        count = f"{len(quality):,}".replace(",", " ")
        print(f"| `{name}` | {len(grids)} | {len(np.unique(shared))} | {count} | **{bad}** | "
              f"{quality.min():.3f} / {quality.mean():.3f} | {seconds:.1f} |")


def actor_of(grid, color, offset, normal):
    if normal is not None:
        plane = vtkPlane()
        plane.SetOrigin(0.0, 0.0, 0.0)
        plane.SetNormal(*normal)
        cut = vtkExtractGeometry()
        cut.SetInputData(grid)
        cut.SetImplicitFunction(plane)
        cut.ExtractInsideOn()
        cut.ExtractBoundaryCellsOn()
        cut.Update()
        grid = cut.GetOutput()
    surface = vtkGeometryFilter()
    surface.SetInputData(grid)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(surface.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.SetPosition(*offset)
    actor.GetProperty().SetColor(*color)
    actor.GetProperty().EdgeVisibilityOn()
    actor.GetProperty().SetEdgeColor(0.25, 0.27, 0.30)
    actor.GetProperty().SetAmbient(0.4)
    actor.GetProperty().SetDiffuse(0.6)
    return actor


def draw(data, output, name, size, direction, normal, apart):
    assembly, _ = sweep(data, name, size)
    grids = grids_of(assembly)
    middle = np.mean([grid.GetCenter() for grid in grids], axis=0)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(*SIZE)
    for panel in (0, 1):
        view = vtkRenderer()
        view.SetViewport(panel / 2, 0, (panel + 1) / 2, 1)
        view.SetBackground(1, 1, 1)
        for v, grid in enumerate(grids):
            offset = panel * apart * (np.array(grid.GetCenter()) - middle)
            view.AddActor(actor_of(grid, COLORS[v % len(COLORS)], offset, normal if panel == 1 else None))
        window.AddRenderer(view)
        camera = view.GetActiveCamera()
        camera.SetFocalPoint(*middle)
        camera.SetPosition(*(middle + np.array(direction)))
        camera.SetViewUp(0, 0, 1)
        view.ResetCamera()
        camera.Zoom(1.25)
    window.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetInputConnection(image.GetOutputPort())
    writer.SetFileName(os.path.join(output, f"assembly_{name}.png"))
    writer.Write()


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--output", required=True)
    parser.add_argument("--data", required=True)
    arguments = parser.parse_args()
    os.makedirs(arguments.output, exist_ok=True)
    print_table(arguments.data)
    for picture in PICTURES:
        draw(arguments.data, arguments.output, *picture)


if __name__ == "__main__":
    main()
