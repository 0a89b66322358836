"""Why something does not fit the table of a format: the explaining side of the walk.

Loaded only when there is something to explain. Each method takes one thing that the walk did not accept at
once and either finds that it is sound after all or notes a problem.
"""

from __future__ import annotations

import re
from abc import ABC, abstractmethod
from collections import Counter
from collections.abc import Hashable, Iterator

from sdfcheck.formats import history, problems
from sdfcheck.formats.choices import Verdict
from sdfcheck.formats.near_names import suggest
from sdfcheck.formats.problems import (
    DeprecatedElement,
    MalformedValue,
    MissingAttribute,
    MissingElement,
    RemovedElement,
    RepeatedElement,
    StrayText,
    UnknownAttribute,
)
from sdfcheck.formats.reading import Outcome, Reading
from sdfcheck.formats.schema import AttributeDefinition, Definition, RowInVersion
from sdfcheck.formats.sdf.values import read_at
from sdfcheck.formats.topology import Displaced, standard_inside
from sdfcheck.formats.version import NEWEST, Version
from sdfcheck.source.document import Aside, Document, Element, Spans, Value
from sdfcheck.source.text import Span, pattern

MOST = 10
"""So many unknown attributes of one element are reported one by one."""


class Findings(ABC):
    """The problems of one document, collected during its walk."""

    def __init__(self, document: Document, version: Version) -> None:
        self.document = document
        self.version = version
        self.found: list[object] = []
        self.customs: list[tuple[Element, Element, Definition]] = []
        """Custom elements in standard ones, with their parent and its definition."""
        self.displaced: dict[Element, tuple[Displaced, ...]] = {}
        """Custom elements → the standard ones in them that could be beside them."""
        self.stray: set[Element] = set()
        """Elements whose text is reported, or is explained by something else that is."""
        self.strange: Counter[Element] = Counter()
        """How many unknown attributes an element has."""

    def unexpected(self, child: Element, parent: Element, place: Definition) -> Definition | None:
        """A child that the version does not list; returns its definition if only the version is too old."""
        if ":" in child.name:
            self.custom(child, parent, place)
            return None
        definition = history.later(place, child.name)
        if definition is None:
            self.unknown_element(child, parent, place)
        else:
            self.too_new(child, definition, "", history.since(place, child.name))
        return definition

    def attribute(self, element: Element, definition: Definition, key: str, text: str) -> None:
        """An attribute that the version does not list, or whose value is not accepted at once."""
        known = definition.attributes.get(key)
        if known is None:
            newest = history.in_version(definition, definition.schema.format.newest)
            known = newest.attributes.get(key) if newest is not None else None
            if newest is None or known is None:
                self.unknown_attribute(element, definition, key)
                return
            self.too_new(element, definition, key, history.since(definition, f"@{key}"))
            definition = newest
        self.attribute_value(element, definition, known, text)

    @abstractmethod
    def unknown_element(self, child: Element, parent: Element, place: Definition) -> None:
        """An element that neither the version nor a later one has there."""

    @abstractmethod
    def unknown_attribute(self, element: Element, definition: Definition, name: str) -> None:
        """The same for an attribute."""

    @abstractmethod
    def too_new(self, element: Element, definition: Definition, attribute: str, since: Version) -> None:
        """An element, or an attribute of it, that is in its place in a later version."""

    @abstractmethod
    def attribute_value(
        self, element: Element, definition: Definition, known: AttributeDefinition, text: str
    ) -> None:
        """The value of a known attribute, which is not accepted at once."""

    @abstractmethod
    def repeated(self, element: Element, first: Element, parent: Element) -> bool:
        """A second element where one may be; returns whether nobody looks at what is in it."""

    @abstractmethod
    def missing(self, parent: Element, place: Definition, name: str) -> None:
        """A required child that is not there."""

    @abstractmethod
    def missing_attribute(self, element: Element, definition: Definition, name: str) -> None:
        """A required attribute that is not there."""

    @abstractmethod
    def conclude(self) -> list[object]:
        """Everything found, once the walk is over."""

    @abstractmethod
    def value(self, element: Element, parent: Element, definition: Definition) -> None:
        """A leaf whose text is not accepted at once."""

    def deprecated(self, element: Element, definition: Definition) -> None:
        """An element that is marked deprecated."""
        self.found.append(DeprecatedElement(element, None, *history.deprecation(definition)))

    def several(self, element: Element, place: Definition) -> None:
        """The elements in one of which only the first counts; a format whose rows say ``exclusive`` has it."""
        raise NotImplementedError

    def wrapped(self, element: Element, definition: Definition) -> None:
        """An element whose attributes have tabs or line breaks; a format whose walk asks for them has it."""
        raise NotImplementedError

    def custom(self, child: Element, parent: Element, place: Definition) -> None:
        """A prefixed element: free, except that it must not hold what belongs to the standard."""
        self.customs.append((child, parent, place))
        if displaced := tuple(standard_inside(child, parent, place)):
            self.displaced[child] = displaced

    def stray_text(self, element: Element) -> None:
        """Text in an element that holds only elements."""
        if element in self.stray:
            return
        self.stray.add(element)
        if (found := stray_text(element)) is not None:
            self.found.append(StrayText(*found, element))

    def is_one_too_many(self, element: Element) -> bool:
        """Counts an unknown attribute; of very many in one element only the first are reported."""
        self.strange[element] += 1
        return self.strange[element] > MOST


