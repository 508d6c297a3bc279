# SPDX-License-Identifier: BSD-3-Clause
"""Formats of meshes by the extension of the file."""

import importlib.util
import os

from ..errors import SweepError

EXODUS = (".ex2", ".exo", ".e")
ABAQUS = (".inp",)
GMSH = (".msh",)
# What meshio writes, with the array of ids that its format knows; a MED file has names as well.
MESHIO = {
    ".med": "cell_tags",
    ".xdmf": "SetId",
    ".su2": "su2:tag",
    ".bdf": "nastran:ref",
    ".mesh": "medit:ref",
}
_MODULES = {".med": ("h5py", "python3-h5py")}

WRITTEN = (".vtu", ".vtk", *EXODUS, *ABAQUS, *GMSH, *MESHIO)


def extension_of(file_name):
    return os.path.splitext(file_name)[1].lower()


def check_meshio(file_name):
    """@throw SweepError where meshio, or what it needs for this file, is not installed."""
    needed = [("meshio", "python3-meshio")]
    if extension_of(file_name) in _MODULES:
        needed.append(_MODULES[extension_of(file_name)])
    for module, package in needed:
        if importlib.util.find_spec(module) is None:
            raise SweepError(
                f"{file_name}: the Python package {module} is needed for such files "
                f"(Debian: {package})."
            )
