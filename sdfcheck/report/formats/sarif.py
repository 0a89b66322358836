"""SARIF 2.1.0, with the additions that GitHub's code scanning requires."""

from __future__ import annotations

import json
import struct
from collections import Counter
from collections.abc import Iterable
from pathlib import Path, PurePosixPath
from typing import Any
from urllib.parse import quote

from sdfcheck.consumers.reaction import lines
from sdfcheck.lint.diagnostic import Diagnostic, Label, Origin, Severity
from sdfcheck.lint.fix import Fix, TextEdit
from sdfcheck.lint.run import RuleFacts, Run
from sdfcheck.release import HOME, __version__
from sdfcheck.report.paths import Paths
from sdfcheck.source.text import Source, Span

# The fingerprints by which GitHub follows a finding when its line moves.
#
# The hash of a line covers the 100 UTF-16 units from its beginning on, spaces left out and line ends
# made equal; a number distinguishes lines that hash alike. GitHub computes the same from the file
# (github/codeql-action, `fingerprints.ts`) where it finds none.


_UNITS = 100
_FACTOR = 37
_MASK = (1 << 64) - 1
_WINDOW = struct.Struct(f"<{_UNITS}H")


def line_hashes(text: str, lines: Iterable[int]) -> dict[int, str]:
    """The fingerprints of the given lines (from 1) of a text."""
    wanted = frozenset(lines)
    dense = text.replace("\r\n", "\n").replace("\r", "\n").replace(" ", "").replace("\t", "")
    units = f"{dense}\uffff".encode("utf-16-le", "surrogatepass") + bytes(_WINDOW.size)
    seen: Counter[bytes] = Counter()
    hashes: dict[int, str] = {}
    start = 0
    for number, line in enumerate(dense.split("\n"), 1):
        window = units[start : start + _WINDOW.size]
        seen[window] += 1
        if number in wanted:
            hashes[number] = f"{_hash(window):x}:{seen[window]}"
        start += len(f"{line}\n".encode("utf-16-le", "surrogatepass"))
    return hashes


def _hash(window: bytes) -> int:
    value = 0
    for unit in _WINDOW.unpack(window):
        value = (value * _FACTOR + unit) & _MASK
    return value


_LEVELS = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.INFO: "note"}
_PROBLEMS = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.INFO: "recommendation"}
_LONGEST = 1024  # characters of a description that GitHub keeps


def render(run: Run) -> str:
    paths = Paths("GITHUB_WORKSPACE")
    indices = {facts.code: index for index, facts in enumerate(run.rules)}
    found = {diagnostic.code for diagnostic in run.diagnostics}
    hashes = _hashes(run.diagnostics)
    driver = {
        "name": "sdfcheck",
        "version": __version__,
        "semanticVersion": __version__,
        "informationUri": HOME,
        "rules": [_rule(facts, facts.remedy if facts.code in found else "") for facts in run.rules],
    }
    log = {
        "$schema": "https://json.schemastore.org/sarif-2.1.0.json",
        "version": "2.1.0",
        "runs": [
            {
                "tool": {"driver": driver},
                "invocations": [{"executionSuccessful": True}],
                "columnKind": "unicodeCodePoints",
                "automationDetails": {"id": "sdfcheck/"},
                "results": [
                    _result(
                        diagnostic, run.gate.severity(diagnostic), indices.get(diagnostic.code), hashes, paths
                    )
                    for diagnostic in run.diagnostics
                ],
            }
        ],
    }
    return json.dumps(log, indent=2) + "\n"


