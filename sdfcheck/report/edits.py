"""A fix as the lines that it changes, with what it takes out of them and puts into them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from sdfcheck.lint.fix import Edit, Fix
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.text import Source
from sdfcheck.source.visible import harmless_document

KEPT, DELETED, INSERTED = "=", "-", "+"
_AROUND = 80
"""Characters that are shown of unchanged text beside a change."""
_LONGEST = 2000
"""Characters that are shown of what a change takes out or puts in."""


class Hunk(NamedTuple):
    """Lines from number ``line`` on, in pieces: each with its kind, in the order of the text."""

    line: int
    pieces: tuple[tuple[str, str], ...]


def hunks(fix: Fix) -> Iterator[Hunk]:
    """The changed lines; changes that share a line are shown together."""
    group: list[Edit] = []
    end = -1
    for edit in sorted(fix.edits, key=lambda edit: (edit.span.start, edit.span.end)):
        if group and edit.span.start > end:
            yield _hunk(group)
            group = []
        group.append(edit)
        end = _line_end(edit.span.source, edit.span.end)
    if group:
        yield _hunk(group)


def _hunk(edits: list[Edit]) -> Hunk:
    line = edits[0].span.begin.line
    return Hunk(line, tuple((kind, shown) for kind, text in _pieces(edits, line) if (shown := _shown(text))))


def _pieces(edits: Iterable[Edit], line: int) -> Iterator[tuple[str, str]]:
    edits = list(edits)
    source = edits[0].span.source
    at = source.line_starts[line - 1]
    for number, edit in enumerate(edits):
        yield KEPT, _between(source.text[at : edit.span.start], is_first=number == 0)
        yield DELETED, _cut(source.text[edit.span.start : edit.span.end])
        yield INSERTED, _cut(edit.text)
        at = max(at, edit.span.end)
    rest = source.text[at : _line_end(source, at)]
    yield KEPT, rest if len(rest) <= _AROUND else f"{rest[:_AROUND]}…"


def _between(text: str, *, is_first: bool) -> str:
    """Unchanged text before a change; the first one has no other change before it."""
    if is_first:
        return text if len(text) <= _AROUND else f"…{text[-_AROUND:]}"
    return text if len(text) <= 2 * _AROUND else f"{text[:_AROUND]}…{text[-_AROUND:]}"


def _cut(text: str) -> str:
    return text if len(text) <= _LONGEST else f"{text[:_LONGEST]}…"


def _shown(text: str) -> str:
    return harmless_document(text.replace("\r\n", "\n"))


def _line_end(source: Source, offset: int) -> int:
    """Where the line of an offset ends, its line end left out."""
    ends = [found for mark in "\r\n" if (found := source.text.find(mark, offset)) >= 0]
    return min(ends, default=len(source.text))
