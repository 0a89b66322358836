"""How one dialect spells a vendor's tag that the other one has: by the table that lint checks the tags with."""

from __future__ import annotations

from typing import Protocol

import numpy as np

from sdfcheck.convert.writer import numbers
from sdfcheck.formats.sdf.values import floats
from sdfcheck.formats.vendor import known_tables
from sdfcheck.formats.vendor.definitions import Place, Slot, Tag, Vendor, value_at
from sdfcheck.formats.vendor.table import vendor
from sdfcheck.formats.vendor.values import as_read
from sdfcheck.robot.motion.poses import Array
from sdfcheck.source.altered import Xml, declared_prefixes
from sdfcheck.source.document import Comment, Document, Element
from sdfcheck.source.sniff import Kind


class Surroundings(Protocol):
    """The new names of the parts of the robot that tags refer to."""

    def name(self, text: str, kinds: tuple[str, ...]) -> str:
        """The new name of what a name calls, which is of one of several kinds (``link``, ``frame``, ``:tag``)."""

    def vector(self, link: str, text: str, *, is_point: bool) -> str:
        """A point or direction of a link's frame, in the frame that is there now."""


_TRUE = frozenset(("1", "true"))


class Spelling:
    """Writes the tags of one vendor as another dialect has them."""

    def __init__(self, source: Vendor, target: Vendor, around: Surroundings) -> None:
        self.source = source
        self.target = target
        self.around = around
        self.mark = f"{source.prefix}:"
        self.dropped: list[Element] = []
        """Tags that were left out: their consumer ignores them where they are, and would not in the other dialect."""
        self._by_use = {
            tag.absent.use: name
            for name, tag in source.tags.items()
            if tag.absent is not None and tag.absent.use
        }
        self._uses = {
            name: tag.absent.use
            for name, tag in target.tags.items()
            if tag.absent is not None and tag.absent.use
        }

    def knows(self, name: str) -> bool:
        """Is it a tag of the vendor that the other dialect can say?"""
        tag = self.target.tags.get(name)
        return tag is not None and bool(tag.places)

    def must_drop(self, element: Element) -> bool:
        """Is a tag ignored where it is, and would be read, or refused, where it would be in the other dialect?"""
        if not (element.name.startswith(self.mark) and self.target.unknown.refused):
            return False
        tag, parent = self.source.tags.get(element.name), element.parent
        places = tag.places if tag is not None else ()
        return parent is None or not any(place.encloses(parent) and place.holds(parent) for place in places)

    def element(self, element: Element) -> Xml:
        """A tag with all that is in it."""
        name = element.name
        tag, other = self.source.tags.get(name), self.target.tags.get(name)
        node = Xml(name)
        node.attributes.update(declared_prefixes(element))
        node.attributes.pop(f"xmlns:{self.source.prefix}", None)
        if tag is None or other is None:
            return self._plain(element, node)
        self._attributes(element, node, tag, other)
        here, there = _place_in(tag, element), _place_like(other, element)
        if here is not None and here.slot is not None and there is not None and there.slot is not None:
            value = value_at(element, here.carrier)
            if value is not None:
                text = self.value(value.text, here.slot, there.slot)
                _carry(node, there.carrier, self._seen(tag, element, text))
        for child in element.nodes:
            if isinstance(child, Comment):
                node.extend(child)
            elif isinstance(child, Element) and not (here is not None and here.carrier == f"/{child.name}"):
                self._child(child, node, tag, other)
        return node

    def write(self, element: Element, node: Xml) -> Xml | None:
        """Write a tag into the counterpart of its parent; the written element, None for an attribute."""
        tag, place = self.source.tags.get(element.name), self.place(element.name, node)
        if tag is not None and place is not None and place.carrier == "attribute" and place.slot is not None:
            here = _place_in(tag, element)
            value = value_at(element, here.carrier) if here is not None else None
            if here is not None and here.slot is not None and value is not None:
                node.attributes[element.name] = self.value(value.text, here.slot, place.slot)
            return None
        node.append(made := self.element(element))
        return made

    def write_attribute(self, element: Element, name: str, node: Xml) -> bool:
        """Write an attribute into the counterpart of its element; False if nobody would look for it there."""
        here, place = self.attribute(element, name), self.place(name, node)
        if here is None or place is None:
            return False
        text = element.attributes[name]
        text = text if place.slot is None else self.value(text, here, place.slot)
        if place.carrier == "attribute":
            node.attributes[name] = text
        else:
            _carry(node.add(name), place.carrier, text)
        return True

    def attribute(self, element: Element, name: str) -> Slot | None:
        """The meaning of an attribute to its consumer; None if it has none there."""
        tag = self.source.tags.get(name)
        places = () if tag is None else tag.places
        return next(
            (each.slot for each in places if each.carrier == "attribute" and each.encloses(element)), None
        )

    def place(self, name: str, node: Xml) -> Place | None:
        """The place of a tag in the other dialect that is in the counterpart of its parent."""
        tag = self.target.tags.get(name)
        places = () if tag is None else tag.places
        return next((place for place in places if place.path[0].name == node.name), None)

    def value(self, text: str, here: Slot, there: Slot) -> str:
        """A value in the other dialect's words."""
        words = " ".join(text.split())
        if self.source.is_lenient and not self.target.is_lenient:
            words = as_read(here, words)
        if there.type == "truth" and here.type == "bool":
            return "true" if words.lower() in _TRUE else "false"
        return self.around.name(words, here.references) if here.references else words

    def _seen(self, tag: Tag, element: Element, text: str) -> str:
        """A point or direction in the frame of a link, where that has moved."""
        parent = element.parent
        if parent is None:
            return text
        if tag.keys.text("direction-in") == parent.name:
            return self.around.vector(parent.attributes.get("name", ""), text, is_point=False)
        sibling = parent.find(tag.keys.text("point-in") or "-")
        place = _place_in(self.source.tags[sibling.name], sibling) if sibling is not None else None
        link = value_at(sibling, place.carrier) if sibling is not None and place is not None else None
        return text if link is None else self.around.vector(link.text.strip(), text, is_point=True)

    def _plain(self, element: Element, node: Xml) -> Xml:
        """Elements that the table does not have, as they are."""
        node.attributes.update(element.attributes)
        node.text = element.content
        node.extend(*map(self.element, element.children()))
        return node

    def _attributes(self, element: Element, node: Xml, tag: Tag, other: Tag) -> None:
        """Attributes of the tag itself; in the other dialect they may be children, plain or of the vendor."""
        carriers = {place.carrier for place in tag.places}
        for name, text in element.attributes.items():
            slot = tag.attributes.get(name)
            if f"@{name}" in carriers:
                continue
            if slot is not None and name in other.attributes:
                node.attributes[name] = self.value(text, slot, other.attributes[name])
            elif slot is not None and name in other.parts:
                node.add(name, self.value(text, slot, other.parts[name]))
            elif (own := self._by_use.get(f"{tag.name}/@{name}")) is not None:
                node.add(own, " ".join(text.split()))
            else:
                node.attributes[name] = text

    def _child(self, child: Element, node: Xml, tag: Tag, other: Tag) -> None:
        name = child.name
        if self.must_drop(child):
            self.dropped.append(child)
            return
        use = self._uses.get(name, "")
        if use.startswith(f"{tag.name}/@"):
            node.attributes[use.rpartition("@")[2]] = " ".join(child.content.split())
        elif (slot := tag.parts.get(name)) is not None and name in other.attributes:
            node.attributes[name] = self.value(child.content, slot, other.attributes[name])
        else:
            node.append(self.element(child))


