# SPDX-License-Identifier: BSD-3-Clause
import os
from typing import Callable, Literal, Mapping, Optional, Sequence, Tuple, Union, overload

from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkUnstructuredGrid

from .sweeps.quality import Quality

_FileName = Union[str, os.PathLike[str]]
_FileOrData = Union[_FileName, vtkDataObject]
_Ids = Union[int, Sequence[int], None]
_Progress = Optional[Callable[[float], object]]

@overload
def sweep(
    solid: _FileOrData, *, size: Optional[float] = None, layers: Optional[int] = None,
    layer_size: Optional[float] = None, source: _Ids = None, target: _Ids = None, volume: _Ids = None,
    quads: Optional[_FileOrData] = None, quad_size: Optional[float] = None, growth: Optional[float] = None,
    both_ends: bool = False, positions: Optional[Sequence[float]] = None,
    direction: Optional[Sequence[float]] = None, draft: Optional[float] = None,
    imprint_tolerance: Optional[float] = None, separate: bool = False, plan: Optional[_FileName] = None,
    faces: Optional[str] = None, feature_angle: Optional[float] = None, tolerance: Optional[float] = None,
    method: Optional[str] = None, precision: Optional[Literal["single", "double"]] = None,
    threads: Optional[int] = None, output: Optional[_FileName] = None,
    set_ids: Optional[Mapping[str, int]] = None, role_sets: bool = True,
    msh_version: Literal["2.2", "4.1"] = "4.1", binary: bool = False, json: Optional[_FileName] = None,
    picture: Optional[_FileName] = None, boundary: Literal[False] = False, progress: _Progress = None,
) -> vtkUnstructuredGrid: ...
@overload
def sweep(
    solid: _FileOrData, *, size: Optional[float] = None, layers: Optional[int] = None,
    layer_size: Optional[float] = None, source: _Ids = None, target: _Ids = None, volume: _Ids = None,
    quads: Optional[_FileOrData] = None, quad_size: Optional[float] = None, growth: Optional[float] = None,
    both_ends: bool = False, positions: Optional[Sequence[float]] = None,
    direction: Optional[Sequence[float]] = None, draft: Optional[float] = None,
    imprint_tolerance: Optional[float] = None, separate: bool = False, plan: Optional[_FileName] = None,
    faces: Optional[str] = None, feature_angle: Optional[float] = None, tolerance: Optional[float] = None,
    method: Optional[str] = None, precision: Optional[Literal["single", "double"]] = None,
    threads: Optional[int] = None, output: Optional[_FileName] = None,
    set_ids: Optional[Mapping[str, int]] = None, role_sets: bool = True,
    msh_version: Literal["2.2", "4.1"] = "4.1", binary: bool = False, json: Optional[_FileName] = None,
    picture: Optional[_FileName] = None, boundary: Literal[True], progress: _Progress = None,
) -> Tuple[vtkUnstructuredGrid, vtkUnstructuredGrid]: ...
def check(mesh: _FileOrData, *, progress: _Progress = None) -> Quality: ...
