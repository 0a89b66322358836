"""One measured process."""

from __future__ import annotations

import os
import subprocess
import sys
import time
from pathlib import Path
from typing import NamedTuple


class Measurement(NamedTuple):
    """Wall time in seconds and the largest resident memory in bytes."""

    seconds: float
    peak: int


class Failure(Exception):
    """A measured process did not do its work."""


def installed(program: str) -> str:
    """The path of a program of this environment."""
    return str(Path(sys.executable).with_name(program))


def measure(command: list[str], folder: Path, *, accepted: tuple[int, ...] = (0,)) -> Measurement:
    """Run a command in a folder, its output thrown away.

    Raises:
        Failure: it ended with an exit code that is not accepted.
    """
    start = time.perf_counter()
    child = subprocess.Popen(
        command, cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
    )
    _, status, usage = os.wait4(child.pid, 0)
    seconds = time.perf_counter() - start
    child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode not in accepted:
        raise Failure(f"exit code {child.returncode}: {' '.join(command[:8])}")
    return Measurement(seconds, usage.ru_maxrss * (1 if sys.platform == "darwin" else 1024))
