"""Why something does not fit the table of a format: the explaining side of the walk.

Loaded only when there is something to explain. Each method takes one thing that the walk did not accept at
once and either finds that it is sound after all or notes a problem.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections import Counter
from collections.abc import Hashable

from sdfcheck.formats import history
from sdfcheck.formats.problems import (
    DeprecatedElement,
    RemovedElement,
    RepeatedElement,
    StrayText,
    UnknownAttribute,
)
from sdfcheck.formats.schema import AttributeDefinition, Definition
from sdfcheck.formats.sdf.text_pieces import stray_line
from sdfcheck.formats.topology import Displaced, standard_inside
from sdfcheck.formats.version import Version
from sdfcheck.source.document import Document, Element

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
        if (span := stray_line(element)) is not None:
            self.found.append(StrayText(span, element))

    def is_one_too_many(self, element: Element) -> bool:
        """Counts an unknown attribute; of very many in one element only the first are reported."""
        self.strange[element] += 1
        return self.strange[element] > MOST


def folded(found: list[object]) -> list[object]:
    """The problems, with one for all repeats of an element, and one for all uses of a removed name."""
    alike: dict[Hashable, list[Element]] = {}
    first_of_kind: list[object] = []
    for problem in found:
        if (kind := _kind(problem)) is None:
            first_of_kind.append(problem)
            continue
        assert isinstance(problem, RepeatedElement | RemovedElement)
        if kind not in alike:
            first_of_kind.append(problem)
        alike.setdefault(kind, []).append(problem.element)
    return [_with_others(problem, alike) for problem in first_of_kind]


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


def _kind(problem: object) -> Hashable:
    """The common part of like problems; None for one that is reported alone."""
    if isinstance(problem, RepeatedElement) and not problem.refused:
        return problem.first
    if isinstance(problem, RemovedElement):
        return problem.element.name, problem.parent.name, problem.attribute
    return None


def _with_others(problem: object, alike: dict[Hashable, list[Element]]) -> object:
    kind = _kind(problem)
    others = tuple(alike[kind][1:]) if kind is not None else ()
    if others and isinstance(problem, RepeatedElement | RemovedElement):
        return problem.changed(others=others)
    return problem
