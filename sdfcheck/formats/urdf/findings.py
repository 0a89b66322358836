"""Why something does not fit URDF's table, and which element or attribute was meant."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from math import isfinite

from sdfcheck.formats import history, problems
from sdfcheck.formats.findings import MOST, Findings, blanks_as_spaces, folded, folded_children, problem_of
from sdfcheck.formats.near_names import suggest
from sdfcheck.formats.reading import AS_WRITTEN, Cause, Outcome, Reading, malformed, misread
from sdfcheck.formats.schema import AttributeDefinition, Definition
from sdfcheck.formats.sdf.values import BLANKS, no_number, stream_float
from sdfcheck.formats.sdf.values import read as read_as_sdf
from sdfcheck.formats.table import Range
from sdfcheck.formats.urdf.schema import COUNTS, VERSIONS, definition, known_parents
from sdfcheck.formats.version import Version
from sdfcheck.source.document import Document, Element, Value
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Span, is_expression

# The meaning of misspelled elements and attributes of URDF, among those that are missing beside them.


_OTHER_WORDS = {"min": "lower", "max": "upper"}
_OTHER_MEASURES = frozenset({"diameter"})


def _named_parts(document: Document) -> dict[str, list[Element]]:
    """Name → the links and joints of that name."""
    found: dict[str, list[Element]] = {}
    for part in document.root.children() if document.root is not None else ():
        if part.name in {"link", "joint"}:
            found.setdefault(part.text_of("name", ""), []).append(part)
    return found


def _is_dropped(setting: Definition, block: Element) -> bool:
    """Is a setting of libsdformat in a block about something that does not have it?"""
    name, about = block.text_of("reference"), setting.row.extra("at")
    if not name or about == "robot":
        return bool(name) is (about == "robot")
    parts = block.document.view(_named_parts).get(name, ())
    needs_shape = setting.row.extra("sdf").startswith("collision/")
    return bool(parts) and not any(
        part.name == about and (part.has("collision") or not needs_shape) for part in parts
    )


def misnamed(element: Element, name: str) -> Span | None:
    """The place of the misspelled attribute or child element that means one of this name."""
    known = element.document.view(_misnamed)
    if element not in known:
        known[element] = dict(_meant(element))
    return known[element].get(name)


def _misnamed(document: Document) -> dict[Element, dict[str, Span]]:
    """Element → the names that were meant in it, as far as somebody has asked, each with a place."""
    return {}


def _meant(element: Element) -> Iterator[tuple[str, Span]]:
    if (place := definition(element)) is None:
        return
    first_of = {child.name: child for child in reversed(list(element.children()))}
    for child in first_of.values():
        if (name := meant_child(child, place)) is not None:
            yield name, child.span
    for key, text in element.attributes.items():
        if (name := meant_attribute(element, key, place)) is not None:
            yield name, Value(element, key, text).name_span


def meant_child(child: Element, place: Definition) -> str | None:
    """The name that an unknown element was probably meant to have, among those that its parent lacks."""
    name = child.name
    if name in place.children or child.parent is None:
        return None
    siblings = {sibling.name for sibling in child.parent.children()}
    near = suggest(name, [n for n, each in place.children.items() if n not in siblings or not each.single])
    if near is None or not known_parents(name):
        return near
    # An element that has its place elsewhere, and holds what it holds there, is misplaced.
    content = {each.name for each in child.children()}
    return near if not content or content & place.children[near].children.keys() else None


def meant_attribute(element: Element, name: str, place: Definition) -> str | None:
    """The name that an unknown attribute was probably meant to have, among those that are missing."""
    if name in place.attributes:
        return None
    missing = [each for each in place.attributes if each not in element.attributes]
    word = _OTHER_WORDS.get(name)
    near = suggest(name, missing) or (word if word in missing else None)
    if near is not None or name in _OTHER_MEASURES or element.name == "limit":
        return near
    # The one attribute that is too many must mean the one that the element cannot do without.
    strange = [each for each in element.attributes if each not in place.attributes and ":" not in each]
    needed = [each for each in place.required_attributes if each in missing]
    has_value = strange == [name] and element.attributes[name].strip()
    return needed[0] if len(needed) == 1 and has_value else None


# Why something does not fit URDF's table: the explaining side of the walk.

# How urdfdom reads a value, with the reason where that is not what is written.
#
# It is stricter than libsdformat: a number has to be all of its text, so `1.5kg`, `1,5`,
# `0x10`, `inf` and `1 ` with a space after it are refused, and in a vector only spaces separate
# the numbers, no tabs or line breaks. Checked against version 3.0.1.


_SIZES = {"vector3": 3, "color": 4, "quaternion": 4}
_EXPECTED = {"double": "a number", "int": "a whole number", "unsigned int": "a whole number"}
_PIECE = re.compile(r"[^ ]+")
_OTHER_BLANK = re.compile(r"[\t\n\r\v\f]+")


def read(attribute: AttributeDefinition, text: str) -> Reading:
    """How the text of an attribute is read, as it is in the file, tabs and line breaks included."""
    kind = attribute.type
    if listed := attribute.listed:
        if text in listed:
            return AS_WRITTEN
        expected = "one of " + ", ".join(listed)
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


# Why something does not fit URDF's table.


_ASKED_BY_RULES = frozenset(("inertia", "limit", "mesh"))
"""Elements for whose missing attributes there are rules of their own."""
COLORS_OF_SDFORMAT = frozenset(("ambient", "diffuse", "emissive", "specular"))
"""The colors of a material there; URDF has one ``color``."""
_COLOR = "a color of SDFormat"
_EXPRESSION = re.compile(r"\$\{[^}]*\}?|\$\([^)]*\)?")
_COMMENT = re.compile(r"<!--.*?(?:-->|\Z)", re.DOTALL)


class UrdfFindings(Findings):
    """The problems of one URDF document, collected during its walk."""

    def __init__(self, document: Document, version: Version) -> None:
        super().__init__(document, version)
        self.unknown: dict[tuple[str, str], list[Element]] = {}
        self.unknown_values: dict[tuple[str, str], list[Value]] = {}
        self.uses_too_new: dict[tuple[str, str, str], list[Element | Value]] = {}
        self.parents: dict[Element, Element] = {}
        """The elements around the unknown ones; xacro's conditions around them do not count."""
        self.places: dict[Element, Definition] = {}
        """The definitions of elements with something unknown in them, of the newest version."""
        root = document.root
        self.is_bodiless = document.kind is Kind.URDF and root is not None and not root.has("link")
        """Is it a robot without links? That is one mistake, whatever its joints lack."""

    # Elements

    def custom(self, child: Element, parent: Element, place: Definition) -> None:
        super().custom(child, parent, _newest(place))

    def too_new(self, element: Element, definition: Definition, attribute: str, since: Version) -> None:
        place = Value(element, attribute, element.attributes[attribute]) if attribute else element
        self.uses_too_new.setdefault((element.name, attribute, str(since)), []).append(place)

    def unknown_element(self, child: Element, parent: Element, place: Definition) -> None:
        if place.name != "geometry":  # otherwise a shape, in its way
            self.unknown_child(child, parent, _newest(place))

    def unknown_child(self, child: Element, parent: Element, place: Definition) -> None:
        self.places[parent] = place
        self.parents[child] = parent
        is_color = place.name == "material" and child.name in COLORS_OF_SDFORMAT
        name = _COLOR if is_color else child.name
        self.unknown.setdefault((place.name, name), []).append(child)

    def repeated(self, element: Element, first: Element, parent: Element) -> bool:
        if parent.name == "geometry":
            self.found.append(problems.SeveralShapes(element, first))
        else:
            self.found.append(problems.RepeatedElement(element, first, parent))
        return True

    def several(self, geometry: Element, place: Definition) -> None:
        newest = _newest(place)
        first, *others = list(geometry.children()) or [geometry]
        seen = {first.name}
        for other in others:
            if other.name not in newest.children:
                if ":" not in other.name:
                    self.unknown_child(other, geometry, newest)
            elif other.name not in seen:
                seen.add(other.name)
                self.found.append(problems.SeveralShapes(other, first))

    def missing(self, parent: Element, place: Definition, name: str) -> None:
        known = self.places.get(parent)
        if known and any(meant_child(child, known) == name for child in parent.children()):
            return  # it is there, misspelled
        if self.is_bodiless and parent.name == "joint":
            return
        if parent.name != "inertial" and name != "geometry":  # which rules look at
            self.found.append(problems.MissingElement(parent, name, None, refused=True))

    # Attributes

    def unknown_attribute(self, element: Element, definition: Definition, name: str) -> None:
        self.places[element] = _newest(definition)
        is_free = definition.open and not definition.attributes
        if not is_free and not self.is_one_too_many(element):
            value = Value(element, name, element.attributes[name])
            self.unknown_values.setdefault((element.name, name), []).append(value)

    def wrapped(self, element: Element, definition: Definition) -> None:
        for key, text in element.attributes.items():
            known = definition.attributes.get(key)
            if known is not None and known.type in COUNTS and known.accepts(text):
                self.attribute_value(element, definition, known, text)

    def attribute_value(
        self, element: Element, definition: Definition, known: AttributeDefinition, text: str
    ) -> None:
        value = Value(element, known.name, text)
        if known.type == "version":
            return  # which a rule looks at
        if not text.strip():
            # Empty names belong to the analysis of names.
            needed = known.name != "name" and not _is_in_color(element)
            if needed and (known.type in COUNTS or known.required):
                self.found.append(problems.MissingAttribute(element, known.name, empty=True))
        else:
            self.judge(value, known)

    def missing_attribute(self, element: Element, definition: Definition, name: str) -> None:
        if (place := self.places.get(element)) and any(
            meant_attribute(element, key, place) == name for key in element.attributes
        ):
            return
        if (element.name == "axis" and not _moves(element.parent)) or _is_in_color(element):
            return
        if self.is_bodiless and element.name == "joint" and name != "name":
            return
        if element.name == "robot" and not any(element.children()):
            return  # it lacks all, which is one mistake
        self.stray.add(element)  # its text is where the value was put
        if element.name not in _ASKED_BY_RULES:
            self.found.append(problems.MissingAttribute(element, name, empty=False))

    def dynamics(self, element: Element) -> None:
        """An element ``dynamics`` with neither of the two attributes of which it needs one."""
        if not any(suggest(name, ("damping", "friction")) for name in element.attributes):
            self.found.append(problems.MissingAttribute(element, "damping", empty=False))

    # Values

    def value(self, element: Element, parent: Element, definition: Definition) -> None:
        """A number or flag in ``<gazebo>``, in the attribute ``value`` or as text."""
        value = element.attribute("value") or element.own_value
        if definition.type == "flag":
            reading = misread(0, len(value.text), Cause.NOT_A_BOOLEAN, "false")
        else:
            bounds = definition.range
            reading = read_as_sdf(definition.type or "", value.text, required=True, bounds=bounds)
            if reading.cause is Cause.TRUTH_VALUE:  # which libsdformat takes for a number in SDFormat alone
                reading = malformed(reading.start, reading.end, Cause.NOT_A_NUMBER)
                reading = reading._replace(expected="a number")
        if reading.outcome is Outcome.EMPTY:
            self.found.append(problems.MalformedValue(value, definition, reading, element.span))
        elif not reading.is_fine and not is_expression(value.text):
            # Where it cannot read a number, libsdformat aborts, wherever that is.
            is_read = reading.outcome is Outcome.MALFORMED or not _is_dropped(definition, parent)
            self.found += problem_of(value, definition, reading) if is_read else ()

    def judge(self, value: Value, known: AttributeDefinition) -> None:
        """Turn the reading of a value into the problem that it is."""
        text = as_written(value)
        reading = read(known, text)
        if reading.is_fine or is_expression(text):
            return
        if reading.outcome is Outcome.NOT_A_CHOICE:
            near = suggest(text, known.listed)
            self.found.append(problems.UnknownChoice(value, known.listed, near, refused=True))
        else:
            self.found += problem_of(value, known, reading)

    def expressions(self, root: Element) -> None:
        """Expressions of xacro that were not replaced, reported once: one step was left out."""
        source = self.document.source
        comments = [match.span() for match in _COMMENT.finditer(source.text)]
        places = [
            match.span()
            for match in _EXPRESSION.finditer(source.text)
            if not any(start <= match.start() < end for start, end in comments)
        ]
        if places:
            first = source.span(*places[0])
            values = tuple(_values_with_expressions(root))
            self.found.append(problems.UnexpandedExpression(first, len(places), values))

    def fold_attributes(self) -> None:
        """Make one problem of the children of an element that should be attributes of it, missing ones included."""
        written: dict[Element, list[Element]] = {}
        for key, uses in self.unknown.items():
            self.unknown[key] = []
            for one in uses:
                is_attribute = one.name in self.places[self.parents[one]].attributes
                others = written.setdefault(self.parents[one], []) if is_attribute else self.unknown[key]
                others.append(one)
        found, self.found = self.found, []
        lacking: dict[Element, problems.MissingAttribute] = {}
        for each in found:
            children = written.get(each.element, ()) if isinstance(each, problems.MissingAttribute) else ()
            if isinstance(each, problems.MissingAttribute) and each.attribute in {
                one.name for one in children
            }:
                lacking.setdefault(each.element, each)
            else:
                self.found.append(each)
        for parent, children in written.items():
            if (missing := lacking.get(parent)) is not None:
                self.found.append(missing.changed(elements=tuple(children)))
                continue
            first = children[0]
            self.found.append(
                problems.UnknownUrdfElement(first, parent, None, (), (first,), False, tuple(children))
            )

    def conclude(self) -> list[object]:
        self.fold_attributes()
        for (_, key), uses in self.unknown.items():
            if not uses:
                continue
            parent = self.parents[uses[0]]
            near = meant_child(uses[0], self.places[parent])
            needed = near is not None and _needs(parent, self.places[parent], near)
            places = known_parents(uses[0].name)
            self.found.append(
                problems.UnknownUrdfElement(
                    uses[0], parent, near, places, tuple(uses), needed, is_color=key == _COLOR
                )
            )
        alike: dict[object, list[problems.UnknownUrdfAttribute]] = {}
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
            found = problems.UnknownUrdfAttribute(values[0], near, tuple(values), needed, more)
            kind: object = name if near is not None else tuple(value.element for value in values)
            alike.setdefault(kind, []).append(found)
        for first, *others in alike.values():
            self.found.append(first.changed(others=tuple(each.value for each in others)))
        for (tag, attribute, since), newer in self.uses_too_new.items():
            what, version = attribute or tag, str(self.version)
            self.found.append(problems.FeatureAboveVersion(newer[0], what, since, version, len(newer)))
        return folded(folded_children(self.found))


@cache
def _newest(place: Definition) -> Definition:
    return history.in_version(place, VERSIONS[-1]) or place


def _needs(parent: Element, place: Definition, child: str) -> bool:
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


def _is_in_color(element: Element) -> bool:
    """Whether it is a texture beside a color, which is taken where the texture names no file."""
    return element.name == "texture" and element.parent is not None and element.parent.has("color")


def _is_in_visual(material: Element) -> bool:
    """Whether a material is that of a visual, where its name alone will do."""
    return material.parent is not None and material.parent.name != "robot"


def as_written(value: Value) -> str:
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
