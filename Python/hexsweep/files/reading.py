# SPDX-License-Identifier: BSD-3-Clause
"""Solids and quads from files."""

import importlib
import os

import hexsweep

from ..errors import SweepError

_CAD = (".step", ".stp", ".iges", ".igs", ".brep", ".brp")
READERS = {
    ".vtk": ("vtkIOLegacy", "vtkDataSetReader"),
    ".vtu": ("vtkIOXML", "vtkXMLUnstructuredGridReader"),
    ".vtp": ("vtkIOXML", "vtkXMLPolyDataReader"),
    ".stl": ("vtkIOGeometry", "vtkSTLReader"),
    ".ply": ("vtkIOPLY", "vtkPLYReader"),
    ".obj": ("vtkIOGeometry", "vtkOBJReader"),
    **{extension: ("hexsweep", "vtkCADReader") for extension in _CAD},
}


def check(file_name):
    """@throw SweepError where there is no file that could be read."""
    check_readable(file_name, READERS)


def check_readable(file_name, extensions):
    """@throw SweepError where there is no file with one of these that could be read."""
    extension = os.path.splitext(file_name)[1].lower()
    if not os.path.isfile(file_name):
        there = "is no file" if os.path.exists(file_name) else "does not exist"
        raise SweepError(f"{file_name}: {there}.")
    if extension in _CAD and not hasattr(hexsweep, "vtkCADReader"):
        raise SweepError(f"{file_name}: this hexsweep was built without OpenCASCADE, and reads no CAD files.")
    if extension not in extensions:
        raise SweepError(f"{file_name}: only {', '.join(extensions)} files are read.")
    try:
        with open(file_name, "rb"):
            pass
    except OSError as error:
        raise SweepError(f"{file_name}: cannot be read: {error.strerror}.") from None


def read(file_name, messages):
    """@param messages: VtkMessages. @return a data set with cells. @throw SweepError."""
    check(file_name)
    module, name = READERS[os.path.splitext(file_name)[1].lower()]
    package = hexsweep if module == "hexsweep" else importlib.import_module("vtkmodules." + module)
    reader = getattr(package, name)()
    reader.SetFileName(file_name)
    with messages.errors_collected() as errors:
        reader.Update()
        data = reader.GetOutputDataObject(0)
    if errors or not data or reader.GetErrorCode() != 0:
        why = f": {errors[0]}" if errors else ""
        raise SweepError(f"{file_name}: cannot be read{why}".rstrip(". \n") + ".")
    if data.GetNumberOfCells() == 0:
        raise SweepError(f"{file_name}: no cells in it.")
    if data.GetFieldData() and data.GetFieldData().HasArray("CADFaceIds"):
        getattr(hexsweep, "vtkCADReader", None)  # its library restores the geometry that came along
    return data
