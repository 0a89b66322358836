"""From a URI in a description to a file on disk.

Schemes: ``model://name/…`` (a model in one of the model folders), ``package://name/…``
(a ROS package), ``file://…``, none (relative to the referring file), and what comes
from the network, which is never fetched.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Mapping
from pathlib import Path

from sdfcheck.source.document import Document
from sdfcheck.source.record import NamedTuple

_SCHEME = re.compile(r"([A-Za-z][A-Za-z0-9+.\-]+):/*")
REMOTE_SCHEMES = frozenset({"http", "https", "fuel", "ftp"})
SEARCHED_SCHEMES = frozenset({"model", "package"})
LOCAL_SCHEMES = frozenset({"file", *SEARCHED_SCHEMES})

_CLIMB = 6
"""How many folders above the referring file may hold the model or package that it names."""


class Location(NamedTuple):
    """Where a URI leads.

    ``path`` is the file or folder, None if nothing is there. ``tried`` are the paths
    that were looked at, ``near`` one that differs only in case. ``name`` is the model or
    package that is named, ``owner`` its folder if that was found, though not the file in it.
    """

    scheme: str
    path: Path | None
    tried: tuple[Path, ...] = ()
    near: Path | None = None
    name: str = ""
    owner: Path | None = None

    @property
    def is_remote(self) -> bool:
        return self.scheme in REMOTE_SCHEMES

    @property
    def is_searched_for(self) -> bool:
        """Does the place depend on search paths, which another computer may have set otherwise?"""
        return self.scheme in SEARCHED_SCHEMES

    @property
    def is_local(self) -> bool:
        """Is the scheme one that leads to a file, none included?"""
        return not self.scheme or self.scheme in LOCAL_SCHEMES


def scheme_of(uri: str) -> str:
    """The scheme in lower case, empty if there is none; the letter of a Windows drive is none."""
    match = _SCHEME.match(uri.strip())
    return match[1].lower() if match else ""


def locate(document: Document, uri: str) -> Location:
    """Find what a URI in a document names; nothing is fetched, nothing is read.

    Each URI of a document is looked up once.
    """
    known = document.view(_Located)
    found = known.get(uri)
    if found is None:
        found = known[uri] = _locate(document, uri.strip())
    return found


class _Located(dict[str, Location]):
    def __init__(self, document: Document) -> None:
        super().__init__()


def _locate(document: Document, text: str) -> Location:
    match = _SCHEME.match(text)
    scheme = match[1].lower() if match else ""
    if scheme and scheme not in LOCAL_SCHEMES:
        return Location(scheme, None)
    listings = document.view(_Listings)
    rest = text[match.end() :] if match else text
    folder = document.path.parent
    if scheme == "file":
        return _first(listings, scheme, [folder / file_path(text)])
    name, _, inside = rest.partition("/")
    if scheme:
        owners = _owners(document, scheme, name)
        inner = [owner / inside if inside else owner for owner in owners.there or owners.near]
        found = _first(listings, scheme, inner)
        if not owners.there:
            # Only the case of letters can be wrong then.
            near = found.path or found.near
            return Location(scheme, None, tuple(owner / inside for owner in owners.tried), near, name)
        return found._replace(name=name, owner=owners.there[0])
    return _first(listings, "", [folder / rest, *(models / inside for models in _models(document, name))])


class _Owners(NamedTuple):
    """Where the folder of a model or package was looked for, where it is, and where it is but for case."""

    tried: tuple[Path, ...]
    there: tuple[Path, ...]
    near: tuple[Path, ...]


class _KnownOwners(dict[tuple[str, str], _Owners]):
    def __init__(self, document: Document) -> None:
        super().__init__()


def _owners(document: Document, scheme: str, name: str) -> _Owners:
    """The folders of a model or package, looked up once for each document."""
    known = document.view(_KnownOwners)
    if (scheme, name) not in known:
        candidates = _models(document, name) if scheme == "model" else _packages(document, name)
        tried = tuple(dict.fromkeys(Path(os.path.normpath(path)) for path in candidates))
        there = tuple(path for path in tried if os.path.isdir(path))
        listings = document.view(_Listings)
        near = () if there else tuple(found for path in tried if (found := _ignoring_case(path, listings)))
        known[scheme, name] = _Owners(tried, there, near)
    return known[scheme, name]


def file_path(uri: str) -> str:
    """The path behind ``file://``, as libsdformat and Gazebo cut it; a host is taken for a folder."""
    rest = uri.strip()[len("file:") :]
    return rest[2:] if rest[:2] == "//" else rest


def _first(listings: _Listings, scheme: str, candidates: list[Path]) -> Location:
    for path in candidates:
        if os.path.exists(path):
            return Location(scheme, path)
    tried = tuple(dict.fromkeys(Path(os.path.normpath(path)) for path in candidates))
    near = next((found for path in tried if (found := _ignoring_case(path, listings)) is not None), None)
    return Location(scheme, None, tried, near)


def _models(document: Document, name: str) -> Iterator[Path]:
    if document.library is not None:
        for folder in document.library.model_folders:
            yield folder / name
    # The usual layout needs no setting: models side by side, or in a `models` folder near by.
    for folder in _above(document):
        yield folder / name
        yield folder / "models" / name


def _packages(document: Document, name: str) -> Iterator[Path]:
    if document.library is not None:
        found = document.library.packages(document.path).find(name)
        if found is not None:
            yield found
    for folder in _above(document):
        if folder.name == name:
            yield folder
        yield folder / name


def _above(document: Document) -> list[Path]:
    """The folder of the document and those above it, up to where everybody's files begin."""
    folder = Path(os.path.abspath(document.path.parent))  # resolve() would follow links
    home = Path(os.path.expanduser("~"))
    shared = {home, *home.parents, Path(folder.anchor)} - {folder}
    return [above for above in (folder, *folder.parents)[:_CLIMB] if above not in shared]


class _Listings(dict[Path, Mapping[str, str]]):
    """What folders hold: names in lower case → names; none for what is no folder. Each is read once."""

    def __init__(self, document: Document) -> None:
        super().__init__()

    def __missing__(self, folder: Path) -> Mapping[str, str]:
        try:
            names = sorted(os.listdir(folder), reverse=True)
        except OSError:
            names = []
        listed = self[folder] = {name.lower(): name for name in names}
        return listed


def _ignoring_case(path: Path, listings: _Listings) -> Path | None:
    """A path that exists and differs from this one only in the case of letters."""
    missing: list[str] = []
    at = path
    while not os.path.exists(at):
        if at.parent == at:
            return None
        missing.insert(0, at.name)
        at = at.parent
    for name in missing:
        same = listings[at].get(name.lower())
        if same is None:
            return None
        at = at / same
    return at if os.path.exists(at) else None
