"""Where comments and sections were meant to end, when their end is missing or misspelt."""

from __future__ import annotations

import re
from typing import NamedTuple

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


def comment_end(text: str, begin: int, limit: int | None = None) -> int:
    """Where a comment without ``-->`` before ``limit`` was meant to end: at a misspelt end, or its line's."""
    limit = len(text) if limit is None else limit
    markup = text.find("<", begin, limit)
    if markup < 0:
        markup = limit
    if match := _MISSPELT_COMMENT_END.search(text, begin, markup):
        return match.end()
    proper = text.find("-->", begin, markup)
    if proper >= 0:
        return proper + 3
    following = text.find("<!--", begin, min(limit, begin + _NEAR))
    for match in _MISSPELT_COMMENT_END.finditer(text, markup, following if following >= 0 else begin + _NEAR):
        if _AT_LINE_END.match(text, match.end()):
            return match.end()
    if markup == len(text):
        return markup
    return line_end(text, begin, limit)


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
    # An outer comment without end swallows tags up to the next comment.
    balance = 0
    for tag in _TAG.finditer(text, at + 4, min(inner, at + _NEAR)):
        balance += -1 if tag[1] else not tag[2]
    begins_with_words = text.find("<", at + 4, line_end(text, at, end)) < 0
    if balance < 0 or (balance > 0 and begins_with_words):
        return InnerComment(inner, True, end)
    return None


def section_end(text: str, begin: int) -> int:
    """Where a CDATA section without ``]]>`` was meant to end: at a misspelt end, or before an end tag."""
    limit = text.find("</", begin)
    if limit < 0:
        limit = len(text)
    match = _MISSPELT_SECTION_END.search(text, begin, limit)
    return match.end() if match else limit
