# SPDX-License-Identifier: BSD-3-Clause
from typing import Iterator, List

from vtkmodules.vtkCommonDataModel import vtkDataSet

class Quality:
    certified: bool
    hexes: int
    inverted: int
    degenerate: int
    not_certified: int
    others: int
    least: float
    mean: float
    shares: List[int]
    grid: vtkDataSet
    def __init__(self, grid: vtkDataSet, others: int = 0) -> None: ...
    def lines(self) -> Iterator[str]: ...
    def line(self) -> str: ...
    def table(self) -> Iterator[str]: ...
