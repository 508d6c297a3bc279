# SPDX-License-Identifier: BSD-3-Clause
"""The sweep as a chain of ParaView filters, run stage by stage, and what came out of it.

Needs the HexSweep plugin to be loaded into paraview.simple.
"""

import json
import math
import os
import time
from dataclasses import dataclass, field

import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints

from arrays import points_of

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
    """What one chain of filters made. `seconds` holds the CPU time of each stage in order."""

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


def bent(case, degrees):
    """A case that is swept along z from z = 0, bent about the direction of y onto an arc.

    The line x = 0 keeps its length; positive angles bend towards negative x.
    """
    turn = math.radians(degrees) / fetch(case.target_surface).GetBounds()[4]
    radius = 1.0 / turn

    def moved(mesh):
        data = fetch(mesh)
        x, y, z = points_of(data).T
        points = vtkPoints()
        points.SetDataTypeToDouble()
        for point in zip(
            (x + radius) * np.cos(z * turn) - radius, y, (x + radius) * np.sin(z * turn)
        ):
            points.InsertNextPoint(point)
        copy = data.NewInstance()
        copy.ShallowCopy(data)
        copy.SetPoints(points)
        producer = simple.TrivialProducer()
        producer.GetClientSideObject().SetOutput(copy)
        producer.UpdatePipeline()
        return producer

    return Case(
        case.name,
        case.note,
        moved(case.source_quads),
        moved(case.source_surface),
        moved(case.target_surface),
        moved(case.linking_quads),
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


def sweep_blend(case, target_quads, report):
    """The first step of HexSweep's interior alone, raw, on quads that another chain projected."""
    return _interior(case, target_quads, _Stages(report), Method="Blend", **RAW)


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
        start = time.process_time()
        proxy.UpdatePipeline()
        self.seconds[name] = time.process_time() - start
        if fetch(proxy).GetNumberOfCells() == 0:
            raise RuntimeError(f"{name}: the filter gave nothing; its error message says why")
        self._report(name, self.seconds[name])


def fetch(proxy):
    """The vtkDataObject that a filter made."""
    return servermanager.Fetch(proxy)


def reported(data, name):
    """The first value of the report `SweepReport<name>` in the field data, None without it."""
    array = data.GetFieldData().GetAbstractArray("SweepReport" + name)
    if not array:
        return None
    value = array.GetVariantValue(0)
    return value.ToString() if value.IsString() else value.ToDouble()


def inverted_quads(sweep):
    return int(reported(fetch(sweep.target_quads), "InvertedQuads"))


def inverted_hexes(sweep):
    """Inverted or degenerate, as HexValidity reports them."""
    hexes = fetch(sweep.hexes)
    return int(reported(hexes, "Inverted")) + int(reported(hexes, "Degenerate"))


def uncertified_hexes(sweep):
    return int(reported(fetch(sweep.hexes), "NotCertified"))


def scaled_jacobians(proxy):
    """The scaled Jacobian of every quad or hex, as a numpy array."""
    return vtk_to_numpy(fetch(proxy).GetCellData().GetArray("ScaledJacobian"))
