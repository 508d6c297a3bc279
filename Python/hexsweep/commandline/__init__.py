# SPDX-License-Identifier: BSD-3-Clause
"""The command line: reads a solid from a file, lists its faces or meshes it, writes a file; or judges
the hexahedra of a file.

It is Python for the sake of what is round the filters: the work in a child process, whose death loses
no file; files that are replaced only when they are whole; formats that Python packages write. So it
shares the interpreter and the VTK of whoever scripts the filters.

Exit status: 0 certified (or listed), 2 meshed but not certified, 1 refused, failed or wrong usage,
128 and the signal's number where it was interrupted.
"""

import os
import sys

from ..errors import SweepError
from ..process import Interrupted, heard_signals
from . import arguments, faces, meshing, validity
from .messages import say


_COMMANDS = {"faces": faces.run, "check": validity.run, "mesh": meshing.run}


def main(words=None):
    """@return the exit status. @param words: sys.argv[1:] by default."""
    try:
        with heard_signals():
            options = arguments.parse(sys.argv[1:] if words is None else words)
            status, text = _COMMANDS[options.command](options)
    except SweepError as refusal:
        if str(refusal):
            say("error", str(refusal))
        return 1
    except Interrupted as interrupted:
        say("error", f"interrupted ({interrupted}); nothing was written.")
        return 128 + interrupted.number
    return _print(text, status)


def _print(text, status):
    try:
        print(text, flush=True)
    except BrokenPipeError:  # the reader has seen enough, as with | head
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    return status
