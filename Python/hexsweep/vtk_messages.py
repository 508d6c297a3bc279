# SPDX-License-Identifier: BSD-3-Clause
"""What VTK and the libraries below it say, as sentences."""

import contextlib
import os
import re
import tempfile

from vtkmodules.vtkCommonCore import vtkLogger, vtkOutputWindow, vtkStringOutputWindow

_WHERE = re.compile(r"\A(ERROR|Warning|Generic Warning): In .*?, line \d+\n")
_WHO = re.compile(r"\A\w+ \((0x)?[0-9a-fA-F]+\): ")
_FAILED_REQUEST = "returned failure for request"


class VtkMessages:
    """Hears what VTK says, in place of its window and its log, from listen() or `with` on."""

    def __init__(self, tell):
        """@param tell: called with "error" or "warning", and the words."""
        self.errors = 0
        self._tell = tell
        self._collected = None
        self._warnings_too = False
        self._window = vtkStringOutputWindow()
        for event in ("ErrorEvent", "WarningEvent"):
            self._window.AddObserver(event, self._observer())
        self._before = None

    def listen(self):
        self._before = vtkOutputWindow.GetInstance(), vtkLogger.GetCurrentVerbosityCutoff()
        vtkOutputWindow.SetInstance(self._window)
        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
        return self

    def __enter__(self):
        return self.listen()

    def __exit__(self, *_):
        window, verbosity = self._before
        vtkOutputWindow.SetInstance(window)
        vtkLogger.SetStderrVerbosity(vtkLogger.ConvertToVerbosity(verbosity))

    @contextlib.contextmanager
    def errors_collected(self, warnings_too=False):
        """Within it errors go to the list that it gives, to be told in one line."""
        before = self._collected, self._warnings_too
        self._collected, self._warnings_too = [], warnings_too
        try:
            yield self._collected
        finally:
            self._collected, self._warnings_too = before

    def _observer(self):
        def observe(_window, event, text):
            if _FAILED_REQUEST in text:
                return  # a print of the request: what failed has been said by the algorithm
            words = " ".join(_WHO.sub("", _WHERE.sub("", text)).split())
            if event == "WarningEvent" and not self._warnings_too:
                self._tell("warning", words)
            elif self._collected is not None:
                self._collected.append(words)
            else:
                self.errors += 1
                self._tell("error", words)

        observe.CallDataType = "string0"
        return observe


@contextlib.contextmanager
def library_messages(errors):
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
