"""Our own JSON, version 1.

Lines and columns count from 1, columns in code points, offsets in code points from 0
(a byte order mark is not counted); ends are exclusive. Every key is always there.
"""

from __future__ import annotations

import json
from collections.abc import Iterable
from typing import Any

from sdfcheck.lint.diagnostic import Diagnostic, Label, Missing, Origin, Severity
from sdfcheck.lint.fix import Fix
from sdfcheck.lint.run import Run
from sdfcheck.release import __version__
from sdfcheck.report.paths import Paths
from sdfcheck.source.text import Source, Span

VERSION = 1


def render(run: Run) -> str:
    """One object; each diagnostic in it has a line of its own."""
    paths = Paths()
    parts = {
        "version": json.dumps(VERSION),
        "tool": json.dumps({"name": "sdfcheck", "version": __version__}),
        "diagnostics": _lines(diagnostic_lines(run, paths)),
        "skipped": _lines(
            json.dumps({"file": paths(path), "reason": reason}) for path, reason in sorted(run.skipped)
        ),
        "summary": json.dumps(_summary(run)),
    }
    return "{\n" + ",\n".join(f"{json.dumps(key)}: {part}" for key, part in parts.items()) + "\n}\n"


def diagnostic_lines(run: Run, paths: Paths) -> list[str]:
    """The diagnostics, each as JSON without a line end."""
    pages = run.pages if run.diagnostics else {}
    return [json.dumps(_diagnostic(found, paths, pages.get(found.code))) for found in run.diagnostics]


def _lines(items: Iterable[str]) -> str:
    lines = ",\n".join(items)
    return f"[\n{lines}\n]" if lines else "[]"


def _diagnostic(diagnostic: Diagnostic, paths: Paths, page: str | None) -> dict[str, Any]:
    return {
        "code": diagnostic.code,
        "name": diagnostic.name,
        "url": page,
        "severity": diagnostic.severity.value,
        "message": diagnostic.message,
        "file": paths(diagnostic.span.source.path),
        "range": _range(diagnostic.span),
        "related": [_place(label, paths) for label in diagnostic.labels],
        "origins": [_place(origin, paths) for origin in diagnostic.origins],
        "help": diagnostic.help,
        "fix": _fix(diagnostic.fix, paths) if diagnostic.fix is not None else None,
        "affects": {
            consumer: {"verdict": reaction.verdict.value, "effect": reaction.words}
            for consumer, reaction in diagnostic.affects
        },
        "missing": _missing(diagnostic.missing) if diagnostic.missing is not None else None,
    }


def _missing(missing: Missing) -> dict[str, Any]:
    return {"kind": missing.kind.name.lower(), "name": missing.name, "uses": missing.uses}


def _place(place: Label | Origin, paths: Paths) -> dict[str, Any]:
    return {"file": paths(place.span.source.path), "range": _range(place.span), "message": place.text}


def _fix(fix: Fix, paths: Paths) -> dict[str, Any]:
    return {
        "applicability": fix.applicability.value,
        "message": fix.title,
        "edits": [
            {"file": paths(edit.span.source.path), "range": _range(edit.span), "text": edit.text}
            for edit in sorted(fix.edits, key=lambda edit: (edit.span.start, edit.span.end))
        ],
    }


def _range(span: Span) -> dict[str, Any]:
    return {"start": _position(span.source, span.start), "end": _position(span.source, span.end)}


def _position(source: Source, offset: int) -> dict[str, int]:
    line, column = source.position(offset)
    return {"line": line, "column": column, "offset": offset}


def _summary(run: Run) -> dict[str, int]:
    fixes = [diagnostic.fix for diagnostic in run.diagnostics if diagnostic.fix is not None]
    return {
        "files": len(run.files),
        "errors": run.count(Severity.ERROR),
        "warnings": run.count(Severity.WARNING),
        "infos": run.count(Severity.INFO),
        "safe_fixes": run.fixable,
        "unsafe_fixes": len(fixes) - run.fixable,
        "fixed": run.fixed,
        "suppressed": run.suppressed,
        "missing": len(run.missing),
        "failing": len(run.failing),
    }
