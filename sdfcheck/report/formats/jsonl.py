"""The diagnostics of our own JSON, one a line."""

from __future__ import annotations

from sdfcheck.lint.run import Run
from sdfcheck.report.formats.json import diagnostic_lines
from sdfcheck.report.paths import Paths


def render(run: Run) -> str:
    return "".join(f"{line}\n" for line in diagnostic_lines(run, Paths()))
