"""How many findings each rule has: the report of ``--statistics``."""

from __future__ import annotations

from sdfcheck.lint.diagnostic import Diagnostic
from sdfcheck.lint.run import Run
from sdfcheck.report.colors import INK_OF
from sdfcheck.report.fit import fitted
from sdfcheck.report.summary import EVERYTHING, View, closing_line


def render(run: Run, *, color: bool = False, view: View = EVERYTHING) -> str:
    """Counts by rule, the most frequent first, with the gravest severity and the kind of fix.

    Of the view, the width and the links count.
    """
    closing = fitted(closing_line(run), view.width) + "\n"
    if not run.diagnostics:
        return closing
    from sdfcheck.report.table import Cell, Column, table

    by_code: dict[str, list[Diagnostic]] = {}
    for diagnostic in run.diagnostics:
        by_code.setdefault(diagnostic.code, []).append(diagnostic)
    rows = []
    for code, found in sorted(by_code.items(), key=lambda group: (-len(group[1]), group[0])):
        severity = max((diagnostic.severity for diagnostic in found), key=lambda severity: severity.rank)
        words = (str(len(found)), severity.value, code, found[0].name, _fix(found))
        row = [Cell(word) for word in words]
        row[1] = row[1]._replace(ink=INK_OF[severity])
        row[2] = row[2]._replace(address=run.pages.get(code) if view.links else None)
        rows.append(row)
    columns = (
        Column("count", is_number=True),
        Column("severity"),
        Column("rule"),
        Column("name", gives_way=True),
        Column("fix"),
    )
    return "\n".join([*table(columns, rows, width=view.width, color=color), "", closing])


def _fix(found: list[Diagnostic]) -> str:
    fixes = [diagnostic.fix for diagnostic in found if diagnostic.fix is not None]
    if not fixes:
        return ""
    return "safe fix" if any(fix.is_safe for fix in fixes) else "unsafe fix"
