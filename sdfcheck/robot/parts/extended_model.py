"""A URDF robot as Gazebo has it: with the links, joints and models that its ``<gazebo>`` blocks add."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, cast

from sdfcheck.robot.model import Model
from sdfcheck.robot.node import Node
from sdfcheck.robot.reserved import NODES

if TYPE_CHECKING:
    from sdfcheck.robot.part import Part
    from sdfcheck.source.element import Element


class ExtendedModel(Model):
    """The scope in which the SDFormat of ``<gazebo>`` blocks looks names up.

    Links and joints that libsdformat merges away leave frames of their names.
    """

    __slots__ = ("robot",)

    def __init__(self, holder: Part, element: Element | None, name: str | None = None) -> None:
        super().__init__(holder.root, element, name or holder.name)
        self.robot = cast("Model", holder)
        self.is_urdf = False

    def part(self, element: Element) -> Part:
        return self.root.part_of(element)

    def children(self, name: str | None = None) -> Iterator[Element]:
        """The parts that the blocks about the robot add to it."""
        for block in self.robot.blocks_by_reference.get("", ()):
            yield from block.children(name)

    def _fill(self, nodes: dict[str, Node]) -> None:
        nodes.update(self.robot.nodes)
        for child in self.children():
            if child.name == "include":
                self._unread = True
            elif child.name in NODES and (name := child.attributes.get("name", "").strip()):
                part = self.part(child)
                if part.kind == "model" and isinstance(part, Node):
                    nodes[name] = part  # of two things with this name the one with names in it
                elif isinstance(part, Node):
                    nodes.setdefault(name, part)
