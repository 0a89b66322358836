"""JUnit XML: a suite per file, a test per diagnostic, a passed one for a clean file.

Findings that fail the run are failures, those about this computer are skipped, and the others have passed.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator

from sdfcheck.lint.diagnostic import Diagnostic
from sdfcheck.lint.run import Run
from sdfcheck.report.colors import painter
from sdfcheck.report.formats.concise import concise_line
from sdfcheck.report.paths import Paths

# Text for the XML formats.


_ILLEGAL = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
_ESCAPES = str.maketrans({"&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;"})


def attributes(**values: object) -> str:
    """Attributes with a space before each."""
    return "".join(f' {name}="{escaped(str(value))}"' for name, value in values.items())


def escaped(text: str) -> str:
    """Safe between tags and quotes; what XML 1.0 cannot hold becomes a replacement character."""
    legal = _ILLEGAL.sub("\ufffd", text).translate(_ESCAPES)
    if legal.isprintable():
        return legal
    return "".join(c if c.isprintable() else f"&#{ord(c)};" for c in legal)


Outcome = Callable[[Diagnostic], str]
"""The name of the element that says what became of a test."""


def render(run: Run) -> str:
    paths = Paths()
    fails = run.gate.judge(run.diagnostics)

    def outcome(diagnostic: Diagnostic) -> str:
        if fails(diagnostic):
            return "failure"
        return "system-out" if diagnostic.missing is None else "skipped"

    by_file: dict[str, list[Diagnostic]] = {paths(path): [] for path in run.files}
    for diagnostic in run.diagnostics:
        by_file.setdefault(paths(diagnostic.span.source.path), []).append(diagnostic)
    tests = sum(max(len(found), 1) for found in by_file.values())
    totals = attributes(name="sdfcheck", tests=tests, failures=len(run.failing), errors=0)
    lines = ['<?xml version="1.0" encoding="UTF-8"?>', f"<testsuites{totals}>"]
    for file, found in sorted(by_file.items()):
        lines += _suite(file, found, outcome, paths)
    lines.append("</testsuites>")
    return "\n".join(lines) + "\n"


def _suite(file: str, found: list[Diagnostic], outcome: Outcome, paths: Paths) -> Iterator[str]:
    outcomes = list(map(outcome, found))
    counts = attributes(name=file, tests=max(len(found), 1), failures=outcomes.count("failure"), errors=0)
    counts += attributes(skipped=outcomes.count("skipped"), package="sdfcheck", file=file)
    yield f"  <testsuite{counts}>"
    if not found:
        yield f"    <testcase{attributes(name='sdfcheck', classname=file)}/>"
    for diagnostic, element in zip(found, outcomes, strict=True):
        line, column = diagnostic.span.begin
        name = f"{diagnostic.code} {diagnostic.name} {line}:{column}"
        message = f"{diagnostic.code} {diagnostic.message}"
        text = escaped(concise_line(diagnostic, paths, painter(False)))
        about = {
            "failure": attributes(type=diagnostic.severity.value, message=message),
            "skipped": attributes(message=message),
        }.get(element, "")
        yield f"    <testcase{attributes(name=name, classname=file)}>"
        yield f"      <{element}{about}>{text}</{element}>"
        yield "    </testcase>"
    yield "  </testsuite>"
