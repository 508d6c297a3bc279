# SPDX-License-Identifier: BSD-3-Clause
"""A bar on a terminal that shows how far the work is."""

import sys

_WIDTH = 40


class Bar:
    """Follows algorithms; draws nothing where stderr is no terminal."""

    def __init__(self):
        self._drawn = None
        self._seen = bool(sys.stderr) and sys.stderr.isatty()

    def follow(self, algorithm):
        if self._seen:
            algorithm.AddObserver("ProgressEvent", lambda *_: self._draw(algorithm.GetProgress()))
        return algorithm

    def erase(self):
        if self._drawn is not None:
            self._print("\r\033[K")
            self._drawn = None

    def _draw(self, fraction):
        percent = round(100 * min(max(fraction, 0.0), 1.0))
        if percent != self._drawn:
            self._drawn = percent
            done = _WIDTH * percent // 100
            self._print(f"\rhexsweep: [{'#' * done}{' ' * (_WIDTH - done)}] {percent:3d} %")

    def _print(self, text):
        sys.stderr.write(text)
        sys.stderr.flush()
