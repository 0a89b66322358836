"""Limits that are kept from outside, where the system keeps none for a process."""

from __future__ import annotations

import sys
from collections.abc import Callable
from contextlib import suppress
from importlib.util import find_spec
from threading import Event, Thread
from typing import TYPE_CHECKING

from sdfcheck.source.errors import WrongUsage
from sdfcheck.source.record import NamedTuple

if TYPE_CHECKING:
    import psutil

_PAUSE = 0.05
"""Seconds between two looks."""


class Limits(NamedTuple):
    """The limits of one expansion: processor and wall time in s, memory and result in bytes."""

    cpu: int = 10
    wall: int = 20
    memory: int = 1 << 30
    output: int = 64_000_000


def is_needed() -> bool:
    """Does the system not limit the memory of a process? Windows cannot, and macOS does not."""
    return sys.platform in {"win32", "darwin"} or find_spec("resource") is None


class Watch:
    """Watches a process and those that it has started, until they take too much or it has to end.

    Raises:
        WrongUsage: psutil is not installed, which says what a process takes.
    """

    def __init__(self, number: int, limits: Limits, stop: Callable[[], object]) -> None:
        if find_spec("psutil") is None:
            raise WrongUsage(
                "xacro files cannot be expanded safely: this system does not limit the memory of a process, and "
                "psutil, which could watch it, is not installed (`--no-expand` checks the files as they are written)"
            )
        self.reason = ""
        """Why the process was stopped; empty while it is not."""
        self._number = number
        self._limits = limits
        self._stop = stop
        self._end = Event()
        self._thread = Thread(target=self._look, daemon=True)

    def __enter__(self) -> Watch:
        self._thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._end.set()
        self._thread.join()

    def _look(self) -> None:
        import psutil

        try:
            process = psutil.Process(self._number)
            before = _seconds(_all(process))
            while not self.reason and not self._end.wait(_PAUSE):
                self.reason = self._excess(_all(process), before)
        except psutil.Error:  # it has ended
            return
        if self.reason:
            self._stop()

    def _excess(self, processes: list[psutil.Process], before: float) -> str:
        if sum(_each(processes, lambda one: one.memory_info().rss)) > self._limits.memory:
            return "more memory is asked for than an expansion may have"
        if _seconds(processes) - before > self._limits.cpu:
            return f"no end after {self._limits.cpu} s of computing"
        return ""


def _all(process: psutil.Process) -> list[psutil.Process]:
    return [process, *process.children(recursive=True)]


def _seconds(processes: list[psutil.Process]) -> float:
    """The processor time of processes."""
    return sum(_each(processes, lambda one: one.cpu_times().user + one.cpu_times().system))


def _each(processes: list[psutil.Process], ask: Callable[[psutil.Process], float]) -> list[float]:
    """The answers of processes; one that has just ended gives none."""
    import psutil

    found = []
    for process in processes:
        with suppress(psutil.Error):
            found.append(ask(process))
    return found
