"""The pieces of a text: tags, texts, comments and the rest."""

from __future__ import annotations

from enum import Enum

from sdfcheck.source.problems import Problem
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.scanner.misspelt_ends import line_end
from sdfcheck.source.scanner.start_tag import StartTag

DEFECT_LIMIT = 50
"""After so many fixes, users run the program again."""


class TokenKind(Enum):
    START = "start tag"
    EMPTY = "empty element"
    END = "end tag"
    TEXT = "text"
    SECTION = "CDATA section"
    COMMENT = "comment"
    DECLARATION = "XML declaration"
    OTHER = "instruction or document type"


class Token(NamedTuple):
    """A piece of the text. ``tag`` is there for a start tag that is not well formed."""

    kind: TokenKind
    start: int
    end: int
    name: str = ""
    tag: StartTag | None = None


class Tokens(NamedTuple):
    """The pieces that are not blank, in order.

    ``doubtful`` are ranges whose reading is a guess; ``entities`` are the names that a document type
    declares; ``odd_ends`` are the starts of end tags that are not well formed. ``cut``: the text breaks
    off inside a piece, and ``problems`` say so.
    """

    pieces: list[Token]
    problems: list[Problem]
    doubtful: list[tuple[int, int]]
    entities: tuple[str, ...]
    odd_ends: frozenset[int]
    cut: bool


def name_range(token: Token, text: str) -> tuple[int, int]:
    """Offsets of the name in a tag; of all of the tag if it has none."""
    if token.tag is not None:
        return token.tag.name_start, token.tag.name_end
    if not token.name:
        return token.start, token.end
    start = text.find(token.name, token.start, token.end)
    return start, start + len(token.name)


def first_line(token: Token, text: str) -> tuple[int, int]:
    """The first line of a text that is not blank."""
    content = text[token.start : token.end]
    start = token.start + len(content) - len(content.lstrip(" \t\r\n"))
    end = line_end(text, start, token.end)
    return start, start + len(text[start:end].rstrip())
