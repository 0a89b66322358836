"""Lints files together with others: a xacro file as what it expands to, SRDF with the robots that it may be about."""

from __future__ import annotations

import re
from bisect import bisect_left, bisect_right, insort
from collections.abc import Iterable, Iterator, Mapping, Sequence, Set
from itertools import chain, islice
from pathlib import Path
from types import MappingProxyType

from sdfcheck.formats.urdf.survey import is_unknown
from sdfcheck.lint.diagnostic import Diagnostic, Severity
from sdfcheck.lint.engine import Dispatch, Xacro, explain, lint_document, look_at
from sdfcheck.lint.fold import fold, settle, with_consequences, without_repeats
from sdfcheck.robot.graph import GazeboBlock, Joint, Link
from sdfcheck.robot.part import Part
from sdfcheck.robot.resources import Pieces
from sdfcheck.robot.root import root_of
from sdfcheck.robot.semantics import find_robots, semantics_in
from sdfcheck.source.document import Document, Element, read
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Span
from sdfcheck.xacro.expansion import Expander
from sdfcheck.xacro.language import KEYWORDS, PREFIX, is_literal
from sdfcheck.xacro.origins import ExpandedDocument
from sdfcheck.xacro.prepare import UnknownParts, expand_as_launched, goes_on, has_unknown_value, prepare
from sdfcheck.xacro.problems import ExpansionFailure, Failure, UnevaluatedExpression
from sdfcheck.xacro.static.analysis import BRACES
from sdfcheck.xacro.static.definitions import keyword, visible_definitions
from sdfcheck.xacro.static.likely_mistakes import missing_prefixes
from sdfcheck.xacro.static.macro_survey import TRANSPARENT, Bodies, unexpanded

# Lints a xacro file: as it is written, and as what it expands to.


def lint_xacro(
    document: Document,
    dispatch: Dispatch,
    expander: Expander | None,
    argument_sets: Sequence[Mapping[str, str]] = (),
    *,
    variants: bool = True,
) -> list[Diagnostic]:
    """All diagnostics of a xacro file, where people edit it; without ``expander`` it is only read."""
    prepared = prepare(document, expander, argument_sets)
    document.problems = [*document.problems, *prepared.problems]  # type: ignore[list-item]
    found = lint_document(document, dispatch)
    shown = (*prepared.documents, *prepared.partial)
    built = _lint_pieces(document, unexpanded(document, shown), dispatch)
    if prepared.documents:  # the robot that consumers get does not have these pieces
        built = [each._replace(affects=()) for each in built]
    for expanded in prepared.documents:
        built += settle(lint_document(expanded, dispatch), expanded, document)
    for expanded in prepared.partial:
        if expanded.root is not None:
            built += settle(_lint_known(expanded, dispatch), expanded, document)
    # Other faults of an expression that is left as it is follow from that.
    left: dict[Path, list[Span]] = {}
    for problem in document.problems:
        if isinstance(problem, UnevaluatedExpression) or (
            isinstance(problem, ExpansionFailure) and problem.kind is Failure.EXPRESSION
        ):
            insort(left.setdefault(problem.span.source.path, []), problem.span, key=lambda span: span.start)
    calls = _left_calls(document)
    found += [
        _with_cause(_as_left(each, calls), calls)
        for each in built
        if not _overlaps(each.span, left.get(each.span.source.path, ()))
    ]
    if variants and expander is not None and not argument_sets and len(prepared.documents) == 1:
        found += _lint_variants(document, prepared.documents[0], dispatch, expander, found)
    return without_repeats(fold(found))


def _with_cause(found: Diagnostic, calls: Mapping[tuple[str, int], Span]) -> Diagnostic:
    """The same with its cause, where xacro may have been meant to read something there: a call, or a part of a file."""
    if call := calls.get((found.span.source.real_path, found.span.start)):
        return found._replace(cause=call)
    if found.cause is not None or not found.origins:
        return found
    is_left = found.span.text in KEYWORDS or BRACES.search(found.span.text)
    return found._replace(cause=found.span) if is_left else found


def _as_left(found: Diagnostic, calls: Mapping[tuple[str, int], Span]) -> Diagnostic:
    """The same without effect on any consumer, where a call leads to it that xacro leaves as it is."""
    is_led = any((step.span.source.real_path, step.span.start) in calls for step in found.origins)
    return found._replace(affects=()) if is_led else found


def _left_calls(document: Document) -> dict[tuple[str, int], Span]:
    """The places of elements that lack the prefix of xacro, and of those around them → where that is reported."""
    causes = {}
    for reading in visible_definitions(document).readings:
        written = reading.document
        for problem in missing_prefixes(written):
            for span in (problem.span, *problem.others):
                element = written.elements[bisect_right(written.scan.starts, span.start) - 1]
                for each in filter(None, (element, element.parent)):
                    causes[written.source.real_path, each.span.start] = problem.span
    return causes


