"""``--`` inside comments: XML forbids it, simulators accept it, and command lines contain it often."""

from __future__ import annotations

import re

from sdfcheck.source.problems import CommentHyphens
from sdfcheck.source.text import Source

_RUN = re.compile(r"-{2,}")


def hyphens(source: Source, at: int, end: int) -> CommentHyphens | None:
    """The fault of the hyphens in the comment from ``at`` to ``end``; None if they are allowed."""
    text = source.text
    runs = tuple(source.span(match.start(), match.end()) for match in _RUN.finditer(text, at + 4, end - 3))
    if not runs and text[end - 4] == "-" and end - 4 >= at + 4:
        runs = (source.span(end - 4, end - 1),)
    return CommentHyphens(runs[0], runs) if runs else None


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
            pieces += text[done : at + 4], _spaced(text[at + 4 : end])
            done = end
        at = text.find("<!--", end)
    return ("".join((*pieces, text[done:])), found) if found else None


def _spaced(content: str) -> str:
    spaced = _RUN.sub(lambda run: " ".join(run[0]), content)
    return f"{spaced} " if spaced.endswith("-") else spaced
