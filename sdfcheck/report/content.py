"""The content of the HTML report, as JSON for its script."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

from sdfcheck.consumers.reaction import Consumer
from sdfcheck.lint.diagnostic import Diagnostic, Severity
from sdfcheck.lint.fix import Fix
from sdfcheck.lint.run import Run
from sdfcheck.release import __version__
from sdfcheck.report.block import first_of, marks_by_file
from sdfcheck.report.colors import INK_OF, painter
from sdfcheck.report.edits import hunks
from sdfcheck.report.frame import frame
from sdfcheck.report.not_found import not_found
from sdfcheck.report.overview import Row, sections
from sdfcheck.report.paths import Paths
from sdfcheck.report.summary import View, closing_line
from sdfcheck.source.visible import visible

Json = dict[str, Any]

MOST_FRAMES = 5000
"""So many findings are shown with their lines of code; those after them with their places only."""
WHOLE = View(Severity.INFO, folds=True)
"""Files that are not found on this computer are apart from the rest, as in the report for people."""


class Content:
    """The findings of a run, with what many of them have in common named once."""

    def __init__(self, run: Run) -> None:
        self._run = run
        self._paths = Paths()
        self._files: dict[Path, int] = {}
        self._rules: dict[str, int] = {}
        self._reactions: dict[tuple[Any, ...], int] = {(): 0}

    def as_json(self) -> Json:
        """The whole content; texts are as people may see them, and numbers refer to lists."""
        run = self._run
        findings = [self._finding(each, number) for number, each in enumerate(run.diagnostics)]
        return {
            "version": __version__,
            "closing": closing_line(run, WHOLE),
            "files": len(run.files),
            "fixed": run.fixed,
            "suppressed": run.suppressed,
            "frames": MOST_FRAMES,
            "findings": findings,
            "places": [visible(self._paths(path)) for path in self._files],
            "rules": self._facts(),
            "reactions": [self._reaction(each) for each in self._reactions],
            "sections": [
                {
                    "heading": section.heading,
                    "fixable": section.is_fixable,
                    "rows": [self._row(row) for row in section.rows],
                }
                for section in sections(run, WHOLE)
            ],
            "missing": list(not_found(WHOLE.missing(run), self._paths, painter(False))),
            "skipped": [
                {"file": visible(self._paths(path)), "reason": visible(reason)}
                for path, reason in sorted(run.skipped)
            ],
        }

    def _finding(self, found: Diagnostic, number: int) -> Json:
        line, column = found.span.begin
        always: Json = {
            "rule": self._rules.setdefault(found.code, len(self._rules)),
            "severity": found.severity.value,
            "file": self._files.setdefault(found.span.source.path, len(self._files)),
            "line": line,
            "column": column,
            "message": visible(found.message),
        }
        # Most findings have few of these, and there may be many findings.
        rarely: Json = {
            "frames": list(self._frames(found)) if number < MOST_FRAMES else None,
            "fix": self._fix(found.fix) if found.fix is not None else None,
            "help": visible(found.help) if found.help else "",
            "origins": [f"{visible(at.text)}: {visible(self._paths.place(at.span))}" for at in found.origins],
            "missing": found.missing is not None,
            "affects": self._reactions.setdefault(found.affects, len(self._reactions)),
        }
        return always | {key: value for key, value in rarely.items() if value}

    def _frames(self, found: Diagnostic) -> Iterator[Json]:
        """Lines of code as the text report has them, colors included; those of other files with their place."""
        frames = list(marks_by_file(found))
        gutter = len(str(max(mark.span.begin.line for marks in frames for mark in marks)))
        for number, marks in enumerate(frames):
            # The empty line at the top separates code from a heading, which is absent here.
            lines = list(frame(marks, gutter, painter(True), INK_OF[found.severity]))[1:]
            place = visible(self._paths.place(first_of(marks).span)) if number else ""
            yield {"place": place, "text": "\n".join(lines)}

    @staticmethod
    def _fix(fix: Fix) -> Json:
        return {
            "title": visible(fix.title),
            "safe": fix.is_safe,
            "hunks": [{"line": hunk.line, "pieces": hunk.pieces} for hunk in hunks(fix)],
        }

    def _facts(self) -> list[Json]:
        known = {facts.code: facts for facts in self._run.rules}
        names = {each.code: each.name for each in self._run.diagnostics}
        return [
            {
                "code": code,
                "name": visible(names[code]),
                "summary": visible(known[code].summary) if code in known else "",
                "page": known[code].page if code in known else None,
            }
            for code in self._rules
        ]

    @staticmethod
    def _reaction(affects: tuple[Any, ...]) -> list[Json]:
        return [
            {"consumer": Consumer(name).title, "verdict": reaction.verdict.value, "words": reaction.words}
            for name, reaction in affects
        ]

    def _row(self, row: Row) -> Json:
        """A rule, and how many of its findings are in a section."""
        return {
            "rule": self._rules[row.first.code],
            "severity": row.first.severity.value,
            "count": len(row.found),
            "files": len({each.span.source.path for each in row.found}),
        }
