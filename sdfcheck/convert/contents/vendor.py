"""Tags of vendors as trees in which it does not show which dialect wrote them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from sdfcheck.convert.contents.entry import Entry
from sdfcheck.convert.marks import MARKS
from sdfcheck.formats.vendor import known_tables
from sdfcheck.formats.vendor.definitions import Slot, Tag, value_at
from sdfcheck.formats.vendor.table import tag_of, vendors
from sdfcheck.formats.vendor.values import as_read
from sdfcheck.source.document import Document, Element
from sdfcheck.source.sniff import Kind

_KEPT = "urdf:"
"""Before the names of elements that a conversion kept from URDF."""


def custom_entries(elements: Iterable[Element], kind: Kind) -> Iterator[Entry]:
    """The custom ones among some elements; tags of a table only where they are read."""
    for element in elements:
        if element.is_custom and _is_read(element, kind):
            yield custom_entry(element, kind)


def custom_entry(element: Element, kind: Kind) -> Entry:
    """A custom element; one that a table is about by the values that are read alone."""
    tag = tag_of(element.document, element.name, kind.value)
    if tag is not None:
        return _tag_entry(element, tag, kind)
    made = Entry(element.name.removeprefix(_KEPT), " ".join(element.content.split()), element)
    for name, text in element.attributes.items():
        if name.removeprefix(_KEPT) == "name":
            made.own = text
        elif text and name not in MARKS:
            made.attributes[name.removeprefix(_KEPT)] = text
    made.children += [custom_entry(child, kind) for child in element.children()]
    return made


def _tag_entry(element: Element, tag: Tag, kind: Kind) -> Entry:
    made = Entry(element.name, "", element)
    place = next((place for place in tag.places if place.slot is not None), None)
    value = value_at(element, place.carrier) if place is not None else None
    if place is not None and place.slot is not None and value is not None:
        made.text = _read(place.slot, value.text)
    for name, slot in tag.attributes.items():
        if (given := element.attribute(name)) is None:
            continue
        if name == "name":
            made.own = given.text
        else:
            made.add(Entry(name, _read(slot, given.text), element))
    for child in element.children():
        if child.name in tag.parts:
            made.add(Entry(child.name, _read(tag.parts[child.name], child.content), child))
    for inner in custom_entries(element.children(), kind):
        inner.name = _local(inner.name)
        made.add(inner)
    return made


def _read(slot: Slot, text: str) -> str:
    """A value as it is read, by the lenient of the dialects."""
    words = " ".join(text.split())
    if slot.type in {"bool", "truth"}:
        return str(words.lower() in {"true", "1"}).lower()
    return as_read(slot, words)


def _is_read(element: Element, kind: Kind) -> bool:
    """Does its consumer look for it where it is? Elements that no table has may be anybody's."""
    if not _has_table(element, element.name):
        return True
    tag, parent = tag_of(element.document, element.name, kind.value), element.parent
    if tag is None or parent is None:
        return False
    if any(above.name == "gazebo" for above in element.around):
        return True  # it is kept there for SDFormat
    return any(place.encloses(parent) and place.holds(parent) for place in tag.places)


def attribute_entry(element: Element, name: str, text: str, kind: Kind) -> Entry | None:
    """A tag that is an attribute where it is read; None if it is not."""
    tag = tag_of(element.document, name, kind.value)
    places = () if tag is None else tag.places
    read = (place.slot for place in places if place.carrier == "attribute" and place.encloses(element))
    slot = next(read, None)
    return None if slot is None else Entry(name, _read(slot, text), element)


def take_attributes(made: Entry, element: Element, kind: Kind) -> None:
    """Give a part what its attributes say to vendors, as another dialect may have elements for that."""
    for name, text in element.attributes.items():
        if ":" in name and _has_table(element, name):
            made.attributes.pop(name, None)
            if (entry := attribute_entry(element, name, text, kind)) is not None:
                made.add(entry)


def attribute_entries(element: Element, kind: Kind) -> Iterator[Entry]:
    """The attributes of an element that are custom, each as an entry of its own."""
    for name, text in element.attributes.items():
        if ":" not in name or name.startswith("xmlns:"):
            continue
        if _has_table(element, name):
            entry = attribute_entry(element, name, text, kind)
        else:
            entry = Entry(name.removeprefix(_KEPT), text, element)
        if entry is not None:
            yield entry


def _has_table(element: Element, name: str) -> bool:
    return name.partition(":")[0] in known_tables(element.document.library)


def seen_from_links(document: Document) -> set[str]:
    """The tags, without prefix, whose numbers change when the frame of a link does."""
    tags = (tag for table in vendors(document.library, "sdf") for tag in table.tags.values())
    return {_local(tag.name) for tag in tags if tag.keys.text("point-in") or tag.keys.text("direction-in")}


def _local(name: str) -> str:
    """The name without the vendor's prefix: what is a tag in one dialect is an attribute in the other."""
    return name.rpartition(":")[2]
