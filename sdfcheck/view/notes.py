"""What is listed beside a scene: findings, and the part that each is about."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

from sdfcheck.lint.diagnostic import Diagnostic
from sdfcheck.lint.run import Run
from sdfcheck.robot.root import root_of
from sdfcheck.source.document import Document
from sdfcheck.source.text import Span


def findings(run: Run, document: Document) -> list[dict[str, Any]]:
    """The findings of a run, with the link or joint in which each is."""
    parts = sorted(_parts(document), key=lambda part: part[0].end - part[0].start)
    pages = run.pages
    return [
        {
            "severity": found.severity.value,
            "code": found.code,
            "name": found.name,
            "message": found.message,
            "place": f"{found.span.source.path.name}:{found.span.begin.line}",
            "url": pages.get(found.code),
            "part": _part(found, parts),
        }
        for found in run.diagnostics
    ]


def _parts(document: Document) -> Iterator[tuple[Span, str]]:
    """Links and joints that the file writes, with all that is in them."""
    root = root_of(document)
    for kind in ("Link", "Joint"):
        for part in root.each(kind):
            yield document.spans.whole(part.element), part.name


def _part(found: Diagnostic, parts: Iterable[tuple[Span, str]]) -> str | None:
    """The innermost part around a finding; of what a macro made, the part that it was made for."""
    span = found.span
    for whole, name in parts:
        if whole.source.path == span.source.path and whole.start <= span.start < whole.end:
            return name
    return None
