"""The expanded text with comments that say where each element was written."""

from __future__ import annotations

from pathlib import Path

from sdfcheck.source.document import Element
from sdfcheck.source.relative import relative_path
from sdfcheck.source.text import Span
from sdfcheck.xacro.origins import ExpandedDocument

_RUN = "--"


def annotated(document: ExpandedDocument) -> str:
    """The text, with a comment before every element that is on a line of its own.

    Elements written on consecutive lines of one file in one go share the comment of the
    element around them.
    """
    text = document.source.text
    root = document.root
    if root is None:
        return text
    pieces, at = [], 0
    starts = document.scan.starts
    for start, element in zip(starts, document.elements, strict=True):
        line = text.rfind("\n", 0, start) + 1
        if text[line:start].strip() or not _is_news(element, document):
            continue
        pieces += [text[at:line], text[line:start], f"<!-- {_origin(element, document)} -->\n"]
        at = line
    return "".join([*pieces, text[at:]])


def _is_news(element: Element, document: ExpandedDocument) -> bool:
    """Whether the comment of the element around does not say it all."""
    parent = element.parent
    if parent is None:
        return True
    spans = document.spans
    same = spans.home(element) is spans.home(parent)
    return not same or spans.origins(element) != spans.origins(parent) or "name" in element.attributes


def _origin(element: Element, document: ExpandedDocument) -> str:
    steps = "".join(f"; {step.text}: {_place(step.span)}" for step in document.origins(element))
    text = f"{_place(element.span)}{steps}".replace(", called here", "")
    while _RUN in text:
        text = text.replace(_RUN, "-")
    return text


def _place(span: Span) -> str:
    path = span.source.path
    shown = relative_path(path) if path.is_absolute() and path.is_relative_to(Path.cwd()) else str(path)
    return f"{shown}:{span.begin.line}"
