# SPDX-License-Identifier: BSD-3-Clause
"""How many threads VTK, and with it every filter, uses in this process."""

from vtkmodules import vtkCommonCore

from ..errors import SweepError

_THREADED = ("STDThread", "TBB", "OpenMP")


def use(number):
    """As many as `number`, or as this machine has where they are fewer. @throw SweepError where it is less than 1, and
    where this VTK has no threads and more than one is asked for."""
    if number < 1:
        raise SweepError(f"--threads {number}: give 1 or more, or leave it out.")
    tools = getattr(vtkCommonCore, "vtkSMPTools", None)
    backends = _backends() if tools else []
    if number == 1 and not backends:
        return
    if not backends:
        raise SweepError(
            f"--threads {number}: this VTK was built without threads; leave --threads out."
        )
    # The one that is in use, where it has threads: the user may have chosen it.
    if number > 1 and tools.GetBackend() not in backends:
        tools.SetBackend(backends[0])
    tools.Initialize(number)


def _backends():
    """Those with threads that this VTK has; a name that it has not would make it complain."""
    enabled = (f"VTK_SMP_ENABLE_{name.upper()}" for name in _THREADED)
    return [name for name, flag in zip(_THREADED, enabled) if getattr(vtkCommonCore, flag, 0)]
