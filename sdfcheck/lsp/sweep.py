"""The diagnostics of the files of a workspace that nobody has opened."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path

from sdfcheck.files.discover import discover
from sdfcheck.files.regular import MEGABYTE, read_regular
from sdfcheck.lint.diagnostic import Diagnostic
from sdfcheck.lint.one_file import Selected, lint_file
from sdfcheck.lsp.workspace import LiveCaches, Workspace
from sdfcheck.source.errors import WrongUsage
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import HEAD, Treatment, sniff, treatment

MOST_FILES = 1_000
"""So many files of a workspace are linted, no more."""
LARGEST = MEGABYTE
"""Answers wait while a file is linted: larger ones are linted when they are opened."""


class Swept(NamedTuple):
    """The diagnostics of a file, and the state of the disk and of the workspace in which they were found."""

    state: tuple[int, int, int]
    found: tuple[Diagnostic, ...]

    @property
    def id(self) -> str:
        """Another one says that there may be other diagnostics."""
        return "-".join(map(str, self.state))


class Sweep:
    """The files of the workspace with their diagnostics, each linted once for each of its states."""

    def __init__(self, workspace: Workspace) -> None:
        self.workspace = workspace
        self._known: dict[str, Swept] = {}
        self._caches: LiveCaches | None = None
        """Of its own: the files that it comes upon are not those that open texts include."""
        self._generation = -1

    def paths(self) -> list[Path]:
        """The descriptions in the folders of the workspace that are not open."""
        return list(self._paths())

    def _paths(self) -> Iterator[Path]:
        workspace, seen = self.workspace, set(self.workspace.buffers)
        for folder in workspace.folders:
            if not os.path.isdir(folder):
                continue
            files = discover([folder], exclude=lambda each: workspace.settings_for(each).excludes(each)).files
            for file in files:
                key = workspace.key(file.path)
                if key not in seen and len(seen) < MOST_FILES:
                    seen.add(key)
                    yield file.path

    def rest(self) -> None:
        """Give up what is only needed while files are linted."""
        if self._caches is not None:
            self._caches.close()
        self._caches = None

    def lint(self, path: Path) -> Swept:
        """The diagnostics in a file, as it is on disk; those about files that it includes are theirs."""
        key = self.workspace.key(path)
        state = self._state(path)
        known = self._known.get(key)
        if known is None or known.state != state:
            known = self._known[key] = Swept(state, tuple(self._found(path, key)))
        return known

    def _state(self, path: Path) -> tuple[int, int, int]:
        try:
            status = os.stat(path)
        except OSError:
            return 0, 0, self.workspace.generation
        return status.st_mtime_ns, status.st_size, self.workspace.generation

    def _found(self, path: Path, key: str) -> Iterator[Diagnostic]:
        workspace = self.workspace
        try:
            data = read_regular(path, LARGEST)
        except OSError:
            return
        kind = sniff(data[:HEAD], path)
        if treatment(kind, path, named=False) is not Treatment.LINT:
            return
        try:
            settings = workspace.settings_for(path)
            found, _ = lint_file(Selected(path, data, kind), workspace.book, settings, self._current())
        except WrongUsage as error:
            workspace.fault = str(error)
            return
        yield from (each for each in found if workspace.key(each.span.source.path) == key)

    def _current(self) -> LiveCaches:
        if self._caches is None or self._generation != self.workspace.generation:
            self.rest()
            workspace = self.workspace
            self._caches = LiveCaches(
                workspace.buffers, expand=workspace.choices.expand, named=workspace.folders
            )
            self._generation = self.workspace.generation
        return self._caches
