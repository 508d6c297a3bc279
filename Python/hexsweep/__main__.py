# SPDX-License-Identifier: BSD-3-Clause
"""Sweeps a tessellated solid from the command line::

    python3 -m hexsweep part.vtk                                     # lists the faces
    python3 -m hexsweep part.vtk --source 3 --layers 6 -o part.vtu   # meshes it with hexahedra

Reads .vtk, .vtu, .vtp, .stl, .ply and .obj; writes .vtu, or .ex2 and .exo (Exodus II with side sets
and node sets, where VTK's Exodus writer is there).
"""

import argparse
import importlib
import os
import sys

from . import vtkOneToOneSweep

_READERS = {
    ".vtk": ("vtkIOLegacy", "vtkDataSetReader"),
    ".vtu": ("vtkIOXML", "vtkXMLUnstructuredGridReader"),
    ".vtp": ("vtkIOXML", "vtkXMLPolyDataReader"),
    ".stl": ("vtkIOGeometry", "vtkSTLReader"),
    ".ply": ("vtkIOPLY", "vtkPLYReader"),
    ".obj": ("vtkIOGeometry", "vtkOBJReader"),
}
_EXODUS = (".ex2", ".exo", ".e")
_WRITTEN = (".vtu", *_EXODUS)


def main(arguments=None):
    options = _parse(arguments)
    solid = _read(options.solid)
    if not options.source:
        _list_faces(solid, options.faces)
        return 0
    sweep = vtkOneToOneSweep()
    sweep.SetSolidData(solid)
    if options.quads:
        sweep.SetSourceQuadsData(_read(options.quads))
    if options.faces:
        sweep.SetInputArrayToProcess(0, 0, 0, 1, options.faces)
    for face in options.source:
        sweep.AddSourceFaceId(face)
    for face in options.target or []:
        sweep.AddTargetFaceId(face)
    sweep.SetNumberOfLayers(options.layers)
    sweep.SetLayerSize(options.layer_size)
    sweep.SetGrowthRatio(options.growth)
    sweep.SetQuadSize(options.quad_size)
    sweep.Update()
    hexes = sweep.GetOutputDataObject(0)
    if hexes.GetNumberOfCells() == 0:
        return 1
    if not _write(sweep, options.output):
        return 1
    print(
        f"{options.output}: {hexes.GetNumberOfCells()} hexahedra, "
        f"{_reported(hexes, 'Inverted')} inverted, {_reported(hexes, 'NotCertified')} not certified, "
        f"scaled Jacobian {float(_reported(hexes, 'MinScaledJacobian')):.3f} (least), "
        f"{float(_reported(hexes, 'MeanScaledJacobian')):.3f} (mean)"
    )
    return 0


def _parse(arguments):
    parser = argparse.ArgumentParser(
        prog="python3 -m hexsweep", description="Meshes a solid with hexahedra by sweeping."
    )
    parser.add_argument("solid", help="closed surface of the solid, with face ids as a cell array")
    parser.add_argument("-o", "--output", help="what to write: .vtu, .ex2 or .exo")
    parser.add_argument("--source", type=int, nargs="+", help="ids of the source faces; none: list")
    parser.add_argument("--target", type=int, nargs="+", help="ids of the target faces (found)")
    parser.add_argument("--layers", type=int, default=10, help="number of layers (10)")
    parser.add_argument("--layer-size", type=float, default=0.0, help="or their thickness")
    parser.add_argument("--growth", type=float, default=1.0, help="thickness of a layer over the last")
    parser.add_argument("--quads", help="file with quads of the source cap (they are made)")
    parser.add_argument("--quad-size", type=float, default=0.0, help="edge length of quads made")
    parser.add_argument("--faces", help="cell array of face ids (FaceId, then CellEntityIds)")
    options = parser.parse_args(arguments)
    if options.source and not options.output:
        parser.error("name the file to write: -o part.vtu")
    if options.output and os.path.splitext(options.output)[1].lower() not in _WRITTEN:
        parser.error(f"cannot write {os.path.splitext(options.output)[1]} files; use .vtu or .ex2")
    return options


def _read(file_name):
    extension = os.path.splitext(file_name)[1].lower()
    if extension not in _READERS:
        sys.exit(f"{file_name}: cannot read {extension} files; use {', '.join(_READERS)}")
    if not os.path.isfile(file_name):
        sys.exit(f"{file_name}: no such file")
    module, name = _READERS[extension]
    reader = getattr(importlib.import_module("vtkmodules." + module), name)()
    reader.SetFileName(file_name)
    reader.Update()
    data = reader.GetOutputDataObject(0)
    if not data or data.GetNumberOfCells() == 0:
        sys.exit(f"{file_name}: no cells in it")
    return data


def _write(sweep, file_name):
    extension = os.path.splitext(file_name)[1].lower()
    if extension in _EXODUS:
        from vtkmodules.vtkIOExodus import vtkExodusIIWriter

        from . import vtkSweepSets

        sets = vtkSweepSets()
        sets.SetHexesConnection(sweep.GetOutputPort(0))
        sets.SetBoundaryConnection(sweep.GetOutputPort(1))
        writer = vtkExodusIIWriter()
        writer.SetInputConnection(sets.GetOutputPort())
    else:
        from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter

        writer = vtkXMLUnstructuredGridWriter()
        writer.SetInputConnection(sweep.GetOutputPort(0))
        writer.SetDataModeToBinary()
    if os.path.exists(file_name):
        os.remove(file_name)
    writer.SetFileName(file_name)
    writer.Write()
    return os.path.exists(file_name)


def _list_faces(solid, array_name):
    """Id, size and place of each face, to choose the source cap from."""
    names = [array_name] if array_name else ["FaceId", "CellEntityIds"]
    ids = next((a for a in map(solid.GetCellData().GetArray, names) if a), None)
    if not ids:
        sys.exit(
            f"the solid has no cell array named {' or '.join(names)}. Name one with --faces; without "
            "any, faces are told apart by the angle between triangles and numbered from 0."
        )
    sums = {}
    for cell in range(solid.GetNumberOfCells()):
        points = solid.GetCell(cell).GetPoints()
        if solid.GetCell(cell).GetCellDimension() != 2:
            continue
        corners = [points.GetPoint(i) for i in range(points.GetNumberOfPoints())]
        total = sums.setdefault(int(ids.GetTuple1(cell)), [0, 0.0, [0.0] * 3, [0.0] * 3])
        total[0] += 1
        for second, third in zip(corners[1:], corners[2:]):
            u = [b - a for a, b in zip(corners[0], second)]
            v = [b - a for a, b in zip(corners[0], third)]
            normal = [0.5 * (u[i - 2] * v[i - 1] - u[i - 1] * v[i - 2]) for i in range(3)]
            area = sum(n * n for n in normal) ** 0.5
            total[1] += area
            for i in range(3):
                total[2][i] += area * (corners[0][i] + second[i] + third[i]) / 3.0
                total[3][i] += normal[i]
    print(f"{'face':>6} {'cells':>8} {'area':>12}   {'centre':<36} flat")
    for face, (cells, area, centre, normal) in sorted(sums.items()):
        place = ", ".join(f"{c / area:.4g}" for c in centre) if area else ""
        flat = sum(n * n for n in normal) ** 0.5 > 0.9999 * area
        print(f"{face:>6} {cells:>8} {area:>12.6g}   ({place:<34}) {'yes' if flat else 'no'}")


def _reported(grid, name):
    return grid.GetFieldData().GetAbstractArray("SweepReport" + name).GetVariantValue(0).ToString()


if __name__ == "__main__":
    sys.exit(main())
