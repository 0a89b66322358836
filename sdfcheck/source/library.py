"""The files of one run: where others are looked for, and each of them read once."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from sdfcheck.source.document import Document

MODEL_PATH_VARIABLES = (
    "GZ_SIM_RESOURCE_PATH",
    "SDF_PATH",
    "IGN_GAZEBO_RESOURCE_PATH",
    "GAZEBO_MODEL_PATH",
    "GAZEBO_RESOURCE_PATH",
)
"""Environment variables in which Gazebo's generations and libsdformat look for models."""

SIZE_LIMIT = 64 * 1024 * 1024
"""Larger files are not read as a part of another one."""


class SearchPaths(NamedTuple):
    """Where names are looked for: folders of models, folders of packages, packages by name."""

    models: tuple[Path, ...] = ()
    packages_in: tuple[Path, ...] = ()
    packages: tuple[tuple[str, Path], ...] = ()

    @property
    def model_folders(self) -> Iterator[Path]:
        """The configured folders, then those of the environment."""
        yield from self.models
        for variable in MODEL_PATH_VARIABLES:
            for part in os.environ.get(variable, "").split(os.pathsep):
                if part:
                    yield Path(part)


class Library:
    """Reads the files that documents refer to, each once, and remembers them for the run."""

    __slots__ = ("_documents", "search")

    def __init__(self, search: SearchPaths | None = None) -> None:
        self.search = search or SearchPaths()
        self._documents: dict[Path, Document | None] = {}

    def add(self, document: Document) -> None:
        """Take in a document that somebody has read already."""
        self._documents[_key(document.path)] = document

    def document(self, path: Path) -> Document | None:
        """The document of a file; None if it cannot be read."""
        key = _key(path)
        if key not in self._documents:
            self._documents[key] = self._read(path)
        return self._documents[key]

    def _read(self, path: Path) -> Document | None:
        from sdfcheck.source.document import read

        try:
            if path.stat().st_size > SIZE_LIMIT:
                return None
            document = read(path.read_bytes(), path)
        except OSError:
            return None
        document.library = self
        return document


def _key(path: Path) -> Path:
    return Path(os.path.realpath(path))
