"""A text without what no markup can be made of; all else stays in its place."""

from __future__ import annotations

import re

from sdfcheck.source.problems import Problem, SyntaxDefect, SyntaxKind
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.text import Source

_ILLEGAL = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\ufffe\uffff\ud800-\udfff]+")
_CONFLICT_MARKER = re.compile(r"^(?:<{7}|\|{7}|={7}|>{7})(?: [^\r\n]*)?(?=[\r\n]|\Z)", re.MULTILINE)
_NO_LINE_END = re.compile(r"[^\r\n]")


class Prepared(NamedTuple):
    """``text`` is as long as the source's, with spaces for what was taken out."""

    text: str
    problems: list[Problem]
    doubtful: list[tuple[int, int]]


def prepare(source: Source) -> Prepared:
    """Blank the characters that XML does not know, and the other side of merge conflicts."""
    text = source.text
    problems: list[Problem] = []
    doubtful: list[tuple[int, int]] = []
    if illegal := _ILLEGAL.search(text):
        problems.append(_illegal(source, illegal))
        text = _ILLEGAL.sub(lambda match: " " * len(match[0]), text)
    if "<<<<<<<" in text:
        pieces, copied = [], 0
        for start, other, last, end in _conflicts(text):
            marker = source.span(start, start + 7)
            problems.append(SyntaxDefect(marker, SyntaxKind.MERGE_CONFLICT, source.span(last, last + 7)))
            doubtful.append((start, end))
            line_end = text.index("\n", start) if "\n" in text[start:other] else start + 7
            for blank, blank_end in ((start, line_end), (other, end)):
                pieces += [text[copied:blank], _NO_LINE_END.sub(" ", text[blank:blank_end])]
                copied = blank_end
        text = "".join((*pieces, text[copied:]))
    return Prepared(text, problems, doubtful)


def _conflicts(text: str) -> list[tuple[int, int, int, int]]:
    """Of each merge conflict: its start, that of the other side, and those of its last marker."""
    found = []
    start = other = -1
    for match in _CONFLICT_MARKER.finditer(text):
        mark = match[0][0]
        if mark == "<":
            start, other = match.start(), -1
        elif start >= 0 and other < 0 and mark in "|=":
            other = match.start()
        elif start >= 0 and other >= 0 and mark == ">":
            found.append((start, other, *match.span()))
            start = other = -1
    return found


def _illegal(source: Source, match: re.Match[str]) -> SyntaxDefect:
    count = sum(len(run) for run in _ILLEGAL.findall(source.text))
    detail = f"U+{ord(match[0][0]):04X}" + (f", {count} in all" if count > 1 else "")
    return SyntaxDefect(source.span(*match.span()), SyntaxKind.ILLEGAL_CHARACTER, None, detail)
