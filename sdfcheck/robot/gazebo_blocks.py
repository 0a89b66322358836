"""What a ``<gazebo>`` block of a URDF robot holds."""

from __future__ import annotations

from collections.abc import Iterator

from sdfcheck.source.element import Element


def extension_parts(block: Element) -> Iterator[Element]:
    """The elements in a ``<gazebo>`` block; what stands in plugins is theirs."""
    for child in block.children():
        yield child
        if child.name != "plugin":
            yield from extension_parts(child)
