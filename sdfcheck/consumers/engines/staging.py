"""Descriptions as files that engines can read: expanded, with the packages that they name."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from sdfcheck.consumers.engines import Question
from sdfcheck.files.library import library_of
from sdfcheck.source.document import Document
from sdfcheck.source.sniff import Kind

_PACKAGE = re.compile(r"(?:package|model)://([^/\s\"'<>]+)")


class Stage:
    """A folder for files that only an engine reads; it is removed in the end."""

    def __init__(self) -> None:
        self._folder = TemporaryDirectory(prefix="sdfcheck-")
        self._number = 0

    def __enter__(self) -> Stage:
        return self

    def __exit__(self, *_: object) -> None:
        self._folder.cleanup()

    def question(
        self, document: Document, action: str = "load", settings: Mapping[str, Any] | None = None
    ) -> Question:
        """A question about a document: its file, if that is what was read, else a copy of its text."""
        path, text = document.path, document.source.text
        suffix = ".sdf" if document.kind is Kind.SDF else ".urdf"
        if path.suffix.lower() != suffix or not _is_text_of(path, text):
            path = self.write(text, path.stem.partition(".")[0] + suffix)
        library = library_of(document)
        models = [] if library is None else [str(one) for one in library.model_folders]
        folders = tuple(packages_in(text, document).items())
        return Question(path, action, settings or {}, folders, tuple(models))

    def write(self, text: str, name: str) -> Path:
        """A text as a file of its own."""
        self._number += 1
        path = Path(self._folder.name, str(self._number), name)
        path.parent.mkdir()
        path.write_text(text, encoding="utf-8", errors="surrogateescape")
        return path


def packages_in(text: str, document: Document) -> dict[str, str]:
    """The packages that URIs in a text name, and where they are, as far as they are found."""
    return dict(_found(sorted(set(_PACKAGE.findall(text))), document))


def _found(names: Iterable[str], document: Document) -> Iterable[tuple[str, str]]:
    library = library_of(document)
    for name in names:
        folder = None if library is None else library.packages(document.path).find(name)
        if folder is not None:
            yield name, str(folder)


def _is_text_of(path: Path, text: str) -> bool:
    try:
        return path.is_file() and path.read_text("utf-8", "surrogateescape") == text
    except OSError:
        return False
