"""The meaning of misspelled elements and attributes of URDF, among those that are missing beside them."""

from __future__ import annotations

from functools import cache

from sdfcheck.formats.near_names import suggest
from sdfcheck.formats.schema import Definition
from sdfcheck.formats.urdf.schema import known_parents, urdf
from sdfcheck.source.document import Element


def misspells(element: Element, name: str) -> bool:
    """Is there a misspelled attribute or child element that means one of this name?"""
    place = definition(element)
    if place is None:
        return False
    attributes = (meant_attribute(element, key, place) for key in element.attributes)
    children = (meant_child(child, place) for child in element.children())
    return name in attributes or name in children


def definition(element: Element) -> Definition | None:
    """The definition of an element by its place in the document; None where URDF has no such element.

    In a macro of xacro it is that of the first place where such an element may be.
    """
    path: list[str] = []
    at: Element | None = element
    while (
        at is not None and not at.name.startswith("xacro:") and (at.name != "robot" or at.parent is not None)
    ):
        path.append(at.name)
        at = at.parent
    steps = "/".join(reversed(path))
    found = urdf().at(steps)
    if found is None and at is not None and at.name != "robot":
        found = next(filter(None, (place.at(steps) for place in _places())), None)
    return found


@cache
def _places() -> tuple[Definition, ...]:
    """All definitions, from the outside in."""
    places = [urdf()]
    for place in places:
        places += place.children.values()
    return tuple(places)


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
    return suggest(name, [each for each in place.attributes if each not in element.attributes])
