"""The content of a ``<gazebo>`` block of a URDF robot."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from sdfcheck.source.element import Element


def extension_parts(block: Element) -> Iterator[Element]:
    """The elements in a ``<gazebo>`` block; what is in plugins is theirs."""
    for child in block.children():
        yield child
        if child.name != "plugin":
            yield from extension_parts(child)


def with_extensions(index: Mapping[str, list[Element]]) -> Mapping[str, list[Element]]:
    """Name → elements, with those in the ``<gazebo>`` blocks that are among them."""
    found = {name: list(elements) for name, elements in index.items()}
    for element in (part for block in index["gazebo"] for part in extension_parts(block)):
        found.setdefault(element.name, []).append(element)
    return found
