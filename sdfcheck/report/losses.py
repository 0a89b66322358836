"""Findings by file and code, one line each: what conversions report."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from sdfcheck.lint.diagnostic import Diagnostic, Severity
from sdfcheck.report.colors import Ink, Paint
from sdfcheck.report.formats.concise import concise_line
from sdfcheck.report.paths import Paths

_PLACES = 5


def by_file_and_code(diagnostics: Iterable[Diagnostic], paths: Paths, paint: Paint) -> Iterator[str]:
    """The first of each file, code and severity, with the number and the places of the others."""
    groups: dict[tuple[str, str, Severity], list[Diagnostic]] = {}
    for each in diagnostics:
        groups.setdefault((paths(each.span.source.path), each.code, each.severity), []).append(each)
    for first, *others in groups.values():
        line = concise_line(first, paths, paint)
        if others:
            places = dict.fromkeys("{}:{}".format(*each.span.begin) for each in others)
            places.pop("{}:{}".format(*first.span.begin), None)
            shown = ", ".join(list(places)[:_PLACES]) + (", …" if len(places) > _PLACES else "")
            line += paint(f" and {len(others)} more" + (f", at {shown}" if shown else " there"), Ink.FAINT)
        yield line
