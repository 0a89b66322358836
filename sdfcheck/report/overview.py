"""The first screen of a large run: its findings by rule, in the order in which to take them on."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from sdfcheck.lint.diagnostic import Diagnostic, Severity, counted
from sdfcheck.lint.run import Run
from sdfcheck.report.colors import INK_OF, Ink, Paint
from sdfcheck.report.digest import files_of
from sdfcheck.report.paths import Paths
from sdfcheck.report.summary import EVERYTHING, View, closing_line
from sdfcheck.report.table import Cell, Column, fitted, table
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.visible import visible

_ROWS = 20
"""So many rules are listed under a heading."""


_FIXABLE = "Fix first: `sdfcheck lint --fix` corrects these without changing a robot"
_HEADINGS = {
    Severity.ERROR: "Errors: a simulator refuses the file, or builds another robot",
    Severity.WARNING: "Warnings: very likely not what is meant",
    Severity.INFO: "Infos",
}


class Row(NamedTuple):
    """The findings of a rule."""

    found: list[Diagnostic]

    @property
    def first(self) -> Diagnostic:
        return self.found[0]


class Section(NamedTuple):
    """Rules that are taken on together, the most frequent first."""

    heading: str
    rows: list[Row]
    is_fixable: bool
    """Whether `sdfcheck lint --fix` fixes these findings."""


def sections(run: Run, view: View) -> Iterator[Section]:
    """Fixable findings first, then errors, then warnings, then infos; those without findings are left out."""
    shown = view.shown(run)
    fixable = [each for each in shown if each.fix is not None and each.fix.is_safe]
    others = [each for each in shown if each.fix is None or not each.fix.is_safe]
    if fixable:
        yield Section(_FIXABLE, _rows(fixable), is_fixable=True)
    for severity, heading in _HEADINGS.items():
        found = [each for each in others if each.severity is severity]
        if found:
            yield Section(heading, _rows(found), is_fixable=False)


def _rows(found: Sequence[Diagnostic]) -> list[Row]:
    by_code: dict[str, list[Diagnostic]] = {}
    for each in found:
        by_code.setdefault(each.code, []).append(each)
    return sorted(map(Row, by_code.values()), key=lambda row: (-len(row.found), row.first.code))


def overview(run: Run, view: View, paths: Paths, paint: Paint) -> Iterator[str]:
    """The sections as text; what is not shown is counted."""
    apart = view.singles(run)
    yield paint(
        f"{counted(len(apart), 'finding')} in {counted(len(files_of(apart)), 'file')}, by rule", Ink.STRONG
    )
    for section in sections(run, view):
        yield from _section(section, paths, paint)
    hidden = [each for each in apart if not each.severity >= view.least]
    if hidden:
        codes = sorted({each.code for each in hidden})
        yield ""
        yield f"{counted(len(hidden), 'info')} of {counted(len(codes), 'rule')}: not shown, and rarely urgent"


def _section(section: Section, paths: Paths, paint: Paint) -> Iterator[str]:
    rows = section.rows
    digits = max(len(str(len(row.found))) for row in rows)
    width = max(len(f"{row.first.code} {row.first.name}") for row in rows[:_ROWS])
    yield ""
    yield paint(section.heading, Ink.STRONG)
    for row in rows[:_ROWS]:
        first = row.first
        rule = paint(f"{first.code} {first.name:{width - len(first.code) - 1}}", INK_OF[first.severity])
        files = counted(len(files_of(row.found)), "file")
        yield f"  {len(row.found):>{digits}}  {rule}  in {files}, first at {visible(paths.place(first.span))}"
    if len(rows) > _ROWS:
        rest = sum(len(row.found) for row in rows[_ROWS:])
        yield f"  {rest:>{digits}}  of {counted(len(rows) - _ROWS, 'other rule')}"


# How many findings each rule has: the report of ``--statistics``.


def render(run: Run, *, color: bool = False, view: View = EVERYTHING) -> str:
    """Counts by rule, the most frequent first, with the gravest severity and the kind of fix.

    Of the view, the width and the links count.
    """
    closing = fitted(closing_line(run), view.width) + "\n"
    if not run.diagnostics:
        return closing

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
