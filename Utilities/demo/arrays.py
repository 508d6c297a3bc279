# SPDX-License-Identifier: BSD-3-Clause
"""Meshes of one kind of cell as numpy arrays."""

from vtkmodules.util.numpy_support import vtk_to_numpy


def points_of(data):
    """n x 3 coordinates."""
    return vtk_to_numpy(data.GetPoints().GetData()).astype(float)


def faces_of(data):
    """m x corners point ids of a mesh whose cells are all of one size."""
    connectivity = vtk_to_numpy(data.GetCells().GetConnectivityArray())
    return connectivity.reshape(data.GetNumberOfCells(), -1)
