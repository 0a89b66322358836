"""The conversion of a URDF file by libsdformat, where its shared library is installed.

It may crash, so each file has a process of its own.
"""

from __future__ import annotations

import ctypes
import os
import subprocess
import sys
from pathlib import Path

from tests.peers import cmdcheck


def converted(path: Path, *, timeout: float = 120) -> str:
    """The SDFormat that libsdformat prints for a file; empty if it prints none.

    Raises:
        FileNotFoundError: no libsdformat is installed.
    """
    name = cmdcheck.library()
    if name is None:
        raise FileNotFoundError("no libsdformat")
    command = [sys.executable, "-m", __name__, name, str(path)]
    child = subprocess.run(
        command, capture_output=True, text=True, errors="replace", timeout=timeout, check=False
    )
    _, start, rest = child.stdout.partition("<sdf")
    return start + rest


def _child(name: str, path: str) -> None:
    ctypes.CDLL(name).cmdPrint(os.fsencode(path))
    ctypes.CDLL(None).fflush(None)
    os._exit(0)


if __name__ == "__main__":
    _child(*sys.argv[1:])
