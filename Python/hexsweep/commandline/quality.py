# SPDX-License-Identifier: BSD-3-Clause
"""Quality of hexahedra that were judged: in a line, and in a table with bars."""

import math

_BINS = 10
_BAR = 40


class Quality:
    """Of a grid with `ScaledJacobian` and the reports of vtkOneToOneSweep or vtkHexValidity."""

    def __init__(self, grid):
        counts = reported(grid, "Hexes")
        self.hexes = int(sum(counts))
        self.inverted, self.degenerate, self.uncertified = (
            int(sum(reported(grid, name))) for name in ("Inverted", "Degenerate", "NotCertified")
        )
        self.least = min(reported(grid, "MinScaledJacobian"))
        means = reported(grid, "MeanScaledJacobian")
        self.mean = sum(n * own for n, own in zip(counts, means)) / max(self.hexes, 1)
        # Those at zero and below, then a tenth each.
        self.shares = _shares(grid.GetCellData().GetArray("ScaledJacobian"))

    def is_certified(self):
        return self.hexes > 0 and self.uncertified == 0

    def line(self):
        return (
            f"{self.hexes} hexahedra, {self.inverted} inverted, {self.uncertified} not certified, "
            f"scaled Jacobian {self.least:.3f} (least), {self.mean:.3f} (mean)"
        )

    def table(self):
        """Lines: the share of hexahedra by scaled Jacobian."""
        yield f"{'scaled Jacobian':<15} {'hexahedra':>10} {'share':>7}"
        for i, count in enumerate(self.shares):
            if i > 0 or count > 0:
                name = "0 and below" if i == 0 else f"{(i - 1) / _BINS:.1f} to {i / _BINS:.1f}"
                share = count / max(self.hexes, 1)
                # What there is shows.
                bar = "#" * max(round(_BAR * share), count > 0)
                yield f"{name:<15} {count:>10} {100 * share:>6.1f}% {bar}".rstrip()


def reported(grid, name):
    """@return the values of all bodies."""
    array = grid.GetFieldData().GetArray("SweepReport" + name)
    return [array.GetTuple1(i) for i in range(array.GetNumberOfTuples())] if array else []


def _shares(values):
    shares = [0] * (_BINS + 1)
    for value in memoryview(values):
        if not math.isnan(value):
            shares[0 if value <= 0.0 else min(int(_BINS * value), _BINS - 1) + 1] += 1
    return shares
