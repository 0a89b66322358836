"""Logging commands of Azure Pipelines: errors and warnings in the summary of a run."""

from __future__ import annotations

from sdfcheck.lint.diagnostic import Diagnostic, Severity
from sdfcheck.lint.run import Run
from sdfcheck.report.colors import painter
from sdfcheck.report.formats.concise import concise_line
from sdfcheck.report.formats.github import annotation
from sdfcheck.report.paths import Paths
from sdfcheck.source.visible import harmless, visible


def render(run: Run) -> str:
    """The gravest first, because Azure shows only the first few; it knows no infos, which are lines of the log."""
    paths = Paths("BUILD_SOURCESDIRECTORY")
    return "".join(f"{_line(diagnostic, severity, paths)}\n" for diagnostic, severity in run.gravest_first)


def _line(diagnostic: Diagnostic, severity: Severity, paths: Paths) -> str:
    if severity is Severity.INFO:
        return harmless(concise_line(diagnostic, paths, painter(False)))
    line, column = diagnostic.span.begin
    properties = {
        "type": severity.value,
        "sourcepath": visible(paths(diagnostic.span.source.path)),
        "linenumber": str(line),
        "columnnumber": str(column),
        "code": diagnostic.code,
    }
    written = "".join(f"{key}={_property(value)};" for key, value in properties.items())
    message = _message(annotation(diagnostic))
    return f"##vso[task.logissue {written}]{message}"


def _message(text: str) -> str:
    """As azure-pipelines-agent reads it; `%25` would stay as it is."""
    return text.replace("%", "%AZP25").replace("\r", "%0D").replace("\n", "%0A")


def _property(text: str) -> str:
    return _message(text).replace("]", "%5D").replace(";", "%3B")
