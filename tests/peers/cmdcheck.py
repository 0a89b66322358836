"""libsdformat's own checker, where its shared library is installed.

The library prints what it thinks and may crash, so each file is checked in a process of
its own: ``python -m tests.peers.cmdcheck FILE…``.
"""

from __future__ import annotations

import ctypes
import ctypes.util
import os
import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

_NEWEST, _OLDEST = 20, 9
_COLOR = re.compile(r"\x1b\[[0-9;]*m")


class Opinion(NamedTuple):
    """The verdict of libsdformat on a file. ``accepted`` is None if it crashed or took too long."""

    accepted: bool | None
    messages: tuple[str, ...]


def library() -> str | None:
    """The newest libsdformat that the loader finds."""
    versions = range(_NEWEST, _OLDEST - 1, -1)
    found = (ctypes.util.find_library(f"sdformat{version}") for version in versions)
    return next((name for name in found if name), None)


def check(path: Path, *, timeout: float = 120) -> Opinion:
    """Ask libsdformat about a file.

    Raises:
        FileNotFoundError: no libsdformat is installed.
    """
    name = library()
    if name is None:
        raise FileNotFoundError("no libsdformat")
    command = [sys.executable, str(Path(__file__)), "--child", name, str(path)]
    try:
        child = subprocess.run(
            command, capture_output=True, text=True, errors="replace", timeout=timeout, check=False
        )
    except subprocess.TimeoutExpired:
        return Opinion(None, (f"no answer within {timeout} s",))
    messages = tuple(_messages(child.stderr + child.stdout))
    return Opinion(None if child.returncode < 0 else child.returncode == 0, messages)


def _messages(text: str) -> Iterator[str]:
    for line in _COLOR.sub("", text).splitlines():
        if line.strip() and line.strip() != "Valid.":
            yield line.strip()


def _child(name: str, path: str) -> None:
    """Calls the checker; ends without the library's exit handlers, which may crash."""
    status = ctypes.CDLL(name).cmdCheck(os.fsencode(path))
    ctypes.CDLL(None).fflush(None)
    os._exit(0 if status == 0 else 1)


def main(arguments: list[str]) -> int:
    rejected = 0
    for argument in arguments:
        opinion = check(Path(argument))
        rejected += opinion.accepted is not True
        verdict = {True: "accepted", False: "rejected", None: "crashed"}[opinion.accepted]
        print("\n  ".join((f"{argument}: {verdict}", *opinion.messages)))
    return min(rejected, 1)


if __name__ == "__main__":
    if sys.argv[1:2] == ["--child"]:
        _child(*sys.argv[2:])
    sys.exit(main(sys.argv[1:]))
