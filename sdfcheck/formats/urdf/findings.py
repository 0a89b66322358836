"""Why something does not fit URDF's table: the explaining side of the walk."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator
from math import isfinite

from sdfcheck.formats.near_names import suggest
from sdfcheck.formats.reading import AS_WRITTEN, Cause, Outcome, Reading, malformed, misread
from sdfcheck.formats.repetition import MOST, folded
from sdfcheck.formats.sdf import problems
from sdfcheck.formats.sdf.numbers import BLANKS, stream_float
from sdfcheck.formats.sdf.parts import no_number
from sdfcheck.formats.sdf.table import Range
from sdfcheck.formats.sdf.text_pieces import blanks_as_spaces, stray_line
from sdfcheck.formats.sdf.value_problems import problem_of
from sdfcheck.formats.sdf.version import Version
from sdfcheck.formats.topology import Displaced, standard_inside
from sdfcheck.formats.urdf import problems as urdf_problems
from sdfcheck.formats.urdf.misspellings import meant_attribute, meant_child
from sdfcheck.formats.urdf.table import UrdfAttribute, UrdfElement, known_parents
from sdfcheck.source.document import Element, Value
from sdfcheck.source.text import Source, is_expression

# How urdfdom reads a value, with the reason where that is not what is written.
#
# It is stricter than libsdformat: a number has to be all of its text, so `1.5kg`, `1,5`,
# `0x10`, `inf` and `1 ` with a space after it are refused, and in a vector only spaces separate
# the numbers, no tabs or line breaks. Checked against version 3.0.1.


_SIZES = {"vector3": 3, "color": 4, "quaternion": 4}
_EXPECTED = {"double": "a number", "int": "a whole number", "unsigned int": "a whole number"}
_PIECE = re.compile(r"[^ ]+")
_OTHER_BLANK = re.compile(r"[\t\n\r\v\f]+")


def read(attribute: UrdfAttribute, text: str) -> Reading:
    """How the text of an attribute is read, as it is in the file, tabs and line breaks included."""
    kind = attribute.type
    if attribute.choices:
        if text in attribute.choices:
            return AS_WRITTEN
        expected = "one of " + ", ".join(attribute.choices)
        return Reading(Outcome.NOT_A_CHOICE, 0, len(text), refused=True, expected=expected)
    if kind not in _SIZES and kind not in _EXPECTED:
        return AS_WRITTEN
    expected = _EXPECTED.get(kind) or f"{_SIZES[kind]} numbers"
    if not text.strip():
        return Reading(Outcome.EMPTY, 0, len(text), refused=True, expected=expected)
    if kind in _SIZES:
        reading = _read_parts(text, _SIZES[kind], attribute.range)
    else:
        reading = _read_number(text, 0, len(text), attribute.range)
    return reading if reading.is_fine else reading._replace(expected=expected)


def _read_parts(text: str, count: int, bounds: Range | None) -> Reading:
    pieces = [match.span() for match in _PIECE.finditer(text)]
    for start, end in pieces:
        # Spaces of other kinds pass before a number, not after one and not alone.
        if blank := _OTHER_BLANK.search(text, end - len(text[start:end].lstrip()), end):
            return malformed(*blank.span(), Cause.BLANK)
        if text[start:end].isspace():
            return malformed(start, end, Cause.BLANK)
    worst = AS_WRITTEN
    for start, end in pieces:
        if worst.is_fine:
            worst = _read_number(text, start, end, bounds)
    if worst.outcome is Outcome.MALFORMED:
        return worst
    if len(pieces) != count:
        start, end = pieces[count if len(pieces) > count else 0][0], pieces[-1][1]
        return Reading(Outcome.WRONG_COUNT, start, end, refused=True, wanted=(count,), got=len(pieces))
    return worst


def _read_number(text: str, start: int, end: int, bounds: Range | None) -> Reading:
    """A number from ``start`` to ``end``, with nothing after it; spaces before it are ignored."""
    while text[start] in BLANKS:
        start += 1
    number = stream_float(text, start)
    if number is None:
        return no_number(text, start, end)
    if number.end != end:
        rest = text[number.end : end]
        if not rest.strip(BLANKS):
            return malformed(number.end, end, Cause.BLANK)
        if rest[0] in BLANKS:
            return malformed(start, end, Cause.EXTRA)
        return no_number(text, start, end)._replace(cause=_cause(rest))
    if number.too_large or not isfinite(number.value):
        return malformed(start, end, Cause.TOO_LARGE)
    if bounds is not None and not bounds.holds(number.value):
        return Reading(Outcome.OUT_OF_RANGE, start, end, range=bounds, refused=bounds.refused)
    return AS_WRITTEN


def _cause(rest: str) -> Cause:
    if is_expression(rest):
        return Cause.EXPRESSION
    return {",": Cause.COMMA, "x": Cause.HEXADECIMAL, "X": Cause.HEXADECIMAL}.get(rest[0], Cause.TRAILING)


# Why something does not fit URDF's table: the explaining side of the walk.
#
# Loaded only when there is something to explain.


_ASKED_BY_RULES = frozenset(("inertia", "limit", "mesh"))
"""Elements for whose missing attributes there are rules of their own."""
_EXPRESSION = re.compile(r"\$\{[^}]*\}?|\$\([^)]*\)?")
_COMMENT = re.compile(r"<!--.*?(?:-->|\Z)", re.DOTALL)


class UrdfFindings:
    """The problems of one document, collected during its walk."""

    def __init__(self, source: Source, version: Version) -> None:
        self.source = source
        self.version = version
        self.customs: list[Element] = []
        """Prefixed elements in standard ones."""
        self.displaced: dict[Element, tuple[Displaced, ...]] = {}
        """Prefixed elements → the standard ones in them that could be beside them."""
        self.found: list[object] = []
        self.stray: set[Element] = set()
        self.unknown: dict[tuple[str, str], list[Element]] = {}
        self.strange: Counter[Element] = Counter()
        """How many unknown attributes an element has."""
        self.unknown_values: dict[tuple[str, str], list[Value]] = {}
        self.parents: dict[Element, Element] = {}
        """The elements around the unknown ones; xacro's conditions around them do not count."""
        self.places: dict[Element, UrdfElement] = {}
        """The definitions of elements with something unknown in them."""

    # Elements

    def unexpected(self, child: Element, parent: Element, place: UrdfElement) -> None:
        """A child that the table does not list."""
        name = child.name
        if ":" in name:
            self.customs.append(child)
            if displaced := tuple(standard_inside(child, parent, place)):
                self.displaced[child] = displaced
            return
        if place.name == "geometry":
            return  # a shape, in its way
        self.places[parent] = place
        self.parents[child] = parent
        self.unknown.setdefault((place.name, name), []).append(child)

    def repeated(self, element: Element, first: Element, parent: Element, place: UrdfElement) -> None:
        if place.name == "geometry":
            self.found.append(problems.SeveralShapes(element, first))
        else:
            self.found.append(problems.RepeatedElement(element, first, parent))

    def shape(self, geometry: Element, place: UrdfElement, seen: dict[str, Element]) -> None:
        """A geometry: urdfdom looks at its first element and at nothing else."""
        first, *others = list(geometry.children()) or [geometry]
        for other in others:
            if other.name not in place.children:
                if ":" not in other.name:
                    self.places[geometry] = place
                    self.parents[other] = geometry
                    self.unknown.setdefault((place.name, other.name), []).append(other)
            elif other.name != first.name and seen.get(other.name) is other:
                self.found.append(problems.SeveralShapes(other, first))

    def missing_child(self, parent: Element, name: str) -> None:
        place = self.places.get(parent)
        if place and any(meant_child(child, place) == name for child in parent.children()):
            return  # it is there, misspelled
        if parent.name != "inertial" and name != "geometry":  # which rules look at
            self.found.append(problems.MissingElement(parent, name, None, refused=True))

    def too_new(self, element: Element, since: Version) -> None:
        self.found.append(
            urdf_problems.FeatureAboveVersion(element, element.name, str(since), str(self.version))
        )

    def stray_text(self, element: Element) -> None:
        if element not in self.stray:
            self.stray.add(element)
            span = stray_line(element)
            if span is not None:
                self.found.append(problems.StrayText(span, element))

    # Attributes

    def attribute(self, element: Element, definition: UrdfElement, key: str, text: str) -> None:
        """An attribute that is unknown, too new, or whose value is not accepted at once."""
        known = definition.attributes.get(key)
        if known is None:
            if ":" not in key:
                self.places[element] = definition
                self.strange[element] += 1
                if self.strange[element] > MOST:
                    return
                self.unknown_values.setdefault((element.name, key), []).append(Value(element, key, text))
            return
        if known.since > self.version:
            value = Value(element, key, text)
            self.found.append(
                urdf_problems.FeatureAboveVersion(value, key, str(known.since), str(self.version))
            )
        self.attribute_value(element, known, text)

    def attribute_value(self, element: Element, known: UrdfAttribute, text: str) -> None:
        """The value of a known attribute, as it is in the file."""
        value = Value(element, known.name, text)
        if known.type == "version":
            return  # which a rule looks at
        if not text.strip():
            # Empty names belong to the analysis of names.
            if known.name != "name" and (known.is_number or known.required):
                self.found.append(problems.MissingAttribute(element, known.name, empty=True))
        else:
            self.judge(value, known)

    def missing_attributes(self, element: Element, missing: tuple[str, ...]) -> None:
        if place := self.places.get(element):
            meant = {meant_attribute(element, key, place) for key in element.attributes}
            missing = tuple(each for each in missing if each not in meant)
            if not missing:
                return
        parent = element.parent
        name = element.name
        if name == "axis" and not _moves(parent):
            return
        if name == "texture" and parent is not None and parent.has("color"):
            return  # the color is taken
        self.stray.add(element)  # its text is where the value was put
        if name not in _ASKED_BY_RULES:
            self.found += [problems.MissingAttribute(element, each, empty=False) for each in missing]

    def dynamics(self, element: Element) -> None:
        """An element ``dynamics`` with neither of the two attributes of which it needs one."""
        if not any(suggest(name, ("damping", "friction")) for name in element.attributes):
            self.found.append(problems.MissingAttribute(element, "damping", empty=False))

    # Values

    def setting(self, element: Element, known: UrdfAttribute) -> None:
        """A number or flag in ``<gazebo>``, in the attribute ``value`` or as text."""
        from sdfcheck.formats.sdf.values import read as read_as_sdf

        value = element.attribute("value") or element.own_value
        if known.type == "flag":
            reading = misread(0, len(value.text), Cause.NOT_A_BOOLEAN, "false")
        else:
            reading = read_as_sdf(known.type, value.text, required=True)
        if reading.outcome is Outcome.EMPTY:
            self.found.append(problems.MalformedValue(value, known, reading, element.span))
        elif not reading.is_fine and not is_expression(value.text):
            self.found += problem_of(value, known, reading)

    def judge(self, value: Value, known: UrdfAttribute) -> None:
        """Turn the reading of a value into the problem that it is."""
        text = _written(value)
        reading = read(known, text)
        if reading.is_fine or is_expression(text):
            return
        if reading.outcome is Outcome.NOT_A_CHOICE:
            near = suggest(text, known.choices)
            self.found.append(problems.UnknownChoice(value, known.choices, near, refused=True))
        else:
            self.found += problem_of(value, known, reading)

    def expressions(self, root: Element) -> None:
        """Expressions of xacro that were not replaced, reported once: one step was left out."""
        comments = [match.span() for match in _COMMENT.finditer(self.source.text)]
        places = [
            match.span()
            for match in _EXPRESSION.finditer(self.source.text)
            if not any(start <= match.start() < end for start, end in comments)
        ]
        if places:
            first = self.source.span(*places[0])
            values = tuple(_values_with_expressions(root))
            self.found.append(urdf_problems.UnexpandedExpression(first, len(places), values))

    def conclude(self) -> list[object]:
        """Everything found, once the walk is over."""
        for uses in self.unknown.values():
            parent = self.parents[uses[0]]
            near = meant_child(uses[0], self.places[parent])
            needed = near is not None and _needs(parent, self.places[parent], near)
            places = known_parents(uses[0].name)
            self.found.append(
                urdf_problems.UnknownUrdfElement(uses[0], parent, near, places, tuple(uses), needed)
            )
        for values in self.unknown_values.values():
            element, name = values[0].element, values[0].attribute
            assert name is not None
            near = meant_attribute(element, name, self.places[element])
            needed = near in self.places[element].required_attributes
            needed = needed and (element.name != "axis" or _moves(element.parent))
            if element.name == "dynamics":
                needed = near is not None and not {"damping", "friction"} & element.attributes.keys()
            count = self.strange.pop(element, 0)
            more = count - 1 if count > MOST else 0
            self.found.append(
                urdf_problems.UnknownUrdfAttribute(values[0], near, tuple(values), needed, more)
            )
        return folded(self.found)


