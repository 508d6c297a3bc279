# SPDX-License-Identifier: BSD-3-Clause
"""Whether a file holds the mesh that was written to it.

A writer may end with success over a file that a full disk has cut short or left holes in.
"""

import operator
import os

from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkFloatArray, vtkIdTypeArray

_PIECE = 1 << 20


def xml_damage(path):
    """The writer of .vtu files goes through the file from front to end, in text.
    @return what is wrong, in words that follow "the file"; nothing where it is whole."""
    return _damage(path, lambda end: end.rstrip().endswith(b"</VTKFile>"))


def text_damage(path):
    """@return as xml_damage(): what a writer of text leaves where the disk is full."""
    return _damage(path, lambda end: end.endswith(b"\n"))


def gmsh_damage(path, binary):
    """@return as xml_damage()."""
    return _damage(path, lambda end: end.endswith(b"\n$EndElements\n"), binary)


def _damage(path, is_end, binary=False):
    """@param is_end: of the last bytes, whether the file may end with them."""
    with open(path, "rb") as file:
        file.seek(-min(64, os.path.getsize(path)), os.SEEK_END)
        if not is_end(file.read()):
            return "has no end"
        file.seek(0)
        pieces = iter(lambda: file.read(_PIECE), b"")
        return "has holes" if not binary and any(b"\0" in piece for piece in pieces) else ""


def legacy_difference(path, own):
    """@param own: the vtkUnstructuredGrid. @return as exodus_difference()."""
    from vtkmodules.vtkIOLegacy import vtkUnstructuredGridReader

    reader = vtkUnstructuredGridReader()
    reader.SetFileName(path)
    reader.ReadAllScalarsOn()
    reader.Update()
    read = reader.GetOutput()
    if _cells(read) != _cells(own) or _corners(read) != _corners(own):
        return "has other hexahedra"
    found, truth = (_doubles(grid.GetPoints().GetData()) for grid in (read, own))
    return "" if found == truth else "has other points"


def exodus_difference(path, sets):
    """@param sets: the output of vtkSweepSets.
    @return what differs, in words that follow "the file"; nothing where nothing does."""
    from vtkmodules.vtkIOExodus import vtkExodusIIReader

    reader = vtkExodusIIReader()
    reader.SetFileName(path)
    reader.UpdateInformation()
    reader.GenerateGlobalNodeIdArrayOn()
    reader.GenerateGlobalElementIdArrayOn()
    for kind in (reader.ELEM_BLOCK, reader.NODAL, reader.SIDE_SET, reader.NODE_SET):
        reader.SetAllArrayStatus(kind, 1)
        for i in range(reader.GetNumberOfObjects(kind)):
            reader.SetObjectStatus(kind, i, 1)
    reader.Update()
    if not reader.GetOutput().GetNumberOfBlocks():
        return "cannot be read"
    # Element blocks, side sets and node sets, as the reader and as the filter place them.
    (blocks, own_blocks), *others = (
        (_grids(reader.GetOutput(), place), _grids(sets, part))
        for place, part in ((0, 0), (4, 1), (7, 2))
    )
    # The writer makes a block of each id in the one grid of the filter.
    (own_block,) = own_blocks
    objects = _values(own_block.GetCellData().GetArray("ObjectId"))
    elements_of = {i: [cell for cell, of in enumerate(objects) if of == i] for i in sorted(set(objects))}
    if [_cells(block) for block in blocks] != [len(cells) for cells in elements_of.values()]:
        return "has other blocks or sets"
    # The reader sorts sets by their ids.
    others = [(read, sorted(own, key=_set_id)) for read, own in others]
    for read, own in others:
        if [_cells(grid) for grid in read] != [_cells(grid) for grid in own]:
            return "has other blocks or sets"
    problems = [
        _block_difference(read, own_block, cells) for read, cells in zip(blocks, elements_of.values())
    ]
    problems += [_set_difference(*pair) for sets in others for pair in zip(*sets)]
    return next(filter(None, problems), "")


def _set_id(grid):
    return grid.GetFieldData().GetArray("SetId").GetTuple1(0)


def _set_difference(read, own):
    # The corners of a side may begin with another one.
    nodes = (sorted(_values(g.GetPointData().GetArray("GlobalNodeId"))) for g in (read, own))
    if not operator.eq(*nodes):
        return "has other sets"
    for name in ("SourceElementId", "SourceElementSide"):
        array = own.GetCellData().GetArray(name)
        if array and _doubles(read.GetCellData().GetArray(name)) != _doubles(array):
            return "has other sides"
    return ""


def _block_difference(read, own, cells):
    """The reader gives elements in the order of the file, and renumbers the nodes.
    @param cells: those of `own` that are the block's."""
    nodes = [i - 1 for i in _values(read.GetPointData().GetArray("GlobalNodeId"))]
    corners = _corners(own)
    used = [p for cell in cells for p in corners[8 * cell : 8 * cell + 8]]
    if [nodes[p] for p in _corners(read)] != used:
        return "has other hexahedra"
    if sorted(nodes) != sorted(set(used)):
        return "has other nodes"
    # Coordinates are read in single precision.
    found, truth = (_values(_as(vtkFloatArray, g.GetPoints().GetData())) for g in (read, own))
    if any(found[3 * i : 3 * i + 3] != truth[3 * n : 3 * n + 3] for i, n in enumerate(nodes)):
        return "has other points"
    for kind, ids in (("GetPointData", nodes), ("GetCellData", cells)):
        for array in _arrays(getattr(own, kind)()):
            found = getattr(read, kind)().GetArray(array.GetName())
            if found and list(_doubles(found)) != _tuples(array, ids):
                return f"has other values of {array.GetName()}"
    return ""


def _tuples(array, ids):
    """Their components in turn."""
    values, width = _doubles(array), array.GetNumberOfComponents()
    return [x for i in ids for x in values[width * i : width * i + width]]


def _grids(blocks, place):
    part = blocks.GetBlock(place)
    return [part.GetBlock(i) for i in range(part.GetNumberOfBlocks())]


def _cells(grid):
    return grid.GetNumberOfCells() if grid else 0


def _corners(grid):
    """Point ids of all cells in turn."""
    return _values(_as(vtkIdTypeArray, grid.GetCells().GetConnectivityArray()))


def _arrays(data):
    arrays = (data.GetArray(i) for i in range(data.GetNumberOfArrays()))
    return [array for array in arrays if array and array.GetName()]


def _as(kind, array):
    copy = kind()
    copy.DeepCopy(array)
    return copy


def _values(array):
    """All components of all tuples in turn."""
    view = memoryview(array)
    return view.cast("B").cast(view.format)


def _doubles(array):
    return _values(_as(vtkDoubleArray, array))