def _place_in(tag: Tag, element: Element) -> Place | None:
    """The place that a tag is in; what is in no right one is taken for the first."""
    parent = element.parent
    fitting = (place for place in tag.places if parent is not None and place.encloses(parent))
    holding = [place for place in fitting if parent is not None and place.holds(parent)]
    return next(iter(holding or tag.places), None)


def _place_like(tag: Tag, element: Element) -> Place | None:
    """The place of the other dialect with the same conditions on the parents."""
    parent = element.parent
    alike = (place for place in tag.places if parent is not None and place.path[0].holds(parent))
    return next(alike, None) or next(iter(tag.places), None)


def _carry(node: Xml, carrier: str, text: str) -> None:
    """Put a value where the carrier says."""
    if carrier == "text":
        node.text = text
    elif carrier[:1] == "@":
        node.attributes[carrier[1:]] = text
    elif carrier:
        node.add(carrier[1:], text)


def uses(root: Element, prefix: str) -> bool:
    """Is a description written for the consumers of a prefix: does it declare or use it?"""
    if prefix in root.namespaces:
        return True
    return any(name.startswith(f"{prefix}:") for name in root.document.names)


def spellings(document: Document, target: Kind, around: Surroundings) -> dict[str, Spelling]:
    """Prefix → how to write its tags, of all that a table is about."""
    source = document.kind.value
    return {
        prefix: Spelling(vendor(table, source), vendor(table, target.value), around)
        for prefix, table in known_tables(document.library).items()
    }


def moved(text: str, pose: Array, *, is_point: bool) -> str:
    """A point or direction, given in an inner frame that has a 4×4 pose in the outer one, in the outer.

    Another text stays as it is.
    """
    vector = floats(text)
    if vector is None or len(vector) != 3 or np.array_equal(pose, np.eye(4)):
        return text
    return numbers(pose[:3, :3] @ np.array(vector) + (pose[:3, 3] if is_point else 0.0))
