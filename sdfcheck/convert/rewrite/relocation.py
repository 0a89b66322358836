"""Files that were found beside an included file, as found from the file that includes it."""

from __future__ import annotations

from pathlib import Path

from sdfcheck.files.uris import locate, scheme_of
from sdfcheck.robot.includes.included import Included
from sdfcheck.source.document import Document
from sdfcheck.source.relative import relative_path

_FILES = frozenset(("diffuse", "environment_map", "filename", "light_map", "normal", "uri"))


def relocated(name: str, text: str, found: Included, document: Document) -> str | None:
    """The new content of an element of that name; None if it can stay."""
    assert found.document is not None
    if name not in _FILES and not name.endswith("_map"):
        return None
    folder = found.document.path.parent
    if not text or scheme_of(text) or Path(text).is_absolute() or not (folder / text).exists():
        return None
    return _seen_from(document, found, folder / text)


def _seen_from(document: Document, found: Included, file: Path) -> str:
    assert found.uri is not None
    uri = found.uri.text.strip()
    place = locate(document, uri).path
    if scheme_of(uri) in {"model", "package"} and place is not None:
        if place.is_dir():
            return f"{uri.rstrip('/')}/{Path(relative_path(file, place)).as_posix()}"
        if file.is_relative_to(place.parent):
            return f"{uri.rpartition('/')[0]}/{file.relative_to(place.parent).as_posix()}"
    return Path(relative_path(file, document.path.parent)).as_posix()
