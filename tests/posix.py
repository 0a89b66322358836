"""The parts of POSIX that tests use: elsewhere such tests are skipped, and their types can be checked."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest

IS_ROOT: bool = getattr(os, "geteuid", lambda: 1)() == 0


def make_pipe(path: Path) -> None:
    """A pipe with a name; the test is skipped where there are none."""
    if sys.platform == "win32" or not hasattr(os, "mkfifo"):
        pytest.skip("this system has no pipes with names")
    os.mkfifo(path)


def open_pipe(path: Path) -> int:
    """The end of a pipe from which to read what is there; close it with ``os.close``."""
    return os.open(path, os.O_RDONLY | getattr(os, "O_NONBLOCK", 0))
