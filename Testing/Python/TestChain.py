# SPDX-License-Identifier: BSD-3-Clause
"""The chained filters on whole cases: nothing inverted, numbered as promised, reported truly.

Truth: the inverted quads are counted here by corner Jacobians about the surface's own normals, the
scaled Jacobians by ParaView's Mesh Quality (Verdict), the numbering against the source quads.
"""

import numpy as np
from chain_testing import (
    chain,
    check,
    faces_of,
    finish,
    inverted_quads,
    points_of,
    quiet,
    read_case,
    simple,
)
from vtkmodules.util.numpy_support import vtk_to_numpy


def check_case(name):
    case = read_case(name)
    sweep = chain.sweep_harmonic(case, quiet)
    source = chain.fetch(case.source_quads)
    target = chain.fetch(sweep.target_quads)
    hexes = chain.fetch(sweep.hexes)
    check_target(name, case, source, target)
    check_numbering(name, source, target, hexes)
    check_quality(name, sweep, hexes)
    check_projector_alone(name, case, target)


def check_target(name, case, source, target):
    faces = faces_of(target)
    check(np.array_equal(faces, faces_of(source)), f"{name}: the target has the same quads")
    inverted = inverted_quads(target, chain.fetch(case.target_surface))
    check(not inverted.any(), f"{name}: {int(inverted.sum())} quads are inverted on the target")
    check(chain.reported(target, "InvertedQuads") == 0, f"{name}: SweepReportInvertedQuads is 0")


def check_numbering(name, source, target, hexes):
    n, m = source.GetNumberOfPoints(), source.GetNumberOfCells()
    layers = hexes.GetNumberOfCells() // m
    check(hexes.GetNumberOfCells() == layers * m, f"{name}: whole layers of hexes")
    check(hexes.GetNumberOfPoints() == (layers + 1) * n, f"{name}: whole layers of points")
    points = points_of(hexes)
    check(np.array_equal(points[:n], points_of(source)), f"{name}: layer 0 is the source")
    check(np.array_equal(points[-n:], points_of(target)), f"{name}: last layer is the target")
    cells, faces = faces_of(hexes), faces_of(source)
    for layer in (0, layers - 1):
        bottom = np.sort(cells[layer * m : (layer + 1) * m], axis=1)
        expected = np.sort(np.hstack([faces + layer * n, faces + (layer + 1) * n]), axis=1)
        check(np.array_equal(bottom, expected), f"{name}: hex k*M + j is quad j in layer {layer}")
    arrays = {
        "SourcePointIds": (hexes.GetPointData(), np.tile(np.arange(n), layers + 1)),
        "SourceCellIds": (hexes.GetCellData(), np.tile(np.arange(m), layers)),
    }
    for array_name, (data, expected) in arrays.items():
        array = data.GetArray(array_name)
        check(array is not None, f"{name}: array {array_name}")
        if array is not None:
            check(np.array_equal(vtk_to_numpy(array), expected), f"{name}: values of {array_name}")
    for data, count in ((hexes.GetPointData(), n), (hexes.GetCellData(), m)):
        array = data.GetArray("SweepLayer")
        check(array is not None, f"{name}: array SweepLayer")
        if array is not None:
            expected = np.repeat(np.arange(array.GetNumberOfTuples() // count), count)
            check(np.array_equal(vtk_to_numpy(array), expected), f"{name}: values of SweepLayer")


def check_quality(name, sweep, hexes):
    quality = simple.MeshQuality(Input=sweep.hexes, HexQualityMeasure="Scaled Jacobian")
    truth = vtk_to_numpy(chain.fetch(quality).GetCellData().GetArray("Quality"))
    ours = chain.scaled_jacobians(sweep.hexes)
    check(np.allclose(ours, truth, rtol=0, atol=1e-12), f"{name}: scaled Jacobians are Verdict's")
    check((truth > 0).all(), f"{name}: {int((truth <= 0).sum())} hexes are inverted")
    verdicts = set(vtk_to_numpy(hexes.GetCellData().GetArray("Validity")).tolist())
    check(verdicts == {0}, f"{name}: every hex is certified (verdicts {sorted(verdicts)})")
    for report, expected in (
        ("Hexes", len(truth)),
        ("Inverted", 0),
        ("MinScaledJacobian", truth.min()),
        ("MeanScaledJacobian", truth.mean()),
    ):
        value = chain.reported(hexes, report)
        check(
            value is not None and abs(value - expected) <= 1e-12 * max(1.0, abs(expected)),
            f"{name}: SweepReport{report} is {value}, expected {expected}",
        )


def check_projector_alone(name, case, chained):
    """Disk maps made by the projector itself must lead to the same quads as the chained filters."""
    alone = simple.SweepQuadProjector(
        SourceQuads=case.source_quads,
        TargetSurface=case.target_surface,
        LinkingSides=case.linking_quads,
        SourceSurface=case.source_surface,
    )
    points = points_of(chained)
    difference = np.abs(points_of(chain.fetch(alone)) - points).max()
    check(
        difference <= 1e-12 * np.ptp(points, axis=0).max(),
        f"{name}: chained disk maps move the quads by {difference}",
    )


for case_name in ("ubend", "c_open", "taper10", "twist270_L"):
    check_case(case_name)
finish()