def folded(found: list[object]) -> list[object]:
    """The problems, with one for all repeats of an element, for all uses of a removed name, and for one attribute."""
    alike: dict[Hashable, list[Element]] = {}
    first_of_kind: list[object] = []
    for problem in found:
        if (kind := _kind(problem)) is None:
            first_of_kind.append(problem)
            continue
        assert isinstance(problem, _Foldable)
        if kind not in alike:
            first_of_kind.append(problem)
        alike.setdefault(kind, []).append(problem.element)
    return [_with_others(problem, alike) for problem in first_of_kind]


def folded_attributes(found: list[object]) -> list[object]:
    """The problems, with one for all attributes of an element that should be children, missing ones included."""
    written: dict[Element, dict[str, UnknownAttribute]] = {}
    for each in found:
        if isinstance(each, UnknownAttribute) and each.child is not None:
            written.setdefault(each.element, {})[each.child] = each
    if not written:
        return found
    missing: dict[Element, list[MissingElement]] = {}
    rest: list[object] = []
    for each in found:
        if isinstance(each, MissingElement) and each.child in written.get(each.element, ()):
            missing.setdefault(each.element, []).append(each)
        elif not (isinstance(each, UnknownAttribute) and each.child is not None):
            rest.append(each)
    return rest + [
        _as_one(list(each.values()), missing.get(element, [])) for element, each in written.items()
    ]


def _as_one(attributes: list[UnknownAttribute], missing: list[MissingElement]) -> object:
    """The attributes of an element that should be children, as one problem: of the first child that is missing."""
    if not missing:
        first, *others = attributes
        return first.changed(others=tuple(each.attribute for each in others))
    ordered = sorted(attributes, key=lambda each: each.child != missing[0].child)
    names = tuple(each.attribute for each in ordered)
    return missing[0].changed(attributes=names, refused=any(each.refused for each in missing))


def folded_values(found: list[object]) -> list[object]:
    """The problems, with one for an element that is empty and its only attribute, which it does not have."""
    strange: dict[Element, list[UnknownAttribute]] = {}
    for each in found:
        if isinstance(each, UnknownAttribute) and len(each.element.attributes) == 1:
            strange.setdefault(each.element, []).append(each)
    empty = {
        each.value.element
        for each in found
        if isinstance(each, MalformedValue) and each.value.attribute is None and not each.value.text.strip()
    }
    both = empty & strange.keys()
    if not both:
        return found
    return [
        each.changed(attribute=strange[each.value.element][0].attribute)
        if isinstance(each, MalformedValue) and each.value.element in both
        else each
        for each in found
        if not (isinstance(each, UnknownAttribute) and each.element in both)
    ]


