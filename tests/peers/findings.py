"""The findings of sdfcheck about files, in the shape that the comparisons need."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from sdfcheck.lint.config.configuration import Configuration
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.lint.session import InternalError, Level, Notice, Options, run

SHARED = Path(__file__).parents[3] / "shared"
"""Real files and the verdicts of other consumers; absent outside the workshop."""

NOT_RUN, CRASHED = "(not run)", "(crashed)"
"""The substitute for a code where no rule is involved."""


class Finding(NamedTuple):
    code: str
    name: str
    severity: Severity
    line: int
    message: str

    @property
    def family(self) -> str:
        return self.code.rstrip("0123456789")


def findings(path: Path, families: Sequence[str] = ()) -> list[Finding]:
    """The findings of the default rules in one file, or of those of some families."""
    failures: list[Finding] = []

    def notify(notice: Notice) -> None:
        if notice.level is Level.FAILURE:
            failures.append(Finding(NOT_RUN, NOT_RUN, Severity.ERROR, 1, notice.text))

    try:
        done = run([path], Options(Configuration(isolated=True)), notify=notify)
    except InternalError as error:
        return [Finding(CRASHED, CRASHED, Severity.ERROR, 1, str(error))]
    found = [Finding(d.code, d.name, d.severity, d.span.begin.line, d.message) for d in done.diagnostics]
    return failures + [finding for finding in found if not families or finding.family in families]
