"""``--`` inside comments: XML forbids it, simulators accept it, and command lines contain it often."""

from __future__ import annotations

import re

from sdfcheck.source.problems import CommentHyphens
from sdfcheck.source.text import Source

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
