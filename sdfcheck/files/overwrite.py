"""Files written whole or not at all."""

from __future__ import annotations

import os
from pathlib import Path


def overwrite(path: Path, data: bytes) -> None:
    """Put ``data`` in the place of a file's content, or leave the file as it is.

    The mode stays; a symbolic link stays one, and the file that it leads to is written.
    Raises OSError.
    """
    import tempfile

    target = os.path.realpath(path)
    mode = os.stat(target).st_mode if os.path.exists(target) else None
    if mode is not None and not os.access(target, os.W_OK):
        raise PermissionError(13, "not writable", str(path))
    handle, name = tempfile.mkstemp(prefix=".sdfcheck-", dir=os.path.dirname(target))
    try:
        with os.fdopen(handle, "wb") as stream:
            stream.write(data)
            stream.flush()
            os.fsync(stream.fileno())
        os.chmod(name, mode & 0o7777 if mode is not None else 0o666 & ~_umask())
        os.replace(name, target)
    except BaseException:
        os.unlink(name)
        raise


def _umask() -> int:
    current = os.umask(0)
    os.umask(current)
    return current
