"""Lints a xacro file: as it is written, and as what it expands to."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from sdfcheck.lint.diagnostic import Diagnostic
from sdfcheck.lint.engine import Dispatch, explain, lint_document, look_at
from sdfcheck.lint.fold import fold, settle, without_repeats
from sdfcheck.robot.includes.macros import parts_in_macros
from sdfcheck.source.document import Document, Element
from sdfcheck.xacro.expansion import Expander
from sdfcheck.xacro.origins import ExpandedDocument
from sdfcheck.xacro.prepare import prepare
from sdfcheck.xacro.static.macro_survey import Bodies
from sdfcheck.xacro.static.uncalled import unexpanded
from sdfcheck.xacro.unknown import UnknownParts, has_unknown_value, is_unknown


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
    shown = (*prepared.documents, *prepared.partial)
    found += _lint_pieces(document, unexpanded(document, shown), dispatch)
    for expanded in prepared.documents:
        found += settle(lint_document(expanded, dispatch), expanded, document)
    for expanded in prepared.partial:
        if expanded.root is not None:
            found += settle(_lint_known(expanded, dispatch), expanded, document)
    return without_repeats(fold(found))


def _lint_known(expanded: ExpandedDocument, dispatch: Dispatch) -> Iterator[Diagnostic]:
    """The problems of a partial expansion that do not depend on what is not known."""
    assert expanded.root is not None
    if expanded.is_open:
        found, depends = _lint_pieces(expanded, [expanded.root], dispatch), has_unknown_value
    else:
        found, depends = lint_document(expanded, dispatch), UnknownParts(expanded).touch
    for each in found:
        places = (expanded.written(span) for span in (each.span, *(label.span for label in each.labels)))
        if not any(map(depends, places)) and not is_unknown(each.message.replace(each.span.text, "")):
            yield each


def _lint_pieces(document: Document, pieces: Iterable[Element], dispatch: Dispatch) -> list[Diagnostic]:
    """The problems of some elements of a robot, whatever the rest of it may be."""
    if document.root is None or document.root.name != "robot":
        return []
    bodies = Bodies(document, pieces)
    found = list(explain(bodies.problems, document, dispatch))
    parts = list(parts_in_macros(document, bodies.elements))
    return found + list(look_at(parts, bodies.elements, document, dispatch))
