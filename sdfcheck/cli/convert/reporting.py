"""The report of conversions: losses, then a line for each file."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from pathlib import Path

from sdfcheck.cli.convert.options import Request
from sdfcheck.cli.convert.outcome import Outcome
from sdfcheck.cli.parts.output import Output, show, write
from sdfcheck.cli.parts.terminal import emit_lines, say, say_lines, wants_color, width_of
from sdfcheck.lint.diagnostic import Diagnostic, Severity
from sdfcheck.lint.run import Run
from sdfcheck.lint.wording import counted, listed
from sdfcheck.report import OutputFormat, render
from sdfcheck.report.summary import View
from sdfcheck.source.record import NamedTuple


class _Row(NamedTuple):
    """A file in the table at the end: how it went, and what there is to say of it."""

    how: str
    text: str


class Reporting:
    """Collects what came of the files of a run, and reports it."""

    def __init__(self, request: Request, wanted: Sequence[Output]) -> None:
        self._request = request
        self._wanted = wanted
        self._done: list[Outcome] = []
        self._rows: list[_Row] = []
        self._unusable = 0

    def add(self, outcome: Outcome, target: Path | None) -> None:
        """A file was converted, or refused."""
        self._done.append(outcome._replace(conversion=None))
        if outcome.failed:
            self._rows.append(_Row("not written", f"{outcome.file}: {outcome.reason}"))
            return
        losses = sum(one.severity is not Severity.INFO for one in outcome.losses)
        how = "verified" if outcome.verification is not None else "not verified"
        how += f", {losses} {'loss' if losses == 1 else 'losses'}" if losses else ""
        where = f" → {target}" if target is not None else ""
        why = f" ({outcome.verdict.removeprefix('not verified: ')})" if outcome.broken is not None else ""
        self._rows.append(_Row(how, f"{outcome.file}{where}{why}"))

    def ignore(self, file: Path, description: str) -> None:
        """A file is of another kind, which is not a mistake."""
        self._rows.append(_Row("ignored", f"{file}: looks like {description}"))

    def fail(self, file: Path, text: str) -> None:
        """A file cannot be used."""
        say(f"error: {text}")
        self._rows.append(_Row("unusable", str(file)))
        self._unusable += 1

    def finish(self) -> int:
        """Report everything; returns the exit code."""
        self._losses()
        if not self._request.quiet:
            self._sum_up()
        if self._unusable:
            return 2
        strict = self._request.strict
        return int(any(one.failed or (strict and one.has_losses) for one in self._done))

    @property
    def _aside(self) -> bool:
        """Whether reports go to stderr, since a result goes to stdout."""
        request = self._request
        return request.output_dir is None and request.output_file is None

    def _losses(self) -> None:
        request, aside = self._request, self._aside
        diagnostics = sorted(
            (one for outcome in self._done for one in outcome.diagnostics), key=lambda one: one.sort_key
        )
        run = Run(tuple(diagnostics), tuple(outcome.file for outcome in self._done))
        stream = sys.stderr if aside else sys.stdout
        color = wants_color(request.color, stream)
        view = View(Severity(request.min_severity), width=width_of(stream))
        for output in self._wanted:
            if diagnostics or not output.format.is_text:
                write(output, run, color=request.color, aside=aside, view=view)
        if self._wanted or not view.shown(run):
            return
        refused = len(self._done) == 1 and self._done[0].failed
        if request.losses == "all" or refused:
            view = view._replace(folds=request.losses != "all")
            show(
                OutputFormat.FULL,
                render(OutputFormat.FULL, run, color=color, view=view),
                color=color,
                aside=aside,
            )
            return
        lines = list(self._grouped(view.shown(run), color=color))
        if view.width is not None:
            from sdfcheck.report.fit import folded

            lines = [part for line in lines for part in folded(line, view.width)]
        (say_lines if aside else emit_lines)(lines, color=color)

    def _grouped(self, diagnostics: Sequence[Diagnostic], *, color: bool) -> Iterator[str]:
        from sdfcheck.report.colors import painter
        from sdfcheck.report.losses import by_file_and_code
        from sdfcheck.report.paths import Paths

        return by_file_and_code(diagnostics, Paths(), painter(color))

    def _sum_up(self) -> None:
        if len(self._rows) == 1 and self._done:
            (outcome,) = self._done
            say(outcome.verdict)
        else:
            width = max((len(row.how) for row in self._rows), default=0)
            for row in self._rows:
                say(f"{row.how:{width}}  {row.text}")
            say(self._closing())
        for outcome in self._done:
            if outcome.encoding and not outcome.failed:
                say(f"note: {outcome.file}: {outcome.encoding} becomes UTF-8")
        hidden = self._hidden()
        if hidden:
            say(f"{counted(hidden, 'info')}: shown with --min-severity info")

    def _closing(self) -> str:
        counts = []
        for how in ("verified", "not verified", "not written", "unusable", "ignored"):
            rows = [row for row in self._rows if row.how.partition(",")[0] == how]
            losing = sum("," in row.how for row in rows)
            if rows:
                counts.append(f"{len(rows)} {how}" + (f" ({losing} with losses)" if losing else ""))
        judges = self._request.verify_with
        also = f"; also compared by {listed(judges)}" if judges else ""
        return f"{counted(len(self._rows), 'file')}: {listed(counts)}{also}"

    def _hidden(self) -> int:
        """How many findings are not shown; reports in a format that was asked for say so themselves."""
        if self._wanted:
            return 0
        least = Severity(self._request.min_severity)
        return sum(not one.severity >= least for outcome in self._done for one in outcome.diagnostics)
