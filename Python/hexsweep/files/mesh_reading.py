# SPDX-License-Identifier: BSD-3-Clause
"""Hexahedra from files of any format that VTK or meshio reads."""

import collections

from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON, VTK_VOXEL, vtkGenericCell

from ..errors import SweepError
from ..vtk_messages import library_messages
from .formats import EXODUS, check_meshio, extension_of
from .reading import READERS, check_readable, read

_VTK = {name: reader for name, reader in READERS.items() if name in (".vtk", ".vtu")}
_MESHIO = (".inp", ".msh", ".med", ".xdmf", ".su2", ".bdf", ".nas", ".mesh", ".cgns", ".ugrid", ".avs")
READ = (*_VTK, *EXODUS, *_MESHIO)

# As vtkHexValidity judges them.
_HEXES = (VTK_HEXAHEDRON, VTK_VOXEL)


def check(file_name):
    """@throw SweepError where there is no file that could be read."""
    check_readable(file_name, READ)
    if extension_of(file_name) in _MESHIO:
        check_meshio(file_name)


def read_mesh(file_name, messages):
    """@param messages: VtkMessages. @return a data set with hexahedra, and how many solid cells
    in it or beside it are none. @throw SweepError."""
    extension = extension_of(file_name)
    if extension in _MESHIO:
        from . import meshio_files

        return meshio_files.read(file_name)
    grid = _read_exodus(file_name, messages) if extension in EXODUS else read(file_name, messages)
    return grid, other_solid_cells(grid, file_name)


def other_solid_cells(grid, name):
    """@param grid: a data set. @return how many of its cells have a volume and are no hexahedra.
    @throw SweepError where none is one."""
    if not grid.IsA("vtkDataSet"):
        raise SweepError(f"{name}: is a {grid.GetClassName()}, and only data sets are judged: give one of its parts.")
    kinds = collections.Counter(grid.GetCellType(cell) for cell in range(grid.GetNumberOfCells()))
    if not any(kinds[kind] for kind in _HEXES):
        raise SweepError(f"{name}: no hexahedra in it.")
    return sum(count for kind, count in kinds.items() if kind not in _HEXES and _is_solid(kind))


def _is_solid(kind):
    cell = vtkGenericCell.InstantiateCell(kind)
    return bool(cell) and cell.GetCellDimension() == 3


def _read_exodus(file_name, messages):
    """All element blocks as one grid. vtkExodusIIReader would round coordinates to single
    precision, so that other hexahedra would be certified than those in the file."""
    try:
        from vtkmodules.vtkIOIOSS import vtkIOSSReader
    except ImportError:
        raise SweepError(f"{file_name}: this VTK has no reader of Exodus II in double precision.") from None
    from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
    from vtkmodules.vtkFiltersCore import vtkAppendFilter

    reader = vtkIOSSReader()
    reader.SetFileName(file_name)
    with messages.errors_collected() as errors, library_messages([]):
        reader.UpdateInformation()
        reader.GetElementBlockSelection().EnableAllArrays()
        reader.Update()
        collection = reader.GetOutputDataObject(0)
    if errors or not collection:
        why = f": {errors[0]}" if errors else ""
        raise SweepError(f"{file_name}: cannot be read{why}".rstrip(". \n") + ".")
    append = vtkAppendFilter()
    append.SetOutputPointsPrecision(vtkAlgorithm.DOUBLE_PRECISION)
    for i in range(collection.GetNumberOfPartitionedDataSets()):
        for j in range(collection.GetNumberOfPartitions(i)):
            part = collection.GetPartition(i, j)
            if part and part.GetNumberOfCells() and _is_solid(part.GetCellType(0)):
                append.AddInputData(part)
    if append.GetNumberOfInputConnections(0) == 0:
        raise SweepError(f"{file_name}: no cells with a volume in it.")
    append.Update()
    return append.GetOutput()
