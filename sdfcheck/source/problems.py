"""Problems of a text that are found before its meaning is looked at.

Each kind of problem is a small value; rules put it into words.
"""

from __future__ import annotations

from enum import Enum

from sdfcheck.source.decode import EncodingDefect
from sdfcheck.source.record import Record
from sdfcheck.source.text import Span


class SyntaxKind(Enum):
    """The ways in which a text fails to be XML."""

    UNCLOSED_ELEMENT = "unclosed element"
    MISMATCHED_END_TAG = "mismatched end tag"
    EXTRA_END_TAG = "extra end tag"
    MISSING_START_TAG = "missing start tag"
    MISSING_SLASH = "missing slash"
    MISSING_ANGLE = "missing angle"
    TRUNCATED = "truncated"
    UNCLOSED_TAG = "unclosed tag"
    BLANK_IN_TAG = "blank in tag"
    ODD_BLANK = "odd blank"
    CROWDED_END_TAG = "crowded end tag"
    UNCLOSED_COMMENT = "unclosed comment"
    NESTED_COMMENT = "nested comment"
    MISSPELT_MARK = "misspelled mark"
    COMMENT_IN_TAG = "comment in tag"
    UNCLOSED_SECTION = "unclosed section"
    UNCLOSED_VALUE = "unclosed value"
    UNQUOTED_VALUE = "unquoted value"
    CURLY_QUOTES = "curly quotes"
    VALUELESS_ATTRIBUTE = "valueless attribute"
    MISSING_EQUALS = "missing equals"
    MISSING_SPACE = "missing space"
    MALFORMED_ATTRIBUTE = "malformed attribute"
    MALFORMED_NAME = "malformed name"
    ANGLE_IN_VALUE = "angle in value"
    STRAY_ANGLE = "stray angle"
    SECTION_END_IN_TEXT = "section end in text"
    ILLEGAL_CHARACTER = "illegal character"
    MERGE_CONFLICT = "merge conflict"
    TEXT_OUTSIDE_ROOT = "text outside root"
    MALFORMED_INSTRUCTION = "malformed instruction"
    ODD_VERSION = "odd version"
    SECOND_DECLARATION = "second declaration"
    NO_ELEMENT = "no element"
    TOO_LONG = "too long"
    TOO_MANY = "too many attributes"
    OTHER = "other"


class SyntaxDefect(Record):
    """Not well formed beyond a harmless misspelling.

    ``other`` is the second place that takes part. ``detail`` is the name that is
    concerned: of the element (what an end tag should say, where one is wrong) or of the
    attribute; else what else there is to say.
    """

    span: Span
    kind: SyntaxKind
    other: Span | None = None
    detail: str = ""


class CommentHyphens(Record):
    """``--`` inside a comment; ``runs`` are all runs of hyphens in it, and one that it ends with."""

    span: Span
    runs: tuple[Span, ...]


class RepeatedAttribute(Record):
    """One attribute name twice in a start tag."""

    span: Span
    first: Span


class LateDeclaration(Record):
    """Something is before ``<?xml``: ``span`` is that something."""

    span: Span
    declaration: Span


class UnknownEntity(Record):
    """A bare ``&`` (then ``name`` is empty) or a reference to an entity that XML does not define."""

    span: Span
    name: str


class DocumentType(Record):
    """A document type declaration, and the names of the entities that it declares."""

    span: Span
    entities: tuple[str, ...]


class ContentAfterRoot(Record):
    """A second root element, an end tag too many, or text, after the root element ``root``."""

    span: Span
    root: Span


class UnrecognizedDocument(Record):
    """A document of no kind that is linted; ``looks_like`` says what it seems to be.

    ``root`` is the name of the root element where that is all that can be said, and
    ``suggestion`` what it was probably meant to be; ``end`` is the name in its end tag.
    """

    span: Span
    looks_like: str
    root: str | None
    suggestion: str | None
    end: Span | None = None


class TooDeep(Record):
    """Elements nested deeper than ``limit``; ``span`` is the first one past it."""

    span: Span
    limit: int


Problem = (
    SyntaxDefect
    | CommentHyphens
    | RepeatedAttribute
    | LateDeclaration
    | EncodingDefect
    | UnknownEntity
    | DocumentType
    | ContentAfterRoot
    | UnrecognizedDocument
    | TooDeep
)
