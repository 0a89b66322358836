"""A document's vendor tags against the vendor's table: names, places, values, and how tags get on.

What refers to parts of the robot by name is noted for ``sdfcheck.robot.naming.vendor_references``.
"""

from __future__ import annotations

import re

from sdfcheck.formats.sdf.text_pieces import part
from sdfcheck.formats.suggest import suggest
from sdfcheck.formats.vendor import problems
from sdfcheck.formats.vendor.carriers import value_at, value_elsewhere
from sdfcheck.formats.vendor.definitions import REFUSED, Effect, Outcome, Place, Slot, Tag, Vendor
from sdfcheck.formats.vendor.relations import beside, missing_children, relations
from sdfcheck.formats.vendor.values import expected_of, misreading, out_of_range
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element, Value
from sdfcheck.source.rewritten import COLON

_CLOSED = frozenset(("plugin", "gazebo"))
"""What lies in these is for their own readers."""


class VendorCheck:
    """One pass over a document with one table."""

    def __init__(self, document: Document, vendor: Vendor, other: Vendor) -> None:
        self.document = document
        self.vendor = vendor
        self.other = other
        """The same vendor's table for the other dialect."""
        self.mark = f"{vendor.prefix}:"
        self.found: list[object] = []
        self.references: list[tuple[Value, Slot, Tag]] = []
        self.decisive: dict[tuple[Element, str], Effect] = {}
        """Parent and name of a misspelt child → what is done because the child is missing."""
        self.new: dict[str, list[Element | Value]] = {}

    def run(self) -> list[object]:
        root = self.document.root
        if root is None:
            return []
        # As an attribute, a tag has a blank before it.
        has_attributes = re.search(rf"\s{re.escape(self.mark)}", self.document.source.text) is not None
        waiting = [root]
        while waiting:
            element = waiting.pop()
            if has_attributes:
                self.attributes(element)
            seen: dict[str, Element] = {}
            below: list[Element] = []
            for child in element.children():
                tag = child.tag
                if tag[0] != "{" and ":" not in tag and COLON not in tag:
                    if tag not in _CLOSED and (has_attributes or len(child)):
                        below.append(child)
                elif (name := child.name).startswith(self.mark) and self.element(child, element, name, seen):
                    below.append(child)
            waiting += reversed(below)
        self.too_new()
        return self.found

    # Where

    def element(self, element: Element, parent: Element, name: str, seen: dict[str, Element]) -> bool:
        """Check one tag; False if what lies below it is not to be looked into."""
        tag = self.vendor.tags.get(name)
        if tag is None:
            self.unknown(name, element, parent)
            return False
        if successor := tag.keys.text("gone"):
            effect = tag.keys.effect("wrong") or REFUSED
            self.found.append(problems.OutdatedTag(self.vendor, name, effect, element, successor, True))
            return False
        place = self.place(tag, element, parent, attribute=False)
        if place is None:
            return False
        if place.single and name in seen:
            effect = Effect(Outcome.IGNORED)
            self.found.append(problems.RepeatedTag(self.vendor, name, effect, element, seen[name]))
            return False
        seen.setdefault(name, element)
        self.note_release(place.since or tag.since, name, element)
        self.content(tag, place, element)
        self.found += relations(self.vendor, tag, element, parent)
        if self.document.kind.value in tag.keys.words("deprecated-in"):
            successor = tag.keys.text("deprecated")
            effect = Effect(Outcome.ACCEPTED)
            self.found.append(problems.OutdatedTag(self.vendor, name, effect, element, successor, False))
        if mirrored := tag.keys.text("mirror"):
            from sdfcheck.formats.vendor.mirror import mirror_problems

            self.found += mirror_problems(self.vendor, tag, element, mirrored)
            self.kept(element)
            return False
        return True

    def kept(self, element: Element) -> None:
        """The tags that keep their meaning where all else repeats a standard element."""
        from sdfcheck.formats.vendor.mirror import stands_here

        seen: dict[str, Element] = {}
        for child in element.children():
            if stands_here(self.vendor, child.name, element):
                self.element(child, element, child.name, seen)

    def attributes(self, element: Element) -> None:
        """Prefixed attributes, of whatever element."""
        if not any(key[0] == "{" or COLON in key for key in element.keys()):  # noqa: SIM118 - lxml has no `in`
            return
        for name, text in element.attributes.items():
            if not name.startswith(self.mark):
                continue
            value = Value(element, name, text)
            tag = self.vendor.tags.get(name)
            if tag is None:
                self.unknown(name, value, None)
                continue
            place = self.place(tag, value, element, attribute=True)
            if place is not None and place.slot is not None:
                self.note_release(place.since or tag.since, name, value)
                self.value(tag, place.slot, value)

    def unknown(self, name: str, target: Element | Value, parent: Element | None) -> None:
        effect = self.vendor.effect_in(parent)
        if parent is not None:
            effect = self.decisive.get((parent, name), effect)
        self.found.append(problems.UnknownTag(self.vendor, name, effect, target, self.meant(name)))

    def meant(self, name: str) -> str | None:
        """The tag that a misspelt name was probably to be."""
        known = (tag.removeprefix(self.mark) for tag in self.vendor.tags)
        found = suggest(name.removeprefix(self.mark), known)
        return f"{self.mark}{found}" if found else None

    def place(self, tag: Tag, target: Element | Value, parent: Element, attribute: bool) -> Place | None:
        """The place that a tag is in; None, and a problem, where it is wrong."""
        fitting = [p for p in tag.places if (p.carrier == "attribute") is attribute and p.encloses(parent)]
        for place in fitting:
            if place.holds(parent):
                return place
        if fitting and self.is_reported(parent):
            return None
        effect = self.vendor.effect_in(None if attribute else parent)
        condition, use = None, ""
        if fitting:
            effect = fitting[0].otherwise or effect
            condition = fitting[0].text
        elif tag.absent is not None:
            use = tag.absent.use
            if not tag.absent.within or parent.name in tag.absent.within:
                effect = tag.absent.effect
        places = tuple(_shown(place) for place in tag.places)
        other = tuple(_shown(p) for p in self.other.tags[tag.name].places) if not places else ()
        self.found.append(
            problems.MisplacedTag(self.vendor, tag.name, effect, target, places, other, use, condition)
        )
        return None

    def is_reported(self, parent: Element) -> bool:
        """Has a parent a wrong choice, which decides what it may hold?"""
        tag = self.vendor.tags.get(parent.name)
        slots = tag.attributes.items() if tag is not None else ()
        return any(slot.choices and parent.attributes.get(n) not in slot.choices for n, slot in slots)

    # What

    def content(self, tag: Tag, place: Place, element: Element) -> None:
        """The values of a tag that is in its place."""
        if place.slot is not None:
            self.carried(tag, place, place.slot, element)
        for slots, sigil in ((tag.attributes, "@"), (tag.parts, "/")):
            for name, slot in slots.items():
                value = value_at(element, f"{sigil}{name}")
                if value is not None:
                    self.value(tag, slot, value)
                elif slot.required:
                    self.missing_value(tag, f"{sigil}{name}", element)
        self.needed_children(tag, element)

    def carried(self, tag: Tag, place: Place, slot: Slot, element: Element) -> None:
        value = value_at(element, place.carrier)
        if value is not None and (value.text or place.carrier != "text"):
            self.value(tag, slot, value)
            return
        lenient = self.vendor.is_lenient and place.carrier == "text"
        empty = misreading(slot, "", lenient, _judged(tag, element))
        effect = empty.effect if empty is not None and place.carrier == "text" else REFUSED
        effect = slot.lacking or effect
        stray = value_elsewhere(element, place.carrier)
        if stray is not None:
            carrier, other = stray
            self.found.append(
                problems.MiscarriedTag(self.vendor, tag.name, effect, element, other, carrier, place.carrier)
            )
        elif place.carrier == "text" and slot.type != "flag":
            fault, expected = problems.TagFault.EMPTY, expected_of(slot)
            own = element.own_value
            self.found.append(
                problems.MalformedTag(self.vendor, tag.name, effect, own, element.span, fault, expected)
            )
        elif place.carrier != "text":
            self.missing_value(tag, place.carrier, element, effect)

    def missing_value(self, tag: Tag, wanted: str, element: Element, effect: Effect = REFUSED) -> None:
        if wanted[0] == "@":
            near = suggest(wanted[1:], element.attributes)
        else:
            near = next((c.name for c in element.children() if c.name == f"{self.mark}{wanted[1:]}"), None)
        self.found.append(problems.MissingTagValue(self.vendor, tag.name, effect, element, wanted, near))

    def needed_children(self, tag: Tag, element: Element) -> None:
        """Children that must be there; one that is merely misspelt is reported as such, with the same effect."""
        names = [child.name for child in element.children()]
        strange = [name for name in names if name.startswith(self.mark) and name not in self.vendor.tags]
        meant = {self.meant(name): name for name in strange}
        for problem in missing_children(self.vendor, tag, element):
            misspelt = next((meant[choice] for choice in problem.choices if choice in meant), None)
            if misspelt is None:
                self.found.append(problem)
            else:
                self.decisive[element, misspelt] = problem.effect

    def value(self, tag: Tag, slot: Slot, value: Value) -> None:
        """One value: its type, its range or choices, and its name's shape."""
        text = value.text
        if "${" in text or "$(" in text:
            return
        judged = _judged(tag, value.element)
        bad = misreading(slot, text, self.vendor.is_lenient, judged)
        if bad is not None and slot.type not in {"string", "file"}:
            span = part(value, bad.start, bad.end) if text.strip() else value.span
            self.found.append(
                problems.MalformedTag(
                    self.vendor, tag.name, bad.effect, value, span, bad.fault, expected_of(slot)
                )
            )
            return
        word = text.strip()
        if slot.choices and word not in slot.choices:
            near = suggest(word, slot.choices)
            self.found.append(
                problems.UnknownTagChoice(self.vendor, tag.name, slot.bad, value, slot.choices, near)
            )
        elif slot.plain is not None and "::" in word:
            self.found.append(problems.ScopedTagName(self.vendor, tag.name, slot.plain, value))
        elif (bound := out_of_range(slot, text)) is not None and judged:
            self.found.append(problems.TagOutOfRange(self.vendor, tag.name, slot.wrong, value, bound))
        elif slot.references and word:
            self.references.append((value, slot, tag))

    # When

    def note_release(self, since: str, name: str, target: Element | Value) -> None:
        """Once for a tag and all that came with it."""
        owner = _owner(target)
        around = self.vendor.tags.get(owner.name) if owner is not None else None
        if since and (around is None or around.since != since):
            self.new.setdefault(f"{since} {name}", []).append(target)

    def too_new(self) -> None:
        """Tags of a later release than the document says; without a word, those of the newest one."""
        root = self.document.root
        declared = root.attribute(self.vendor.version) if root is not None and self.vendor.version else None
        limit = _release(declared.text if declared is not None else "")
        newest = _release(self.vendor.release)
        for key, uses in self.new.items():
            since, _, name = key.partition(" ")
            release = _release(since)
            if release > limit if limit else declared is None and newest and release >= newest:
                effect = self.vendor.unknown
                self.found.append(
                    problems.TooNewTag(self.vendor, name, effect, uses[0], since, declared, len(uses))
                )


def _judged(tag: Tag, element: Element) -> bool:
    """Does the range hold here? With ``range-with``, only beside one of those tags."""
    conditions = tag.keys.text("range-with")
    return not conditions or beside(conditions, element) is not None


def _owner(target: Element | Value) -> Element | None:
    return target.element if isinstance(target, Value) else target.parent


def _shown(place: Place) -> str:
    """A place for people: without the root, which goes without saying."""
    return f"{place.text}/@" if place.carrier == "attribute" else place.text


def _release(text: str) -> tuple[int, ...]:
    parts = text.strip().split(".")
    return tuple(map(int, parts)) if all(part.isdecimal() for part in parts) else ()
