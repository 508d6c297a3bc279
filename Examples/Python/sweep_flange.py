# SPDX-License-Identifier: BSD-3-Clause
"""Sweeps a CAD solid in the system's Python.

    python3 sweep_flange.py <Data> <hexes.vtu>

Faces of the flange are numbered by the cell array FaceId; 3 is the cap to begin with.
"""
import os
import sys

from hexsweep import vtkOneToOneSweep
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader, vtkXMLUnstructuredGridWriter

data, output = sys.argv[1:]

solid = vtkXMLUnstructuredGridReader()
solid.SetFileName(os.path.join(data, "solids", "flange", "solid.vtu"))

sweep = vtkOneToOneSweep()
sweep.SetInputConnection(solid.GetOutputPort())
sweep.AddSourceFaceId(3)
sweep.SetNumberOfLayers(6)
sweep.Update()

hexes = sweep.GetOutput()
if hexes.GetNumberOfCells() == 0:
    sys.exit("nothing was meshed; the message above says why")
validity = vtk_to_numpy(hexes.GetCellData().GetArray("Validity"))  # 0: proved valid
quality = vtk_to_numpy(hexes.GetCellData().GetArray("ScaledJacobian"))
print(
    f"{len(validity)} hexes, {(validity != 0).sum()} not certified, "
    f"scaled Jacobian {quality.min():.3f} at least"
)

writer = vtkXMLUnstructuredGridWriter()
writer.SetInputData(hexes)
writer.SetFileName(output)
writer.SetDataModeToBinary()
writer.Write()
