"""Checkstyle's XML, which many review tools read."""

from __future__ import annotations

from sdfcheck.lint.diagnostic import Diagnostic, Severity
from sdfcheck.lint.run import Run
from sdfcheck.report.formats.junit import attributes
from sdfcheck.report.paths import Paths


def render(run: Run) -> str:
    paths = Paths()
    by_file: dict[str, list[Diagnostic]] = {}
    for diagnostic in run.diagnostics:
        by_file.setdefault(paths(diagnostic.span.source.path), []).append(diagnostic)
    lines = ['<?xml version="1.0" encoding="UTF-8"?>', '<checkstyle version="4.3">']
    for file, found in sorted(by_file.items()):
        lines.append(f"  <file{attributes(name=file)}>")
        lines += [f"    <error{_error(diagnostic, run.gate.severity(diagnostic))}/>" for diagnostic in found]
        lines.append("  </file>")
    lines.append("</checkstyle>")
    return "\n".join(lines) + "\n"


def _error(diagnostic: Diagnostic, severity: Severity) -> str:
    line, column = diagnostic.span.begin
    return attributes(
        line=line,
        column=column,
        severity=severity.value,
        message=diagnostic.message,
        source=f"sdfcheck.{diagnostic.code}",
    )
