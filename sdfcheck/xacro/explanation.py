"""From what the expanding process reports to a problem with an exact place."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Mapping
from typing import Any

from sdfcheck.source.document import Document
from sdfcheck.source.problems import SyntaxDefect
from sdfcheck.source.scanner.parse_tag import parse_start_tag
from sdfcheck.source.scanner.start_tag import StartTag
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Source, Span, Step
from sdfcheck.xacro.origins import Provenance
from sdfcheck.xacro.problems import (
    ExpansionFailure,
    Failure,
    Mismatch,
    Problem,
    UndefinedMacro,
    UndefinedProperty,
    UnknownPackage,
    WrongMacroArguments,
    XacroIncludeCycle,
)

Report = Mapping[str, Any]

_MISMATCHES = {
    "Invalid": Mismatch.UNKNOWN,
    "Undefined": Mismatch.MISSING,
    "Not": Mismatch.MISSING_BLOCK,
    "Unused": Mismatch.EXTRA_BLOCK,
}
_FAILURES: Mapping[str, Failure] = {
    "argument": Failure.ARGUMENT,
    "variable": Failure.VARIABLE,
    "limit": Failure.LIMIT,
    "refused": Failure.REFUSED,
    "other": Failure.EXPRESSION,
}


def explain(report: Report, provenance: Provenance, document: Document) -> Problem:
    """The problem that made an expansion fail."""
    case = _Case(report, provenance, document)
    kind: str = report["kind"]
    take: Callable[[_Case], Problem] | None = _TAKE.get(kind)
    if take is not None:
        return take(case)
    detail = str(report.get("name") or report.get("message") or "")
    failure = _FAILURES[kind]
    if failure is Failure.VARIABLE and detail in os.environ:
        failure = Failure.WITHHELD
    return ExpansionFailure(case.span(), failure, detail, str(report.get("expression", "")), case.origins)


class _Case:
    """A report, and the place that it speaks of."""

    def __init__(self, report: Report, provenance: Provenance, document: Document) -> None:
        self.report = report
        self.provenance = provenance
        self.source, self.at = self.place(document)
        self.tag: StartTag = parse_start_tag(self.source, self.at)[0]
        self.origins: tuple[Step, ...] = _shortened(provenance.steps(report.get("step", -1)))

    def place(self, document: Document) -> tuple[Source, int]:
        place = self.report.get("place")
        if place and place[0] < len(self.provenance.files) and place[1]:
            source = self.provenance.files[place[0]]
            at = source.offset(place[1], place[2])
            if source.text.startswith("<", at):
                return source, at
        scan = document.scan
        return document.source, scan.starts[0] if scan.starts else 0

    @property
    def name(self) -> Span:
        return self.source.span(self.tag.name_start, self.tag.name_end)

    def span(self, word: str = "") -> Span:
        """The smallest place known: the word in the expression, the expression, the value, the tag."""
        start, end = self.value()
        expression: str = self.report.get("expression", "")
        if expression:
            found = self.source.text.find(expression, start, end)
            if found < 0:
                start, end = self.at, self.reach()
                found = self.source.text.find(expression, start, end)
            if found < 0:
                return self.value_span()
            start, end = found, found + len(expression)
        if word:
            match = re.compile(rf"(?<![\w.]){re.escape(word)}(?!\w)").search(self.source.text, start, end)
            if match:
                return self.source.span(match.start(), match.end())
        return self.source.span(start, end) if expression else self.value_span()

    def value(self) -> tuple[int, int]:
        """The range of the attribute that is spoken of, else of the start tag after its name."""
        for attribute in self.tag.attributes:
            if attribute.name == self.report.get("attribute"):
                return attribute.value_start, attribute.value_end
        return self.tag.name_end, self.tag.end

    def value_span(self) -> Span:
        start, end = self.value()
        known = end != self.tag.end and start < end
        return self.source.span(start, end) if known else self.name

    def attribute(self, name: str) -> Span:
        for attribute in self.tag.attributes:
            if attribute.name == name:
                return self.source.span(attribute.name_start, attribute.name_end)
        return self.name

    def reach(self) -> int:
        """Where the element ends: the text inside may hold the expression."""
        scan = self.provenance.sources.scan(self.source)
        if self.at in scan.starts:
            return scan.close_ends[scan.starts.index(self.at)]
        return self.tag.end


def _shortened(steps: tuple[Step, ...], most: int = 12) -> tuple[Step, ...]:
    """A long chain without its middle."""
    return steps if len(steps) <= most else (*steps[: most // 2], *steps[-most // 2 :])


def _property(case: _Case) -> Problem:
    name: str = case.report["name"]
    return UndefinedProperty(case.span(name), name, None, case.origins)


def _macro(case: _Case) -> Problem:
    attribute = "macro" if case.tag.name == "xacro:call" else ""
    span = case.name
    if attribute:
        span = case.value_span()
    elif ":" in span.text:
        span = case.source.span(span.start + span.text.index(":") + 1, span.end)
    return UndefinedMacro(span, case.report["name"], None, case.origins)


def _package(case: _Case) -> Problem:
    name: str = case.report["name"]
    return UnknownPackage(case.span(name), name, None, case.origins)


def _file(case: _Case) -> Problem:
    detail = f"{case.report['name']}: {case.report['message']}"
    expression = case.report.get("expression", "")
    return ExpansionFailure(case.span(), Failure.FILE, detail, expression, case.origins)


def _syntax(case: _Case) -> Problem:
    file, line, column = case.report["at"]
    source = case.provenance.files[file]
    start = source.offset(line, column)
    fault = source.span(start, start + 1)
    detail: str = case.report["message"]
    if not case.report.get("place"):  # the file itself: no include was under way
        return ExpansionFailure(fault, Failure.TEXT, detail, cause=fault)
    defects = (
        each.span for each in Document(source, Kind.XACRO, []).problems if isinstance(each, SyntaxDefect)
    )
    cause = next(defects, fault)
    return ExpansionFailure(case.span(), Failure.SYNTAX, detail, origins=case.origins, cause=cause)


def _recursion(case: _Case) -> Problem:
    name: str = case.report["name"]
    if case.report["what"] == "include":
        return XacroIncludeCycle(case.value_span(), name, (), case.origins)
    return ExpansionFailure(case.name, Failure.RECURSION, name, "", case.origins)


def _arguments(case: _Case) -> Problem:
    report = case.report
    kind = _MISMATCHES[report["what"]]
    names = tuple(report["names"])
    span = case.attribute(names[0]) if kind is Mismatch.UNKNOWN else case.name
    definition = None
    if report.get("definition"):
        definition = case.provenance.name_at(*report["definition"])
    parameters = tuple(report["parameters"])
    return WrongMacroArguments(span, report["macro"], kind, names, parameters, definition, case.origins)


_TAKE: Mapping[str, Callable[[_Case], Problem]] = {
    "property": _property,
    "macro": _macro,
    "package": _package,
    "file": _file,
    "syntax": _syntax,
    "recursion": _recursion,
    "arguments": _arguments,
}
