"""Reads one file and lints it, a xacro file also as what it expands to."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from sdfcheck.lint.diagnostic import Diagnostic
from sdfcheck.lint.engine import Dispatch, Xacro, lint_document
from sdfcheck.source.document import Document, read
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Span

if TYPE_CHECKING:
    from sdfcheck.files.library import Library
    from sdfcheck.lint.suppress.directives import Comment


class FileResult(NamedTuple):
    diagnostics: list[Diagnostic]
    comments: Sequence[Comment] = ()
    """Those that speak to sdfcheck."""
    outward: Sequence[Span] = ()
    """Where comments may be for what other files bring out."""
    document: Document | None = None
    """The document that the comments are in."""


def lint_source(
    data: bytes,
    path: Path,
    kind: Kind | None,
    dispatch: Dispatch,
    library: Library | None = None,
    xacro: Xacro | None = None,
) -> FileResult:
    """Read and lint one file's bytes. Any text gives diagnostics.

    Other files are taken from the library; without one nothing is looked up.
    """
    document = library.known(data, path) if library is not None else None
    is_own = document is None or document.kind is not (kind or document.kind)
    if document is None or is_own:
        document = read(data, path, kind)
    document.library, document.included_by = library, ()
    if document.kind is Kind.URDF and library is not None:
        from sdfcheck.xacro.prepare import is_fragment

        if is_fragment(document):
            document, is_own = read(data, path, Kind.XACRO), True
            document.library = library
    if library is not None and is_own:
        library.turn_to(document)
    if document.kind is Kind.SRDF:
        from sdfcheck.lint.semantics import lint_semantics

        return result(lint_semantics(document, dispatch, xacro), document)
    if document.kind is Kind.XACRO:
        from sdfcheck.lint.expanded import lint_xacro
        from sdfcheck.xacro.static.definitions import is_robot

        expander, sets = xacro or Xacro(None)
        # A file that includes this one calls its macros, and shows the problems in them.
        is_open = expander is None or not is_robot(document)
        return result(lint_xacro(document, dispatch, expander, sets), document, open=is_open)
    return result(lint_document(document, dispatch), document)


def result(diagnostics: list[Diagnostic], document: Document, *, open: bool = False) -> FileResult:
    """The diagnostics that the document's comments leave; all of it if it is ``open`` to others."""
    source = document.source
    if "sdfcheck:" not in source.text or document.root is None:
        return FileResult(diagnostics)
    from sdfcheck.lint.suppress.directives import comments, includes

    whole = [source.span(0, len(source.text))]
    outward = whole if open else includes(source, document.scan)
    return FileResult(diagnostics, comments(source, document.scan), outward, document)
