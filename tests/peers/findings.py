"""What sdfcheck says of files, in the shape that the comparisons need."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from sdfcheck.lint.diagnostic import Severity
from sdfcheck.lint.engine import Dispatch, lint_source
from sdfcheck.lint.packs import load_index
from sdfcheck.lint.select import SILENT, select

SHARED = Path(__file__).parents[3] / "shared"
"""Real files and the verdicts of other readers; absent outside the workshop."""


class Finding(NamedTuple):
    code: str
    severity: Severity
    line: int
    message: str

    @property
    def family(self) -> str:
        return self.code.rstrip("0123456789")


class Linter:
    """Lints files one by one with the default rules, or those of some families."""

    def __init__(self, families: Sequence[str] = ()) -> None:
        index = load_index()
        self._families = frozenset(families)
        self._dispatch = Dispatch(index, select(index.facts, SILENT))

    def findings(self, path: Path) -> list[Finding]:
        result = lint_source(path.read_bytes(), path, None, self._dispatch)
        found = [
            Finding(d.code, d.severity, d.span.begin.line, d.message) for d in result.diagnostics if d.code
        ]
        return [finding for finding in found if not self._families or finding.family in self._families]

    def errors(self, path: Path) -> list[Finding]:
        return [finding for finding in self.findings(path) if finding.severity is Severity.ERROR]
