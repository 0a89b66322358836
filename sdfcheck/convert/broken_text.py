"""Texts that are read as XML by guessing."""

from __future__ import annotations

from sdfcheck.formats.namespaces import declarations
from sdfcheck.source.document import Document
from sdfcheck.source.problems import (
    ContentAfterRoot,
    RepeatedAttribute,
    SyntaxDefect,
    SyntaxKind,
    TooDeep,
    UnknownEntity,
)
from sdfcheck.source.text import Span
from sdfcheck.source.wrong_usage import WrongUsage

_BEYOND_REPAIR = (ContentAfterRoot, RepeatedAttribute, SyntaxDefect, TooDeep)


def break_of(document: Document) -> Span | None:
    """The first place where some of a text would be lost if it were written anew; None if there is none."""
    return _first(document, _BEYOND_REPAIR)


def refuse_broken(document: Document) -> None:
    """Raise WrongUsage where the text is broken: consumers refuse it, or read another robot."""
    if (span := break_of(document)) is not None:
        line, column = span.begin
        place = f"{document.path}:{line}:{column}"
        raise WrongUsage(f"{place}: the text is broken here; `sdfcheck lint` says how")


def guess_in(document: Document) -> Span | None:
    """The first place where others may read another text; None if the whole of it can be compared."""
    return _first(document, (*_BEYOND_REPAIR, UnknownEntity))


def _first(document: Document, kinds: tuple[type, ...]) -> Span | None:
    found = (problem for problem in document.problems if isinstance(problem, kinds))
    # The version of XML that a declaration names does not change the text.
    spans = [p.span for p in found if getattr(p, "kind", None) is not SyntaxKind.ODD_VERSION]
    # A prefix that one element declares twice has no meaning that could be written.
    spans += [each.span for each in declarations(document) if each.first is not None]
    return min(spans, key=lambda span: span.start, default=None)
