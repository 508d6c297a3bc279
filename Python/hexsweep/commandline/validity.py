# SPDX-License-Identifier: BSD-3-Clause
"""Whether the hexahedra of a file are valid, whoever made them."""

from ..files import mesh_reading, picture, report
from ..files.output import new_files
from ..process import in_child
from ..sweeps import threads
from ..sweeps.quality import judge
from .messages import vtk_messages_said
from .progress import Bar


def run(options):
    """@return exit status and what to print. @throw SweepError."""
    mesh_reading.check(options.mesh)
    with new_files([options.mesh], json=options.json, picture=options.picture) as new:
        if options.picture:
            picture.check(options.picture)
        certified, text = in_child(lambda: _judge(options, new))
        new.put_in_place()
    return 0 if certified else 2, text


def _judge(options, new):
    """@return whether all solid cells are certified hexahedra, and lines about them."""
    if options.threads is not None:
        threads.use(options.threads)
    bar = Bar()
    grid, others = mesh_reading.read_mesh(options.mesh, vtk_messages_said(bar))
    quality = judge(grid, others, bar.follow)
    bar.erase()
    if options.json:
        about = {"input": options.mesh, "other_solid_cells": quality.others}
        report.write(new.paths["json"], quality.grid, quality, quality.certified, about)
    if options.picture:
        picture.draw(quality.grid, new.paths["picture"])
    return quality.certified, f"{options.mesh}: {quality}"