def folded_texts(found: list[object]) -> list[object]:
    """The problems, with one for an element that holds a text in place of the children that it lacks."""
    texts = {each.element: each for each in found if isinstance(each, StrayText)}
    alone = {element: text for element, text in texts.items() if not any(element.children())}
    lacking: dict[Element, list[MissingElement]] = {}
    for each in found if alone else ():
        if isinstance(each, MissingElement) and each.element in alone:
            lacking.setdefault(each.element, []).append(each)
    result = [
        each
        for each in found
        if not (isinstance(each, StrayText | MissingElement) and each.element in lacking)
    ]
    for element, (first, *others) in lacking.items():
        span = alone[element].span
        is_whole = first.fits and not others and span.text == element.content
        result.append(
            first.changed(
                text=span,
                others=tuple(each.child for each in others),
                refused=first.refused or any(each.refused for each in others),
                fits=is_whole,
            )
        )
    return result


def folded_children(found: list[object]) -> list[object]:
    """The problems, with one for all children that an element lacks."""
    result: list[object] = []
    first: dict[tuple[Element, bool, Span | None], int] = {}
    for each in found:
        if isinstance(each, MissingElement) and each.text is None and not each.attributes:
            at = first.setdefault((each.element, each.refused, each.cause), len(result))
            if at < len(result):
                one = result[at]
                assert isinstance(one, MissingElement)
                result[at] = one.changed(others=(*one.others, each.child))
                continue
        result.append(each)
    return result


def counted(found: list[object], strange: Counter[Element]) -> list[object]:
    """The problems; where an element has too many unknown attributes, its first says how many there are."""
    reported: set[Element] = set()
    result = []
    for problem in found:
        if isinstance(problem, UnknownAttribute) and strange[problem.element] > MOST:
            element = problem.element
            more = 0 if element in reported else strange[element] - 1
            reported.add(element)
            problem = problem.changed(more=more)  # noqa: PLW2901
        result.append(problem)
    return result


_Foldable = RepeatedElement | RemovedElement | MissingAttribute


def _kind(problem: object) -> Hashable:
    """The common part of like problems; None for one that is reported alone."""
    if isinstance(problem, RepeatedElement) and not problem.refused:
        return problem.first
    if isinstance(problem, RemovedElement):
        return problem.element.name, problem.parent.name, problem.attribute
    if isinstance(problem, MissingAttribute) and not problem.elements and not problem.element.content:
        element, parent = problem.element, problem.element.parent
        return element.title, parent and parent.name, problem.attribute, problem.empty, problem.cause
    return None


def _with_others(problem: object, alike: dict[Hashable, list[Element]]) -> object:
    kind = _kind(problem)
    others = tuple(alike[kind][1:]) if kind is not None else ()
    if others and isinstance(problem, _Foldable):
        return problem.changed(others=others)
    return problem


# The problem of a value that was not accepted at once, if it has one.

_KINDS = {Outcome.MISREAD: problems.MisreadValue, Outcome.WRONG_COUNT: problems.WrongComponentCount}


def text_problems(element: Element, definition: Definition) -> Iterator[object]:
    """The problems of the text of an element that holds a value."""
    newest = history.in_version(definition, NEWEST) or definition
    value = element.own_value
    rotation = element.attribute("rotation_format") if "rotation_format" in newest.attributes else None
    degrees = element.attribute("degrees")
    if rotation is not None and degrees is not None and _exclude_each_other(rotation, degrees):
        yield problems.ConflictingRotation(degrees, rotation)
    elif not value.text:
        # An empty pose is a usual way to leave it at the default; an empty number is not. Its children are reported.
        is_split = any(":" not in child.name for child in element.children())
        if newest.needs_value or not (is_split or definition.type in {"pose", "string"}):
            reading = _as_read(definition, read_at(newest, ""))
            yield problems.MalformedValue(value, definition, reading, element.span)
    elif cut := cut_text(element):
        yield problems.CutText(value, cut)
    elif rotation is not None:
        yield from judge(value, newest, read_at(newest, value.text, rotation.text.strip() or "euler_rpy"))
    elif not definition.accepts(value.text) and (
        newest.type != definition.type or not newest.accepts(value.text)
    ):
        yield from judge(value, definition, _as_read(definition, read_at(definition, value.text)))


def _as_read(definition: Definition, reading: Reading) -> Reading:
    """The same reading, but not refused where no consumer reads the value."""
    return reading._replace(refused=reading.refused and history.is_read(definition))


def _exclude_each_other(rotation: Value, degrees: Value) -> bool:
    return rotation.text.strip() == "quat_xyzw" and degrees.text.strip().lower() in {"true", "1"}


