# SPDX-License-Identifier: BSD-3-Clause
"""The whole job: from a solid to its hexahedra, and to the files that are asked for."""

import os

from .. import vtkManyToManySweep, vtkOneToOneSweep
from ..errors import SweepError
from ..files import picture, reading, report, writing
from ..files.output import new_files
from . import assembly, settings, threads
from .quality import Quality, reported

_CELLS = 0, 0, 0, 1  # of SetInputArrayToProcess: a cell array


class Mesh:
    """What a sweep gives."""

    def __init__(self, sweep):
        """@param sweep: that has run."""
        self.hexes, self.boundary = (sweep.GetOutputDataObject(port) for port in range(2))
        self.quality = Quality(self.hexes)
        self.missing = [int(volume) for volume in reported(self.hexes, "UnmeshedVolumes")]
        self.certified = self.quality.certified and not self.missing

    def lines(self):
        yield self.quality.line()
        yield from self.quality.table()
        if self.missing:
            yield f"without hexahedra: volume {', '.join(map(str, self.missing))}"


def check(options):
    """Of what can be known before any work. @return writing.Choices. @throw SweepError."""
    settings.check(options)
    for name in _input_files(options):
        reading.check(name)
    choices = writing.Choices(options.role_sets, options.set_ids, options.msh_version, options.binary)
    if options.output:
        writing.check(options.output, choices)
    return choices


def outputs(options):
    """NewFiles for what is asked for. @throw SweepError."""
    # A plan that is there is read, and stays as it is.
    plan = options.plan if options.plan and not os.path.exists(options.plan) else None
    return new_files(
        _input_files(options), mesh=options.output, json=options.json, picture=options.picture, plan=plan
    )


def run(options, choices, new, messages, follow, tell):
    """Writes the new files.

    @param options:  words of the command line as attributes; `solid` and `quads` may be data sets.
    @param choices:  writing.Choices.
    @param new:      of outputs().
    @param messages: VtkMessages.
    @param follow:   called with an algorithm, which it gives back: shows its progress.
    @param tell:     called with "warning" and a sentence.
    @return Mesh. @throw SweepError.
    """
    if options.threads is not None:
        threads.use(options.threads)
    solid = _data(options.solid, messages)
    together = assembly.is_one(solid, options)
    if not together and not options.separate and solid.IsA("vtkPartitionedDataSetCollection"):
        for sentence in assembly.gaps(solid):
            tell("warning", sentence)
    sweep = assembly.Assembly(solid, options, follow) if together else _single(solid, options, follow, messages)
    sweep.Update()
    hexes = sweep.GetOutputDataObject(0)
    if sweep.GetErrorCode() != 0 or not hexes or hexes.GetNumberOfCells() == 0:
        raise SweepError("" if messages.errors else "there is no mesh, and no filter has said why.")
    sets = writing.write(sweep, new.files["mesh"], choices, messages) if options.output else None
    mesh = Mesh(sweep)
    if options.json:
        about = {"input": settings.name_of(options.solid), "output": options.output, "settings": _settings(options)}
        report.write(new.paths["json"], hexes, mesh.quality, mesh.certified, about, sets)
    if options.picture:
        picture.draw(hexes, new.paths["picture"])
    if "plan" in new.paths:
        sweep.write_plan(new.paths["plan"])
    return mesh


def choose_face_ids(algorithm, options):
    """@param options: with `faces`, the name of an array or nothing."""
    if options.faces:
        algorithm.SetInputArrayToProcess(*_CELLS, options.faces)


def _input_files(options):
    return [solid for solid in (options.solid, options.quads) if isinstance(solid, str)]


def _data(solid, messages):
    return reading.read(solid, messages) if isinstance(solid, str) else solid


def _single(solid, options, follow, messages):
    """One body, or several that are meshed by themselves. @throw SweepError."""
    if options.plan:
        raise SweepError(f"--plan: {settings.name_of(options.solid)} has no bodies that touch.")
    sweep = follow(vtkOneToOneSweep() if settings.is_between_two(options) else vtkManyToManySweep())
    sweep.SetSolidData(solid)
    if options.quads:
        sweep.SetSourceQuadsData(_data(options.quads, messages))
    _configure(sweep, options)
    return sweep


def _settings(options):
    """As they were given; the others are those of the filter."""
    lists = {
        "SourceFaceIds": options.source, "TargetFaceIds": options.target,
        "VolumeIds": options.volumes, "LayerPositions": options.positions,
        "SetIds": dict(options.set_ids), "SweepDirection": options.direction,
    }
    given = {name: value for name, value in lists.items() if value}
    return {**options.settings, **given, "GrowFromBothEnds": options.both_ends}


def _configure(sweep, options):
    choose_face_ids(sweep, options)
    if options.direction:
        sweep.SetSweepDirection(*options.direction)
    for face in options.source or []:
        sweep.AddSourceFaceId(face)
    for face in options.target or []:
        sweep.AddTargetFaceId(face)
    for volume in options.volumes or []:
        sweep.AddVolumeId(volume)
    for position in options.positions or []:
        sweep.AddLayerPosition(position)
    sweep.SetGrowFromBothEnds(options.both_ends)
    for name, value in options.settings.items():
        getattr(sweep, "Set" + name)(value)
