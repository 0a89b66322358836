"""Code frames: lines of a file with the places in them underlined."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from sdfcheck.report.colors import Ink, Paint
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.text import Source, Span
from sdfcheck.source.visible import cells, visible

_LONGEST = 120  # characters of a line that are shown
_CONTEXT = 30  # characters kept on either side of a mark in a longer line


class Mark(NamedTuple):
    """A place to underline, what to say of it, and whether it is the defect itself."""

    span: Span
    text: str
    is_primary: bool


class _Stroke(NamedTuple):
    """The part of a mark in its first line: characters ``start`` to ``end`` of that line, at least one."""

    start: int
    end: int
    mark: Mark


class _View(NamedTuple):
    """A line, or the stretch of a long one, that is shown: from character ``start``."""

    text: str
    start: int
    is_cut_before: bool
    is_cut_after: bool


def frame(marks: Iterable[Mark], gutter: int, paint: Paint, ink: Ink) -> Iterator[str]:
    """The lines of one source that hold marks.

    ``ink`` paints the defect; ``gutter`` is the width of the widest line number.
    """
    by_line: dict[int, list[Mark]] = {}
    for mark in sorted(marks, key=lambda mark: (mark.span.start, mark.span.end)):
        by_line.setdefault(mark.span.begin.line, []).append(mark)
    edge = paint(f"{'':{gutter}} |", Ink.GUTTER)
    yield edge
    previous = 0
    for number, on_line in by_line.items():
        source = on_line[0].span.source
        if previous and number == previous + 2:
            yield from _line(source, number - 1, [], gutter, paint, ink)
        elif previous and number > previous + 2:
            yield paint(f"{'':{gutter}} :", Ink.GUTTER)
        yield from _line(source, number, on_line, gutter, paint, ink)
        previous = number


def _line(
    source: Source, number: int, marks: list[Mark], gutter: int, paint: Paint, ink: Ink
) -> Iterator[str]:
    start, end = _bounds(source, number)
    strokes = [_stroke(mark, start, end) for mark in marks]
    for group in _groups(strokes) if end - start > _LONGEST else [strokes]:
        view = _view(source.text, start, end, group)
        shown, columns = cells(view.text)
        before, after = "…" * view.is_cut_before, "…" * view.is_cut_after
        code = f" {before}{shown}{after}".rstrip()
        yield paint(f"{number:>{gutter}} |", Ink.GUTTER) + code
        for row in _rows(group):
            text, column = "", 0
            for stroke in row:
                left, right = _extent(stroke, view, columns)
                text += " " * (left - column) + _underline(stroke.mark, right - left, paint, ink)
                column = right
            yield paint(f"{'':{gutter}} |", Ink.GUTTER) + f" {text}"


def _extent(stroke: _Stroke, view: _View, columns: Sequence[int]) -> tuple[int, int]:
    """The cells to underline, at least one; a stroke that is cut off runs on below the `…`."""
    last = len(columns) - 1
    left, right = (columns[min(at - view.start, last)] for at in (stroke.start, stroke.end))
    if stroke.end - view.start > last and view.is_cut_after:
        right += 1
    return left + view.is_cut_before, max(right, left + 1) + view.is_cut_before


def _underline(mark: Mark, width: int, paint: Paint, ink: Ink) -> str:
    line = ("^" if mark.is_primary else "-") * width
    text = f"{line} {visible(mark.text)}" if mark.text else line
    return paint(text, ink if mark.is_primary else Ink.LABEL)


def _bounds(source: Source, number: int) -> tuple[int, int]:
    """Offsets of a line's text, its line end left out; a line may be the whole file, so it is not copied."""
    starts, text = source.line_starts, source.text
    start = starts[number - 1]
    end = starts[number] if number < len(starts) else len(text)
    while end > start and text[end - 1] in "\r\n":
        end -= 1
    return start, end


def _stroke(mark: Mark, start: int, end: int) -> _Stroke:
    first = min(mark.span.start, end)
    last = min(mark.span.end, end)
    if mark.span.end > end:
        # Spaces before a line end that the span runs over are not worth a line.
        while last > first and mark.span.source.text[last - 1].isspace():
            last -= 1
    return _Stroke(first - start, max(last, first + 1) - start, mark)


def _groups(strokes: list[_Stroke]) -> Iterator[list[_Stroke]]:
    """Strokes of a long line in groups that one view can show."""
    group: list[_Stroke] = []
    for stroke in strokes:
        if group and stroke.end - group[0].start > _LONGEST - 2 * _CONTEXT:
            yield group
            group = []
        group.append(stroke)
    yield group


def _view(text: str, start: int, end: int, strokes: list[_Stroke]) -> _View:
    length = end - start
    furthest = max((stroke.end for stroke in strokes), default=0)
    if length <= _LONGEST or furthest + _CONTEXT <= _LONGEST:
        first = 0
    else:
        first = max(0, min(strokes[0].start - _CONTEXT, length - _LONGEST))
    last = min(first + _LONGEST, length)
    return _View(text[start + first : start + last], first, first > 0, last < length)


def _rows(strokes: list[_Stroke]) -> Iterator[list[_Stroke]]:
    """Strokes in rows: side by side as long as they do not touch and only the last one has a text."""
    row: list[_Stroke] = []
    for stroke in strokes:
        if row and (row[-1].mark.text or stroke.start < row[-1].end):
            yield row
            row = []
        row.append(stroke)
    if row:
        yield row
