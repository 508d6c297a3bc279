# SPDX-License-Identifier: BSD-3-Clause
"""VTK's warnings and errors into a file for a while, with one line of each on the terminal."""

import re
import sys
from contextlib import contextmanager

from vtkmodules.vtkCommonCore import vtkLogger

# "(   1.2s) [thread] file.cxx:12  WARN| vtkClass (0x1234): What is wrong. More about it ..."
_MESSAGE = re.compile(r"(?:WARN|ERR)\| +vtk(\w+) \(0x[0-9a-f]+\): *(.*?)(?=[.:] |[.:]?$)", re.M)


@contextmanager
def messages_to(file_name, show):
    """Inside `with messages_to(name, show):` VTK's messages go to that file.

    Afterwards `show(line)` is called with the first sentence of each; when the block ends with an
    exception the whole file is written to the terminal.
    """
    usual = vtkLogger.GetCurrentVerbosityCutoff()
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
    vtkLogger.LogToFile(file_name, vtkLogger.TRUNCATE, vtkLogger.VERBOSITY_WARNING)
    try:
        yield
    except Exception:
        sys.stderr.write(_end(file_name, usual))
        raise
    for filter_name, sentence in _MESSAGE.findall(_end(file_name, usual)):
        show(f"{filter_name}: {sentence}")


def _end(file_name, verbosity):
    """Back to the terminal; returns what is in the file."""
    vtkLogger.EndLogToFile(file_name)
    vtkLogger.SetStderrVerbosity(verbosity)
    with open(file_name, encoding="utf-8") as file:
        return file.read()
