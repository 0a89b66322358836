"""Lints a xacro file: as it is written, and as what it expands to."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from sdfcheck.lint.diagnostic import Diagnostic
from sdfcheck.lint.engine import Dispatch, explain, lint_document, look_at
from sdfcheck.lint.fold import fold, settle
from sdfcheck.robot.macros import parts_in_macros
from sdfcheck.source.document import Document
from sdfcheck.xacro.expansion import Expander
from sdfcheck.xacro.prepare import prepare
from sdfcheck.xacro.static.macro_survey import Bodies
from sdfcheck.xacro.static.uncalled import unexpanded


def lint_xacro(
    document: Document,
    dispatch: Dispatch,
    expander: Expander | None,
    argument_sets: Iterable[Mapping[str, str]] = (),
) -> list[Diagnostic]:
    """All diagnostics of a xacro file, where people edit it; without ``expander`` it is only read."""
    prepared = prepare(document, expander, argument_sets)
    document.problems = [*document.problems, *prepared.problems]  # type: ignore[list-item]
    found = lint_document(document, dispatch)
    if document.root is not None and document.root.name == "robot":
        bodies = Bodies(document, unexpanded(document, prepared.documents))
        found += explain(bodies.problems, document, dispatch)
        found += look_at(list(parts_in_macros(document, bodies.elements)), document, dispatch)
    for expanded in prepared.documents:
        found += settle(lint_document(expanded, dispatch), expanded)
    return fold(found)
