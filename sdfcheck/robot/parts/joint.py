"""Joints."""

from __future__ import annotations

from typing import TYPE_CHECKING, cast

from sdfcheck.robot.node import Node
from sdfcheck.robot.parts.axis import Axis
from sdfcheck.robot.values import lazy, number

if TYPE_CHECKING:
    from sdfcheck.robot.model import Model
    from sdfcheck.robot.parts.gazebo import GazeboBlock
    from sdfcheck.robot.parts.link import Link
    from sdfcheck.robot.parts.sensor import Sensor
    from sdfcheck.source.element import Value

UNCONVERTED = frozenset({"floating", "planar"})
"""The types of URDF that SDFormat does not have: libsdformat drops such joints."""

MOVING_IN_URDF = frozenset({"revolute", "continuous", "prismatic"}) | UNCONVERTED

PRESERVING = ("preserveFixedJoint", "disableFixedJointLumping")
"""The settings in ``<gazebo>`` that keep a fixed joint."""

AXES = {
    "revolute": 1,
    "continuous": 1,
    "prismatic": 1,
    "screw": 1,
    "gearbox": 2,
    "revolute2": 2,
    "universal": 2,
    "ball": 0,
    "fixed": 0,
}
"""Type in SDFormat → the number of axes that the joint moves about or along."""


class Joint(Node):
    """A joint between two links; in URDF also Drake's ``drake:joint``."""

    __slots__ = ()
    kind = "joint"

    @lazy
    def type(self) -> str:
        """The type as simulators compare it: in SDFormat small letters, without spaces; empty if there is none."""
        text = self._text("type") or ""
        return text if self.is_urdf else text.strip().lower()

    @property
    def type_value(self) -> Value | None:
        """The type with its place."""
        return self.attribute("type")

    @property
    def is_fixed(self) -> bool:
        """Does it not let its child move?"""
        return self.type == "fixed"

    @property
    def is_unconverted(self) -> bool:
        """In URDF: does libsdformat drop it, as SDFormat does not have its type?"""
        return self.is_urdf and self.type in UNCONVERTED

    @property
    def is_preserved(self) -> bool:
        """Does a ``<gazebo>`` block make libsdformat keep it although it is fixed?"""
        return any(block.is_on(name) for block in self.gazebo_blocks for name in PRESERVING)

    @property
    def is_lumped(self) -> bool:
        """In URDF: does libsdformat merge its child into its parent?"""
        return self.is_urdf and self.is_fixed and self.parent_name != "world" and not self.is_preserved

    @property
    def is_for_drake_only(self) -> bool:
        """Is it a ``drake:joint``, which nobody but Drake sees?"""
        return self.element.name == "drake:joint"

    @property
    def model(self) -> Model | None:
        """The model that it is in; None in a world."""
        return cast("Model", self.holder) if self.holder is not None and self.holder.kind == "model" else None

    # Ends

    @lazy
    def parent_value(self) -> Value | None:
        """The name of its parent with its place; None where there is no name."""
        return self._end("parent")

    @lazy
    def child_value(self) -> Value | None:
        """The name of its child with its place; None where there is no name."""
        return self._end("child")

    @property
    def parent_name(self) -> str:
        """The name of its parent as written."""
        return self.parent_value.text if self.parent_value is not None else ""

    @property
    def child_name(self) -> str:
        """The name of its child as written."""
        return self.child_value.text if self.child_value is not None else ""

    @lazy
    def parent(self) -> Node | None:
        """The link, frame, model or world that its parent names; None if that is nothing known."""
        if not self.is_urdf and self.parent_name == "world":
            return self.root.outermost(self)
        return self._named(self.parent_name)

    @lazy
    def child(self) -> Node | None:
        """The link, frame or model that its child names; None if that is nothing known."""
        return self._named(self.child_name)

    @property
    def parent_link(self) -> Link | None:
        """The link that its parent moves with; None for the world, and where that is unknown."""
        return _link(self.parent)

    @property
    def child_link(self) -> Link | None:
        """The link that its child moves with; None where that is unknown."""
        return _link(self.child)

    def _end(self, role: str) -> Value | None:
        prefix = "drake:" if self.is_for_drake_only and not self.is_urdf else ""
        element = self.find(prefix + role)
        if element is None:
            return None
        value = element.attribute("link") if self.is_urdf else element.own_value
        return value if value is not None and value.text else None

    def _named(self, name: str) -> Node | None:
        if self.is_urdf:
            from sdfcheck.formats.urdf.table import is_expression

            found = self.look_up(name) if name and not is_expression(name) else None
            return found if found is not None and found.kind == "link" else None
        found = self.look_up(name) if name else None
        return None if found is self else found

    @property
    def attachment(self) -> Node | None:
        return self.child

    @property
    def base_name(self) -> str:
        return self.written_base or self.child_name

    # Motion

    @lazy
    def axis(self) -> Axis:
        """Its first axis; with defaults where none is written."""
        return self._only("axis", Axis)

    @lazy
    def axis2(self) -> Axis:
        """Its second axis, in SDFormat; with defaults where none is written."""
        return self._only("axis2", Axis)

    @property
    def axes(self) -> tuple[Axis, ...]:
        """The axes that it moves about or along, given or not."""
        count = self.axis_count
        return (self.axis, self.axis2)[:count]

    @property
    def axis_count(self) -> int:
        """The number of axes that its type has."""
        if self.is_urdf:
            return 0 if self.type in {"fixed", "floating"} else 1
        return AXES.get(self.type, 0)

    @property
    def counterparts(self) -> tuple[Joint, ...]:
        """The other joints of its model whose names differ only by the side: those of the other wheels or legs."""
        from sdfcheck.robot.naming.sides import without_sides

        key = without_sides(self.name)
        if key == self.name or self.model is None:
            return ()
        joints = self.model.joints
        return tuple(joint for joint in joints if joint is not self and without_sides(joint.name) == key)

    @property
    def mirror(self) -> Joint | None:
        """The joint whose name says left where its own says right; None without one."""
        from sdfcheck.robot.naming.sides import mirrored

        name = mirrored(self.name)
        return self.model.joints_by_name.get(name) if name != self.name and self.model is not None else None

    @property
    def moves(self) -> bool:
        """Is it of a type of URDF that lets its child move?"""
        return self.type in MOVING_IN_URDF if self.is_urdf else self.type != "fixed"

    screw_thread_pitch = number("screw_thread_pitch", 1.0, "Of a screw: m of travel per turn.")
    thread_pitch = number(
        "thread_pitch", 1.0, "Of a screw, as older versions write it: radians of turn per m, left-handed."
    )
    gearbox_ratio = number("gearbox_ratio", 1.0, "Of a gearbox: turns of the parent per turn of the child.")

    @property
    def sensors(self) -> tuple[Sensor, ...]:
        """Its sensors; in URDF those of the ``<gazebo>`` blocks about it."""
        blocks = (sensor for block in self.gazebo_blocks for sensor in block.sensors)
        return (*(() if self.is_urdf else self._parts("sensor")), *blocks)

    @property
    def gazebo_blocks(self) -> tuple[GazeboBlock, ...]:
        """The ``<gazebo>`` blocks about it, in URDF."""
        model = self.model
        if not self.is_urdf or model is None:
            return ()
        return tuple(model.blocks_by_reference.get(self.name, ()))


def _link(node: Node | None) -> Link | None:
    carrier = node.carrier if node is not None else None
    return cast("Link", carrier) if carrier is not None and carrier.kind == "link" else None
