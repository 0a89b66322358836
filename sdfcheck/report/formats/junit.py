"""JUnit XML: a suite per file, a failed test per diagnostic, a passed one for a clean file."""

from __future__ import annotations

from collections.abc import Iterator

from sdfcheck.lint.diagnostic import Diagnostic
from sdfcheck.lint.run import Run
from sdfcheck.report.colors import painter
from sdfcheck.report.formats.concise import concise_line
from sdfcheck.report.formats.xml_text import attributes, escaped
from sdfcheck.report.paths import Paths


def render(run: Run) -> str:
    paths = Paths()
    by_file: dict[str, list[Diagnostic]] = {paths(path): [] for path in run.files}
    for diagnostic in run.diagnostics:
        by_file.setdefault(paths(diagnostic.span.source.path), []).append(diagnostic)
    tests = sum(max(len(found), 1) for found in by_file.values())
    totals = attributes(name="sdfcheck", tests=tests, failures=len(run.diagnostics), errors=0)
    lines = ['<?xml version="1.0" encoding="UTF-8"?>', f"<testsuites{totals}>"]
    for file, found in sorted(by_file.items()):
        lines += _suite(file, found, paths)
    lines.append("</testsuites>")
    return "\n".join(lines) + "\n"


def _suite(file: str, found: list[Diagnostic], paths: Paths) -> Iterator[str]:
    counts = attributes(name=file, tests=max(len(found), 1), failures=len(found), errors=0, skipped=0)
    yield f"  <testsuite{counts}{attributes(package='sdfcheck', file=file)}>"
    if not found:
        yield f"    <testcase{attributes(name='sdfcheck', classname=file)}/>"
    for diagnostic in found:
        line, column = diagnostic.span.begin
        name = f"{diagnostic.code} {diagnostic.name} {line}:{column}"
        message = f"{diagnostic.code} {diagnostic.message}"
        text = escaped(concise_line(diagnostic, paths, painter(False)))
        yield f"    <testcase{attributes(name=name, classname=file)}>"
        yield f"      <failure{attributes(type=diagnostic.severity.value, message=message)}>{text}</failure>"
        yield "    </testcase>"
    yield "  </testsuite>"
