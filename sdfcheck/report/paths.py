"""How files are called in reports."""

from __future__ import annotations

import os
from collections.abc import Iterable
from contextlib import suppress
from pathlib import Path

from sdfcheck.source.text import Span


class Paths:
    """Names files with forward slashes: relative to a folder if they lie below it, otherwise as given.

    The folder is the current one, or the one that the environment variable ``root``
    names: a CI service counts from its checkout, wherever the command was started. Where none of ``files`` is
    below it, it is the one that all of them are in.
    """

    __slots__ = ("_here", "_names", "_root")

    def __init__(self, root: str = "", files: Iterable[Path] = ()) -> None:
        try:
            self._here = os.getcwd()
        except FileNotFoundError:  # the current folder was deleted
            self._here = ""
        self._root = os.path.join(os.environ.get(root) or self._here, "")
        self._names: dict[Path, str] = {}
        whole = [self._absolute(path) for path in files]
        if whole and not any(map(self._is_below, whole)):
            with suppress(ValueError):  # they are on several drives
                self._root = os.path.join(os.path.commonpath(map(os.path.dirname, whole)), "")

    def __call__(self, path: Path) -> str:
        name = self._names.get(path)
        if name is None:
            name = self._names[path] = self._name(path)
        return name

    def place(self, span: Span) -> str:
        """Where a span begins, as ``path:line:column``."""
        line, column = span.begin
        return f"{self(span.source.path)}:{line}:{column}"

    def absolute(self, path: Path) -> Path:
        """The whole path; symbolic links stay."""
        return Path(self._absolute(path))

    def _absolute(self, path: Path) -> str:
        return os.path.normpath(os.path.join(self._here, path))

    def _name(self, path: Path) -> str:
        whole = self._absolute(path)
        name = Path(whole[len(self._root) :]).as_posix() if self._is_below(whole) else path.as_posix()
        # Bytes of a name that are no UTF-8 would keep the report from being written.
        return name if name.isprintable() else name.encode("utf-8", "replace").decode("utf-8")

    def _is_below(self, whole: str) -> bool:
        # The case of letters does not matter where the system says so.
        return self._root != "" and os.path.normcase(whole).startswith(os.path.normcase(self._root))
