"""Descriptions as files that engines can read: expanded, with the packages that they name."""

from __future__ import annotations

import os
import re
from codecs import BOM_UTF8
from collections.abc import Iterator, Mapping
from contextlib import suppress
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from sdfcheck.consumers.engines import Question
from sdfcheck.files.library import library_of
from sdfcheck.files.regular import read_regular
from sdfcheck.files.uris import locate
from sdfcheck.source.document import Document
from sdfcheck.source.sniff import Kind

_PACKAGE = re.compile(r"(package|model)://([^/\s\"'<>]+(?: [^/:\s\"'<>]+)*)(/[^\s\"'<>]*)?")
_NAME = re.compile(r"(?<=<uri>)\s*([\w.-]+)\s*(?=</uri>)")
"""A name of a model in place of a URI."""
_MOST = 1_000
"""So many packages are looked for."""
_LONGEST = 1_000_000
"""Longer texts of models are not read for others that they include (bytes)."""


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
        self,
        document: Document,
        action: str = "load",
        settings: Mapping[str, Any] | None = None,
        text: str | None = None,
    ) -> Question:
        """A question about a document, maybe with another text: its file, if that has this text, else a copy."""
        path, text = document.path, document.source.text if text is None else text
        suffix = ".sdf" if document.kind is Kind.SDF else ".urdf"
        is_copy = path.suffix.lower() != suffix or not _is_text_of(path, text)
        if is_copy:
            path = self.write(text, path.stem.partition(".")[0] + suffix)
        library = library_of(document)
        models = [] if library is None else [str(one) for one in library.model_folders]
        packages = packages_in(text, document)
        beside = (str(Path(folder).parent) for name, folder in packages.items() if Path(folder).name == name)
        places = tuple(dict.fromkeys((*models, *beside)))
        return Question(path, action, settings or {}, tuple(packages.items()), places, is_copy)

    def write(self, text: str, name: str) -> Path:
        """A text as a file of its own."""
        self._number += 1
        path = Path(self._folder.name, str(self._number), name)
        path.parent.mkdir()
        path.write_text(text, encoding="utf-8", errors="surrogateescape")
        return path


def packages_in(text: str, document: Document) -> dict[str, str]:
    """The packages and models that URIs in a text and in those models name, and where they are, if they are found."""
    found: dict[str, str] = {}
    waiting = [text]
    while waiting:
        named = _NAME.sub(r"model://\1", waiting.pop())
        for scheme, name, inside in sorted(set(_PACKAGE.findall(named))):
            folder = _folder_of(scheme, name, inside, document) if name not in found else None
            if folder is not None and len(found) < _MOST:
                found[name] = str(folder)
                waiting += _texts_in(folder) if scheme == "model" else ()
    return found


def _folder_of(scheme: str, name: str, inside: str, document: Document) -> Path | None:
    """The folder of a package or model, absolute; of several that which has what is asked for in it."""
    library = library_of(document)
    path = locate(document, f"{scheme}://{name}{inside}").path if inside else None
    whole = "" if path is None else path.absolute().as_posix()
    if inside and whole.endswith(inside):
        return Path(whole.removesuffix(inside))
    found = locate(document, f"{scheme}://{name}").owner
    if found is None and library is not None:
        found = library.packages(document.path).find(name, document.path)
    return None if found is None else found.absolute()


def _texts_in(folder: Path) -> Iterator[str]:
    """The texts of the model that is in a folder."""
    for file in sorted(folder.glob("*.sdf")):
        with suppress(OSError):
            yield read_regular(file, _LONGEST).decode("utf-8", "replace")


def _is_text_of(path: Path, text: str) -> bool:
    encoded = text.encode("utf-8", "surrogateescape")
    try:
        return os.path.isfile(path) and path.read_bytes().removeprefix(BOM_UTF8) == encoded
    except OSError:
        return False
