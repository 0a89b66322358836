"""The door through which files are written: whole or not at all, and never over what the run has read."""

from __future__ import annotations

import errno
import os
import stat
import sys
import time
from contextlib import suppress
from pathlib import Path

from sdfcheck.files.regular import descriptor, is_below, is_new_to_run, was_read

_PREFIX, _DIGITS = ".sdfcheck-", 16
_BEGINNING = 10.0
"""Seconds that pass at most between making a file and writing to it."""


class Refused(OSError):
    """A file that is not written; ``strerror`` says why, with the file as its subject."""

    def __init__(self, path: Path, why: str) -> None:
        super().__init__(errno.EINVAL, why, str(path))


def why_not(path: Path, error: OSError) -> str:
    """The sentence about a file that was not written."""
    if isinstance(error, Refused):
        return f"{path} {error.strerror}"
    return f"cannot write {path}: {error.strerror or error}"


def overwrite(path: Path, data: bytes, *, instead: bool = False, lasting: bool = True) -> None:
    """Put ``data`` in the place of a file's content, or leave the file as it is.

    ``instead``: the file is the one that the data was made from, and may have been read. ``lasting``: the
    file is on the disk, whatever happens to the computer afterwards; that takes its time.
    Mode, owner and group stay; a symbolic link stays one, and the file that it leads to is written. Of
    several hard links only this one gets the new content. Files that this process was given open
    (``/dev/stdout``, a shell's ``>(…)``) and the null device are written to.

    Raises OSError: Refused as :func:`refuse_to_write` says.
    """
    own = descriptor(path)
    if own is not None:
        _write_to(os.dup(own), data)
    elif goes_to_a_file(path):
        status = refuse_to_write(path, instead=instead)
        _replace(os.path.realpath(path), data, status, lasting=lasting)


def goes_to_a_file(path: Path) -> bool:
    """Whether writing makes a file: not to what this process was given open, nor to the null device."""
    return descriptor(path) is None and os.path.abspath(path) != os.devnull


def refuse_to_write(path: Path, *, instead: bool = False) -> os.stat_result | None:
    """Make sure that a path may be written; returns what is there, None if nothing is.

    Raises OSError: Refused for pipes, devices and folders, for links that lead out of the tree, and for what the
    run has read, unless the data goes there ``instead``.
    """
    try:
        status = os.stat(path)
    except FileNotFoundError:
        status = None
    except ValueError:
        raise Refused(path, "has the character NUL, which no path can have") from None
    if status is not None and not stat.S_ISREG(status.st_mode):
        raise Refused(path, "is not a file")
    tree = _tree_left(path)
    if tree:
        raise Refused(path, f"leads out of {tree} by a link; name the file itself")
    if status is None:
        return None
    if not instead and was_read(status):
        raise Refused(path, "is an input and would be overwritten; name another file")
    if not os.access(path, os.W_OK):
        raise PermissionError(errno.EACCES, "not writable", str(path))
    return status


def _tree_left(path: Path) -> str:
    """The folder that a path seems to be in, and by a link is not: repository, current folder or its own; else ''."""
    from sdfcheck.files.git import work_tree

    plain, real = os.path.abspath(path), os.path.realpath(path)
    here, own = os.getcwd(), os.path.dirname(plain)
    root = work_tree(Path(own))
    tree = str(root) if root is not None else here if is_below(plain, (here,)) else own
    return "" if is_below(real, (os.path.realpath(tree),)) else tree


def _replace(target: str, data: bytes, old: os.stat_result | None, *, lasting: bool) -> None:
    """Write a new file and rename it to ``target``."""
    folder = os.path.dirname(target)
    _sweep(folder)
    name = os.path.join(folder, f"{_PREFIX}{os.urandom(_DIGITS // 2).hex()}")
    # By hand: `tempfile` takes longer to load than a small file takes to convert.
    handle = os.open(name, os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_BINARY", 0), 0o600)
    try:
        with os.fdopen(handle, "wb") as stream:
            _is_locked(stream.fileno())
            stream.write(data)
            stream.flush()
            if lasting:
                os.fsync(stream.fileno())
            if sys.platform != "win32":  # which replaces no file that is open
                _put(name, target, old)
        if sys.platform == "win32":
            _put(name, target, old)
    except BaseException:
        os.unlink(name)
        raise


def _put(name: str, target: str, old: os.stat_result | None) -> None:
    if old is not None:
        _keep_owner(name, old)
    os.chmod(name, old.st_mode & 0o7777 if old is not None else 0o666 & ~_umask())
    os.replace(name, target)


def _sweep(folder: str) -> None:
    """Remove what runs have left in a folder that were killed while they wrote."""
    if not is_new_to_run(folder):
        return
    for name in os.listdir(folder):
        if name.startswith(_PREFIX) and len(name) == len(_PREFIX) + _DIGITS:
            with suppress(OSError):  # it may be somebody else's, or gone by now
                _remove_left(os.path.join(folder, name))


def _remove_left(path: str) -> None:
    """Remove a file unless it is one that a process writes."""
    handle = os.open(path, os.O_WRONLY | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0))
    try:
        status = os.fstat(handle)
        # One that was made just now is not locked yet.
        is_begun = status.st_size > 0 or time.time() - status.st_mtime > _BEGINNING
        if stat.S_ISREG(status.st_mode) and is_begun and _is_locked(handle):
            os.unlink(path)
    finally:
        os.close(handle)


def _is_locked(handle: int) -> bool:
    """Lock a file that is written; False if another process has done so."""
    if sys.platform == "win32":
        return True
    import fcntl

    try:
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        return False
    except OSError:
        return True  # a file system without locks
    return True


def _keep_owner(name: str, old: os.stat_result) -> None:
    if sys.platform == "win32":
        return
    new = os.stat(name)
    if (new.st_uid, new.st_gid) == (old.st_uid, old.st_gid):
        return
    uid = -1 if new.st_uid == old.st_uid else old.st_uid
    try:
        os.chown(name, uid, old.st_gid)
    except OSError:
        raise PermissionError(1, "its owner and group cannot be kept") from None


def _write_to(handle: int, data: bytes) -> None:
    if sys.stdout is not None:
        sys.stdout.flush()
    with os.fdopen(handle, "wb") as stream:
        stream.write(data)


def _umask() -> int:
    current = os.umask(0)
    os.umask(current)
    return current