def _rule(facts: RuleFacts, remedy: str) -> dict[str, Any]:
    """The description of a rule; how to correct a finding is said of those that have findings."""
    summary = facts.summary[:_LONGEST]
    to_fix = f"\n\nHow to fix it: {remedy}" if remedy else ""
    consumers = "".join(f"\n- {line}" for line in lines(facts.affects))
    affects = f"\n\nAffects:\n{consumers}" if consumers else ""
    command = f"sdfcheck rule {facts.name}"
    more = f"[{facts.name}]({facts.page})" if facts.page else f"`{command}`"
    return {
        "id": facts.code,
        "name": facts.name.title().replace("-", ""),
        "shortDescription": {"text": summary},
        "fullDescription": {"text": summary},
        **({"helpUri": facts.page} if facts.page else {}),
        "help": {
            "text": f"{facts.summary}{to_fix}{affects}\n\nMore: {facts.page or command}",
            "markdown": f"{facts.summary}{to_fix}{affects}\n\nMore: {more}",
        },
        "defaultConfiguration": {"enabled": facts.is_on, "level": _LEVELS[facts.severity]},
        "properties": {
            "precision": "high",
            "problem.severity": _PROBLEMS[facts.severity],
            "tags": [facts.family],
        },
    }


def _result(
    diagnostic: Diagnostic,
    severity: Severity,
    index: int | None,
    hashes: dict[tuple[Source, int], str],
    paths: Paths,
) -> dict[str, Any]:
    span = diagnostic.span
    result: dict[str, Any] = {"ruleId": diagnostic.code}
    if index is not None:
        result["ruleIndex"] = index
    result |= {
        "level": _LEVELS[severity],
        "message": {"text": diagnostic.message},
        "locations": [{"physicalLocation": _location(span, paths)}],
        "partialFingerprints": {"primaryLocationLineHash": hashes[span.source, span.begin.line]},
    }
    related: list[Label | Origin] = [*diagnostic.labels, *diagnostic.origins]
    if related:
        result["relatedLocations"] = [
            {"id": number, "physicalLocation": _location(place.span, paths), "message": {"text": place.text}}
            for number, place in enumerate(related, 1)
        ]
    if diagnostic.fix is not None:
        result["fixes"] = [_fix(diagnostic.fix, paths)]
    return result


def _fix(fix: Fix, paths: Paths) -> dict[str, Any]:
    by_path: dict[Path, list[TextEdit]] = {}
    for edit in sorted(fix.edits, key=lambda edit: (edit.span.start, edit.span.end)):
        by_path.setdefault(edit.span.source.path, []).append(edit)
    return {
        "description": {"text": f"{fix.title} ({fix.applicability.value} fix)"},
        "artifactChanges": [
            {
                "artifactLocation": _artifact(path, paths),
                "replacements": [
                    {"deletedRegion": _region(edit.span), "insertedContent": {"text": edit.text}}
                    for edit in edits
                ],
            }
            for path, edits in by_path.items()
        ],
    }


def _location(span: Span, paths: Paths) -> dict[str, Any]:
    return {"artifactLocation": _artifact(span.source.path, paths), "region": _region(span)}


def _artifact(path: Path, paths: Paths) -> dict[str, str]:
    """A reference below the root of the sources, or else a whole URI."""
    name = PurePosixPath(paths(path))
    if name.is_absolute() or ".." in name.parts or path.drive:
        return {"uri": paths.absolute(path).as_uri()}
    return {"uri": quote(str(name)), "uriBaseId": "%SRCROOT%"}


def _region(span: Span) -> dict[str, int]:
    begin, finish = span.begin, span.finish
    return {
        "startLine": begin.line,
        "startColumn": begin.column,
        "endLine": finish.line,
        "endColumn": finish.column,
    }


def _hashes(diagnostics: Iterable[Diagnostic]) -> dict[tuple[Source, int], str]:
    """GitHub's fingerprints of all lines on which diagnostics begin."""
    lines: dict[Source, set[int]] = {}
    for diagnostic in diagnostics:
        lines.setdefault(diagnostic.span.source, set()).add(diagnostic.span.begin.line)
    return {
        (source, line): value
        for source, wanted in lines.items()
        for line, value in line_hashes(source.text, wanted).items()
    }
