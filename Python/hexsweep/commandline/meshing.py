# SPDX-License-Identifier: BSD-3-Clause
"""From the file of a solid to the file of a mesh."""

from ..files import picture
from ..process import Died, in_child
from ..sweeps import job
from .messages import say, vtk_messages_said
from .progress import Bar


def run(options):
    """@return exit status and what to print. @throw SweepError: the output is as it was then."""
    choices = job.check(options)
    with job.outputs(options) as new:
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
    """@return whether all hexahedra are certified, and lines about them."""
    bar = Bar()
    try:
        mesh = job.run(options, choices, new, vtk_messages_said(bar), bar.follow, say)
    finally:
        bar.erase()
    return mesh.certified, "\n".join(mesh.lines())
