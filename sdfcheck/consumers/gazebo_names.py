"""Names from the time when Gazebo was called Ignition, and the names of frame ids."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from typing import cast

from sdfcheck.consumers.gazebo_problems import FrameIdSpelling, IgnitionName
from sdfcheck.formats.sdf.version import Version
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Span

_FILE = re.compile(r"(?:lib)?ignition-gazebo\d*-([\w-]+?)(?:\.so)?")
_CLASS = re.compile(r"ignition::(gazebo(?=::|\Z))?")

_PREFIX = "ignition"
_OLD_NAMESPACE, _NAMESPACE = "http://ignitionrobotics.org/schema", "http://gazebosim.org/schema"

_FRAME_IDS = frozenset(("gz_frame_id", "ignition_frame_id", "frame_id"))
_TWELVE = Version(1, 12)


def ignition_names(document: Document) -> Iterator[IgnitionName]:
    """Plugins, elements and prefixes that were called after Ignition."""
    for element in elements(document):
        name = element.name
        if name == "plugin":
            yield from _plugin(element)
        elif name == "ignition-gui":
            yield IgnitionName(element.span, name, "gz-gui", tuple(_tags(element, "gz-gui")))
    yield from _prefix(document)


def elements(document: Document) -> Iterator[Element]:
    """All elements of a document."""
    root = document.root
    assert root is not None
    return (element for element in cast("Iterable[Element]", root.iter("*")))


def new_file(name: str) -> str | None:
    """What an Ignition plugin's file is called now: systems lose ``lib`` and ``.so``, too."""
    found = _FILE.fullmatch(name.strip())
    return f"gz-sim-{found[1]}" if found else None


def new_class(name: str) -> str | None:
    """What a class of Ignition is called now."""
    new = _CLASS.sub(lambda found: "gz::sim" if found[1] else "gz::", name, count=1)
    return new if _CLASS.match(name) else None


def _plugin(plugin: Element) -> Iterator[IgnitionName]:
    """File and class are one name in two spellings, to be changed together."""
    changes: list[tuple[Span, str, str]] = []
    for attribute, renamed in (("filename", new_file), ("name", new_class)):
        value = plugin.attribute(attribute)
        new = renamed(value.text) if value is not None else None
        if value is not None and new is not None:
            changes.append((value.span, value.text, new))
    if changes:
        span, old, new = changes[0]
        yield IgnitionName(span, old, new, tuple((place, text) for place, _, text in changes))


def _prefix(document: Document) -> Iterator[IgnitionName]:
    """One report for a prefix and all its uses."""
    uses = list(_prefixed(document))
    if not uses:
        return
    begin = f"{_PREFIX}:"
    changes = [(span, "gz:" + span.text.removeprefix(begin)) for span in uses if span.text.startswith(begin)]
    for element in elements(document):
        if f"xmlns:{_PREFIX}" in document.source.text:
            changes += _declaration(element)
    first = changes[0][0]
    span = first.source.span(first.start, first.start + len(_PREFIX))
    yield IgnitionName(span, _PREFIX, "gz", tuple(dict.fromkeys(changes)))


def _prefixed(document: Document) -> Iterator[Span]:
    spans = document.spans
    for element in elements(document):
        begin = f"{_PREFIX}:"
        if element.name.startswith(begin):
            yield from (span for span, _ in _tags(element, ""))
        if len(element.attrib):
            for name in element.attributes:
                if name.startswith(begin):
                    yield spans.attribute_name(element, name)


def _declaration(element: Element) -> Iterator[tuple[Span, str]]:
    """The changes to a declaration of the prefix; it goes where its successor has one."""
    spans = element.document.spans
    given = {attribute.name for attribute in spans.start_tag(element).attributes}
    old, new = f"xmlns:{_PREFIX}", "xmlns:gz"
    if old not in given:
        return
    if new in given or "gz" in element.nsmap:
        yield spans.attribute_whole(element, old), ""
        return
    yield spans.attribute_name(element, old), new
    value = spans.attribute_value(element, old)
    if value.text == _OLD_NAMESPACE:
        yield value, _NAMESPACE


def _tags(element: Element, name: str) -> Iterator[tuple[Span, str]]:
    """The names in the start tag and in the end tag, if there is one."""
    yield element.span, name
    end = element.document.spans.end_name(element)
    if end is not None:
        yield end, name


def frame_ids(document: Document) -> Iterator[FrameIdSpelling]:
    """Frame ids of sensors. What was never standard is ``frame_id`` from 1.12 on."""
    version: Version | None = None
    if document.kind is Kind.SDF:
        from sdfcheck.formats.sdf.survey import survey

        version = survey(document).version
    instead = "frame_id" if version is not None and version >= _TWELVE else "gz_frame_id"
    by_name: dict[str, list[Element]] = {}
    for element in elements(document):
        parent = element.parent
        if element.name not in _FRAME_IDS or parent is None or parent.name != "sensor":
            continue
        if element.name != "frame_id" and (element.name != instead or version is not None):
            by_name.setdefault(element.name, []).append(element)
    for uses in by_name.values():
        yield FrameIdSpelling(tuple(uses), instead, str(version or ""))
