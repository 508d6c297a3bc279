# SPDX-License-Identifier: BSD-3-Clause
"""The mesh into a file, by VTK's writers, whose word is not taken for it."""

import contextlib
import os
import tempfile

from . import checking
from .messages import Refusal

EXODUS = (".ex2", ".exo", ".e")
WRITTEN = (".vtu", *EXODUS)

_MOST_INT32 = 1 << 31


def write(sweep, new, role_sets, messages):
    """@param new: NewFile. @param messages: VtkMessages. @throw Refusal where it went wrong."""
    exodus = os.path.splitext(new.path)[1].lower() in EXODUS
    source, writer = _exodus_writer(sweep, role_sets) if exodus else _xml_writer(sweep)
    writer.SetFileName(new.path)
    with messages.errors_collected() as errors, _library_messages(errors):
        done = writer.Write()
    if new.is_begun() or not errors:
        new.make_sure()
    if errors or not done or writer.GetErrorCode() != 0:
        raise new.failure(f"the writer failed{_first(errors)}")
    with messages.errors_collected(warnings_too=True) as errors, _library_messages(errors):
        if exodus:
            difference = checking.exodus_difference(new.path, source.GetOutputDataObject(0))
        else:
            difference = checking.xml_damage(new.path)
    if errors or difference:
        raise new.failure(f"the file that was written {difference or 'is damaged'}{_first(errors)}")


def _first(errors):
    return ": " + " ".join(errors[0].split()).rstrip(".") if errors else ""


def _exodus_writer(sweep, role_sets):
    try:
        from vtkmodules.vtkIOExodus import vtkExodusIIWriter
    except ImportError:
        raise Refusal("this VTK has no Exodus II writer; write a .vtu file.") from None
    from .. import vtkSweepSets

    sets = vtkSweepSets()
    sets.SetHexesConnection(sweep.GetOutputPort(0))
    sets.SetBoundaryConnection(sweep.GetOutputPort(1))
    sets.SetRoleSets(role_sets)
    writer = vtkExodusIIWriter()
    writer.SetInputConnection(sets.GetOutputPort())
    return sets, writer


def _xml_writer(sweep):
    from .. import vtkHexGridWriter

    grid = sweep.GetOutputDataObject(0)
    writer = vtkHexGridWriter()
    writer.SetInputConnection(sweep.GetOutputPort(0))
    # Of what every reader of Debian 12 and 13 accepts, the fastest: see Documentation/Results.md.
    writer.SetDataModeToBinary()
    writer.SetCompressorTypeToLZ4()
    writer.SetCompressionLevel(9)
    if grid.GetCells().GetNumberOfConnectivityIds() < _MOST_INT32:
        writer.SetIdTypeToInt32()
    return sweep, writer


@contextlib.contextmanager
def _library_messages(errors):
    """Adds to `errors` what a C library writes to stderr meanwhile."""
    screen = os.dup(2)
    with tempfile.TemporaryFile() if not hasattr(os, "memfd_create") else open(
        os.memfd_create("stderr"), "w+b"
    ) as file:
        os.dup2(file.fileno(), 2)
        try:
            yield
        finally:
            os.dup2(screen, 2)
            os.close(screen)
            file.seek(0)
            said = file.read().decode(errors="replace").strip()
            if said:
                errors.append(said)