def _overlaps(one: Span, others: Sequence[Span]) -> bool:
    """Has a place something in common with others of its file, which are in order?"""
    last = bisect_left(others, one.end, key=lambda span: span.start) - 1
    return last >= 0 and one.start < others[last].end


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
    return with_consequences([*found, *look_at(parts, bodies.elements, document, dispatch)])


# Lints the robots that other arguments make: each boolean turned, each empty prefix filled.

_TURNED = {"true": "false", "false": "true", "True": "False", "False": "True", "1": "0", "0": "1"}
_OFF = frozenset({"false", "False", "0"})
_OF_ENVIRONMENT = re.compile(r"^\$\(optenv\s+\w+\s+(\w+)\s*\)$")
_FILLED = "any_"
_MOST_VARIANTS = 8
_MOST_NESTED = 4
_MOST_ERRORS = 5
"""With a value that brings more of them the robot is not meant to be at all."""
_MOST_ELEMENTS = 6_000
"""So many elements all variants of a robot may have together, and each by itself."""


def _lint_variants(
    document: Document,
    robot: ExpandedDocument,
    dispatch: Dispatch,
    expander: Expander,
    known: Iterable[Diagnostic],
) -> Iterator[Diagnostic]:
    """The findings that a robot has only with another value of an argument, which each names.

    These are errors, and warnings about what only that value brings. They are warnings for this file, and do not count
    for what a consumer does with it: a branch may be for another consumer. A finding counts if it is there with all
    other values as well: turned alone, an argument may leave out what another one would bring. Where they cannot be
    expanded together, only what arguments switch on is tried.
    """
    usual = _places(robot)

    def new(arguments: Mapping[str, str]) -> list[Diagnostic] | None:
        found = _found_with(arguments, document, robot, usual, dispatch, expander)
        return found and [
            each for each in found if _where(each) not in seen and _where(each)[1:] not in repeated
        ]

    seen = set(map(_where, known))
    repeated = {(span.source.path, span.start) for each in known for span in each.repeats}
    most = min(_MOST_VARIANTS, _MOST_ELEMENTS // len(robot.elements))
    values = dict(islice(other_values(document), most))
    together = new(values) if values else []
    left = None if together is None else set(map(_where, together))
    turned = [{name: value} for name, value in values.items() if left is not None or value not in _OFF]
    for arguments in chain(turned, _nested(together or (), values, document)):
        if left is not None and left <= seen:
            return
        wrong = new(arguments) or []
        is_meant = sum(each.severity is Severity.ERROR for each in wrong) <= _MOST_ERRORS
        for each in wrong if is_meant else ():
            if left is None or _where(each) in left:
                seen.add(_where(each))
                given = " and ".join(f"`{name}:={value}`" for name, value in arguments.items())
                message = f"{each.message} (with {given})"
                yield each.without_fix._replace(message=message, severity=Severity.WARNING, affects=())


def _nested(
    found: Iterable[Diagnostic], values: Mapping[str, str], document: Document
) -> Iterator[dict[str, str]]:
    """The values that it takes to reach an error in a branch within a branch, or in a file that a branch includes."""
    files = {
        reading.document.source.real_path: reading.document
        for reading in visible_definitions(document).readings
    }
    tried: set[frozenset[str]] = set()
    for each in found:
        words: set[str] = set()
        for span in (each.span, *(origin.span for origin in each.origins)):
            if written := files.get(span.source.real_path):
                number = bisect_right(written.scan.starts, span.start) - 1
                around = written.elements[number].around if number >= 0 else ()
                conditions = (
                    part.text_of("value", "") for part in around if keyword(part) in {"if", "unless"}
                )
                words.update(re.findall(r"\w+", " ".join(conditions)))
        needed = frozenset(words.intersection(values))
        if len(needed) > 1 and needed not in tried and len(tried) < _MOST_NESTED:
            tried.add(needed)
            yield {name: value for name, value in values.items() if name in needed}


def _found_with(
    arguments: Mapping[str, str],
    document: Document,
    robot: ExpandedDocument,
    usual: Set[tuple[str, int]],
    dispatch: Dispatch,
    expander: Expander,
) -> list[Diagnostic] | None:
    """The errors of a robot with other arguments, and the warnings about elements that are not the ``usual`` ones.

    None where it cannot be expanded, none where it is too large.
    """
    expansion = expander.expand(document, arguments)
    expanded = expansion.document
    if expanded is None:
        return None if goes_on(expansion) else []
    if expanded.source.text == robot.source.text or len(expanded.elements) > _MOST_ELEMENTS:
        return []
    if _has_links(robot) and not _has_links(expanded):
        return []  # the argument leaves the robot out, as it is meant to
    expanded.library = document.library
    brought = _places(expanded) - usual
    found = fold(
        settle(lint_document(expanded, dispatch if brought else dispatch.of_errors), expanded, document)
    )

    def counts(each: Diagnostic) -> bool:
        at = expanded.provenance.last_before(each.span.source, each.span.start)
        is_brought = at >= 0 and _place(expanded, at) in brought
        return each.severity is Severity.ERROR or (each.severity is Severity.WARNING and is_brought)

    return [each for each in found if counts(each)]


def _places(document: ExpandedDocument) -> set[tuple[str, int]]:
    """The files that the elements of an expansion are from, and where they begin there."""
    return {_place(document, number) for number in range(len(document.elements))}


def _place(document: ExpandedDocument, number: int) -> tuple[str, int]:
    provenance = document.provenance
    return str(provenance.source(number).path), provenance.offset(number)


def _has_links(robot: ExpandedDocument) -> bool:
    return robot.root is not None and robot.root.has("link")


def _where(found: Diagnostic) -> tuple[str, Path, int]:
    return found.code, found.span.source.path, found.span.start


def other_values(document: Document) -> Iterator[tuple[str, str]]:
    """Names of arguments, each with a value that its default is not."""
    visible = visible_definitions(document)
    defaults: dict[str, str] = {}
    for reading in visible.readings:
        defaults = {**reading.arguments, **defaults}
    conditions = " ".join(
        element.text_of("value") or ""
        for reading in visible.readings
        for element, _ in reading.elements
        if keyword(element) in {"if", "unless"}
    )
    for name, given in defaults.items():
        default = _OF_ENVIRONMENT.sub(r"\1", given)
        if default in _TURNED and (default not in {"0", "1"} or f"arg {name})" in conditions):
            yield name, _TURNED[default]
        elif not default and name.endswith("prefix"):
            yield name, _FILLED


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
    """The parts of links and joints, plugins and files, that elements in macros of a document for xacro make.

    And sensors, where it is expanded, which may lack what an uncalled macro would get.
    """
    robot = root_of(document).scopes[0]
    pieces = Pieces(robot, elements)
    if pieces.resources:
        yield pieces
        yield from pieces.resources
    for element in pieces.elements:
        if element.name == "gazebo":
            block = GazeboBlock(robot, element)
            yield from block.plugins
            yield from filter(_is_whole, block.sensors if isinstance(document, ExpandedDocument) else ())
        owner = _OWNERS.get(element.name)
        place = next((each for each in element.around if each.name not in TRANSPARENT), None)
        if owner is None or place is None:
            continue
        holder = robot.registry.get(place)
        if holder is None:
            holder = robot.registry[place] = owner(robot, place)
        yield holder.part(element)


def _is_whole(part: Part) -> bool:
    """Is nothing in it left that xacro would have read?"""
    return not any(each.name.startswith(PREFIX) for each in part.element.below)


# Lints SRDF: with the robots that it may be about, and where it is written in xacro, as it expands.


def lint_semantics(document: Document, dispatch: Dispatch, xacro: Xacro | None) -> list[Diagnostic]:
    """All diagnostics of an SRDF file; of one for xacro those of what it expands to, if it does."""
    expander = xacro.expander if xacro is not None else None
    if "<xacro:" not in document.source.text:
        _find_robots(document, expander)
        return lint_document(document, dispatch)
    written = read(document.source.text.encode(), document.path, Kind.XACRO)
    written.library = document.library
    expanded = None if expander is None else expand_as_launched(written, expander.expand, {}).document
    if expanded is None or expanded.root is None or expanded.root.name != "robot":
        return []
    expanded.kind, expanded.library = Kind.SRDF, document.library
    declared = (each for known in visible_definitions(written).readings for each in known.arguments.items())
    _find_robots(expanded, expander, {name: text for name, text in declared if text and is_literal(text)})
    return fold(settle(lint_document(expanded, dispatch), expanded, written))


def _find_robots(
    document: Document, expander: Expander | None, given: Mapping[str, str] = MappingProxyType({})
) -> None:
    """Find them, expanded with the arguments of the file, which launch files give to both, if they can be."""

    def expand(robot: Document, arguments: Mapping[str, str]) -> Document | None:
        assert expander is not None
        for values in ({**given, **arguments}, arguments):
            found = expand_as_launched(robot, expander.expand, values).document
            if found is not None or not given:
                return found
        return None

    for semantics in semantics_in(document):
        find_robots(semantics, expand if expander is not None else None)
