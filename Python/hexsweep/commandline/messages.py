# SPDX-License-Identifier: BSD-3-Clause
"""One clear line on stderr for each error or warning."""

import contextlib
import os
import re
import sys
import tempfile

from vtkmodules.vtkCommonCore import vtkLogger, vtkOutputWindow, vtkStringOutputWindow

_WHERE = re.compile(r"\A(ERROR|Warning|Generic Warning): In .*?, line \d+\n")
_WHO = re.compile(r"\A\w+ \((0x)?[0-9a-fA-F]+\): ")
_FAILED_REQUEST = "returned failure for request"


class Refusal(Exception):
    """Why it cannot be done, for the user; without text where that has been said already."""


def say(kind, text):
    """@param kind: "error" or "warning". @param text: one sentence or more, of any number of lines."""
    if sys.stderr:  # it may be closed
        print(f"hexsweep: {kind}: {' '.join(text.split())}", file=sys.stderr, flush=True)


class VtkMessages:
    """Says what VTK says, in lines of ours, in place of its window and its log."""

    def __init__(self, bar=None):
        """@param bar: progress.Bar, which gives way to lines."""
        self.errors = 0
        self._bar = bar
        self._collected = None
        self._warnings_too = False
        self._window = vtkStringOutputWindow()
        for event in ("ErrorEvent", "WarningEvent"):
            self._window.AddObserver(event, self._observer())
        vtkOutputWindow.SetInstance(self._window)
        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)

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
            if self._bar:
                self._bar.erase()
            words = " ".join(_WHO.sub("", _WHERE.sub("", text)).split())
            if event == "WarningEvent" and not self._warnings_too:
                say("warning", words)
            elif self._collected is not None:
                self._collected.append(words)
            else:
                self.errors += 1
                say("error", words)

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
