"""Lints files together with others: a xacro file as what it expands to, SRDF with the robots that it may be about."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from sdfcheck.lint.diagnostic import Diagnostic
from sdfcheck.lint.engine import Dispatch, Xacro, explain, lint_document, look_at
from sdfcheck.lint.fold import fold, settle, without_repeats
from sdfcheck.robot.graph import GazeboBlock, Joint, Link
from sdfcheck.robot.part import Part
from sdfcheck.robot.resources import Pieces
from sdfcheck.robot.root import root_of
from sdfcheck.robot.semantics import find_robots, semantics_in
from sdfcheck.source.document import Document, Element, read
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Span
from sdfcheck.xacro.expansion import Expander
from sdfcheck.xacro.language import KEYWORDS
from sdfcheck.xacro.origins import ExpandedDocument
from sdfcheck.xacro.prepare import UnknownParts, has_unknown_value, is_unknown, prepare
from sdfcheck.xacro.problems import UnevaluatedExpression
from sdfcheck.xacro.static.analysis import BRACES
from sdfcheck.xacro.static.macro_survey import TRANSPARENT, Bodies, unexpanded

# Lints a xacro file: as it is written, and as what it expands to.


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
    built = _lint_pieces(document, unexpanded(document, shown), dispatch)
    for expanded in prepared.documents:
        built += settle(lint_document(expanded, dispatch), expanded, document)
    for expanded in prepared.partial:
        if expanded.root is not None:
            built += settle(_lint_known(expanded, dispatch), expanded, document)
    # Other faults of an expression that is left as it is follow from that.
    left = [problem.span for problem in document.problems if isinstance(problem, UnevaluatedExpression)]
    found += [_with_cause(each) for each in built if not any(_overlap(each.span, span) for span in left)]
    return without_repeats(fold(found))


def _with_cause(found: Diagnostic) -> Diagnostic:
    """The same, with its own place as the cause where another file has what xacro may have been meant to read there."""
    if found.cause is not None or not found.origins:
        return found
    is_left = found.span.text in KEYWORDS or BRACES.search(found.span.text)
    return found._replace(cause=found.span) if is_left else found


def _overlap(one: Span, other: Span) -> bool:
    return one.source.path == other.source.path and one.start < other.end and other.start < one.end


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


# Parts of URDF in macros of xacro, where no robot shows them.

_OWNERS: dict[str, type[Link | Joint]] = {
    "axis": Joint,
    "collision": Link,
    "inertial": Link,
    "limit": Joint,
    "visual": Link,
}
"""Class → the class of the holder: a macro without one is taken for it."""


def parts_in_macros(document: Document, elements: Iterable[Element]) -> Iterator[Part]:
    """The parts of links and joints, plugins and files, that elements in macros of a document for xacro make."""
    robot = root_of(document).scopes[0]
    pieces = Pieces(robot, elements)
    if pieces.resources:
        yield pieces
        yield from pieces.resources
    for element in pieces.elements:
        if element.name == "gazebo":
            yield from GazeboBlock(robot, element).plugins
        owner = _OWNERS.get(element.name)
        place = next((each for each in element.around if each.name not in TRANSPARENT), None)
        if owner is None or place is None:
            continue
        holder = robot.registry.get(place)
        if holder is None:
            holder = robot.registry[place] = owner(robot, place)
        yield holder.part(element)


# Lints SRDF: with the robots that it may be about, and where it is written in xacro, as it expands.


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
