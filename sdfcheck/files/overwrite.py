"""Files written whole or not at all; pipes and devices written to."""

from __future__ import annotations

import os
import stat
import sys
from pathlib import Path

from sdfcheck.files.regular import descriptor


def overwrite(path: Path, data: bytes) -> None:
    """Put ``data`` in the place of a file's content, or leave the file as it is.

    Mode, owner and group stay; a symbolic link stays one, and the file that it leads to is written. Of
    several hard links only this one gets the new content. A path that is not a regular file (a pipe, a
    device, ``/dev/stdout``) is written to, and keeps its kind.

    Raises OSError.
    """
    own = descriptor(path)
    if own is not None:
        _write_to(os.dup(own), data)
        return
    try:
        status = os.stat(path)
    except FileNotFoundError:
        _replace(os.path.realpath(path), data, None)
        return
    if stat.S_ISREG(status.st_mode):
        if not os.access(path, os.W_OK):
            raise PermissionError(13, "not writable", str(path))
        _replace(os.path.realpath(path), data, status)
    else:
        _write_to(os.open(path, os.O_WRONLY | getattr(os, "O_NOCTTY", 0)), data)


def identity(path: Path) -> tuple[int, int] | str:
    """A value that is equal for two paths that lead to one file, by whatever links."""
    try:
        status = os.stat(path)
    except OSError:
        return os.path.realpath(path)
    return status.st_dev, status.st_ino


def _replace(target: str, data: bytes, old: os.stat_result | None) -> None:
    """Write a new file and rename it to ``target``."""
    name = os.path.join(os.path.dirname(target), f".sdfcheck-{os.urandom(8).hex()}")
    # By hand: `tempfile` takes longer to load than a small file takes to convert.
    handle = os.open(name, os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_BINARY", 0), 0o600)
    try:
        with os.fdopen(handle, "wb") as stream:
            stream.write(data)
            stream.flush()
            os.fsync(stream.fileno())
        if old is not None:
            _keep_owner(name, old)
        os.chmod(name, old.st_mode & 0o7777 if old is not None else 0o666 & ~_umask())
        os.replace(name, target)
    except BaseException:
        os.unlink(name)
        raise


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
