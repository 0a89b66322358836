"""The door through which files are read: regular files of a bearable size, where they may lie.

A path that a person wrote goes through :func:`read_named`, any other through
:func:`read_regular`. Both note the files, so that the run does not write over them.
"""

from __future__ import annotations

import errno
import os
import stat
import sys
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from pathlib import Path
from typing import BinaryIO, Protocol

MEGABYTE = 1024 * 1024
SIZE_LIMIT = 256 * MEGABYTE
"""Larger files are not read, unless the configuration says otherwise."""


class Configured(int):
    """A limit, in bytes, that the configuration sets (``max-file-size``)."""


_LONGEST_CHAIN = 40
"""So many symbolic links are followed, as by Linux."""

_AT_ONCE = (
    getattr(os, "O_NONBLOCK", 0)
    | getattr(os, "O_NOCTTY", 0)
    | getattr(os, "O_CLOEXEC", 0)
    | getattr(os, "O_BINARY", 0)
)
_KINDS = (
    (stat.S_ISFIFO, "a pipe"),
    (stat.S_ISDIR, "a folder"),
    (stat.S_ISCHR, "a device"),
    (stat.S_ISBLK, "a device"),
    (stat.S_ISSOCK, "a socket"),
)
_KERNEL = ("/proc", "/sys", "/dev")
"""Folders whose files are what the kernel makes up, also where they look regular."""
_MEMORY = ("/dev/shm",)

Identity = tuple[int, int]
"""A value that is equal for two paths that lead to one file, by whatever links: device and inode."""


class Noted:
    """The files that a run has read, and the folders that it has written to."""

    __slots__ = ("folders", "read")

    def __init__(self) -> None:
        self.read: set[Identity] = set()
        self.folders: set[str] = set()


_NOTED: ContextVar[Noted | None] = ContextVar("noted", default=None)
"""The notes of the run; None where nobody asks for them."""


OUTSIDE = "outside of the project, its packages and model paths"


class Unfit(OSError):
    """A file that is not read; ``strerror`` says why."""

    def __init__(self, path: Path, why: str) -> None:
        super().__init__(errno.EINVAL, why, str(path))


class Outside(Unfit):
    """A file that a description or a folder leads to, outside of what may be read for it."""


class Bounds(Protocol):
    """The places that files may be read from."""

    def hold(self, path: Path, real: str) -> bool:
        """Whether they hold a file; ``real`` is its path without symbolic links."""


def read_named(path: Path, limit: int = SIZE_LIMIT) -> bytes:
    """The content of a file whose path a person wrote; raises OSError, as :func:`open_named`."""
    with open_named(path, limit) as stream:
        return read_on(stream, path, limit)


def read_regular(path: Path, limit: int = SIZE_LIMIT, within: Bounds | None = None) -> bytes:
    """The content of a regular file of at most ``limit`` bytes; raises OSError, as :func:`open_regular`."""
    handle = _open(path, limit, within)
    try:
        # Not by a stream: what expands xacro may open files by their paths only.
        pieces, left = [], limit + 1
        while left > 0 and (piece := os.read(handle, min(left, MEGABYTE))):
            pieces.append(piece)
            left -= len(piece)
    finally:
        os.close(handle)
    if not left:
        raise _too_large(path, limit)
    return b"".join(pieces)


def open_named(path: Path, limit: int = SIZE_LIMIT) -> BinaryIO:
    """Open a regular file, or a pipe that this process was given (``/dev/stdin``, a shell's ``<(…)``).

    Raises OSError, as :func:`open_regular`.
    """
    own = descriptor(path)
    if own is None:
        return open_regular(path, limit)
    return os.fdopen(_checked(os.dup(own), path, limit, is_own=True), "rb")


def open_regular(path: Path, limit: int = SIZE_LIMIT, within: Bounds | None = None) -> BinaryIO:
    """Open a regular file that lies ``within`` bounds (None: anywhere on a disk).

    Raises OSError: Outside where it does not; Unfit for pipes, devices, what the kernel makes up
    and files larger than ``limit``.
    """
    return os.fdopen(_open(path, limit, within), "rb")


