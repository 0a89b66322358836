"""One line per diagnostic, in the shape that editors know from compilers."""

from __future__ import annotations

from sdfcheck.lint.diagnostic import Diagnostic
from sdfcheck.lint.run import Run
from sdfcheck.report.colors import INK_OF, Ink, Paint, painter
from sdfcheck.report.paths import Paths
from sdfcheck.report.summary import closing_line
from sdfcheck.source.visible import visible


def render(run: Run, *, color: bool = False) -> str:
    paint, paths = painter(color), Paths()
    lines = [concise_line(diagnostic, paths, paint) for diagnostic in run.diagnostics]
    return "\n".join([*lines, closing_line(run)]) + "\n"


def concise_line(diagnostic: Diagnostic, paths: Paths, paint: Paint) -> str:
    """``path:line:column: severity: message [code]``, and the kind of fix."""
    place = paint(visible(paths.place(diagnostic.span)), Ink.STRONG)
    severity = paint(diagnostic.severity.value, INK_OF[diagnostic.severity])
    fix = f" ({diagnostic.fix.applicability.value} fix)" if diagnostic.fix is not None else ""
    return f"{place}: {severity}: {visible(diagnostic.message)} [{diagnostic.code}]{fix}"
