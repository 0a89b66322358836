"""Defects of the encoding of a text: apart from the other problems, since every text is decoded."""

from __future__ import annotations

from enum import Enum

from sdfcheck.source.record import Record
from sdfcheck.source.text import Span


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