def _open(path: Path, limit: int, within: Bounds | None) -> int:
    try:
        # A device may act when it is opened, a pipe wait for somebody who never comes.
        _refuse_odd(path, os.stat(path))
        handle = os.open(path, os.O_RDONLY | _AT_ONCE)
    except ValueError:
        raise Unfit(path, "no path can have the character NUL") from None
    return _checked(handle, path, limit, within)


def _checked(
    handle: int, path: Path, limit: int, within: Bounds | None = None, *, is_own: bool = False
) -> int:
    """A file that was opened and may be read; what is judged is that file, not what its path leads to by then."""
    try:
        status = os.fstat(handle)
        if not is_own:
            _refuse_odd(path, status)
            real = os.path.realpath(path)
            if not os.path.samestat(os.stat(real), status):
                raise Unfit(path, "changed while it was opened")
            if within is not None and not within.hold(path, real):
                raise Outside(path, OUTSIDE)
            if is_made_up(real):
                raise Unfit(path, "a file of the kernel, not of a disk")
        elif not stat.S_ISFIFO(status.st_mode):
            _refuse_odd(path, status)
        if status.st_size > limit:
            raise _too_large(path, limit)
        _note(status)
    except BaseException:
        os.close(handle)
        raise
    return handle


def read_on(stream: BinaryIO, path: Path, limit: int = SIZE_LIMIT) -> bytes:
    """The rest of a stream; raises Unfit where that is more than ``limit`` bytes, as a pipe may have."""
    data = stream.read(limit + 1)
    if len(data) > limit:
        raise _too_large(path, limit)
    return data


@contextmanager
def noting() -> Iterator[set[Identity]]:
    """Note the files that are read meanwhile."""
    before, noted = _NOTED.get(), Noted()
    token = _NOTED.set(noted)
    try:
        yield noted.read
    finally:
        _NOTED.reset(token)
        if before is not None:
            before.read |= noted.read


def note_read(files: Iterable[Identity | Path]) -> None:
    """Files that another process has read for this one."""
    noted = _NOTED.get()
    if noted is not None:
        noted.read.update(
            filter(None, (identity(file) if isinstance(file, Path) else file for file in files))
        )


def was_read(status: os.stat_result) -> bool:
    """Whether the run has read a file."""
    noted = _NOTED.get()
    return noted is not None and (status.st_dev, status.st_ino) in noted.read


def is_new_to_run(folder: str) -> bool:
    """Whether the run has not asked this about a folder before."""
    noted = _NOTED.get()
    if noted is None:
        return True
    is_new = folder not in noted.folders
    noted.folders.add(folder)
    return is_new


def identity(path: Path) -> Identity | None:
    """The identity of a file; None where there is none."""
    try:
        status = os.stat(path)
    except (OSError, ValueError):
        return None
    return status.st_dev, status.st_ino


def _note(status: os.stat_result) -> None:
    noted = _NOTED.get()
    if noted is not None and stat.S_ISREG(status.st_mode):
        noted.read.add((status.st_dev, status.st_ino))


def is_below(path: str, folders: Iterable[str]) -> bool:
    """Whether a path is one of the folders, or below one; all of them absolute."""
    return any(path == folder or path.startswith(os.path.join(folder, "")) for folder in folders)


def names_in(folder: str | os.PathLike[str]) -> list[str]:
    """The names of what is in a folder, sorted; none if it cannot be listed."""
    try:
        return sorted(os.listdir(folder))
    except (OSError, ValueError):
        return []


def is_made_up(real: str) -> bool:
    """Whether a path without links leads to what the kernel makes up."""
    return is_below(real, _KERNEL) and not is_below(real, _MEMORY)


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
    hint = " (`max-file-size` in the configuration)" if isinstance(limit, Configured) else ""
    return Unfit(path, f"larger than {size}{hint}")


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
