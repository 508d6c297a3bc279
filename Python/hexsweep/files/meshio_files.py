# SPDX-License-Identifier: BSD-3-Clause
"""Meshes into files, and out of them, by meshio (MIT licence), where it is installed."""

import contextlib
import io
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON, vtkCellArray, vtkUnstructuredGrid

from ..errors import SweepError
from .formats import MESHIO, extension_of

# Solids that no hexahedron is: meshio's names of their cells begin so.
_OTHER_SOLIDS = ("tetra", "wedge", "pyramid", "hexahedron", "polyhedron", "VTK_LAGRANGE")


class _Sets:
    """The output of vtkSweepSets in arrays, hexahedra in the order of their ids."""

    def __init__(self, sets):
        parts = [sets.GetBlock(i) for i in range(3)]
        grid = parts[0].GetBlock(0)
        order = np.argsort(_array(grid.GetCellData(), "GlobalElementId"))
        self.points = vtk_to_numpy(grid.GetPoints().GetData()).astype(float)
        corners = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 8)
        self.hexes = corners[order].astype(np.int64)
        self.volumes = _array(grid.GetCellData(), "ObjectId")[order].astype(np.int64)
        name = parts[0].GetMetaData(0).Get(sets.NAME())
        ids = np.unique(self.volumes)
        self.names = {int(i): name if len(ids) == 1 else f"Volume {i}" for i in ids}
        self.quads, self.faces, self.face_names = [], [], {}
        seen = set()
        for i in range(parts[1].GetNumberOfBlocks()):
            side_set = parts[1].GetBlock(i)
            hexes, sides = (
                _array(side_set.GetCellData(), f"SourceElement{kind}") for kind in ("Id", "Side")
            )
            pairs = set(zip(hexes.tolist(), sides.tolist()))
            if pairs & seen:  # source, target or sides: the same quads again
                continue
            seen |= pairs
            nodes = _array(side_set.GetPointData(), "GlobalNodeId") - 1
            quads = vtk_to_numpy(side_set.GetCells().GetConnectivityArray()).reshape(-1, 4)
            number = side_set.GetFieldData().GetArray("SetId").GetTuple1(0)
            self.quads.append(nodes[quads])
            self.faces.append(np.full(len(quads), int(number), dtype=np.int64))
            self.face_names[int(number)] = (
                side_set.GetFieldData().GetAbstractArray("SetName").GetValue(0)
            )
        self.quads, self.faces = np.concatenate(self.quads), np.concatenate(self.faces)


def write(sets, path):
    """@param sets: the output of vtkSweepSets."""
    import meshio

    own = _Sets(sets)
    key = MESHIO[extension_of(path)]
    ids = [own.volumes, own.faces]
    tags = {}
    if key == "cell_tags":
        # MED tells cells of one group by a negative number for its family.
        shift = int(own.volumes.max())
        ids = [-own.volumes, -own.faces - shift]
        names = {-i: name for i, name in own.names.items()}
        names.update({-i - shift: name for i, name in own.face_names.items()})
        tags = {family: [name] for family, name in zip(names, _ascii(names.values()))}
    points = _fitting(own.points) if extension_of(path) == ".bdf" else own.points
    # h5py complains once more, past its own error, where the disk was full.
    sys.unraisablehook = lambda _: None
    mesh = meshio.Mesh(
        points, [("hexahedron", own.hexes), ("quad", own.quads)], cell_data={key: ids}
    )
    if tags:
        mesh.cell_tags = tags
    if extension_of(path) == ".su2":
        mesh.cells = [_pair(block) for block in mesh.cells]
    # By default XDMF has its numbers in a second file, which would not be put in place with the first.
    options = {"data_format": "XML"} if extension_of(path) == ".xdmf" else {}
    with _silent():
        mesh.write(path, **options)


def _fitting(points):
    """Numbers of which meshio 5.0 writes no more than the 16 characters that Nastran has for them:
    beyond, it stops."""
    size = np.abs(points)
    far = (size < 1e-9) | (size >= 1e9)  # two digits in the exponent
    decimals = 11 - (points < 0) - far
    points = points.copy()
    for number in (9, 10):
        chosen = decimals == number
        points[chosen] = [float(f"{x:.{number}e}") for x in points[chosen]]
    return points


def _ascii(names):
    """Other characters become underscores, as meshio makes rubbish of them in MED files; names that
    are then the same are numbered."""
    plain = ["".join(c if " " <= c <= "~" else "_" for c in name)[:70] for name in names]
    return [f"{name} {i}" if plain.count(name) > 1 else name for i, name in enumerate(plain, 1)]


def _pair(block):
    """meshio 5.0 takes blocks of cells for pairs of a type and an array in its writer of SU2."""
    kind = type(block)
    pair = type(kind.__name__, (kind,), {"__iter__": lambda self: iter((self.type, self.data))})
    block.__class__ = pair
    return block


def difference(path, sets):
    """@return what differs from what was written, in words that follow "the file"; nothing where
    nothing does."""
    own, mesh = _Sets(sets), _read(path)
    hexes = [block.data for block in mesh.cells if block.type == "hexahedron"]
    # Text of some formats has fewer digits than a double.
    size = np.ptp(own.points, axis=0).max()
    if mesh.points.shape != own.points.shape or abs(mesh.points - own.points).max() > 1e-6 * size:
        return "has other points"
    if not hexes or not np.array_equal(np.concatenate(hexes), own.hexes):
        return "has other hexahedra"
    quads = sum(len(block.data) for block in mesh.cells if block.type == "quad")
    return "" if quads == len(own.quads) else "has other quads"


def read(path):
    """@return hexahedra as a vtkUnstructuredGrid, and how many solid cells of other types there are.
    @throw SweepError."""
    mesh = _read(path)
    hexes = [block.data for block in mesh.cells if block.type == "hexahedron"]
    others = sum(
        len(block.data)
        for block in mesh.cells
        if block.type.startswith(_OTHER_SOLIDS) and block.type != "hexahedron"
    )
    if not hexes:
        raise SweepError(f"{path}: no hexahedra in it.")
    corners = np.concatenate(hexes)
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(mesh.points, dtype=float), deep=True))
    cells = vtkCellArray()
    starts = np.arange(0, corners.size + 1, 8)
    cells.SetData(
        numpy_to_vtkIdTypeArray(starts.astype(np.int64), deep=True),
        numpy_to_vtkIdTypeArray(np.ascontiguousarray(corners, dtype=np.int64).ravel(), deep=True),
    )
    grid = vtkUnstructuredGrid()
    grid.SetPoints(points)
    grid.SetCells(VTK_HEXAHEDRON, cells)
    return grid, others


def _read(path):
    import meshio

    try:
        with _silent() as said:
            return meshio.read(path)
    # It ends the program where no format fits, and its readers of text raise what they meet.
    except (Exception, SystemExit) as error:
        words = " ".join(said.getvalue().split()) or str(error)
        raise SweepError(f"{path}: cannot be read by meshio: {words}".rstrip(". ") + ".") from None


@contextlib.contextmanager
def _silent():
    """What it prints is no line of ours."""
    said = io.StringIO()
    with contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
        yield said


def _array(data, name):
    return vtk_to_numpy(data.GetArray(name))
