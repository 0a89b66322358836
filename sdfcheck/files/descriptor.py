"""Paths that name open files of this process: ``/dev/stdout``, ``/dev/fd/3``."""

from __future__ import annotations

import os
import sys
from pathlib import Path

_LONGEST_CHAIN = 40
"""So many symbolic links are followed, as by Linux."""


def descriptor(path: Path) -> int | None:
    """The number of the open file that a path names; None for any other path."""
    at = os.path.abspath(path)
    for _ in range(_LONGEST_CHAIN):
        folder, name = os.path.split(at)
        if name.isascii() and name.isdigit() and os.path.realpath(folder) in _folders():
            return int(name)
        if not os.path.islink(at):
            return None
        at = os.path.normpath(os.path.join(os.path.realpath(folder), os.readlink(at)))
    return None


def _folders() -> tuple[str, ...]:
    folders = ("/dev/fd",) if sys.platform == "darwin" else ("/dev/fd", "/proc/self/fd")
    return tuple(os.path.realpath(folder) for folder in folders)
