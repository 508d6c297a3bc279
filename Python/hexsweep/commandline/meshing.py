# SPDX-License-Identifier: BSD-3-Clause
"""From the file of a solid to the file of a mesh."""

from .. import vtkOneToOneSweep
from . import threads
from .faces import choose_face_ids
from .messages import Refusal, VtkMessages
from .output import NewFile
from .process import Died, in_child
from .reading import check, read
from .writing import write


def run(options):
    """@return exit status and what to print. @throw Refusal: the output is as it was then."""
    inputs = [name for name in (options.solid, options.quads) if name]
    for name in inputs:
        check(name)
    with NewFile(options.output, inputs) as new:
        try:
            certified, text = in_child(lambda: _mesh(options, new))
        except Died:
            if new.is_begun():  # VTK's writer of .vtu files may crash on a full disk
                new.make_sure()
            raise
        new.put_in_place()
    return 0 if certified else 2, f"{options.output}: {text}"


def _mesh(options, new):
    """Writes the new file. @return whether all hexahedra are certified, and a line about them."""
    if options.threads:
        threads.use(options.threads)
    messages = VtkMessages()
    sweep = vtkOneToOneSweep()
    sweep.SetSolidData(read(options.solid, messages))
    if options.quads:
        sweep.SetSourceQuadsData(read(options.quads, messages))
    _configure(sweep, options)
    sweep.Update()
    hexes = sweep.GetOutputDataObject(0)
    if sweep.GetErrorCode() != 0 or hexes.GetNumberOfCells() == 0:
        raise Refusal("" if messages.errors else "there is no mesh, and no filter has said why.")
    write(sweep, new, options.role_sets, messages)
    counts = _reported(hexes, "Hexes")
    inverted, uncertified = (int(sum(_reported(hexes, name))) for name in ("Inverted", "NotCertified"))
    least = min(_reported(hexes, "MinScaledJacobian"))
    means = _reported(hexes, "MeanScaledJacobian")
    mean = sum(count * own for count, own in zip(counts, means)) / sum(counts)
    return inverted == 0 and uncertified == 0, (
        f"{hexes.GetNumberOfCells()} hexahedra, {inverted} inverted, {uncertified} not certified, "
        f"scaled Jacobian {least:.3f} (least), {mean:.3f} (mean)"
    )


def _configure(sweep, options):
    choose_face_ids(sweep, options)
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


def _reported(grid, name):
    """@return the values of all bodies."""
    array = grid.GetFieldData().GetArray("SweepReport" + name)
    return [array.GetTuple1(i) for i in range(array.GetNumberOfTuples())]
