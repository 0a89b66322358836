"""Lints SRDF: with the robots that it may be about, and where it is written in xacro, as it expands."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from sdfcheck.lint.diagnostic import Diagnostic
from sdfcheck.lint.engine import Dispatch, Xacro, lint_document
from sdfcheck.lint.fold import fold, settle
from sdfcheck.robot.semantics.robots import find_robots
from sdfcheck.robot.semantics.semantics import semantics_in
from sdfcheck.source.document import Document, read
from sdfcheck.source.sniff import Kind

if TYPE_CHECKING:
    from sdfcheck.xacro.expansion import Expander


def lint_semantics(document: Document, dispatch: Dispatch, xacro: Xacro | None) -> list[Diagnostic]:
    """All diagnostics of an SRDF file; of one for xacro those of what it expands to, if it does."""
    expander = xacro.expander if xacro is not None else None
    if "<xacro:" not in document.source.text:
        _find_robots(document, expander)
        return lint_document(document, dispatch)
    written = read(document.source.text.encode(), document.path, Kind.XACRO)
    written.library = document.library
    expanded = None if expander is None else expander.expand(written).document
    if expanded is None or expanded.root is None or expanded.root.name != "robot":
        return []
    expanded.kind, expanded.library = Kind.SRDF, document.library
    _find_robots(expanded, expander)
    return fold(settle(lint_document(expanded, dispatch), expanded, written))


def _find_robots(document: Document, expander: Expander | None) -> None:
    def expand(robot: Document, arguments: Mapping[str, str]) -> Document | None:
        assert expander is not None
        return expander.expand(robot, arguments).document

    for semantics in semantics_in(document):
        find_robots(semantics, expand if expander is not None else None)
