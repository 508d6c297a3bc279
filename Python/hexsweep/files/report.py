# SPDX-License-Identifier: BSD-3-Clause
"""All that is known of a mesh, as JSON for other programs."""

import json
import math

from vtkmodules.vtkCommonCore import vtkDataArray, vtkVersion

from .. import __version__


def write(path, grid, quality, certified, about, sets=None):
    """@param quality: Quality of the grid. @param about: entries by name, which come first.
    @param sets: the output of vtkSweepSets."""
    content = {
        "hexsweep": __version__,
        "vtk": vtkVersion.GetVTKVersion(),
        **about,
        "certified": certified,
        "hexahedra": quality.hexes,
        "nodes": grid.GetNumberOfPoints(),
        "inverted": quality.inverted,
        "degenerate": quality.degenerate,
        "not_certified": quality.not_certified,
        "scaled_jacobian": {
            "least": quality.least,
            "mean": quality.mean,
            "at_or_below_zero": quality.shares[0],
            "tenths": quality.shares[1:],
        },
        "arrays": {
            kind: _names(getattr(grid, f"Get{kind.title()}Data")()) for kind in ("point", "cell")
        },
        "report": _reports(grid.GetFieldData()),
    }
    if sets is not None:
        content["sets"] = _sets(sets)
    with open(path, "w", encoding="utf-8") as file:
        json.dump(_finite(content), file, indent=2, ensure_ascii=False, allow_nan=False)
        file.write("\n")


def _reports(data):
    """Every array SweepReport..., as a list: several bodies have several values."""
    arrays = (data.GetAbstractArray(i) for i in range(data.GetNumberOfArrays()))
    return {
        array.GetName(): _values(array)
        for array in arrays
        if array.GetName() and array.GetName().startswith("SweepReport")
    }


def _values(array):
    count = array.GetNumberOfTuples()
    if not isinstance(array, vtkDataArray):
        return [array.GetValue(i) for i in range(count)]
    width = array.GetNumberOfComponents()
    whole = not array.GetDataTypeAsString() in ("double", "float")
    values = [array.GetComponent(i, k) for i in range(count) for k in range(width)]
    return [int(value) for value in values] if whole else values


def _names(data):
    arrays = (data.GetAbstractArray(i) for i in range(data.GetNumberOfArrays()))
    return [array.GetName() for array in arrays if array.GetName()]


def _sets(sets):
    sides, nodes = sets.GetBlock(1), sets.GetBlock(2)
    return [
        {
            "name": sides.GetBlock(i).GetFieldData().GetAbstractArray("SetName").GetValue(0),
            "id": int(sides.GetBlock(i).GetFieldData().GetArray("SetId").GetTuple1(0)),
            "node_set_id": int(nodes.GetBlock(i).GetFieldData().GetArray("SetId").GetTuple1(0)),
            "sides": sides.GetBlock(i).GetNumberOfCells(),
            "nodes": nodes.GetBlock(i).GetNumberOfCells(),
        }
        for i in range(sides.GetNumberOfBlocks())
    ]


def _finite(value):
    """JSON has no name for what is not a number."""
    if isinstance(value, dict):
        return {key: _finite(own) for key, own in value.items()}
    if isinstance(value, (list, tuple)):
        return [_finite(own) for own in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value
