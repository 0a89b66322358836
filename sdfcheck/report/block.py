"""One diagnostic as people read it: heading, lines of code, remarks."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path

from sdfcheck.lint.diagnostic import Diagnostic
from sdfcheck.report.colors import INK_OF, Ink, Paint, linked
from sdfcheck.report.frame import Mark, frame
from sdfcheck.report.paths import Paths
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.text import Span
from sdfcheck.source.visible import visible


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
        yield f"{'':{gutter}}{paint(arrow, Ink.GUTTER)} {visible(paths.place(first.span))}"
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
