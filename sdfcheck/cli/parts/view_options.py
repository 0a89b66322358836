"""How much a report for people shows, and which exit code it earns."""

from __future__ import annotations

from types import SimpleNamespace

import click

from sdfcheck.cli.parts.options import together
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.lint.run import Gate, Run
from sdfcheck.report.summary import View

_SEVERITIES = click.Choice([severity.value for severity in Severity])
shown = together(
    click.option(
        "--min-severity",
        type=_SEVERITIES,
        help="Show what is at least so severe, and count the rest (text formats).  [default: warning]",
    ),
    click.option(
        "--max-diagnostics",
        type=click.IntRange(0),
        metavar="N",
        help="Show at most N findings (text formats).",
    ),
    click.option(
        "--no-fold",
        is_flag=True,
        help="Show repeated findings and what is not found one by one (text formats).",
    ),
    click.option(
        "--fail-on",
        type=_SEVERITIES,
        help="Exit with 1 if a finding is at least this severe.  [default: warning]",
    ),
    click.option(
        "--fail-on-missing",
        is_flag=True,
        help="Exit with 1 also if packages or models are not found on this computer.",
    ),
    click.option("--max-warnings", type=click.IntRange(0), metavar="N", help="Tolerate up to N warnings."),
    click.option("--exit-zero", is_flag=True, help="Exit with 0 whatever is found."),
)
"""The options about how much is shown, and about the exit code."""


class Request(SimpleNamespace):
    """The command line, as click read it: each option is an attribute."""


def view_of(request: Request, usual: Severity) -> View:
    """How much is shown; what fails a run is never hidden. ``usual`` is the configured severity that fails one."""
    if request.min_severity is not None:
        least = Severity(request.min_severity)
    else:
        failing = Severity(request.fail_on) if request.fail_on else usual
        least = min(Severity.WARNING, failing, key=lambda severity: severity.rank)
    return View(least, not request.no_fold, request.max_diagnostics)


def gate_of(request: Request, usual: Severity) -> Gate:
    """The gate of a run. ``usual`` is the configured severity that fails one."""
    least = Severity(request.fail_on) if request.fail_on else usual
    return Gate(least, request.fail_on_missing, request.max_warnings)


def exit_code(request: Request, done: Run) -> int:
    """The exit code that the findings earn."""
    return int(not request.exit_zero and bool(done.failing))
