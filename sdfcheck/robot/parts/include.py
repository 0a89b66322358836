"""Includes: other files that become part of a model or world."""

from __future__ import annotations

from typing import TYPE_CHECKING

from sdfcheck.robot.part import Part
from sdfcheck.robot.values import lazy

if TYPE_CHECKING:
    from sdfcheck.robot.includes import Included
    from sdfcheck.robot.model import Model
    from sdfcheck.robot.node import Node
    from sdfcheck.source.element import Value


class Include(Part):
    """An ``include``."""

    __slots__ = ()
    kind = "include"

    @property
    def name(self) -> str:
        """The name that it gives to what it brings; empty where it gives none."""
        name = self.find("name")
        return name.content if name is not None else ""

    @property
    def uri_value(self) -> Value | None:
        """The uri with its place; None where there is none."""
        return self.found.uri

    @property
    def uri(self) -> str:
        """The uri; empty where there is none."""
        return self.uri_value.text if self.uri_value is not None else ""

    @property
    def is_merged(self) -> bool:
        """Do the parts of the model become parts of the one that includes it?"""
        return self.found.merge

    @lazy
    def found(self) -> Included:
        """What it leads to: file, document, model, or why there is none."""
        from sdfcheck.robot.includes import included

        return included(self.document, self.element)

    @property
    def placement_frame_value(self) -> Value | None:
        """The name of the frame of the model that its pose places, with its place; None if there is none."""
        placement = self.find("placement_frame")
        return placement.own_value if placement is not None and placement.content else None

    @lazy
    def node(self) -> Node | None:
        """The model that it brings whole, or the frame that stands for one that it merges; None if neither."""
        from sdfcheck.robot.scope import Scope

        if not isinstance(self.holder, Scope):
            return None
        return next((node for node in self.holder.nodes.values() if node.place is self.element), None)

    @property
    def model(self) -> Model | None:
        """The model that it brings whole; None if it brings none, or merges it."""
        from sdfcheck.robot.model import Model

        return self.node if isinstance(self.node, Model) else None

    @property
    def content(self) -> Model | None:
        """The model that it brings, whole or merged."""
        from sdfcheck.robot.frame import MergedFrame

        return self.node.model if isinstance(self.node, MergedFrame) else self.model
