# SPDX-License-Identifier: BSD-3-Clause
"""One clear line on stderr for each error or warning."""

import sys

from ..vtk_messages import VtkMessages


def say(kind, text):
    """@param kind: "error" or "warning". @param text: one sentence or more, of any number of lines."""
    if sys.stderr:  # it may be closed
        print(f"hexsweep: {kind}: {' '.join(text.split())}", file=sys.stderr, flush=True)


def vtk_messages_said(bar=None):
    """@param bar: progress.Bar, which gives way to lines. @return VtkMessages that are said."""

    def tell(kind, words):
        if bar:
            bar.erase()
        say(kind, words)

    return VtkMessages(tell).listen()
