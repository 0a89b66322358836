"""The files of one run: where others are looked for, and each of them read once."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar, cast

from sdfcheck.files.disk import Disk
from sdfcheck.files.regular import SIZE_LIMIT, read_regular
from sdfcheck.source.record import NamedTuple

if TYPE_CHECKING:
    from sdfcheck.files.packages import Packages
    from sdfcheck.source.document import Document
    from sdfcheck.source.sniff import Kind

T = TypeVar("T")

MODEL_PATH_VARIABLES = (
    "GZ_SIM_RESOURCE_PATH",
    "SDF_PATH",
    "IGN_GAZEBO_RESOURCE_PATH",
    "GAZEBO_MODEL_PATH",
    "GAZEBO_RESOURCE_PATH",
)
"""Environment variables in which Gazebo's generations and libsdformat look for models."""


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


def library_of(document: Document) -> Library | None:
    """The library that a document looks others up in; None: nothing is looked up."""
    library = document.library
    return library if isinstance(library, Library) else None


class Library:
    """Reads the files that documents refer to, each once, and remembers them for the run.

    Files of more than ``limit`` bytes are not read.
    """

    __slots__ = (
        "_current",
        "_documents",
        "_hashes",
        "_limit",
        "_packages",
        "_projects",
        "_roots",
        "_unseen",
        "disk",
        "model_folders",
        "search",
    )

    def __init__(self, search: SearchPaths | None = None, limit: int = SIZE_LIMIT) -> None:
        self.search = search or SearchPaths()
        self.disk = Disk()
        self._limit = limit
        self.model_folders = tuple(dict.fromkeys(self.search.model_folders))
        self._current: Document | None = None
        self._documents: dict[str, Document | None] = {}
        self._hashes: dict[str, int] = {}
        self._unseen: list[Document] = []
        self._roots: dict[Path, Path] = {}
        self._packages: dict[Path, Packages] = {}
        self._projects: dict[tuple[object, Path], object] = {}

    def document(self, path: Path, kind: Kind | None = None) -> Document | None:
        """The document of a file; None if it cannot be read."""
        key = self.disk.real(path)
        if key not in self._documents:
            document = self._documents[key] = self._read(path, key, kind)
            if document is not None:
                self._unseen.append(document)
        return self._documents[key]

    def known(self, data: bytes, path: Path) -> Document | None:
        """The document of a file that was read before and held these bytes; it has this path now."""
        if not self._documents:
            return None
        key = self.disk.real(path)
        document = self._documents.get(key)
        if document is None or self._hashes[key] != hash(data):
            return None
        document.source.path = path
        return document

    def turn_to(self, document: Document) -> None:
        """Look at a document that is not kept; release the one before, unless another was reached through it."""
        if self._current is not None and not self._current.is_referred_to:
            self._current.release()
        self._current = document

    def unseen(self) -> Iterator[Document]:
        """The documents that were read and not handed out here before; looking at them may bring in more."""
        while self._unseen:
            yield self._unseen.pop(0)

    def packages(self, path: Path) -> Packages:
        """The packages around a file."""
        from sdfcheck.files.packages import Packages, project_root

        root = self._roots.get(path.parent)
        if root is None:
            root = self._roots[path.parent] = project_root(path)
        if root not in self._packages:
            self._packages[root] = Packages(root, dict(self.search.packages), self.search.packages_in)
        return self._packages[root]

    def of_project(self, path: Path, view: Callable[[Packages], T]) -> T:
        """A view of the packages around a file, made once for all files among them."""
        packages = self.packages(path)
        key = (view, packages.root)
        if key not in self._projects:
            self._projects[key] = view(packages)
        return cast(T, self._projects[key])

    def forget(self) -> None:
        """Read files anew when they are asked for next; what packages there are is remembered."""
        self.disk = Disk()
        self._documents.clear()
        self._hashes.clear()
        self._unseen.clear()
        self._projects.clear()

    def documents(self) -> tuple[Document, ...]:
        """The documents that were read."""
        return tuple(document for document in self._documents.values() if document is not None)

    def holds(self, path: Path) -> bool:
        """Did something refer to a file?"""
        return self.disk.real(path) in self._documents

    def _read(self, path: Path, key: str, kind: Kind | None) -> Document | None:
        from sdfcheck.source.document import read

        try:
            data = read_regular(path, self._limit)
        except OSError:
            return None
        plain = os.path.normpath(path)
        document = read(data, Path(plain) if self.disk.real(plain) == key else path, kind)
        self._hashes[key] = hash(data)
        document.library = self
        return document
