# SPDX-License-Identifier: BSD-3-Clause
"""Several bodies that touch, as one conforming mesh; the plan of their sweeps as a file."""

import json
import os

from vtkmodules.vtkCommonDataModel import vtkBoundingBox
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer

from .. import __version__, vtkAssemblySweep
from ..errors import SweepError
from .settings import name_of

# Options of a single sweep that mean nothing, or something else, for an assembly.
_SINGLE = {
    "quads": "--quads", "volumes": "--volume", "positions": "--positions", "both_ends": "--both-ends",
    "method": "--method", "precision": "--precision",
}
_SINGLE_SETTINGS = {
    "NumberOfLayers": "--layers", "LayerSize": "--layer-size", "GrowthRatio": "--growth", "QuadSize": "--quad-size",
}
# Of the smaller body's size: a narrow gap, and none at all.
_NARROW, _TOUCH = 1e-3, 1e-6
_SETTINGS = ("Size", "FeatureAngle", "MatchTolerance")


def is_one(data, options):
    """Whether the file has bodies that share faces, and they are to be meshed together."""
    if options.separate or not data.IsA("vtkPartitionedDataSetCollection"):
        return False
    seen = set()
    for solid in range(data.GetNumberOfPartitionedDataSets()):
        part = data.GetPartition(solid, 0)
        ids = part.GetCellData().GetArray("FaceId") if part else None
        own = set(memoryview(ids)) if ids else set()
        if seen & own:
            return True
        seen |= own
    return False


def gaps(data):
    """@return a sentence for each two bodies of a collection between which there is a gap, but hardly any: less
    than a thousandth of the smaller one. Whoever drew them may have meant them to touch."""
    solids = []
    for number in range(data.GetNumberOfPartitionedDataSets()):
        part = data.GetPartition(number, 0)
        if part and part.GetNumberOfPoints():
            solids.append((number + 1, part, vtkBoundingBox(part.GetBounds())))
    sentences = []
    for i, (one, first, box) in enumerate(solids):
        for other, second, other_box in solids[i + 1:]:
            size = min(box.GetDiagonalLength(), other_box.GetDiagonalLength())
            near = vtkBoundingBox(box)
            near.Inflate(_NARROW * size)
            if not near.Intersects(other_box):
                continue
            least = min(_distance(first, second), _distance(second, first))
            if _TOUCH * size < least < _NARROW * size:
                sentences.append(
                    f"volume {one} and volume {other} are {least:.3g} apart: they do not touch, and their meshes do "
                    "not fit. Where they should touch, move them together in the CAD system."
                )
    return sentences


def _distance(points_of, surface):
    """The least distance of points from a surface, 0 where some are inside."""
    from vtkmodules.vtkFiltersCore import vtkImplicitPolyDataDistance  # only where bodies are apart

    distance = vtkImplicitPolyDataDistance()
    distance.SetInput(surface)
    return max(0.0, min(distance.EvaluateFunction(points_of.GetPoint(i)) for i in range(points_of.GetNumberOfPoints())))


def check(options):
    """@throw SweepError where options and an assembly do not go together."""
    given = [word for name, word in _SINGLE.items() if getattr(options, name)]
    given += [word for name, word in _SINGLE_SETTINGS.items() if name in options.settings]
    if given:
        raise SweepError(
            f"{given[0]}: the bodies of {name_of(options.solid)} touch and get one mesh, for which it cannot be given. "
            "With --separate each body is meshed by itself."
        )


