"""Frames: named places that are attached to something."""

from __future__ import annotations

from typing import TYPE_CHECKING, cast

from sdfcheck.robot.node import Node
from sdfcheck.robot.values import lazy

if TYPE_CHECKING:
    from sdfcheck.robot.model import Model
    from sdfcheck.robot.part import Part
    from sdfcheck.robot.scope import Scope
    from sdfcheck.source.element import Element, Value


class Frame(Node):
    """A ``frame``, or Drake's ``drake:frame`` in URDF."""

    __slots__ = ()
    kind = "frame"

    @property
    def attached_to_value(self) -> Value | None:
        """The reference to what it is attached to, with its place; None if nothing is written."""
        value = self.attribute("link" if self.is_urdf else "attached_to")
        return value if value is not None and value.text.strip() else None

    @property
    def attached_to(self) -> Node | None:
        """The node that it is attached to, by default its holder; None if the name is unknown."""
        return self.attachment

    @property
    def attachment(self) -> Node | None:
        value = self.attached_to_value
        return self.look_up(value.text.strip()) if value is not None else (self.merged or self.scope)

    @property
    def base_name(self) -> str:
        value = self.attached_to_value
        return self.written_base or (value.text.strip() if value is not None else "")


class MergedFrame(Frame):
    """The frame that represents a model which an include merged into another."""

    __slots__ = ("model",)

    def __init__(self, holder: Part, element: Element, model: Model) -> None:
        super().__init__(holder, element, f"_merged__{model.name}__model__")
        self.model = model

    @lazy
    def apart(self) -> Model:
        """The model as it is by itself, not merged."""
        from sdfcheck.robot.includes.brought import included_model
        from sdfcheck.robot.includes.included import included

        model = included_model(cast("Scope", self.model.holder), included(self.document, self.element))
        return self.model if model is None else model

    @property
    def attached_to_value(self) -> Value | None:
        return None

    @lazy
    def attachment(self) -> Node | None:
        """The canonical link of the model, which may itself have come by a merge."""
        node = self.apart.attachment
        return None if node is None else self.scope.resolve(node.name)

    @property
    def pose_element(self) -> Element | None:
        return self.model.pose_element

    @property
    def base_name(self) -> str:
        return self.written_base
