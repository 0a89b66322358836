"""Workflow commands of GitHub Actions: annotations beside the lines of a pull request."""

from __future__ import annotations

from sdfcheck.lint.diagnostic import Diagnostic, Severity
from sdfcheck.lint.run import Run
from sdfcheck.report.paths import Paths
from sdfcheck.source.visible import visible

# The text of a finding where a build service shows it beside the line.


def annotation(diagnostic: Diagnostic) -> str:
    """The message, the title of the fix and the help, one line each."""
    lines = [diagnostic.message]
    if diagnostic.fix is not None:
        lines.append(f"help: {diagnostic.fix.title} ({diagnostic.fix.applicability.value} fix)")
    if diagnostic.help:
        lines.append(f"help: {diagnostic.help}")
    return "\n".join(map(visible, lines))


_COMMANDS = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.INFO: "notice"}
_SHOWN = 10  # annotations that GitHub shows of one step


def render(run: Run) -> str:
    """The gravest first, because GitHub shows only the first few."""
    paths = Paths("GITHUB_WORKSPACE")
    lines = [_command(diagnostic, severity, paths) for diagnostic, severity in run.gravest_first]
    if len(lines) > _SHOWN:
        lines.append(f"::notice::{len(lines) - _SHOWN} more in the log of this step")
    return "".join(f"{line}\n" for line in lines)


def _command(diagnostic: Diagnostic, severity: Severity, paths: Paths) -> str:
    begin, finish = diagnostic.span.begin, diagnostic.span.finish
    properties = {
        "file": visible(paths(diagnostic.span.source.path)),
        "line": str(begin.line),
        "endLine": str(finish.line),
    }
    # GitHub rejects columns of a range over several lines.
    if begin.line == finish.line:
        properties |= {"col": str(begin.column), "endColumn": str(finish.column)}
    properties["title"] = f"{diagnostic.code} {diagnostic.name}"
    written = ",".join(f"{key}={_property(value)}" for key, value in properties.items())
    message = _message(annotation(diagnostic))
    return f"::{_COMMANDS[severity]} {written}::{message}"


def _message(text: str) -> str:
    return text.replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")


def _property(text: str) -> str:
    return _message(text).replace(":", "%3A").replace(",", "%2C")
