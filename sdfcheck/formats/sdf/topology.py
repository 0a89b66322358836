"""Standard elements inside custom ones.

The custom-elements proposal lets custom elements add, never move: links wrapped in
``<p:group>`` are lost to every reader. But a custom element may use any name for
content of its own, so a name alone proves nothing: an element counts as a standard one
when it could stand, as it is, beside its custom parent.
"""

from __future__ import annotations

from collections.abc import Iterator

from sdfcheck.formats.sdf.schema import Definition
from sdfcheck.source.element import Element

# Elements that are things of their own. Settings such as <pose> or <mass> inside a
# custom element are its parameters.
_ENTITIES = frozenset(
    "world model link joint frame visual collision sensor light actor include gripper inertial".split()
)


def standard_inside(custom: Element, parent: Element, place: Definition) -> Iterator[Element]:
    """The outermost elements in a custom element that belong beside it, into ``parent``."""
    for child in custom.children():
        name = child.name
        if ":" in name:
            yield from standard_inside(child, parent, place)
        elif name in _ENTITIES and name in place.children:
            definition = place.children[name]
            if _is_standard(child, definition) and not _refers(child, parent):
                yield child


def _is_standard(element: Element, definition: Definition) -> bool:
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
    return len(element) == 0 and any(
        sibling.attributes.get("name") == name for sibling in parent.children(element.name)
    )
