"""Reading what has an end: regular files of a bearable size."""

from __future__ import annotations

import errno
import os
import stat
import sys
from pathlib import Path
from typing import BinaryIO

MEGABYTE = 1024 * 1024
SIZE_LIMIT = 256 * MEGABYTE
"""Larger files are not read, unless the configuration says otherwise."""

_LONGEST_CHAIN = 40
"""So many symbolic links are followed, as by Linux."""

_AT_ONCE = getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0)
_KINDS = (
    (stat.S_ISFIFO, "a pipe"),
    (stat.S_ISDIR, "a folder"),
    (stat.S_ISCHR, "a device"),
    (stat.S_ISBLK, "a device"),
    (stat.S_ISSOCK, "a socket"),
)


class Unfit(OSError):
    """A file that is not read; ``strerror`` says why."""

    def __init__(self, path: Path, why: str) -> None:
        super().__init__(errno.EINVAL, why, str(path))


def read_regular(path: Path, limit: int = SIZE_LIMIT) -> bytes:
    """The content of a regular file of at most ``limit`` bytes; raises OSError, as :func:`open_regular`."""
    with open_regular(path, limit) as stream:
        return read_on(stream, path, limit)


def open_regular(path: Path, limit: int = SIZE_LIMIT) -> BinaryIO:
    """Open a regular file, or a pipe that this process was given (``/dev/stdin``, a shell's ``<(…)``).

    Raises OSError: Unfit for other pipes, for devices and for files larger than ``limit``.
    """
    own = descriptor(path)
    if own is None:
        # A device may act when it is opened, a pipe wait for somebody who never comes.
        _refuse_odd(path, os.stat(path))
    handle = os.dup(own) if own is not None else os.open(path, os.O_RDONLY | _AT_ONCE)
    try:
        status = os.fstat(handle)
        if own is None or not stat.S_ISFIFO(status.st_mode):
            _refuse_odd(path, status)
        if status.st_size > limit:
            raise _too_large(path, limit)
        return os.fdopen(handle, "rb")
    except BaseException:
        os.close(handle)
        raise


def read_on(stream: BinaryIO, path: Path, limit: int = SIZE_LIMIT) -> bytes:
    """The rest of a stream; raises Unfit where that is more than ``limit`` bytes, as a pipe may have."""
    data = stream.read(limit + 1)
    if len(data) > limit:
        raise _too_large(path, limit)
    return data


def oddity(path: Path) -> str:
    """The reason not to read a path found in a folder; empty if it can be read."""
    try:
        kind = _kind(os.stat(path))
    except FileNotFoundError:
        return "a link that leads nowhere" if os.path.islink(path) else "not there"
    except OSError as error:
        return "a loop of links" if error.errno == errno.ELOOP else f"cannot be read: {error.strerror}"
    return f"{kind}, not a file" if kind else ""


def _refuse_odd(path: Path, status: os.stat_result) -> None:
    kind = _kind(status)
    if kind:
        raise Unfit(path, f"{kind}, not a file")


def _kind(status: os.stat_result) -> str:
    """Its kind, where it is not a regular file."""
    if stat.S_ISREG(status.st_mode):
        return ""
    return next((name for is_kind, name in _KINDS if is_kind(status.st_mode)), "something odd")


def _too_large(path: Path, limit: int) -> Unfit:
    size = f"{limit} bytes" if limit % MEGABYTE else f"{limit // MEGABYTE} MB"
    return Unfit(path, f"larger than {size} (`max-file-size` in the configuration)")


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
