"""Why something does not fit the table: the explaining side of the walk.

Loaded only when there is something to explain. Each method takes one thing that the
walk did not accept at once and either finds that it is sound all the same or notes a
problem.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from sdfcheck.formats import history, problems
from sdfcheck.formats.schema import AttributeDefinition, Definition
from sdfcheck.formats.suggest import suggest
from sdfcheck.formats.topology import standard_inside
from sdfcheck.formats.choices import Verdict
from sdfcheck.formats.reading import Outcome, Reading
from sdfcheck.formats.version import NEWEST, Version
from sdfcheck.source.element import Element, Value
from sdfcheck.source.text import Span

if TYPE_CHECKING:
    from sdfcheck.formats.survey import Survey

_VALUE_PROBLEMS = {
    Outcome.MISREAD: problems.MisreadValue,
    Outcome.WRONG_COUNT: problems.WrongComponentCount,
}


# Without these the file is refused; for all else that is required a default is taken.
_REFUSED = frozenset(
    {
        ("joint", "parent"),
        ("joint", "child"),
        ("world/include", "uri"),
        ("model/include", "uri"),
    }
)

_PIECE = re.compile(r"<!--.*?-->|<!\[CDATA\[.*?\]\]>|<\?.*?\?>|([^<]+)|<", re.S)


class Findings:
    """The problems of one document, collected during its walk."""

    def __init__(self, survey: Survey) -> None:
        self.survey = survey
        self.version = survey.version
        self.found: list[object] = []
        self.stray: set[Element] = set()
        self.missing_children: list[tuple[Element, Definition, str]] = []
        self.too_new: dict[tuple[str, str], list[Element]] = {}
        self.too_new_at: dict[tuple[str, str], tuple[Element, Version]] = {}

    def root(self, root: Element, definition: Definition) -> None:
        """The root's attributes; its version decides against what everything else is checked."""
        for name, text in root.attributes.items():
            if name == "version" and text.strip():
                if Version.parse(text) is None:
                    value = Value(root, "version", text)
                    self.found.append(problems.UnknownVersion(value, _meant_version(text)))
            elif name == "version":
                self.found.append(problems.MissingVersion(root))
            elif ":" not in name and not name.startswith("xmlns"):
                self.unknown_attribute(root, definition, name)
        if "version" not in root.attributes:
            self.found.append(problems.MissingVersion(root))

    # Elements

    def unexpected(self, child: Element, parent: Element, place: Definition) -> Definition | None:
        """A child that the table does not list; returns the newest definition if only the version is too old."""
        if not isinstance(child.tag, str):
            return None  # a comment or an instruction
        name = child.name
        if ":" in name:
            self.custom(child, parent, place)
            return None
        newest = history.in_version(place, NEWEST)
        definition = newest.children.get(name) if newest else None
        if definition is not None:
            since = history.since(place, name)
            self.note_too_new(child, parent, definition.place, since)
            return definition
        old = history.last_version(place, name)
        if old is not None:
            successor = history.successor(place, name)
            if not history.carried_over(place, name, self.version):
                self.found.append(problems.RemovedElement(child, parent, None, old, successor))
            return None
        suggestion = suggest(name, place.children)
        places = history.known_parents(name)
        if places:
            self.found.append(problems.MisplacedElement(child, parent, places, suggestion))
        else:
            self.found.append(problems.UnknownElement(child, parent, suggestion))
        return None

    def custom(self, child: Element, parent: Element, place: Definition) -> None:
        """A prefixed element: free, except that it must not hold what belongs to the standard."""
        self.survey.customs.append((child, parent, place))
        name = child.attributes.get("name")
        if name is not None:
            self.survey.named[parent].append((child.name, name, child))
        for element in standard_inside(child, parent, place):
            self.found.append(problems.TopologyChanged(element, child, parent))

    def note_too_new(self, element: Element, parent: Element, place: str, since: Version) -> None:
        self.too_new.setdefault((place, ""), []).append(element)
        self.too_new_at.setdefault((place, ""), (parent, since))

    def repeated(self, element: Element, first: Element, parent: Element) -> None:
        self.found.append(problems.RepeatedElement(element, first, parent))

    def deprecated(self, element: Element, definition: Definition) -> None:
        successor = history.deprecation(definition.place)
        self.found.append(problems.DeprecatedElement(element, None, *successor))

    def missing(self, parent: Element, place: Definition, name: str) -> None:
        if place.path == "joint" and parent.attributes.get("type") == "ball":
            return  # libsdformat takes defaults for a ball joint
        self.missing_children.append((parent, place, name))

    def absent(self, parent: Element, place: Definition, name: str) -> object:
        """A required child that is not there; a custom sibling may have been put in its stead."""
        child = place.children[name]
        for custom, owner, _ in self.survey.customs:
            if owner is parent and child.type is not None and len(custom) == 0:
                return problems.ReplacedElement(custom, parent, name)
        default = None if (place.path, name) in _REFUSED else child.default
        return problems.MissingElement(parent, name, default)

    def stray_text(self, element: Element) -> None:
        if element in self.stray:
            return
        self.stray.add(element)
        if (span := _stray_span(element)) is not None:
            self.found.append(problems.StrayText(span, element))

    # Attributes

    def attribute(
        self, element: Element, parent: Element, definition: Definition, key: str, text: str
    ) -> None:
        """An attribute that is unknown, or whose value is not accepted at once."""
        known = definition.attributes.get(key)
        if known is not None:
            self.attribute_value(element, definition, known, text)
            return
        name = key if key[0] != "{" else ""
        if not name or ":" in name or "\ua4fd" in name:
            return  # prefixed: free
        newest = history.in_version(definition, NEWEST)
        if newest is not None and name in newest.attributes:
            since = history.since(definition, "@" + name)
            self.too_new.setdefault((definition.place, name), []).append(element)
            self.too_new_at.setdefault((definition.place, name), (parent, since))
            known = newest.attributes[name]
            if not known.accepts(text):
                self.attribute_value(element, newest, known, text)
            return
        self.unknown_attribute(element, definition, name)

    def unknown_attribute(self, element: Element, definition: Definition, name: str) -> None:
        old = history.last_version(definition, "@" + name)
        if old is not None and not history.carried_over(definition, "@" + name, self.version):
            successor = history.successor(definition, "@" + name)
            parent = element.parent if element.parent is not None else element
            self.found.append(problems.RemovedElement(element, parent, name, old, successor))
        elif old is None:
            suggestion = suggest(name, definition.attributes)
            self.found.append(problems.UnknownAttribute(element, name, suggestion))

    def missing_attribute(self, element: Element, name: str) -> None:
        self.found.append(problems.MissingAttribute(element, name, empty=False))

    def attribute_value(
        self, element: Element, definition: Definition, known: AttributeDefinition, text: str
    ) -> None:
        value = Value(element, known.name, text)
        if not text.strip():
            # Empty names belong to the analysis of names.
            if known.required and known.name != "name":
                self.found.append(problems.MissingAttribute(element, known.name, empty=True))
            return
        newest = history.in_version(definition, NEWEST)
        counterpart = newest.attributes.get(known.name) if newest else None
        if counterpart is not None and counterpart.accepts(text):
            return
        self.judge(value, known, known.read(text))

    # Values

    def value(self, element: Element, parent: Element, definition: Definition) -> None:
        """A leaf whose text is not accepted at once."""
        for child in element.children():
            self.unexpected(child, element, definition)
        text = element.content
        if self.rotation(element, definition, text):
            return
        if not text:
            if definition.needs_value:
                reading = definition.read(text)
                value = Value(element, None, text)
                self.found.append(problems.MalformedValue(value, definition, reading, element.span))
            return
        if cut := _cut_text(element):
            value = Value(element, None, text)
            self.found.append(problems.CutText(value, cut))
        if definition.accepts(text):
            return
        newest = history.in_version(definition, NEWEST)
        if newest is not None and newest.type == definition.type and newest.accepts(text):
            return
        self.judge(Value(element, None, text), definition, definition.read(text, _rotation_format(element)))

    def rotation(self, element: Element, definition: Definition, text: str) -> bool:
        """Attributes of a pose that do not go together; True if that was the problem."""
        if definition.type != "pose" or _rotation_format(element) != "quat_xyzw":
            return False
        degrees = element.attribute("degrees")
        if degrees is not None and degrees.text.strip().lower() in {"true", "1"}:
            rotation = element.attribute("rotation_format")
            assert rotation is not None
            self.found.append(problems.ConflictingRotation(degrees, rotation))
            return True
        return False

    def judge(self, value: Value, definition: Definition | AttributeDefinition, reading: Reading) -> None:
        """Turn a reading into the problem that it is."""
        if reading.is_fine:
            return
        span = _part(value, reading.start, reading.end)
        outcome = reading.outcome
        if outcome is Outcome.NOT_A_CHOICE:
            self.choice(value, definition, reading)
        elif outcome is Outcome.OUT_OF_RANGE:
            self.found.append(problems.ValueOutOfRange(value, span, str(reading.range), reading.refused))
        elif outcome is Outcome.NOT_FINITE:
            self.found.append(problems.ValueOutOfRange(value, span, "finite", reading.refused))
        else:
            kind = _VALUE_PROBLEMS.get(outcome, problems.MalformedValue)
            self.found.append(kind(value, definition, reading, span))

    def choice(self, value: Value, definition: Definition | AttributeDefinition, reading: Reading) -> None:
        """A value that is not in the list of the version, which need not keep anybody from reading it."""
        choices = definition.choices
        assert choices is not None
        doubtful = reading.verdict in {Verdict.UNKNOWN, Verdict.WRONG_CASE, Verdict.REMOVED}
        if not reading.refused and (choices.library or not doubtful):
            return
        candidates = choices.library or choices.listed
        text = value.text.strip()
        self.found.append(
            problems.UnknownChoice(value, candidates, suggest(text, candidates), reading.refused)
        )

    def conclude(self) -> list[object]:
        """Everything found, once the walk is over."""
        for parent, place, name in self.missing_children:
            self.found.append(self.absent(parent, place, name))
        for (place, attribute), uses in self.too_new.items():
            parent, since = self.too_new_at[place, attribute]
            if attribute:
                self.found.append(
                    problems.TooNewAttribute(uses[0], attribute, since, self.version, tuple(uses))
                )
            else:
                self.found.append(
                    problems.TooNewElement(uses[0], parent, since, self.version, tuple(uses))
                )
        return self.found


