"""One diagnostic as people read it: heading, lines of code with the places underlined, remarks."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path

from sdfcheck.lint.diagnostic import Diagnostic
from sdfcheck.report.colors import INK_OF, Ink, Paint, linked
from sdfcheck.report.paths import Paths
from sdfcheck.report.table import wrapped
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.text import Source, Span
from sdfcheck.source.visible import cells, visible, width_of

# Code frames: lines of a file with the places in them underlined.

_LONGEST = 120  # cells of a line that are shown
_LEAST = 24  # on however narrow a terminal
_CONTEXT = 30  # characters kept on either side of a mark in a longer line, at most


_BESIDE = 4  # characters before a mark that wide ones do not push out


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


class _Look(NamedTuple):
    """How lines are drawn: ``code`` cells for one, after a gutter; ``is_narrow``: labels have to fit, too."""

    gutter: int
    paint: Paint
    ink: Ink
    code: int
    is_narrow: bool

    @property
    def context(self) -> int:
        return min(_CONTEXT, self.code // 4)


def frame(
    marks: Iterable[Mark], gutter: int, paint: Paint, ink: Ink, width: int | None = None
) -> Iterator[str]:
    """The lines of one source that hold marks.

    ``ink`` paints the defect; ``gutter`` is the width of the widest line number; ``width``
    is the number of cells of the terminal, if there is one.
    """
    look = _Look(gutter, paint, ink, _LONGEST, is_narrow=False)
    if width is not None:
        look = look._replace(code=max(min(_LONGEST, width - gutter - len(" | ") - 2), _LEAST), is_narrow=True)
    by_line: dict[int, list[Mark]] = {}
    for mark in sorted(marks, key=lambda mark: (mark.span.start, mark.span.end)):
        if not mark.span.source.is_foreign:
            by_line.setdefault(mark.span.begin.line, []).append(mark)
    if not by_line:
        return
    edge = paint(f"{'':{gutter}} |", Ink.GUTTER)
    yield edge
    previous = 0
    for number, on_line in by_line.items():
        source = on_line[0].span.source
        if previous and number == previous + 2:
            yield from _line(source, number - 1, [], look)
        elif previous and number > previous + 2:
            yield paint(f"{'':{gutter}} :", Ink.GUTTER)
        yield from _line(source, number, on_line, look)
        previous = number


def _line(source: Source, number: int, marks: list[Mark], look: _Look) -> Iterator[str]:
    gutter, paint = look.gutter, look.paint
    start, end = _bounds(source, number)
    strokes = [_stroke(mark, start, end) for mark in marks]
    for group in _groups(strokes, look) if _is_long(source.text, start, end, look) else [strokes]:
        view = _view(source.text, start, end, group, look)
        shown, columns = cells(view.text)
        before, after = "…" * view.is_cut_before, "…" * view.is_cut_after
        code = f" {before}{shown}{after}".rstrip()
        yield paint(f"{number:>{gutter}} |", Ink.GUTTER) + code
        for row in _rows(group):
            for text in _underlines(row, view, columns, look):
                yield paint(f"{'':{gutter}} |", Ink.GUTTER) + f" {text}"


def _extent(stroke: _Stroke, view: _View, columns: Sequence[int]) -> tuple[int, int]:
    """The cells to underline, at least one; a stroke that is cut off runs on below the `…`."""
    last = len(columns) - 1
    left, right = (columns[min(at - view.start, last)] for at in (stroke.start, stroke.end))
    if stroke.end - view.start > last and view.is_cut_after:
        right += 1
    return left + view.is_cut_before, max(right, left + 1) + view.is_cut_before


def _underlines(row: list[_Stroke], view: _View, columns: Sequence[int], look: _Look) -> Iterator[str]:
    """The line below a line of code; what is to be said of the last stroke goes on below that."""
    text, column, label, left, is_beside = "", 0, "", 0, True
    for stroke in row:
        left, right = _extent(stroke, view, columns)
        line = ("^" if stroke.mark.is_primary else "-") * (right - left)
        color = look.ink if stroke.mark.is_primary else Ink.LABEL
        label = visible(stroke.mark.text)
        is_beside = not look.is_narrow or right + 1 + width_of(label) <= look.code + 2
        text += " " * (left - column) + look.paint(f"{line} {label}" if label and is_beside else line, color)
        column = right
    yield text
    if label and not is_beside:
        indent = min(left, max(look.code - width_of(label), 2))
        for part in wrapped(" " * indent + label, look.code, indent):
            yield " " * indent + look.paint(part[indent:], color)


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


def _is_long(text: str, start: int, end: int, look: _Look) -> bool:
    """Whether a line has more cells than there is room for."""
    return end - start > look.code or cells(text[start:end])[1][-1] > look.code


def _groups(strokes: list[_Stroke], look: _Look) -> Iterator[list[_Stroke]]:
    """Strokes of a long line in groups that one view can show."""
    group: list[_Stroke] = []
    for stroke in strokes:
        if group and stroke.end - group[0].start > look.code - 2 * look.context:
            yield group
            group = []
        group.append(stroke)
    yield group


def _view(text: str, start: int, end: int, strokes: list[_Stroke], look: _Look) -> _View:
    length = end - start
    furthest = max((stroke.end for stroke in strokes), default=0)
    if length <= look.code or furthest + look.context <= look.code:
        first = 0
    else:
        first = max(0, min(strokes[0].start - look.context, length - look.code))
    last = min(first + look.code, length)
    first, last = _narrowed(text, start, first, last, strokes, look)
    return _View(text[start + first : start + last], first, first > 0, last < length)


def _narrowed(
    text: str, start: int, first: int, last: int, strokes: list[_Stroke], look: _Look
) -> tuple[int, int]:
    """The stretch of a line without what does not fit, as characters are wide: less before the marks, then after."""
    columns = cells(text[start + first : start + last])[1]
    excess = columns[-1] - look.code
    if excess <= 0:
        return first, last
    kept = min((stroke.start for stroke in strokes), default=first)
    while excess > 0 and first < kept - _BESIDE:
        excess -= columns[1] - columns[0]
        first, columns = first + 1, columns[1:]
    while excess > 0 and last > first + 1:
        excess -= columns[-1] - columns[-2]
        last, columns = last - 1, columns[:-1]
    return first, last


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


class Style(NamedTuple):
    """How diagnostics are shown: names of files, colors, and the cells of the terminal, if there is one."""

    paths: Paths
    paint: Paint
    width: int | None = None


def block(
    diagnostic: Diagnostic, is_explained: bool, style: Style, others: str = "", page: str | None = None
) -> Iterator[str]:
    """The lines of one diagnostic, which may represent ``others``.

    ``is_explained``: there is a rule to read about; ``page``: where its code leads to.
    """
    paths, paint, width = style
    ink = INK_OF[diagnostic.severity]
    frames = list(marks_by_file(diagnostic))
    gutter = len(str(max(mark.span.begin.line for marks in frames for mark in marks)))
    title = paint(f"{diagnostic.severity.value}[{linked(diagnostic.code, page)}]", ink)
    yield title + paint(f": {visible(diagnostic.message)}", Ink.STRONG)
    for number, marks in enumerate(frames):
        arrow, first = (":::", first_of(marks)) if number else ("-->", marks[0])
        label = f": {first.text}" if first.text and first.span.source.is_foreign else ""
        yield f"{'':{gutter}}{paint(arrow, Ink.GUTTER)} {visible(paths.place(first.span) + label)}"
        yield from frame(marks, gutter, paint, ink, width)
    remarks = list(_remarks(diagnostic, paths))
    if others:
        remarks.append(("and", others))
    if is_explained:
        remarks.append(("more", f"sdfcheck rule {diagnostic.name}"))
    yield from _notes(remarks, f"{'':{gutter}} ", paint)


def marks_by_file(diagnostic: Diagnostic) -> Iterator[list[Mark]]:
    """The marks, file by file; the defect is the first mark of the first file."""
    primary = Mark(diagnostic.span, "", True)
    by_file = {_file(primary.span): [primary]}
    for label in diagnostic.labels:
        by_file.setdefault(_file(label.span), []).append(Mark(label.span, label.text, False))
    yield from by_file.values()


def first_of(marks: Iterable[Mark]) -> Mark:
    """The mark that is first in its file."""
    return min(marks, key=lambda mark: mark.span.start)


def _file(span: Span) -> tuple[Path, str]:
    """A file may have been read twice, and have changed in between."""
    return span.source.path, span.source.text


def _remarks(diagnostic: Diagnostic, paths: Paths) -> Iterator[tuple[str, str]]:
    if diagnostic.fix is not None:
        yield "help", f"{diagnostic.fix.title} ({diagnostic.fix.applicability.value} fix)"
    if diagnostic.help:
        yield "help", diagnostic.help
    for origin in diagnostic.origins:
        yield "note", f"{origin.text}: {paths.place(origin.span)}"


def _notes(remarks: Iterable[tuple[str, str]], indent: str, paint: Paint) -> Iterator[str]:
    """The lines below the frames."""
    for kind, text in remarks:
        yield f"{indent}{paint('=', Ink.GUTTER)} {paint(f'{kind}:', Ink.STRONG)} {visible(text)}"
