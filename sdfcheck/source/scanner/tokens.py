"""The pieces of a text: tags, texts, comments and the rest."""

from __future__ import annotations

import re
from enum import Enum

from sdfcheck.source.problems import CommentHyphens, Problem
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.scanner.broken_tag import line_end
from sdfcheck.source.scanner.start_tag import StartTag
from sdfcheck.source.text import Source

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
    """Offsets of the name in a tag; of all of the tag if it has none, or is written with another one."""
    if token.tag is not None:
        return token.tag.name_start, token.tag.name_end
    if not token.name:
        return token.start, token.end
    start = text.find(token.name, token.start, token.end)
    return (start, start + len(token.name)) if start >= 0 else (token.start, token.end)


def first_line(token: Token, text: str) -> tuple[int, int]:
    """The first line of a text that is not blank."""
    content = text[token.start : token.end]
    start = token.start + len(content) - len(content.lstrip(" \t\r\n"))
    end = line_end(text, start, token.end)
    return start, start + len(text[start:end].rstrip())


# The steps for the pieces of a text.


class Act(Enum):
    """The outcome of a token."""

    OPEN = "opens an element"
    CLOSE = "closes the innermost element"
    KEEP = "belongs to the innermost element"
    DROP = "is not part of the tree"


class Step(NamedTuple):
    """A token and what becomes of it; ``name`` is that of the element, misspelled or not."""

    act: Act
    token: Token
    number: int
    name: str = ""


class Pairs(NamedTuple):
    """The steps from the root's start tag to its end, and what is wrong; after ``end`` nothing was read."""

    steps: list[Step]
    problems: list[Problem]
    doubtful: list[tuple[int, int]]
    end: int


# ``--`` inside comments: XML forbids it, simulators accept it, and command lines contain it often.

_RUN = re.compile(r"-{2,}")


def hyphens(source: Source, at: int, end: int) -> CommentHyphens | None:
    """The fault of the hyphens in the comment from ``at`` to ``end``; None if they are allowed."""
    begin, close = at + 4, end - 3
    runs = [source.span(*match.span()) for match in _RUN.finditer(source.text, begin, close)]
    if begin < close and source.text[close - 1] == "-" and not (runs and runs[-1].end == close):
        runs.append(source.span(close - 1, close))
    if not runs:
        return None
    first = runs[0]
    return CommentHyphens(source.span(first.start, max(first.end, first.start + 2)), tuple(runs))


def without_hyphens(source: Source) -> tuple[str, list[CommentHyphens]] | None:
    """The text with the runs of hyphens in its comments spaced out, and these runs.

    None where there are none, or where it is not certain what is a comment.
    """
    text = source.text
    if "<![CDATA[" in text:
        return None
    pieces: list[str] = []
    found: list[CommentHyphens] = []
    done = 0
    at = text.find("<!--")
    while at >= 0:
        end = text.find("-->", at + 4)
        if end < 0 or text.find("<!--", at + 4, end) >= 0:
            return None
        problem = hyphens(source, at, end + 3)
        if problem is not None:
            found.append(problem)
            for run in problem.runs:
                pieces += text[done : run.start], " ".join(run.text) + " " * (run.end == end)
                done = run.end
        at = text.find("<!--", end)
    return ("".join((*pieces, text[done:])), found) if found else None
