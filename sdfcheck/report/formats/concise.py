"""One line per diagnostic, in the shape that editors know from compilers: nothing is folded."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from sdfcheck.lint.diagnostic import Diagnostic, Severity
from sdfcheck.lint.run import Run
from sdfcheck.report.colors import INK_OF, Ink, Paint, linked, painter
from sdfcheck.report.paths import Paths
from sdfcheck.report.summary import EVERYTHING, View, closing_line
from sdfcheck.source.visible import visible


def render(run: Run, *, color: bool = False, view: View = EVERYTHING) -> str:
    paint, paths = painter(color), Paths()
    shown = view.shown(run)
    pages = run.pages if view.links else {}
    lines = [
        concise_line(diagnostic, paths, paint, pages.get(diagnostic.code))
        for diagnostic in shown[: view.most]
    ]
    if len(shown) > len(lines):
        lines.append(f"{len(shown) - len(lines)} more not shown")
    if missing := view.missing(run):
        from sdfcheck.report.digest import not_found

        lines += not_found(missing, paths, paint)
    return "\n".join([*lines, closing_line(run, view)]) + "\n"


def concise_line(diagnostic: Diagnostic, paths: Paths, paint: Paint, page: str | None = None) -> str:
    """``path:line:column: severity: message [code]``, and the kind of fix; the code leads to ``page``."""
    place = paint(visible(paths.place(diagnostic.span)), Ink.STRONG)
    severity = paint(diagnostic.severity.value, INK_OF[diagnostic.severity])
    fix = f" ({diagnostic.fix.applicability.value} fix)" if diagnostic.fix is not None else ""
    return f"{place}: {severity}: {visible(diagnostic.message)} [{linked(diagnostic.code, page)}]{fix}"


# Findings by file and code, one line each: what conversions report.


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
