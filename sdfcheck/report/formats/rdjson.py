"""reviewdog's diagnostic format; columns count UTF-8 bytes."""

from __future__ import annotations

import json
from typing import Any

from sdfcheck.lint.diagnostic import Diagnostic, Severity
from sdfcheck.lint.run import Run
from sdfcheck.release import HOME
from sdfcheck.report.paths import Paths
from sdfcheck.source.text import Source, Span


def render(run: Run) -> str:
    paths, pages = Paths(), run.pages
    result = {
        "source": {"name": "sdfcheck", "url": HOME},
        "diagnostics": [
            _diagnostic(diagnostic, run.gate.severity(diagnostic), paths, pages.get(diagnostic.code))
            for diagnostic in run.diagnostics
        ],
    }
    return json.dumps(result, indent=2) + "\n"


def _diagnostic(diagnostic: Diagnostic, severity: Severity, paths: Paths, page: str | None) -> dict[str, Any]:
    source = diagnostic.span.source
    shown: dict[str, Any] = {
        "message": diagnostic.message,
        "location": {"path": paths(source.path), "range": _range(diagnostic.span)},
        "severity": severity.name,
        "code": {"value": diagnostic.code, **({"url": page} if page else {})},
    }
    # A suggestion has no path: it can only be for the file of the diagnostic.
    edits = diagnostic.fix.edits if diagnostic.fix is not None else ()
    suggestions = [
        {"range": _range(edit.span), "text": edit.text}
        for edit in sorted(edits, key=lambda edit: (edit.span.start, edit.span.end))
        if edit.span.source.path == source.path
    ]
    if suggestions:
        shown["suggestions"] = suggestions
    return shown


def _range(span: Span) -> dict[str, Any]:
    return {"start": _position(span.source, span.start), "end": _position(span.source, span.end)}


def _position(source: Source, offset: int) -> dict[str, int]:
    # In ASCII a column is a column; counting bytes takes long where one line is the whole file.
    is_ascii = source.text.isascii()
    line, column = source.position(offset) if is_ascii else source.utf8_position(offset)
    return {"line": line, "column": column}
