"""Misspelled URIs: judged by the text alone, or by what is on disk."""

from __future__ import annotations

import re
from collections.abc import Iterator
from enum import Enum
from pathlib import Path

from sdfcheck.files.uris import LOCAL_SCHEMES, REMOTE_SCHEMES, SEARCHED_SCHEMES, Location
from sdfcheck.formats.near_names import suggest
from sdfcheck.source.document import Value
from sdfcheck.source.record import NamedTuple

_SCHEMES = sorted(LOCAL_SCHEMES | REMOTE_SCHEMES)
_PARTS = re.compile(r"([A-Za-z][A-Za-z0-9+.\-]+):([/\\]*)(.*)", re.DOTALL)
_DRIVE = re.compile(r"(?:file:/*)?[A-Za-z]:[/\\]")
_FUEL = re.compile(r"https?://fuel\.(?:gazebosim|ignitionrobotics)\.org/+(?:\d+\.\d+/+)?[^/]+/+([^/]+)/")
_KINDS = ("models", "worlds", "collections")
_BLANKS = re.compile(r"(?<!\s)(?:\s*/\s+|\s+/\s*)")


class UriFault(Enum):
    """The ways in which a text is not a URI, or not the one that is meant."""

    BACKSLASH = "backslash"
    SLASHES = "number of slashes"
    ABSOLUTE = "absolute path"
    SCHEME_CASE = "capital letters"
    UNKNOWN_SCHEME = "unknown scheme"
    NO_NAME = "no name"
    BLANK = "blank"
    FUEL_KIND = "kind of thing on Fuel"


class Misspelling(NamedTuple):
    """The fault of a URI, and the URI that was probably meant."""

    fault: UriFault
    meant: str | None


class OtherCase(NamedTuple):
    """The file that would be found if case did not matter; ``meant`` is the URI of it, if that is clear."""

    path: Path
    meant: str | None


def misspelling(value: Value) -> Misspelling | None:
    """The fault of a URI, whatever it leads to."""
    text = value.text.strip()
    if _DRIVE.match(text):
        return None
    if "\\" in text:
        return Misspelling(UriFault.BACKSLASH, _with_slashes(text))
    fuel = _FUEL.match(text)
    if fuel is not None and fuel[1] not in _KINDS and (near := suggest(fuel[1], _KINDS)) is not None:
        return Misspelling(UriFault.FUEL_KIND, text[: fuel.start(1)] + near + text[fuel.end(1) :])
    match = _PARTS.match(text)
    if match is not None:
        found = _scheme_fault(match[1], match[2], match[3])
        if found is not None:
            # An expression such as `$(find arm)` brings an absolute path.
            is_path = found.fault is UriFault.SLASHES and match[2] == "///" and "$" in value.span.text
            return Misspelling(UriFault.ABSOLUTE, None) if is_path else found
    return Misspelling(UriFault.BLANK, text) if text != value.text else None


def misplaced_blanks(value: Value) -> Misspelling | None:
    """Spaces around slashes: a reason why a URI leads nowhere."""
    text = value.text.strip()
    if len(text.split()) > 1 and (tight := _BLANKS.sub("/", text)) != text:
        return Misspelling(UriFault.BLANK, tight)
    return None


def is_absolute(value: Value) -> bool:
    """Is it a path that holds on this computer alone? A URI that an expression in the source makes
    may be valid elsewhere.
    """
    text = value.text.strip()
    is_path = text.startswith("/") or text.lower().startswith("file:///") or _DRIVE.match(text) is not None
    return is_path and "$" not in value.span.text


def other_case(value: Value, location: Location) -> OtherCase | None:
    """The path at the place of a URI but for the case of letters."""
    if location.near is None:
        return None
    return OtherCase(location.near, _recased(value.text.strip(), location.near))


def _scheme_fault(scheme: str, slashes: str, rest: str) -> Misspelling | None:
    lower = scheme.lower()
    if lower not in _SCHEMES:
        near = suggest(lower, _SCHEMES)
        if near is None or not slashes:
            return None
        return Misspelling(UriFault.UNKNOWN_SCHEME, f"{near}://{rest}")
    if lower in REMOTE_SCHEMES and len(slashes) != 2:
        return Misspelling(UriFault.SLASHES, f"{lower}://{rest}")
    if lower not in SEARCHED_SCHEMES:
        return None
    if not rest.strip("/"):
        return Misspelling(UriFault.NO_NAME, None)
    if len(slashes) != 2 and _names_package(lower, rest):
        return Misspelling(UriFault.SLASHES, f"{lower}://{rest}")
    if lower != scheme:
        return Misspelling(UriFault.SCHEME_CASE, f"{lower}://{rest}")
    return None


def _names_package(scheme: str, rest: str) -> bool:
    """Is it not a file alone, without the package that it is in? That is said of it, then."""
    return scheme != "package" or "/" in rest or "." not in rest


def _with_slashes(text: str) -> str:
    match = _PARTS.match(text)
    if match is None or match[1].lower() not in _SCHEMES:
        return text.replace("\\", "/")
    slashes = "//" if match[1].lower() in SEARCHED_SCHEMES else match[2].replace("\\", "/")
    return f"{match[1]}:{slashes}{match[3]}".replace("\\", "/")


def _recased(text: str, near: Path) -> str | None:
    """The URI in the letters that the disk has; None where its parts are not those of the path."""
    start = len(text) - len(re.sub(r"^[A-Za-z][A-Za-z0-9+.\-]+:/*", "", text))
    parts = list(_trailing(text[start:]))
    meant = "/".join(near.parts[-len(parts) :])
    written = "/".join(parts)
    return text[: len(text) - len(written)] + meant if written.lower() == meant.lower() else None


def _trailing(path: str) -> Iterator[str]:
    """The parts of a path after the last ``..``."""
    parts = path.split("/")
    after = max((n for n, part in enumerate(parts) if part in {"..", "."}), default=-1)
    yield from parts[after + 1 :]
