"""Slips in URIs, told from the text alone or by what lies on disk."""

from __future__ import annotations

import re
from collections.abc import Iterator

from sdfcheck.files.uris import LOCAL_SCHEMES, REMOTE_SCHEMES, SEARCHED_SCHEMES, Location
from sdfcheck.formats.suggest import suggest
from sdfcheck.robot.file_problems import AbsolutePath, MalformedUri, UriFault, WrongCase
from sdfcheck.source.element import Value

_SCHEMES = sorted(LOCAL_SCHEMES | REMOTE_SCHEMES)
_PARTS = re.compile(r"([A-Za-z][A-Za-z0-9+.\-]+):([/\\]*)(.*)", re.DOTALL)
_DRIVE = re.compile(r"(?:file:/*)?[A-Za-z]:[/\\]")
_BLANKS = re.compile(r"(?<!\s)(?:\s*/\s+|\s+/\s*)")


def malformed(value: Value) -> MalformedUri | None:
    """What is wrong with a URI whatever it leads to."""
    text = value.text.strip()
    if _DRIVE.match(text):
        return None
    if "\\" in text:
        return MalformedUri(value, UriFault.BACKSLASH, _with_slashes(text))
    match = _PARTS.match(text)
    if match is not None:
        found = _scheme_fault(match[1], match[2], match[3])
        if found is not None:
            return MalformedUri(value, *found)
    if text != value.text:
        return MalformedUri(value, UriFault.BLANK, text)
    return None


def absolute(value: Value) -> AbsolutePath | None:
    """A path that holds on this computer alone, unless an expression in the source makes it."""
    text = value.text.strip()
    is_path = text.startswith("/") or text.lower().startswith("file:///") or _DRIVE.match(text)
    return AbsolutePath(value) if is_path and "$" not in value.span.text else None


def misspelt(value: Value, location: Location) -> MalformedUri | WrongCase | None:
    """A slip that explains why a URI leads nowhere."""
    text = value.text.strip()
    if len(text.split()) > 1 and (tight := _BLANKS.sub("/", text)) != text:
        return MalformedUri(value, UriFault.BLANK, tight)
    if location.near is not None:
        return WrongCase(value, location.near, _recased(text, location))
    return None


def _scheme_fault(scheme: str, slashes: str, rest: str) -> tuple[UriFault, str | None] | None:
    lower = scheme.lower()
    if lower not in _SCHEMES:
        near = suggest(lower, _SCHEMES)
        if near is None or not slashes:
            return None
        return UriFault.UNKNOWN_SCHEME, f"{near}://{rest}"
    if lower in REMOTE_SCHEMES and len(slashes) != 2:
        return UriFault.SLASHES, f"{lower}://{rest}"
    if lower not in SEARCHED_SCHEMES:
        return None
    if not rest.strip("/"):
        return UriFault.NO_NAME, None
    if len(slashes) != 2:
        return UriFault.SLASHES, f"{lower}://{rest}"
    if lower != scheme:
        return UriFault.SCHEME_CASE, f"{lower}://{rest}"
    return None


def _with_slashes(text: str) -> str:
    match = _PARTS.match(text)
    if match is None or match[1].lower() not in _SCHEMES:
        return text.replace("\\", "/")
    slashes = "//" if match[1].lower() in SEARCHED_SCHEMES else match[2].replace("\\", "/")
    return f"{match[1]}:{slashes}{match[3]}".replace("\\", "/")


def _recased(text: str, location: Location) -> str | None:
    """The URI in the letters that the disk has; None where its parts are not those of the path."""
    assert location.near is not None
    start = len(text) - len(re.sub(r"^[A-Za-z][A-Za-z0-9+.\-]+:/*", "", text))
    parts = list(_trailing(text[start:]))
    meant = "/".join(location.near.parts[-len(parts) :])
    written = "/".join(parts)
    return text[: len(text) - len(written)] + meant if written.lower() == meant.lower() else None


def _trailing(path: str) -> Iterator[str]:
    """The parts of a path behind the last ``..``."""
    parts = path.split("/")
    after = max((n for n, part in enumerate(parts) if part in {"..", "."}), default=-1)
    yield from parts[after + 1 :]
