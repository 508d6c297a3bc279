# SPDX-License-Identifier: BSD-3-Clause
"""Prints number, least and mean scaled Jacobian of the hexahedra of a file, by VTK's Verdict."""

import json
import sys

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersVerdict import vtkMeshQuality
from vtkmodules.vtkIOLegacy import vtkUnstructuredGridReader
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

HEXAHEDRON = 12

path = sys.argv[1]
reader = vtkXMLUnstructuredGridReader() if path.endswith(".vtu") else vtkUnstructuredGridReader()
reader.SetFileName(path)
quality = vtkMeshQuality()
quality.SetInputConnection(reader.GetOutputPort())
quality.SetHexQualityMeasureToScaledJacobian()
quality.Update()
grid = quality.GetOutput()
values = vtk_to_numpy(grid.GetCellData().GetArray("Quality"))
values = values[vtk_to_numpy(grid.GetCellTypesArray()) == HEXAHEDRON]
print(json.dumps({"hexes": len(values), "least": float(values.min()), "mean": float(values.mean())}))
