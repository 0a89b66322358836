"""Limits of an expansion: time, memory and the files that are read. Runs in the process that expands, nowhere else."""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping, Sequence
from contextlib import suppress
from typing import TextIO

from sdfcheck.xacro.process.interpreter import Refused, TooMuch


def limit(limits: Mapping[str, int]) -> None:
    """Bound processor time (s), memory and written files (none); reaching the time raises TooMuch.

    Where the system has no such limits, :mod:`sdfcheck.xacro.process.watch` keeps them from outside.
    """
    if sys.platform == "win32":
        return
    try:
        import resource
        import signal
    except ImportError:
        return

    def out_of_time(number: int, frame: object) -> None:
        raise TooMuch(f"no end after {seconds} s of computing")

    seconds = limits["cpu"]
    signal.signal(signal.SIGXCPU, out_of_time)
    for what, soft, hard in (
        (resource.RLIMIT_CPU, seconds, seconds + 1),
        (resource.RLIMIT_AS, limits["memory"], limits["memory"]),
        (resource.RLIMIT_FSIZE, 0, 0),
        (resource.RLIMIT_CORE, 0, 0),
        (getattr(resource, "RLIMIT_NPROC", None), 0, 0),
    ):
        if what is not None:
            with suppress(OSError, ValueError):  # not every system has every limit
                resource.setrlimit(what, (soft, hard))


class Readable:
    """The files that may be read: below the project's root, or below a folder that was pointed out.

    A link inside the project, or in what its workspace has ``installed``, does not lead out of them.
    ``linked`` are files behind links out of a folder that was pointed out, as far as they are known.
    """

    __slots__ = ("linked", "links", "roots")

    def __init__(self, root: str, trusted: Sequence[str], installed: Sequence[str] = ()) -> None:
        self.roots = tuple(_plain(os.path.realpath(folder)) for folder in (root, *installed, *trusted))
        self.links = tuple(_plain(os.path.abspath(folder)) for folder in trusted)
        self.linked: list[str] = []

    def __call__(self, path: str) -> bool:
        real = os.path.realpath(path)
        inside = _below(_plain(real), self.roots) or _below(_plain(os.path.abspath(path)), self.links)
        return inside and (os.path.isfile(real) or os.path.isdir(real) or not os.path.exists(real))


def _plain(path: str) -> str:
    """A path as systems compare it that do not distinguish letters by case; of Windows without ``\\\\?\\``."""
    return os.path.normcase(path.removeprefix("\\\\?\\") if os.sep == "\\" else path)


def _below(path: str, folders: Sequence[str]) -> bool:
    return any(path == folder or path.startswith(folder.rstrip(os.sep) + os.sep) for folder in folders)


class Door:
    """Opens the files that xacro reads, in place of Python's ``open``. Their text is UTF-8 in every locale.

    ``closed`` is a file that may be read and that the system, locked up, does not open: a link in a folder that
    was pointed out leads to it.
    """

    __slots__ = ("_readable", "closed")

    def __init__(self, readable: Readable) -> None:
        self._readable = readable
        self.closed = ""

    def __call__(self, name: str | bytes | os.PathLike[str], mode: str = "r") -> TextIO:
        path = os.path.abspath(os.fsdecode(name))
        if mode != "r" or not self._readable(path):
            raise Refused(f"{os.fsdecode(name)} lies outside of the project")
        try:
            return open(name, encoding="utf-8")
        except PermissionError:
            self.closed = path
            raise
