"""Standard elements inside custom ones.

The custom-elements proposal lets custom elements add, never move: links wrapped in ``<p:group>``
are lost to every simulator, and so are a mass or a shape. But a custom element may use any name for
content of its own, so a name alone proves nothing. A part of a robot (a link, a joint) counts as a
standard one when it could be, unchanged, beside its custom parent. A setting (a mass, a material)
counts when, in addition, it is not given there, is not the default, and the custom element is a
mere wrapper: without attributes or text, and with only such elements in it.
"""

from __future__ import annotations

from collections.abc import Iterator

from sdfcheck.formats.schema import Definition
from sdfcheck.source.document import Element
from sdfcheck.source.record import NamedTuple

_PARTS = frozenset(
    "world model link joint frame visual collision sensor light actor include gripper inertial".split()
)
_BOOLEANS = {"1": "true", "0": "false"}


class Displaced(NamedTuple):
    """A standard element in a custom one."""

    element: Element
    is_needed: bool
    """Is it a part of a robot, or one that is required where it belongs?"""


def standard_inside(custom: Element, parent: Element, place: Definition) -> Iterator[Displaced]:
    """The outermost elements in a custom element that could be beside it, into ``parent``."""
    is_wrapper = _is_wrapper(custom, place)
    for child in custom.children():
        name = child.name
        if ":" in name:
            yield from standard_inside(child, parent, place)
        elif (definition := place.children.get(name)) is None:
            definition = _of_link(place, name)
            if definition is not None and _is_bare(custom) and _is_sound(child, definition):
                yield Displaced(child, False)
        elif name in _PARTS:
            if _is_part(child, definition) and not _refers(child, parent):
                yield Displaced(child, True)
        elif is_wrapper and not _is_given(name, parent, place) and _is_setting(child, definition):
            needed = place.name == "geometry" or name in place.required_children
            yield Displaced(child, needed)


def _of_link(place: Definition, name: str) -> Definition | None:
    """The definition of a collision, visual or geometry, which belongs into a link of a world, model or robot."""
    model = place.children["model"] if place.name == "world" else place
    link = model.children.get("link")
    if link is None or name not in {"collision", "geometry", "visual"}:
        return None
    return link.children[name] if name != "geometry" else link.children["collision"].children[name]


def _is_part(element: Element, definition: Definition) -> bool:
    """Has it what the format requires of such an element, and nothing that it does not know?"""
    attributes = element.attributes
    if any(name not in attributes for name in definition.required_attributes):
        return False
    if any(":" not in name and name not in definition.attributes for name in attributes):
        return False
    names = [child.name for child in element.children()]
    if any(":" not in name and name not in definition.children for name in names):
        return False
    if definition.name in {"joint", "include"}:
        return all(name in names for name in definition.required_children)
    return not element.content


def _refers(element: Element, parent: Element) -> bool:
    """An empty element that names a sibling of its kind is a reference to it."""
    name = element.attributes.get("name")
    return not element.nodes and any(
        sibling.attributes.get("name") == name for sibling in parent.children(element.name)
    )


def _is_wrapper(custom: Element, place: Definition) -> bool:
    """Does it hold nothing but what belongs into ``place``?"""
    return _is_bare(custom) and all(
        ":" in child.name or child.name in place.children for child in custom.children()
    )


def _is_bare(custom: Element) -> bool:
    """Has it neither attributes nor text?"""
    return not custom.content and all(name.startswith("xmlns:") for name in custom.attributes)


def _is_given(name: str, parent: Element, place: Definition) -> bool:
    """Is it there already, or another shape in its place?"""
    if place.name == "geometry":
        return any(":" not in child.name for child in parent.children())
    return parent.find(name) is not None


def _is_setting(element: Element, definition: Definition) -> bool:
    """Is it what the format allows, and does it make a difference?"""
    if definition.open or not _is_sound(element, definition):
        return False
    default = definition.default
    return default is None or bool(element.attributes) or not _is_same(element.content, default)


def _is_sound(element: Element, definition: Definition) -> bool:
    attributes = element.attributes
    if any(name not in attributes for name in definition.required_attributes):
        return False
    for name, text in attributes.items():
        known = definition.attributes.get(name)
        if ":" not in name and (known is None or not known.accepts(text)):
            return False
    if definition.type is not None:
        return not element.nodes and bool(definition.accepts(element.content))
    if element.content:
        return False
    return all(
        ":" in child.name
        or ((inner := definition.children.get(child.name)) is not None and _is_sound(child, inner))
        for child in element.children()
    )


def _is_same(text: str, default: str) -> bool:
    """Do two texts mean the same value, perhaps in other digits?"""
    words, others = text.split(), default.split()
    return len(words) == len(others) and all(map(_is_same_word, words, others))


def _is_same_word(word: str, other: str) -> bool:
    try:
        return float(word) == float(other)
    except ValueError:
        return _BOOLEANS.get(word.lower(), word) == _BOOLEANS.get(other.lower(), other)
