"""Bytes to text, as forgiving as the simulators and as exact as an editor needs."""

from __future__ import annotations

import codecs
from enum import Enum
from pathlib import Path

from sdfcheck.source.record import NamedTuple, Record
from sdfcheck.source.text import Source, Span, pattern


class EncodingKind(Enum):
    UNDECODABLE = "undecodable"
    UNKNOWN_ENCODING = "unknown encoding"
    DISAGREEMENT = "disagreement"
    WIDE = "wide"


class EncodingDefect(Record):
    """The bytes are not what the declaration (or XML's default, UTF-8) says.

    ``actual`` is what they seem to be; empty if that cannot be determined.
    """

    span: Span
    kind: EncodingKind
    declared: str
    actual: str


_DECLARATION = pattern(r"""\s*<\?xml\s[^>]*?encoding\s*=\s*(["'])([A-Za-z][A-Za-z0-9._-]*)\1""")
# Longer marks first: UTF-32's little-endian mark begins with UTF-16's.
_MARKS = (
    (codecs.BOM_UTF8, "utf-8"),
    (codecs.BOM_UTF32_LE, "utf-32-le"),
    (codecs.BOM_UTF32_BE, "utf-32-be"),
    (codecs.BOM_UTF16_LE, "utf-16-le"),
    (codecs.BOM_UTF16_BE, "utf-16-be"),
)
# Without a mark; a text begins with a tag.
_WIDE_STARTS = (
    (b"<\0\0\0", "utf-32-le"),
    (b"\0\0\0<", "utf-32-be"),
    (b"<\0", "utf-16-le"),
    (b"\0<", "utf-16-be"),
)
# Python knows text encodings that no XML file means (punycode, unicode_escape, …).
_PLAUSIBLE = pattern(r"utf-|ascii|iso8859|latin|cp\d|windows|koi8|shift_jis|euc_|gb|big5|mac-roman|iso2022")


def _as_latin1(error: UnicodeError) -> tuple[str, int]:
    """Decode only the bytes that are not UTF-8 as Latin-1, as old files need."""
    if not isinstance(error, UnicodeDecodeError):
        raise error
    return error.object[error.start : error.end].decode("latin-1"), error.end


codecs.register_error("sdfcheck-latin-1", _as_latin1)


class Encoding(NamedTuple):
    """How the bytes of a file spell characters.

    ``kind`` says what is wrong with the declaration, if anything is.
    """

    mark: bytes
    """The byte order mark that they begin with."""
    codec: str
    declared: str = ""
    place: tuple[int, int] = (0, 0)
    """Where the name of the encoding is in the declaration."""
    kind: EncodingKind | None = None


def encoding_of(data: bytes) -> Encoding:
    """The encoding to read a file's bytes with."""
    mark, marked = next(((m, name) for m, name in _MARKS if data.startswith(m)), (b"", ""))
    wide = marked if marked != "utf-8" else ""
    wide = wide or next((name for start, name in _WIDE_STARTS if data.startswith(start)), "")
    if wide:
        return Encoding(mark, wide, kind=EncodingKind.WIDE)
    declaration = _DECLARATION.match(data[len(mark) : len(mark) + 400].decode("latin-1"))
    if not declaration:
        return Encoding(mark, "utf-8")
    codec, kind = _choose(declaration[2], data[len(mark) :], bool(mark))
    return Encoding(mark, codec, declaration[2], declaration.span(2), kind)


def decode(data: bytes, path: Path) -> tuple[Source, list[EncodingDefect]]:
    """Decode a file's bytes; whatever they hold, there is a text, and a defect where it is a guess."""
    mark, codec, declared, place, kind = encoding_of(data)
    data = data[len(mark) :]
    if kind is EncodingKind.WIDE:
        source = Source(path, data.decode(codec, "replace").lstrip("\ufeff"))
        family = codec[:6].upper()
        return source, [EncodingDefect(source.span(0, 1), EncodingKind.WIDE, family, family)]
    try:
        text, bad = data.decode(codec), -1
    except UnicodeDecodeError as error:
        bad = len(data[: error.start].decode(codec, "replace"))
        text = data.decode(codec, "sdfcheck-latin-1" if codec == "utf-8" else "replace")
    source = Source(path, text)
    defects = []
    if kind:
        defects.append(EncodingDefect(source.span(*place), kind, declared, "UTF-8"))
    elif bad >= 0:
        guess = "Latin-1" if codec == "utf-8" else ""
        defects.append(
            EncodingDefect(source.span(bad, bad + 1), EncodingKind.UNDECODABLE, declared or "UTF-8", guess)
        )
    return source, defects


def _choose(declared: str, data: bytes, marked_utf8: bool) -> tuple[str, EncodingKind | None]:
    """The encoding to read with, and what is wrong with the declaration."""
    try:
        name = codecs.lookup(declared).name
    except LookupError:
        return "utf-8", EncodingKind.UNKNOWN_ENCODING
    if not _PLAUSIBLE.match(name) or name == "utf-7":
        return "utf-8", EncodingKind.UNKNOWN_ENCODING
    # The declaration was legible as ASCII, so the text cannot be in a wide encoding.
    if name.startswith(("utf-16", "utf-32")) or (marked_utf8 and name not in {"utf-8", "ascii"}):
        return "utf-8", EncodingKind.DISAGREEMENT
    if name == "ascii" and not data.isascii():
        return "utf-8", EncodingKind.DISAGREEMENT
    return ("utf-8" if name == "ascii" else name), None


# The limits of what is read of a text.

DEPTH_LIMIT = 256
"""How deep elements may be nested. libxml2 stops there; tinyxml2, which libsdformat uses, ends at 500."""

ATTRIBUTE_LIMIT = 1000
"""The most attributes of an element that are read."""

LENGTH_LIMIT = 10_000_000
"""The longest text or value, in characters: libxml2's bound, which consumers in Python have."""
