# SPDX-License-Identifier: BSD-3-Clause
"""Work in a process of its own, whose death is one more thing to report."""

import contextlib
import json
import os
import select
import signal
import sys
import threading

from .errors import SweepError

_SIGNALS = [
    getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name)
]
_HEARING = 200  # milliseconds between two looks for signals


class Interrupted(BaseException):
    """A signal asks to end."""

    def __init__(self, number):
        super().__init__(signal.Signals(number).name)
        self.number = number


class Died(SweepError):
    """A process ended before its work did."""


@contextlib.contextmanager
def heard_signals():
    """Within it Ctrl-C and the like raise Interrupted; signals that are ignored stay ignored."""

    def interrupt(number, _frame):
        raise Interrupted(number)

    before = {}
    if threading.current_thread() is threading.main_thread():
        for number in _SIGNALS:
            if signal.getsignal(number) != signal.SIG_IGN:
                before[number] = signal.signal(number, interrupt)
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


def in_child(work):
    """What `work` returns (to be told in JSON), computed where a crash loses nothing.

    @throw SweepError that of `work`; Died.
    """
    if not hasattr(os, "fork"):
        return work()
    for stream in filter(None, (sys.stdout, sys.stderr)):
        stream.flush()  # or both processes would print it
    end, start = os.pipe()
    # A signal between the fork and what follows it would leave the child without a parent.
    signal.pthread_sigmask(signal.SIG_BLOCK, _SIGNALS)
    child = os.fork()
    if child == 0:
        os.close(end)
        _tell(work, start)
    try:
        signal.pthread_sigmask(signal.SIG_UNBLOCK, _SIGNALS)
        os.close(start)
        with open(end, "rb") as pipe:
            # A signal that comes just before a read that waits would be heard only after it.
            answer = select.poll()  # for any descriptor; select() has those below 1024 only
            answer.register(pipe, select.POLLIN)
            while not answer.poll(_HEARING):
                pass
            told = pipe.read()
        _, status = os.waitpid(child, 0)
    except BaseException:
        with contextlib.suppress(ProcessLookupError, ChildProcessError):
            os.kill(child, signal.SIGKILL)
            os.waitpid(child, 0)
        raise
    if status != 0 or not told:
        raise Died(f"the process that does the work {_death(status)}; nothing was written.")
    kind, value = json.loads(told)
    if kind == "refused":
        raise SweepError(value)
    return value


def _tell(work, pipe):
    """Ends the process, never returns."""
    status = 1
    try:
        for number in _SIGNALS:
            if signal.getsignal(number) != signal.SIG_IGN:
                signal.signal(number, signal.SIG_DFL)  # at once, even in the midst of a filter
        signal.pthread_sigmask(signal.SIG_UNBLOCK, _SIGNALS)
        try:
            answer = ("done", work())
        except SweepError as refusal:
            answer = ("refused", str(refusal))
        with open(pipe, "wb") as stream:
            stream.write(json.dumps(answer).encode())
        status = 0
    except BaseException:
        sys.excepthook(*sys.exc_info())
    finally:
        if sys.stderr:
            sys.stderr.flush()
        os._exit(status)


def _death(status):
    if os.WIFSIGNALED(status):
        return f"was ended by {signal.Signals(os.WTERMSIG(status)).name}"
    return f"failed (exit status {os.WEXITSTATUS(status)})"
