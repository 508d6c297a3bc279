# SPDX-License-Identifier: BSD-3-Clause
"""Quality of hexahedra that were judged: in numbers, in a line, and in a table with bars."""

import math

from .. import vtkHexValidity
from ..errors import SweepError

_BINS = 10
_BAR = 40


class Quality:
    """Validity and quality of hexahedra; print() shows it as a table.

    Attributes:
        certified:     whether all cells with a volume are hexahedra, each one proved valid
        hexes:         how many hexahedra
        inverted:      those whose Jacobian is zero or negative somewhere
        degenerate:    those with an edge without length, or a coordinate that is not finite
        not_certified: all that are not proved valid
        others:        other cells with a volume, which are not judged
        least, mean:   scaled Jacobian, as Verdict defines it
        shares:        numbers of hexahedra by scaled Jacobian: at zero and below, then a tenth each
        grid:          the VTK grid with the cell arrays Validity, ScaledJacobian, JacobianLowerBound
    """

    def __init__(self, grid, others=0):
        """Of a grid with `ScaledJacobian` and the reports of vtkOneToOneSweep or vtkHexValidity."""
        counts = reported(grid, "Hexes")
        self.grid, self.others = grid, others
        self.hexes = int(sum(counts))
        self.inverted, self.degenerate, self.not_certified = (
            int(sum(reported(grid, name))) for name in ("Inverted", "Degenerate", "NotCertified")
        )
        self.least = min(reported(grid, "MinScaledJacobian"))
        means = reported(grid, "MeanScaledJacobian")
        self.mean = sum(n * own for n, own in zip(counts, means)) / max(self.hexes, 1)
        self.shares = _shares(grid.GetCellData().GetArray("ScaledJacobian"))
        self.certified = self.hexes > 0 and self.not_certified == 0 and others == 0

    def __repr__(self):
        return f"<hexsweep quality: {self.line()}>"

    def __str__(self):
        return "\n".join(self.lines())

    def lines(self):
        yield self.line()
        yield from self.table()
        if self.others:
            yield f"Not judged: {self.others} other cells with a volume, which are no hexahedra."

    def line(self):
        return (
            f"{self.hexes} hexahedra, {self.inverted} inverted, {self.not_certified} not certified, "
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


def judge(grid, others, follow):
    """@param others: solid cells that are no hexahedra. @param follow: shows the progress of an algorithm.
    @return Quality. @throw SweepError without text, where the filter has said why."""
    validity = follow(vtkHexValidity())
    validity.SetInputData(grid)
    validity.Update()
    if validity.GetErrorCode() != 0:
        raise SweepError()
    return Quality(validity.GetOutputDataObject(0), others)


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
