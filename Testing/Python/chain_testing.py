# SPDX-License-Identifier: BSD-3-Clause
"""What the pvpython tests share: the plugin, the demo's chain, checks that say what failed."""

import os
import sys

import numpy as np
from paraview import simple
from vtkmodules.vtkCommonCore import mutable
from vtkmodules.vtkCommonDataModel import vtkStaticCellLocator

SOURCE_DIR = os.environ["HEXSWEEP_SOURCE_DIR"]
DATA_DIR = os.environ["HEXSWEEP_DATA_DIR"]
OUTPUT_DIR = os.environ["HEXSWEEP_TEST_OUTPUT_DIR"]

simple.LoadPlugin(os.environ["HEXSWEEP_PLUGIN"], remote=False, ns=vars(simple))
sys.path.insert(0, os.path.join(SOURCE_DIR, "Utilities", "demo"))
import chain  # noqa: E402, F401  (for the tests)
from arrays import faces_of, points_of  # noqa: E402

_failures = []


def check(condition, what):
    """Notes a failed check and goes on, so that one run shows all of them."""
    if not condition:
        _failures.append(what)
        print("FAILED:", what, flush=True)


def finish():
    """Ends the test; its exit code tells whether every check held."""
    print(f"{len(_failures)} failed checks")
    sys.exit(1 if _failures else 0)


def read_case(name):
    return chain.read_case(os.path.join(DATA_DIR, "cases", name))


def quiet(stage, seconds):
    """A progress report for chain.py that says nothing."""


def inverted_quads(quads, surface):
    """True for each quad with a corner Jacobian <= 0 about the normal of `surface` at that corner.

    The triangles of `surface` may face either way: they are taken to face as most of the quads'
    area does, which the quads of a sweep share with their source.
    """
    points, faces = points_of(quads), faces_of(quads)
    normals = _surface_normals(surface, points)
    corners = points[faces]
    forward = np.roll(corners, -1, axis=1) - corners
    backward = np.roll(corners, 1, axis=1) - corners
    jacobians = np.einsum("qci,qci->qc", np.cross(forward, backward), normals[faces])
    if jacobians.sum() < 0:
        jacobians = -jacobians
    return (jacobians <= 0).any(axis=1)


def _surface_normals(surface, points):
    """The unit normal of the surface's closest triangle for each point."""
    triangles = points_of(surface)[faces_of(surface)]
    normals = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    locator = vtkStaticCellLocator()
    locator.SetDataSet(surface)
    locator.BuildLocator()
    closest, cell, sub, distance = [0.0] * 3, mutable(0), mutable(0), mutable(0.0)
    found = np.empty(len(points), dtype=int)
    for i, point in enumerate(points):
        locator.FindClosestPoint(point, closest, cell, sub, distance)
        found[i] = cell.get()
    return normals[found]
