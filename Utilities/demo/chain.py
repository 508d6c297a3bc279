# SPDX-License-Identifier: BSD-3-Clause
"""The sweep as a chain of ParaView filters, run stage by stage, and what came out of it.

Needs the HexSweep plugin to be loaded into paraview.simple.
"""

import json
import os
import time
from dataclasses import dataclass, field

from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

# Nothing is moved after it has been placed.
RAW = {"EnsureValid": 0, "ImproveQuality": 0}


@dataclass
class Case:
    """The four meshes of one folder of Data/cases, as readers."""

    name: str
    note: str
    source_quads: object
    source_surface: object
    target_surface: object
    linking_quads: object


@dataclass
class Sweep:
    """What one chain of filters made. `seconds` holds the wall time of each stage in order."""

    target_quads: object
    hexes: object
    seconds: dict = field(default_factory=dict)

    @property
    def total_seconds(self):
        return sum(self.seconds.values())


def read_case(folder):
    """Reads a case; the files are read here, so that no stage is charged for them."""
    with open(os.path.join(folder, "case.json"), encoding="utf-8") as file:
        description = json.load(file)

    def read(name):
        reader = simple.XMLUnstructuredGridReader(
            registrationName=name, FileName=[os.path.join(folder, name + ".vtu")]
        )
        reader.UpdatePipeline()
        return reader

    return Case(
        description["name"],
        description["note"],
        read("source_quads"),
        read("source_surface"),
        read("target_surface"),
        read("linking_quads"),
    )


def sweep_harmonic(case, report, raw=False):
    """HexSweep's own chain: both caps into one disk, quads across, interior, verdict.

    `report(stage, seconds)` is called after each stage. `raw` takes the projection and the interior
    as they come; otherwise every filter has its default settings.
    """
    run = _Stages(report)
    source_disk = simple.HarmonicDiskMap(
        registrationName="SourceDisk",
        Input=case.source_surface,
        Partner=case.target_surface,
        LinkingSides=case.linking_quads,
    )
    run.stage("disk map of the source", source_disk)
    target_disk = simple.HarmonicDiskMap(
        registrationName="TargetDisk",
        Input=case.target_surface,
        Partner=case.source_surface,
        LinkingSides=case.linking_quads,
    )
    run.stage("disk map of the target", target_disk)
    target_quads = simple.SweepQuadProjector(
        registrationName="TargetQuads",
        SourceQuads=case.source_quads,
        TargetSurface=target_disk,
        LinkingSides=case.linking_quads,
        SourceSurface=source_disk,
    )
    target_quads.DiskMaps = "FromInput"
    if raw:
        _set(target_quads, **RAW)
    run.stage("quads onto the target", target_quads)
    return _interior(case, target_quads, run, **(RAW if raw else {}))


def sweep_affine(case, report):
    """The usual method for comparison, raw: least-squares affine map, boundary error (Knupp 1998,
    Roca et al. 2005, Staten et al. 2006), nothing untangled."""
    run = _Stages(report)
    target_quads = simple.SweepQuadProjector(
        registrationName="AffineTargetQuads",
        SourceQuads=case.source_quads,
        TargetSurface=case.target_surface,
        LinkingSides=case.linking_quads,
        SourceSurface=case.source_surface,
    )
    _set(target_quads, Method="AffineLeastSquares", **RAW)
    run.stage("quads onto the target", target_quads)
    return _interior(case, target_quads, run, Method="AffineBoundaryError", **RAW)


def _interior(case, target_quads, run, **properties):
    interior = simple.CageHexInterior(
        registrationName="Interior",
        SourceQuads=case.source_quads,
        TargetQuads=target_quads,
        LinkingSides=case.linking_quads,
    )
    _set(interior, **properties)
    run.stage("hexes inside", interior)
    verdict = simple.HexValidity(registrationName="Validity", Input=interior)
    run.stage("validity", verdict)
    return Sweep(target_quads, verdict, run.seconds)


def _set(proxy, **properties):
    """Sets properties, those of RAW only where the filter has them: others repair nothing."""
    for name, value in properties.items():
        if name not in RAW or name in proxy.ListProperties():
            setattr(proxy, name, value)


class _Stages:
    def __init__(self, report):
        self.seconds = {}
        self._report = report

    def stage(self, name, proxy):
        start = time.perf_counter()
        proxy.UpdatePipeline()
        self.seconds[name] = time.perf_counter() - start
        if fetch(proxy).GetNumberOfCells() == 0:
            raise RuntimeError(f"{name}: the filter gave nothing; its error message says why")
        self._report(name, self.seconds[name])


def fetch(proxy):
    """The vtkDataObject that a filter made."""
    return servermanager.Fetch(proxy)


def reported(data, name):
    """The single value of the report `SweepReport<name>` in the field data, None without it."""
    array = data.GetFieldData().GetArray("SweepReport" + name)
    return array.GetTuple1(0) if array else None


def scaled_jacobians(proxy):
    """The scaled Jacobian of every quad or hex, as a numpy array."""
    return vtk_to_numpy(fetch(proxy).GetCellData().GetArray("ScaledJacobian"))
