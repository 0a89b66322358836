"""Answers of the file system, remembered."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from typing import TypeVar, cast

T = TypeVar("T")
_NO_NAMES = frozenset({"", os.curdir, os.pardir})


class Disk:
    """Answers about paths; those that were given stay as they are for a run."""

    __slots__ = ("_existing", "_listings", "_real", "_views")

    def __init__(self) -> None:
        self._existing: dict[str, bool] = {}
        self._listings: dict[str, Mapping[str, str]] = {}
        self._real: dict[str, str] = {}
        self._views: dict[tuple[object, str], object] = {}

    def view(self, folder: str, compute: Callable[[str, Disk], T]) -> T:
        """The result of ``compute`` for a folder, as its path is written; computed once."""
        key = (compute, folder)
        if key not in self._views:
            self._views[key] = compute(folder, self)
        return cast("T", self._views[key])

    def has(self, path: str) -> bool:
        """Is there a file or folder?"""
        found = self._existing.get(path)
        if found is None:
            found = self._existing[path] = os.path.exists(path)
        return found

    def real(self, path: str | os.PathLike[str]) -> str:
        """The absolute path without symbolic links; folders on the way are followed once."""
        folder, name = os.path.split(path)
        if name in _NO_NAMES:
            return os.path.realpath(path)
        found = os.path.join(self._folder(folder), name)
        return os.path.realpath(found) if os.path.islink(found) else found

    def _folder(self, folder: str) -> str:
        below: list[tuple[str, str]] = []
        while (found := self._real.get(folder)) is None:
            above, name = os.path.split(folder)
            if name in _NO_NAMES:
                found = self._real[folder] = os.path.realpath(folder)
            else:
                below.append((folder, name))
                folder = above
        for folder, name in reversed(below):
            plain = os.path.join(found, name)
            found = self._real[folder] = os.path.realpath(plain) if os.path.islink(plain) else plain
        return found

    def ignoring_case(self, path: str) -> str | None:
        """A path that exists and differs from this one only in the case of letters."""
        missing: list[str] = []
        at = path
        while not self.has(at):
            above, name = os.path.split(at)
            if not name:
                return None
            missing.append(name)
            at = above or os.curdir
        for name in reversed(missing):
            same = self._listing(at).get(name.lower())
            if same is None:
                return None
            at = os.path.join(at, same)
        return os.path.normpath(at) if self.has(at) else None

    def _listing(self, folder: str) -> Mapping[str, str]:
        """The entries of a folder: names in lower case → names; empty if it is not a folder."""
        listed = self._listings.get(folder)
        if listed is None:
            try:
                names = sorted(os.listdir(folder), reverse=True)
            except OSError:
                names = []
            listed = self._listings[folder] = {name.lower(): name for name in names}
        return listed