def _needs(parent: Element, place: UrdfElement, child: str) -> bool:
    """Whether the element cannot do without such a child."""
    if place.name == "robot" and child == "link":
        return True
    if place.name == "joint" and child == "limit":
        return parent.attributes.get("type") in {"revolute", "prismatic"}
    if place.name == "material":
        return not _is_in_visual(parent) and not parent.has("color") and not parent.has("texture")
    return child in place.required_children and not parent.has(child)


def _moves(joint: Element | None) -> bool:
    """Whether urdfdom reads the axis of a joint."""
    return joint is not None and joint.attributes.get("type") not in {"fixed", "floating"}


def _is_in_visual(material: Element) -> bool:
    """Whether a material is that of a visual, where its name alone will do."""
    return material.parent is not None and material.parent.name != "robot"


def _written(value: Value) -> str:
    """A value with the tabs and line breaks of the file, which the parser has turned into spaces."""
    if value.element.document.is_expanded:
        return value.text  # xacro writes spaces
    text = value.span.text
    return text if "&" not in text and blanks_as_spaces(text) == value.text else value.text


def _values_with_expressions(root: Element) -> Iterator[Value]:
    for element in root.walk():
        for name, text in element.attributes.items():
            if is_expression(text) and (value := element.attribute(name)) is not None:
                yield value
        if is_expression(element.content) and element.own_value is not None:
            yield element.own_value
