"""From a URI in a description to a file on disk.

Schemes: ``model://name/…`` (a model in one of the model folders), ``package://name/…``
(a ROS package), ``file://…``, none (relative to the referring file), and what comes
from the network, which is never fetched.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from sdfcheck.source.document import Document

_SCHEME = re.compile(r"([A-Za-z][A-Za-z0-9+.\-]+):/*")
REMOTE_SCHEMES = frozenset({"http", "https", "fuel", "ftp"})
_CLIMB = 6
"""How many folders above the referring file may hold the model or package that it names."""


class Location(NamedTuple):
    """Where a URI leads.

    ``path`` is the file or folder, None if nothing is there. ``tried`` are the paths
    that were looked at, ``near`` one that differs only in case. ``owner`` is the folder
    of the model or package if that was found, though not the file in it.
    """

    scheme: str
    path: Path | None
    tried: tuple[Path, ...] = ()
    near: Path | None = None
    owner: Path | None = None

    @property
    def is_remote(self) -> bool:
        return self.scheme in REMOTE_SCHEMES

    @property
    def is_searched_for(self) -> bool:
        """Does the place depend on search paths, which another computer may have set otherwise?"""
        return self.scheme in {"model", "package"}


def locate(document: Document, uri: str) -> Location:
    """Find what a URI in a document names; nothing is fetched, nothing is read."""
    text = uri.strip()
    match = _SCHEME.match(text)
    scheme = match[1].lower() if match else ""
    if scheme in REMOTE_SCHEMES:
        return Location(scheme, None)
    rest = text[match.end() :] if match else text
    if scheme == "file":
        rest = text[len("file://") :] if text[:7].lower() == "file://" else text[len("file:") :]
        return _first(scheme, [_folder(document) / rest])
    if scheme in {"model", "package"}:
        name, _, inside = rest.partition("/")
        owners = list(_models(document, name) if scheme == "model" else _packages(document, name))
        found = _first(scheme, [owner / inside if inside else owner for owner in owners])
        existing = next((owner for owner in owners if owner.is_dir()), None)
        return found._replace(owner=existing)
    if scheme:
        return Location(scheme, None)
    name, _, inside = rest.partition("/")
    return _first("", [_folder(document) / rest, *(folder / inside for folder in _models(document, name))])


def _first(scheme: str, candidates: list[Path]) -> Location:
    for path in candidates:
        if path.exists():
            return Location(scheme, path)
    near = next((found for path in candidates if (found := _ignoring_case(path)) is not None), None)
    return Location(scheme, None, tuple(dict.fromkeys(candidates)), near)


def _folder(document: Document) -> Path:
    return document.path.parent


def _model_folders(document: Document) -> Iterator[Path]:
    if document.library is not None:
        yield from document.library.search.model_folders


def _models(document: Document, name: str) -> Iterator[Path]:
    for folder in _model_folders(document):
        yield folder / name
    # The usual layout needs no setting: models side by side, or in a `models` folder near by.
    for folder in _above(document):
        yield folder / name
        yield folder / "models" / name


def _packages(document: Document, name: str) -> Iterator[Path]:
    if document.library is not None:
        search = document.library.search
        yield from (path for package, path in search.packages if package == name)
        yield from (folder / name for folder in search.packages_in)
    for folder in _above(document):
        if folder.name == name:
            yield folder
        yield folder / name


def _above(document: Document) -> list[Path]:
    folder = Path(os.path.abspath(_folder(document)))  # noqa: PTH100 - resolve() would follow links
    return [folder, *folder.parents][:_CLIMB]


def _ignoring_case(path: Path) -> Path | None:
    """A path that exists and differs from this one only in the case of letters."""
    path = Path(os.path.normpath(path))
    missing: list[str] = []
    at = path
    while not at.exists():
        if at.parent == at:
            return None
        missing.insert(0, at.name)
        at = at.parent
    for name in missing:
        if not at.is_dir():
            return None
        at_name = next((entry for entry in sorted(os.listdir(at)) if entry.lower() == name.lower()), None)  # noqa: PTH208
        if at_name is None:
            return None
        at = at / at_name
    return at
