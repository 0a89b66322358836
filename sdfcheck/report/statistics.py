"""How often each rule spoke: the report of ``--statistics``."""

from __future__ import annotations

from sdfcheck.lint.diagnostic import Diagnostic
from sdfcheck.lint.run import Run
from sdfcheck.report.colors import INK_OF, painter
from sdfcheck.report.summary import closing_line


def render(run: Run, *, color: bool = False) -> str:
    """Counts per rule, the most frequent first, with the gravest severity and the kind of fix."""
    paint = painter(color)
    by_code: dict[str, list[Diagnostic]] = {}
    for diagnostic in run.diagnostics:
        by_code.setdefault(diagnostic.code, []).append(diagnostic)
    groups = sorted(by_code.items(), key=lambda group: (-len(group[1]), group[0]))
    digits = max((len(str(len(found))) for found in by_code.values()), default=0)
    code_width = max(map(len, by_code), default=0)
    lines: list[str] = []
    for code, found in groups:
        severity = max((diagnostic.severity for diagnostic in found), key=lambda severity: severity.rank)
        grade = paint(f"{severity.value:7}", INK_OF[severity])
        lines.append(f"{len(found):>{digits}}  {grade}  {code:{code_width}}  {found[0].name}{_fix(found)}")
    return "\n".join([*lines, *([""] if lines else []), closing_line(run)]) + "\n"


def _fix(found: list[Diagnostic]) -> str:
    fixes = [diagnostic.fix for diagnostic in found if diagnostic.fix is not None]
    if not fixes:
        return ""
    return " (safe fix)" if any(fix.is_safe for fix in fixes) else " (unsafe fix)"
