# SPDX-License-Identifier: BSD-3-Clause
"""Whether the hexahedra of a file are valid, whoever made them."""

from .. import vtkHexValidity
from . import mesh_reading, picture, report, threads
from .messages import Refusal, VtkMessages
from .output import new_files
from .process import in_child
from .progress import Bar
from .quality import Quality


def run(options):
    """@return exit status and what to print. @throw Refusal."""
    mesh_reading.check(options.mesh)
    with new_files([options.mesh], json=options.json, picture=options.picture) as new:
        if options.picture:
            picture.check(options.picture)
        certified, text = in_child(lambda: _judge(options, new))
        new.put_in_place()
    return 0 if certified else 2, text


def _judge(options, new):
    """@return whether all solid cells are certified hexahedra, and lines about them."""
    if options.threads:
        threads.use(options.threads)
    bar = Bar()
    messages = VtkMessages(bar)
    grid, others = mesh_reading.read_mesh(options.mesh, messages)
    validity = bar.follow(vtkHexValidity())
    validity.SetInputData(grid)
    validity.Update()
    bar.erase()
    if validity.GetErrorCode() != 0:
        raise Refusal()  # it has said why
    judged = validity.GetOutputDataObject(0)
    quality = Quality(judged)
    certified = quality.is_certified() and others == 0
    lines = [f"{options.mesh}: {quality.line()}", *quality.table()]
    if others:
        lines.append(f"Not judged: {others} other cells with a volume, which are no hexahedra.")
    if options.json:
        about = {"input": options.mesh, "other_solid_cells": others}
        report.write(new.paths["json"], judged, quality, certified, about)
    if options.picture:
        picture.draw(judged, new.paths["picture"])
    return certified, "\n".join(lines)
