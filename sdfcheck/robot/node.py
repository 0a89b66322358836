"""Nodes: what poses can be relative to, and what references name.

Links, joints, frames and models are nodes of the model or world that they are in, and
worlds are nodes, too. A frame moves with what it is attached to, a joint with its child,
a model with its canonical link. A static model moves with nothing, and is a place of its
own. Source: libsdformat 17's FrameSemantics.cc and parser.cc, checked against what they do.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, cast

from sdfcheck.robot.part import Part
from sdfcheck.robot.reserved import MODEL_FRAME
from sdfcheck.robot.values import lazy

if TYPE_CHECKING:
    from sdfcheck.robot.frame import MergedFrame
    from sdfcheck.robot.motion.pose import Pose
    from sdfcheck.robot.scope import Scope
    from sdfcheck.source.element import Element


class Node(Part):
    """A named place: a link, joint, frame, model or world."""

    __slots__ = ("_name", "merged")

    def __init__(self, holder: Part, element: Element | None, name: str | None = None) -> None:
        super().__init__(holder, element)
        self._name = name
        self.merged: MergedFrame | None = None
        """The frame of the model that brought it here, if an include was merged."""

    @property
    def name(self) -> str:
        """The name by which it goes in its model or world."""
        if self._name is None:
            name = self._text("name") or ""
            self._name = name if self.is_urdf else name.strip()
        return self._name

    @property
    def place(self) -> Element:
        """The element of the enclosing file that brings it: its own, or that of the include."""
        return self.element

    @property
    def scope(self) -> Scope:
        """The model or world in which its name is known."""
        if self.holder is not None and self.holder.kind == "gazebo":
            return cast("Node", self.holder).scope
        return cast("Scope", self.holder)

    @property
    def scoped_name(self) -> str:
        """Its name from the top of the file: ``robot::arm::hand``."""
        scope: Part | None = self.holder
        outer = scope.scoped_name if isinstance(scope, Node) and scope.kind == "model" else ""
        return f"{outer}::{self.name}" if outer else self.name

    @property
    def apart(self) -> Node:
        """It as it is by itself, where an include merged it into another model."""
        return self

    # Motion

    @property
    def attachment(self) -> Node | None:
        """The next node on the way to the link that carries it; None if there is none."""
        return None

    @lazy
    def carrier(self) -> Node | None:
        """The node that it moves with: a link, the world, or a static model; None if that is unknown."""
        seen: set[Node] = set()
        at: Node | None = self
        while at is not None and at not in seen:
            seen.add(at)
            if at.kind in {"link", "world"} or at.stands_still:
                return at
            at = at.attachment
        return None

    @property
    def stands_still(self) -> bool:
        """Is it a model that is itself static? One in a static model need not be."""
        return False

    # Where it is

    @property
    def pose_element(self) -> Element | None:
        """The ``pose`` that counts for it."""
        return self.find("pose")

    @property
    def written_base(self) -> str:
        """The name that its pose is written relative to; empty where there is none."""
        from sdfcheck.robot.parts.placement import reference_of

        return reference_of(self.pose_element)

    @property
    def base_name(self) -> str:
        """The name of what its pose is relative to; empty where that is the model or world it is in."""
        return self.written_base

    @property
    def base(self) -> Node | None:
        """The node that its pose is relative to; None where a reference is not resolved."""
        name = self.base_name
        return self.look_up(name) if name else (self.merged or self.scope)

    def look_up(self, reference: str) -> Node | None:
        """The node that a reference written in this part names."""
        if reference == MODEL_FRAME and self.merged is not None:
            return self.merged
        around: Part | None = self.holder
        if around is not None and around.kind == "gazebo":
            return self.scope.resolve(reference)
        return None if self.scope_around is None else self.scope_around.resolve(reference)

    def pose(self, relative_to: str | Node | None = None) -> Pose:
        """Where it is with all joints at zero.

        ``relative_to`` names a frame as a reference in this model would, is a node, or
        ``"world"`` for the outermost model or world; by default the model or world that
        it is in. Lengths in m, angles in rad.

        Raises PoseError where a reference leads nowhere or a number cannot be read.
        """
        from sdfcheck.robot.motion.pose import resolved

        return resolved(self, relative_to)


class Outside(Node):
    """The world around a model that is alone in its file."""

    __slots__ = ()
    kind = "world"
