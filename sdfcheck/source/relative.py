"""Paths seen from a folder."""

from __future__ import annotations

import os
from pathlib import Path


def relative_path(path: str | os.PathLike[str], start: str | os.PathLike[str] = os.curdir) -> str:
    """A path as seen from a folder; the whole path where no way leads there: on another drive of Windows."""
    try:
        return os.path.relpath(path, start)
    except ValueError:
        return os.path.abspath(path)


def shown(path: Path) -> str:
    """The path as people call it: relative, where it lies below the current folder."""
    relative = relative_path(path)
    return (str(path) if relative.startswith("..") else relative).replace(os.sep, "/")