def judge(value: Value, definition: RowInVersion, reading: Reading) -> Iterator[object]:
    """Turn a reading into the problem that it is."""
    if reading.outcome is Outcome.NOT_A_CHOICE:
        yield from _choice(value, definition, reading)
    else:
        yield from problem_of(value, definition, reading)


def problem_of(value: Value, definition: RowInVersion, reading: Reading) -> Iterator[object]:
    """The problem of a number or truth value, if there is one."""
    if reading.is_fine:
        return
    span = part(value, reading.start, reading.end)
    if reading.outcome is Outcome.OUT_OF_RANGE:
        instead = reading.range.instead if reading.range else None
        yield problems.ValueOutOfRange(value, span, str(reading.range), reading.refused, instead)
    elif reading.outcome is Outcome.NOT_FINITE:
        yield problems.ValueOutOfRange(value, span, "finite", reading.refused)
    else:
        kind = _KINDS.get(reading.outcome, problems.MalformedValue)
        yield kind(value, definition, reading, span)


def _choice(value: Value, definition: RowInVersion, reading: Reading) -> Iterator[problems.UnknownChoice]:
    """A value that is not in the list of the version, which need not keep anybody from reading it."""
    choices = definition.choices
    assert choices is not None
    doubtful = reading.verdict in {Verdict.UNKNOWN, Verdict.WRONG_CASE, Verdict.REMOVED}
    # Of what is in its own list libsdformat makes what it can, whatever the version.
    in_list = choices.library and reading.verdict is not Verdict.UNKNOWN
    if not reading.refused and (in_list or not doubtful):
        return
    candidates = choices.library or choices.listed
    suggestion = suggest(value.text.strip(), candidates)
    yield problems.UnknownChoice(value, candidates, suggestion, reading.refused)


# Texts that an element holds in several pieces, and which of them consumers ignore.

_PIECE = pattern(r"<!--.*?(?:-->|\Z)|<!\[CDATA\[.*?(?:\]\]>|\Z)|<\?.*?(?:\?>|\Z)|([^<]+)|<", re.DOTALL)


def part(value: Value, start: int, end: int) -> Span:
    """The place of a part of a value; all of it where the file has another text (entities, an expression)."""
    span = value.span
    if value.text in {span.text, blanks_as_spaces(span.text)}:
        return value.element.document.spans.span(value.element, span.start + start, span.start + end)
    return span


def blanks_as_spaces(text: str) -> str:
    """The value that a parser makes of the text of an attribute, entities aside."""
    return text.replace("\r\n", " ").translate({ord(blank): " " for blank in "\t\n\r"})


def cut_text(element: Element) -> Span | None:
    """The text after a comment in the middle of a value, which no consumer sees."""
    pieces = [element.text, *(node.tail for node in element.nodes if isinstance(node, Aside))]
    filled = [piece for piece in pieces if piece.strip()]
    if len(filled) < 2:
        return None
    spans = element.document.spans
    place = spans.place(element)
    first = spans.text(element)
    for piece in _PIECE.finditer(spans.home(element).text, first.end, place.close):
        if (found := _filled(piece)) is not None:
            return spans.span(element, *found)
    return None


def stray_text(element: Element) -> tuple[Span, str] | None:
    """The first line of the text between an element's children, and its place; None if it is in CDATA sections only.

    A CDATA section beside elements is a way to write notes, never a value.
    """
    document = element.document
    source = document.source
    spans = Spans(source, document.scan) if document.is_expanded else document.spans
    around = spans.place(element)
    edges = [around.end]
    for child in element.children():
        edges += [spans.place(child).start, spans.place(child).close_end]
    edges.append(around.close)
    for start, end in zip(edges[::2], edges[1::2], strict=True):
        for piece in _PIECE.finditer(source.text, start, end):
            if (found := _filled(piece)) is not None:
                line = source.text[slice(*found)].splitlines()[0].rstrip()
                place = document.written(source.span(found[0], found[0] + len(line)))
                return place, line.replace("&gt;", ">")
    return None


def _filled(piece: re.Match[str]) -> tuple[int, int] | None:
    """Where the text of a piece begins and ends; None if it is blank, or no text."""
    text = piece[1] or ""
    if not text.strip():
        return None
    start = piece.start(1) + len(text) - len(text.lstrip())
    return start, start + len(text.strip())
