"""The report that people read: each diagnostic with its lines of code."""

from __future__ import annotations

from sdfcheck.lint.run import Run
from sdfcheck.report.summary import closing_line


def render(run: Run, *, color: bool = False) -> str:
    return "\n\n".join([*_blocks(run, color), closing_line(run)]) + "\n"


def _blocks(run: Run, color: bool) -> list[str]:
    if not run.diagnostics:
        return []  # most runs: load nothing more
    from sdfcheck.report.block import block
    from sdfcheck.report.colors import painter
    from sdfcheck.report.paths import Paths

    paint, paths = painter(color), Paths()
    known = {facts.code for facts in run.rules}
    return [
        "\n".join(block(diagnostic, diagnostic.code in known, paths, paint)) for diagnostic in run.diagnostics
    ]
