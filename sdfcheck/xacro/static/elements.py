"""The elements of the xacro language, also where they are misspelled."""

from __future__ import annotations

from collections.abc import Iterator

from sdfcheck.formats.near_names import nearest
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element
from sdfcheck.xacro.language import KEYWORDS, OPTIONAL, PREFIX, REQUIRED
from sdfcheck.xacro.problems import IgnoredIncludeContent, WrongXacroAttribute

_INCLUDE = "xacro:include"
_FREE = frozenset({"gazebo", "plugin", "ros2_control", "transmission", "mujoco"})
"""The content of these belongs to others, and its names may be those of xacro's elements."""


def keyword(element: Element) -> str:
    """Which element of the language this is or was meant to be, empty if none."""
    name = element.name
    if name.startswith(PREFIX):
        own = name[len(PREFIX) :]
        if own in KEYWORDS:
            return own
        near = nearest(own, REQUIRED)
        return near if near is not None and _has_needs(element, near) else ""
    return name if lacks_prefix(element) else ""


def lacks_prefix(element: Element) -> bool:
    """Whether an element is xacro's but for the prefix: by its name, its attributes and its place."""
    name = element.name
    return name in REQUIRED and _has_needs(element, name) and not is_free(element)


def is_free(element: Element) -> bool:
    """Whether an element is inside of what is another format's than the document's."""
    names = [each.name for each in element.around]
    return any(name in _FREE or (":" in name and not name.startswith(PREFIX)) for name in names)


def is_conditional(element: Element) -> bool:
    """Whether xacro may ignore an element."""
    return any(keyword(each) in {"if", "unless"} for each in element.around)


def is_outside(element: Element) -> bool:
    """Is an element directly in the root?"""
    return element.parent is not None and element.parent.parent is None


def own_attributes(element: Element, own: str) -> dict[str, str]:
    """The attributes of an element of the language, each by the name that was meant."""
    given = element.attributes
    if own not in REQUIRED or all(name in _taken(own) for name in given):
        return given
    meant: dict[str, str] = {}
    for name, text in given.items():
        meant.setdefault(_meant(name, own, given) or name, text)
    return meant


Found = WrongXacroAttribute | IgnoredIncludeContent


def element_problems(document: Document) -> Iterator[Found]:
    """Problems of the elements of the language in a document: their attributes, and what is not read."""
    for element in document.elements[1:]:
        if is_in_include(element):
            continue
        if element.name == _INCLUDE:
            yield from (IgnoredIncludeContent(child.span, child.name) for child in element.children())
        if element.name.startswith(PREFIX) and element.name[len(PREFIX) :] in REQUIRED:
            yield from _wrong_attributes(element, element.name[len(PREFIX) :])


def is_in_include(element: Element) -> bool:
    """Whether an element is where xacro looks at nothing."""
    return any(each.name == _INCLUDE for each in element.around)


def _wrong_attributes(element: Element, own: str) -> Iterator[WrongXacroAttribute]:
    given = element.attributes
    meant = set()
    for name in given:
        if name not in _taken(own) and ":" not in name:
            near = _meant(name, own, given)
            meant.add(near)
            span = element.document.spans.attribute_name(element, name)
            yield WrongXacroAttribute(span, element.name, name, is_missing=False, near=near)
    for name in REQUIRED[own]:
        if name not in given and name not in meant:
            yield WrongXacroAttribute(element.span, element.name, name, is_missing=True)


def _meant(name: str, own: str, given: dict[str, str]) -> str | None:
    """The intended name of an attribute: one that is near, else the only one that is required and missing."""
    free = [each for each in _taken(own) if each not in given]
    if name in _taken(own) or ":" in name:
        return None
    missing = [each for each in REQUIRED[own] if each not in given]
    unknown = [each for each in given if each not in _taken(own)]
    return nearest(name, free) or (missing[0] if len(missing) == len(unknown) == 1 else None)


def _taken(own: str) -> tuple[str, ...]:
    return (*REQUIRED[own], *OPTIONAL.get(own, ()))


def _has_needs(element: Element, own: str) -> bool:
    return all(name in element.attributes for name in REQUIRED[own])
