# SPDX-License-Identifier: BSD-3-Clause
"""A list of the faces of a solid, to choose the source cap from, and the ways to sweep it."""

from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet

from .. import vtkSolidFaces, vtkSweepCandidates
from ..errors import SweepError
from ..files.reading import check, read
from ..process import in_child
from ..sweeps.job import choose_face_ids
from .messages import vtk_messages_said

_MOST_CANDIDATES = 20


def run(options):
    """@return exit status and what to print. @throw SweepError."""
    check(options.solid)
    return 0, in_child(lambda: _list(options))


def _list(options):
    messages = vtk_messages_said()
    solid = read(options.solid, messages)
    faces = _table(vtkSolidFaces(), solid, options)
    candidates = _table(vtkSweepCandidates(), solid, options)
    return "\n".join([*_body_lines(solid, faces), *_face_lines(faces), *_candidate_lines(candidates, _volumes(faces))])


def _table(algorithm, solid, options):
    algorithm.SetInputData(solid)
    choose_face_ids(algorithm, options)
    for name, value in options.settings.items():
        getattr(algorithm, "Set" + name)(value)
    algorithm.Update()
    if algorithm.GetErrorCode() != 0:
        raise SweepError()
    return algorithm.GetOutput()


def _body_lines(solid, table):
    """Of several bodies: their numbers and names."""
    volumes = _volumes(table)
    if len(volumes) > 1 and hasattr(solid, "GetNumberOfPartitionedDataSets"):
        for volume in volumes:
            name = solid.GetMetaData(volume - 1).Get(vtkCompositeDataSet.NAME())
            yield f"volume {volume}: {name}"


def _face_lines(table):
    if table.GetFieldData().GetArray("SweepReportFacesByAngle").GetTuple1(0):
        yield (
            "The solid has no cell array FaceId or CellEntityIds: faces are told apart by the angle "
            "between triangles and numbered from 0."
        )
    ids, triangles, areas, centers, flatness, volumes = (table.GetColumn(i) for i in range(6))
    names, surfaces = (table.GetColumnByName(name) for name in ("Name", "Surface"))
    several = len(_volumes(table)) > 1
    heading = f"{'volume':>6} " if several else ""
    known = any(surfaces.GetValue(row) for row in range(table.GetNumberOfRows()))
    last = f"{'surface':<10} name" if known else "flat"
    yield f"{heading}{'face':>6} {'triangles':>9} {'area':>12}   {'centre':<36} {last}"
    for row in range(table.GetNumberOfRows()):
        place = ", ".join(f"{x:.4g}" for x in centers.GetTuple3(row))
        flat = "yes" if flatness.GetValue(row) > 0.9999 else "no"
        last = f"{surfaces.GetValue(row):<10} {names.GetValue(row)}".rstrip() if known else flat
        volume = f"{volumes.GetValue(row):>6} " if several else ""
        yield (
            f"{volume}{ids.GetValue(row):>6} {triangles.GetValue(row):>9} {areas.GetValue(row):>12.6g}   "
            f"({place:<34}) {last}"
        )


def _volumes(table):
    column = table.GetColumnByName("VolumeId")
    return sorted({column.GetValue(row) for row in range(column.GetNumberOfValues())})


def _candidate_lines(table, volumes):
    """@param volumes: all that the solid has."""
    for volume in volumes:
        rows = [r for r in range(table.GetNumberOfRows()) if _number(table, r, "VolumeId") == volume]
        body = f"volume {volume}" if len(volumes) > 1 else "the solid"
        if not rows:
            yield f"No pair of face sets was found between which {body} can be swept."
            continue
        yield f"Ways to sweep {'it' if len(volumes) == 1 else body}, the best first:"
        yield f"{'score':>6} verdict  source -> target"
        yield from (_candidate_line(table, row) for row in rows[:_MOST_CANDIDATES])
        if len(rows) > _MOST_CANDIDATES:
            yield f"({len(rows) - _MOST_CANDIDATES} more, see Sweep Candidates in ParaView)"
    if table.GetFieldData().GetArray("SweepReportCandidatesCut").GetTuple1(0):
        yield "(There are more caps than were tried.)"


def _number(table, row, name):
    return table.GetValueByName(row, name).ToLongLong()


def _candidate_line(table, row):
    source, target, verdict, reasons = (
        table.GetValueByName(row, name).ToString()
        for name in ("SourceFaceIds", "TargetFaceIds", "Verdict", "Reasons")
    )
    score = table.GetValueByName(row, "Score").ToDouble()
    why = f": {reasons}" if reasons else ""
    return f"{score:>6.3f} {verdict:<8} {source} -> {target}{why}"