class Assembly:
    """vtkAssemblySweep with both outputs on ports, as the writers ask for them."""

    def __init__(self, data, options, follow):
        """@param follow: shows the progress of an algorithm. @throw SweepError as check(), and for a plan that is none."""
        check(options)
        self.filter = follow(vtkAssemblySweep())
        self.filter.SetInputDataObject(data)
        self.filter.MergedOn()
        self._plan = options.plan
        self._known = _read_plan(options.plan) if options.plan and os.path.exists(options.plan) else None
        for name in _SETTINGS:
            if name in options.settings:
                getattr(self.filter, "Set" + name)(options.settings[name])
        if self._known:
            self._obey(self._known, "Size" not in options.settings)
        owners = _owners(data)
        for faces, add in ((options.source, self.filter.AddVolumeSource), (options.target, self.filter.AddVolumeTarget)):
            for face in faces or []:
                add(_owner(owners, face), face)
        self._outputs = [vtkTrivialProducer(), vtkTrivialProducer()]

    def Update(self):
        self.filter.Update()
        volumes = self.filter.GetOutputDataObject(0)
        if volumes.GetNumberOfPartitionedDataSets():
            self._outputs[0].SetOutput(volumes.GetPartition(0, 0))
        self._outputs[1].SetOutput(self.filter.GetOutputDataObject(1))

    def GetErrorCode(self):
        return self.filter.GetErrorCode()

    def GetOutputPort(self, port):
        return self._outputs[port].GetOutputPort()

    def GetOutputDataObject(self, port):
        return self._outputs[port].GetOutputDataObject(0)

    def write_plan(self, path):
        """@param path: a new file. A plan that was read stays as it is."""
        if self._known:
            content = self._known
        else:
            fields = self.GetOutputDataObject(0).GetFieldData()
            text = {name: fields.GetAbstractArray("SweepReport" + name) for name in ("PlannedSources", "PlannedTargets")}
            ids, layers = (fields.GetArray("SweepReport" + name) for name in ("VolumeIds", "Layers"))
            names = fields.GetAbstractArray("VolumeNames")
            content = {
                "hexsweep": __version__,
                "size": fields.GetArray("SweepReportSize").GetTuple1(0),
                "volumes": [
                    {
                        "id": int(ids.GetTuple1(v)),
                        "name": names.GetValue(int(ids.GetTuple1(v))) if names else "",
                        "source": [int(word) for word in text["PlannedSources"].GetValue(v).split()],
                        "target": [int(word) for word in text["PlannedTargets"].GetValue(v).split()],
                        # A body that is cut into pieces has layers in each of them.
                        **({"layers": int(layers.GetTuple1(v))} if layers.GetTuple1(v) else {}),
                    }
                    for v in range(ids.GetNumberOfTuples())
                ],
            }
        with open(path, "w", encoding="utf-8") as file:
            json.dump(content, file, indent=2, ensure_ascii=False)
            file.write("\n")

    def _obey(self, plan, with_size):
        try:
            if with_size and "size" in plan:
                self.filter.SetSize(float(plan["size"]))
            for volume in plan.get("volumes", []):
                number = int(volume["id"])
                for face in volume.get("source", []):
                    self.filter.AddVolumeSource(number, int(face))
                for face in volume.get("target", []):
                    self.filter.AddVolumeTarget(number, int(face))
                if "layers" in volume:
                    self.filter.AddVolumeLayers(number, int(volume["layers"]))
        except (TypeError, ValueError, KeyError, AttributeError) as error:
            raise SweepError(
                f"{self._plan}: is no plan: {error!r}. Each volume needs its id; source and target are lists of "
                "face ids, layers a number."
            ) from None


def _read_plan(path):
    try:
        with open(path, encoding="utf-8") as file:
            plan = json.load(file)
    except (OSError, ValueError) as error:
        raise SweepError(f"{path}: cannot be read as a plan: {error}.") from None
    if not isinstance(plan, dict):
        raise SweepError(f"{path}: is no plan. Delete it, and it will be written.")
    return plan


def _owners(data):
    """The volumes of each face, from 1 on."""
    owners = {}
    for solid in range(data.GetNumberOfPartitionedDataSets()):
        part = data.GetPartition(solid, 0)
        for face in set(memoryview(part.GetCellData().GetArray("FaceId"))) if part else ():
            owners.setdefault(int(face), []).append(solid + 1)
    return owners


def _owner(owners, face):
    volumes = owners.get(face, [])
    if len(volumes) != 1:
        why = "two bodies have it: use --plan" if volumes else "no body has it"
        raise SweepError(f"face {face} cannot be named as a cap: {why}.")
    return volumes[0]
