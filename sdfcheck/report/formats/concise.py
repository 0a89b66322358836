"""One line per diagnostic, in the shape that editors know from compilers: nothing is folded."""

from __future__ import annotations

from sdfcheck.lint.diagnostic import Diagnostic
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
