# SPDX-License-Identifier: BSD-3-Clause
"""From the file of a solid to the file of a mesh."""

import os

from .. import vtkManyToManySweep, vtkOneToOneSweep
from . import assembly, picture, report, threads, writing
from .arguments import is_between_two
from .faces import choose_face_ids
from .messages import Refusal, VtkMessages, say
from .output import new_files
from .process import Died, in_child
from .progress import Bar
from .quality import Quality, reported
from .reading import check, read


def run(options):
    """@return exit status and what to print. @throw Refusal: the output is as it was then."""
    inputs = [name for name in (options.solid, options.quads) if name]
    for name in inputs:
        check(name)
    choices = writing.Choices(
        options.role_sets, options.set_ids, options.msh_version, options.binary
    )
    writing.check(options.output, choices)
    # A plan that is there is read, and stays as it is.
    plan = options.plan if options.plan and not os.path.exists(options.plan) else None
    outputs = {"mesh": options.output, "json": options.json, "picture": options.picture, "plan": plan}
    with new_files(inputs, **outputs) as new:
        if options.picture:
            picture.check(options.picture)
        try:
            certified, text = in_child(lambda: _mesh(options, choices, new))
        except Died:
            if new.files["mesh"].is_begun():  # VTK's writer of .vtu files may crash on a full disk
                new.files["mesh"].make_sure()
            raise
        new.put_in_place()
    return 0 if certified else 2, f"{options.output}: {text}"


def _mesh(options, choices, new):
    """Writes the new files. @return whether all hexahedra are certified, and lines about them."""
    if options.threads:
        threads.use(options.threads)
    bar = Bar()
    messages = VtkMessages(bar)
    solid = read(options.solid, messages)
    together = assembly.is_one(solid, options)
    if not together and not options.separate and solid.IsA("vtkPartitionedDataSetCollection"):
        for sentence in assembly.gaps(solid):
            say("warning", sentence)
    sweep = assembly.Assembly(solid, options, bar.follow) if together else _single(solid, options, bar, messages)
    sweep.Update()
    bar.erase()
    hexes = sweep.GetOutputDataObject(0)
    if sweep.GetErrorCode() != 0 or not hexes or hexes.GetNumberOfCells() == 0:
        raise Refusal("" if messages.errors else "there is no mesh, and no filter has said why.")
    sets = writing.write(sweep, new.files["mesh"], choices, messages)
    quality = Quality(hexes)
    missing = [int(volume) for volume in reported(hexes, "UnmeshedVolumes")]
    certified = quality.inverted == 0 and quality.is_certified() and not missing
    if options.json:
        about = {"input": options.solid, "output": options.output, "settings": _settings(options)}
        report.write(new.paths["json"], hexes, quality, certified, about, sets)
    if options.picture:
        picture.draw(hexes, new.paths["picture"])
    if "plan" in new.paths:
        sweep.write_plan(new.paths["plan"])
    lines = [quality.line(), *quality.table()]
    if missing:
        lines.append(f"without hexahedra: volume {', '.join(map(str, missing))}")
    return certified, "\n".join(lines)


def _single(solid, options, bar, messages):
    """One body, or several that are meshed by themselves. @throw Refusal."""
    if options.plan:
        raise Refusal(f"--plan: {options.solid} has no bodies that touch.")
    sweep = bar.follow(vtkOneToOneSweep() if is_between_two(options) else vtkManyToManySweep())
    sweep.SetSolidData(solid)
    if options.quads:
        sweep.SetSourceQuadsData(read(options.quads, messages))
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