def _meant_version(text: str) -> str | None:
    """The version behind a slip: blanks around it, a leading zero, a third number."""
    parts = text.strip().split(".")
    numbers = [part.lstrip("0") or "0" for part in parts[:2]]
    version = Version.parse(".".join(numbers))
    return str(version) if version else None


def _rotation_format(element: Element) -> str:
    return element.attributes.get("rotation_format", "euler_rpy").strip() or "euler_rpy"


def _part(value: Value, start: int, end: int) -> Span:
    """The place of a part of a value; all of it where the text in the file is spelt otherwise (entities)."""
    span = value.span
    if span.text == value.text:
        return Span(span.source, span.start + start, span.start + end)
    return span


def _cut_text(element: Element) -> Span | None:
    """The text behind a comment in the middle of a value, which no reader sees."""
    pieces = [element.text, *(node.tail for node in element if not isinstance(node.tag, str))]
    filled = [piece for piece in pieces if piece and piece.strip()]
    if len(filled) < 2:
        return None
    spans = element.document.spans
    place = spans.place(element)
    source = element.document.source
    start = source.text.index("-->", spans.text(element).end) + 3
    rest = source.text[start : place.close]
    start += len(rest) - len(rest.lstrip())
    return source.span(start, start + len(rest.strip()))


def _stray_span(element: Element) -> Span | None:
    """The first line of the text between an element's children; None if it is in CDATA sections only.

    A CDATA section beside elements is a way to write notes: nobody means it as a value.
    """
    spans = element.document.spans
    source = element.document.source
    place = spans.place(element)
    edges = [place.end]
    for child in element.children():
        edges += [spans.place(child).start, spans.place(child).close_end]
    edges.append(place.close)
    for start, end in zip(edges[::2], edges[1::2], strict=True):
        for piece in _PIECE.finditer(source.text, start, end):
            text = piece[1] or ""
            if text.strip():
                begin = piece.start(1) + len(text) - len(text.lstrip())
                return source.span(begin, begin + len(text.strip().splitlines()[0].rstrip()))
    return None
