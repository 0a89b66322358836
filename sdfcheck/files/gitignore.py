"""``.gitignore`` files, for where git is not there to ask."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING

from sdfcheck.files.git import work_tree
from sdfcheck.files.regular import MEGABYTE, read_regular
from sdfcheck.source.relative import relative_path

if TYPE_CHECKING:
    from pathspec import GitIgnoreSpec

SIZE_LIMIT = MEGABYTE
"""Larger files of patterns are not read."""


class Ignores:
    """The ``.gitignore`` files that apply in a folder, outermost first."""

    __slots__ = ("_layers",)

    def __init__(self, layers: tuple[tuple[str, GitIgnoreSpec], ...] = ()) -> None:
        self._layers = layers

    @classmethod
    def above(cls, folder: Path) -> Ignores:
        """Those between the root of the repository and ``folder``, unless they ignore ``folder`` itself."""
        root = work_tree(folder)
        absolute = Path(os.path.abspath(folder))
        ignores = cls()
        if root is None:
            return ignores
        ignores = ignores._reading(root, ".git/info/exclude")
        inside = [place for place in reversed([absolute, *absolute.parents]) if root in place.parents]
        for place in inside:
            ignores = ignores.entering(place.parent)
            if ignores.ignore(place, folder=True):
                return cls()
        return ignores

    def entering(self, folder: Path) -> Ignores:
        """With the ``.gitignore`` of ``folder`` added, if it has one."""
        return self._reading(folder, ".gitignore")

    def ignore(self, path: Path, *, folder: bool) -> bool:
        """Whether ``path`` is ignored; the innermost file with an opinion decides."""
        absolute = os.path.abspath(path)
        for top, spec in reversed(self._layers):
            relative = relative_path(absolute, top).replace(os.sep, "/")
            verdict = spec.check_file(relative + "/" if folder else relative).include
            if verdict is not None:
                return verdict
        return False

    def _reading(self, folder: Path, name: str) -> Ignores:
        try:
            lines = read_regular(folder / name, SIZE_LIMIT).decode("utf-8", "replace").splitlines()
        except OSError:
            return self
        return Ignores((*self._layers, (os.path.abspath(folder), _compile(lines))))


def _compile(lines: list[str]) -> GitIgnoreSpec:
    """The patterns; like git, ignore lines that are not patterns."""
    from pathspec import GitIgnoreSpec

    try:
        return GitIgnoreSpec.from_lines(lines)
    except ValueError:
        return GitIgnoreSpec.from_lines([line for line in lines if _is_pattern(line)])


def _is_pattern(line: str) -> bool:
    from pathspec import GitIgnoreSpec

    try:
        GitIgnoreSpec.from_lines([line])
    except ValueError:
        return False
    return True
