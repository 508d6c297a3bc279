# SPDX-License-Identifier: BSD-3-Clause
"""The hexes of one case against a stored mesh, and both against Verdict.

The projection and the interior as they come, without optimisation afterwards: the same cells, the
points and numbers where they were. That the stored mesh is good is not taken on trust: ParaView's
Mesh Quality (Verdict) judges it and this run's mesh alike. After a change that is meant to move
points, look at the new mesh, then replace the baseline by the file that this test writes.
"""

import os

import numpy as np
from chain_testing import (
    DATA_DIR,
    OUTPUT_DIR,
    chain,
    check,
    faces_of,
    finish,
    points_of,
    quiet,
    read_case,
    simple,
)
from vtkmodules.util.numpy_support import vtk_to_numpy

BASELINE = os.path.join(DATA_DIR, "Baseline", "TestDataRegression.vtu")
OUTPUT = os.path.join(OUTPUT_DIR, "TestDataRegression.vtu")



def main():
    sweep = chain.sweep_harmonic(read_case("taper10"), quiet, raw=True)
    simple.SaveData(
        OUTPUT, proxy=sweep.hexes, DataMode="Binary", CompressorType="ZLib", CompressionLevel="9"
    )
    print("this run's mesh:", OUTPUT)
    baseline = simple.XMLUnstructuredGridReader(FileName=[BASELINE])
    expected, found = chain.fetch(baseline), chain.fetch(sweep.hexes)
    if len(points_of(found)) == len(points_of(expected)):
        compare(found, expected)
    else:
        check(False, f"{found.GetNumberOfPoints()} points, not {expected.GetNumberOfPoints()}")
    for name, proxy in (("baseline", baseline), ("this run", sweep.hexes)):
        check_quality(name, proxy)
    finish()


def compare(found, expected):
    check(np.array_equal(faces_of(found), faces_of(expected)), "the hexes have the corners they had")
    points, moved = points_of(expected), points_of(found) - points_of(expected)
    # The solver and the compiler's choice of instructions may differ in the last digits. Those
    # count relative to the edges at a point, not to the whole mesh.
    bad = np.linalg.norm(moved, axis=1) > 1e-6 * shortest_edges(points, faces_of(expected))
    check(not bad.any(), f"{int(bad.sum())} points moved, the farthest by {np.abs(moved).max()}")
    for name in ("SourceCellIds", "SweepLayer"):
        same = np.array_equal(cell_values(found, name), cell_values(expected, name))
        check(same, f"cell array {name}")
    change = np.abs(cell_values(found, "ScaledJacobian") - cell_values(expected, "ScaledJacobian"))
    # A scaled Jacobian has no unit, and changes by about as much as a point moves in edge lengths.
    check(change.max() <= 1e-5, f"ScaledJacobian changed by {change.max()}")


def check_quality(name, proxy):
    quality = simple.MeshQuality(Input=proxy, HexQualityMeasure="Scaled Jacobian")
    truth = cell_values(chain.fetch(quality), "Quality")
    difference = np.abs(cell_values(chain.fetch(proxy), "ScaledJacobian") - truth).max()
    # 1e-12: two ways to round the same products.
    check(difference <= 1e-12, f"{name}: scaled Jacobians differ from Verdict's by {difference}")
    check(truth.min() > 0.30 and truth.mean() > 0.85,
          f"{name}: by Verdict min {truth.min()}, mean {truth.mean()}; the case allows 0.304, 0.860")


def cell_values(data, name):
    return vtk_to_numpy(data.GetCellData().GetArray(name)).astype(float)


def shortest_edges(points, hexes):
    """The length of the shortest edge at each point."""
    ends = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4),
            (0, 4), (1, 5), (2, 6), (3, 7)]
    shortest = np.full(len(points), np.inf)
    for a, b in ends:
        lengths = np.linalg.norm(points[hexes[:, a]] - points[hexes[:, b]], axis=1)
        np.minimum.at(shortest, hexes[:, a], lengths)
        np.minimum.at(shortest, hexes[:, b], lengths)
    return shortest


main()
