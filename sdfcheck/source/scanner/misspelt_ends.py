"""Where comments and sections were meant to end, when their end is missing or misspelled."""

from __future__ import annotations

import re

from sdfcheck.source.record import NamedTuple

_LINE = re.compile(r"[^\r\n]*")
_MISSPELT_COMMENT_END = re.compile(r"(?:--!>|--\s{1,80}>|(?<!-)->)")
_AT_LINE_END = re.compile(r"[ \t]*(?:[\r\n]|\Z)")
_MISSPELT_SECTION_END = re.compile(r"\]\s{0,80}\]?\s{0,80}>|\]\]")
_TAG = re.compile(r"<(/?)[A-Za-z_][^<>]*?(/?)>")

_NEAR = 20_000
"""How far the end of something is looked for; farther away it would be a guess."""


class InnerComment(NamedTuple):
    """A ``<!--`` inside a comment.

    ``unclosed``: the outer comment lacks its end. Otherwise somebody has nested the two,
    and what was meant to be comment ends at ``rest_end``.
    """

    start: int
    unclosed: bool
    rest_end: int


def line_end(text: str, at: int, limit: int | None = None) -> int:
    """The offset of the end of the line, at most ``limit``."""
    match = _LINE.match(text, at, len(text) if limit is None else limit)
    assert match
    return match.end()


class CommentEnd(NamedTuple):
    """Where a comment was meant to end; from ``misspelt`` on (-1: nowhere) is what was to end it."""

    end: int
    misspelt: int = -1


def comment_end(text: str, begin: int, limit: int | None = None) -> CommentEnd:
    """Where a comment without ``-->`` before ``limit`` was meant to end: at a misspelled end, or after its words."""
    limit = len(text) if limit is None else limit
    markup = text.find("<", begin, limit)
    if markup < 0:
        markup = limit
    proper = text.find("-->", begin, markup)
    if proper >= 0:
        return CommentEnd(proper + 3)
    if match := _MISSPELT_COMMENT_END.search(text, begin, markup):
        return CommentEnd(match.end(), match.start())
    following = text.find("<!--", begin, min(limit, begin + _NEAR))
    for match in _MISSPELT_COMMENT_END.finditer(text, markup, following if following >= 0 else begin + _NEAR):
        if _AT_LINE_END.match(text, match.end()):
            return CommentEnd(match.end(), match.start())
    if markup == len(text):
        return CommentEnd(markup)
    # Words up to the next markup, or markup that the comment was to hide.
    end = line_end(text, begin, limit)
    return CommentEnd(begin + len(text[begin:markup].rstrip()) if end < markup else end)


def find_inner_comment(text: str, at: int, end: int) -> InnerComment | None:
    """The comment from ``at`` to ``end`` holds another's beginning: why?

    None: no harm done, it is just there.
    """
    inner = text.find("<!--", at + 4, end - 3)
    if inner < 0:
        return None
    following = text.find("<!--", end, end + _NEAR)
    leftover = text.find("-->", end, following if following >= 0 else end + _NEAR)
    if leftover >= 0:
        return InnerComment(inner, False, leftover + 3)
    # An outer comment without end swallows what is between its words and the next comment.
    markup = text.find("<", at + 4)
    if text[at + 4 : markup].strip() and line_end(text, at, markup) < markup < inner:
        return InnerComment(inner, True, end)
    balance = 0
    for tag in _TAG.finditer(text, at + 4, min(inner, at + _NEAR)):
        balance += -1 if tag[1] else not tag[2]
    return InnerComment(inner, True, end) if balance < 0 else None


def section_end(text: str, begin: int) -> int:
    """Where a CDATA section without ``]]>`` was meant to end: at a misspelled end, or before an end tag."""
    limit = text.find("</", begin)
    if limit < 0:
        limit = len(text)
    match = _MISSPELT_SECTION_END.search(text, begin, limit)
    return match.end() if match else limit
