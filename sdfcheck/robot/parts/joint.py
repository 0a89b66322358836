"""Joints, with their axes."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, cast

from sdfcheck.formats.sdf.survey import survey
from sdfcheck.formats.version import Version
from sdfcheck.robot.graph import Node, Part
from sdfcheck.robot.naming.name import MODEL_FRAME, mirrored, without_sides
from sdfcheck.robot.values import Number, Vector, is_true, lazy, number

if TYPE_CHECKING:
    from sdfcheck.robot.graph import Model
    from sdfcheck.robot.motion.origin import Origin, Triple
    from sdfcheck.robot.parts.gazebo import GazeboBlock
    from sdfcheck.robot.parts.link import Link
    from sdfcheck.robot.parts.sensor import Sensor
    from sdfcheck.source.document import Value


# Axes of joints: directions, limits, dynamics, and joints that follow others.


ENDLESS = 1e15
"""Limits from here on mean none: before 1.10 the format writes 1e16 for infinity."""
_FIVE, _SEVEN = Version(1, 5), Version(1, 7)


class _AxisPart(Part):
    """Something that belongs to an axis: in URDF it is written in the joint."""

    __slots__ = ()

    @property
    def joint(self) -> Joint:
        """The joint."""
        at = self.holder
        while at is not None and at.kind != "joint":
            at = at.holder
        assert at is not None, "axes are made in joints only"
        return cast("Joint", at)

    @property
    def axis(self) -> Axis:
        """The axis that it belongs to."""
        return self.holder if isinstance(self.holder, Axis) else self.joint.axis


class Axis(Part):
    """A direction that a joint turns about or moves along."""

    __slots__ = ()
    kind = "axis"

    @property
    def joint(self) -> Joint:
        """The joint that it belongs to."""
        return cast("Joint", self.holder)

    @property
    def name(self) -> str:
        """``axis`` or ``axis2``."""
        return self.element.name if self.is_given else "axis"

    @property
    def xyz(self) -> Vector:
        """The direction as written, of any length."""
        return self._vector("xyz", (1.0, 0.0, 0.0) if self.is_urdf else (0.0, 0.0, 1.0))

    @lazy
    def length(self) -> float:
        """The length of the direction as written; nan where that is not three finite numbers."""
        xyz = self.xyz
        length = math.hypot(*xyz) if len(xyz) == 3 else math.nan
        return length if length < math.inf else math.nan

    @property
    def expressed_in(self) -> str:
        """The name of the frame in which the direction is written; empty: that of the joint.

        Up to 1.4, and in 1.5 and 1.6 with ``use_parent_model_frame``, it is that of the model. Source: libsdformat 17.
        """
        xyz = self.find("xyz") if not self.is_urdf else None
        written = xyz.attributes.get("expressed_in", "").strip() if xyz is not None else ""
        if written or self.is_urdf or (version := survey(self.document).version) >= _SEVEN:
            return written
        flag = self.find("use_parent_model_frame")
        return MODEL_FRAME if version < _FIVE or (flag is not None and is_true(flag.content)) else ""

    @property
    def _owner(self) -> Part:
        return self.joint if self.is_urdf else self

    @lazy
    def limit(self) -> Limit:
        """How far, how fast and how strongly the joint moves."""
        return self._owner._only("limit", Limit)

    @lazy
    def dynamics(self) -> Dynamics:
        """Damping, friction and spring."""
        return self._owner._only("dynamics", Dynamics)

    @lazy
    def mimic(self) -> Mimic | None:
        """Which joint the axis follows; None if it follows none."""
        found = self._owner._only("mimic", Mimic)
        return found if found.is_given else None


class Limit(_AxisPart):
    """The limits of an axis, in rad or m, N or N·m, rad/s or m/s."""

    __slots__ = ()
    kind = "limit"

    @lazy
    def lower(self) -> Number:
        """The lowest position; without limit -inf, in URDF 0 where only the rest is written."""
        return self._number("lower", 0.0 if self.is_urdf and self.is_given else -math.inf)

    @lazy
    def upper(self) -> Number:
        """The highest position; without limit inf, in URDF 0 where only the rest is written."""
        return self._number("upper", 0.0 if self.is_urdf and self.is_given else math.inf)

    effort = number(
        "effort", math.inf, "The greatest force or torque; in SDFormat a negative one means unlimited."
    )
    velocity = number("velocity", math.inf, "The greatest speed; in SDFormat a negative one means unlimited.")
    stiffness = number("stiffness", 1e8, "The stiffness of the stops, in SDFormat.")
    dissipation = number("dissipation", 1.0, "The dissipation of the stops, in SDFormat.")

    @property
    def range(self) -> tuple[float, float]:
        """The lowest and the highest position as simulators take them: infinite where there is no limit."""
        if self.is_urdf and self.joint.type not in {"revolute", "prismatic"}:
            return -math.inf, math.inf
        return _endless(self.lower), _endless(self.upper)

    @property
    def greatest_effort(self) -> float:
        """The effort as simulators take it: infinite where there is no limit."""
        return _unlimited(self.effort)

    @property
    def greatest_velocity(self) -> float:
        """The velocity as simulators take it: infinite where there is no limit."""
        return _unlimited(self.velocity)


class Dynamics(_AxisPart):
    """The resistance to motion along an axis."""

    __slots__ = ()
    kind = "dynamics"

    damping = number("damping", 0.0, "N·m·s/rad or N·s/m.")
    friction = number("friction", 0.0, "N·m or N.")
    spring_reference = number(
        "spring_reference", 0.0, "The position at which the spring is at rest, in SDFormat."
    )
    spring_stiffness = number("spring_stiffness", 0.0, "N·m/rad or N/m, in SDFormat.")


class Mimic(_AxisPart):
    """An axis that follows another: position = multiplier · (position of the leader - reference) + offset."""

    __slots__ = ()
    kind = "mimic"

    @property
    def leader_value(self) -> Value | None:
        """The name of the joint that it follows, with its place; None where there is no name."""
        value = self.attribute("joint")
        return value if value is not None and value.text.strip() else None

    @property
    def leader_name(self) -> str:
        """The name of the joint that it follows."""
        return self.leader_value.text.strip() if self.leader_value is not None else ""

    @property
    def leader(self) -> Joint | None:
        """The joint that it follows; None if the name is not that of a joint."""
        model = self.joint.model
        if self.is_urdf:  # where joints and links have names of their own
            name = self.leader_value.text if self.leader_value is not None else ""
            return model.joints_by_name.get(name) if model is not None and name else None
        found = self.joint.look_up(self.leader_name) if self.leader_name else None
        return cast("Joint", found) if found is not None and found.kind == "joint" else None

    @property
    def leader_guess(self) -> str | None:
        """The joint that it was probably meant to follow, where the name is not that of a joint."""
        joint, model = self.joint, self.joint.model
        if not self.is_urdf or model is None:
            return joint.scope.guess(self.leader_name, but=(joint.name,), kind="joint").meant
        from sdfcheck.formats.near_names import nearest

        candidates = (name for name in model.joints_by_name if name != joint.name)
        return nearest(self.leader_name, candidates, self.document)

    @property
    def leads_into_ring(self) -> bool:
        """Do its leaders follow each other without end?"""
        seen: set[Mimic] = set()
        at: Mimic | None = self
        while at is not None and at not in seen:
            seen.add(at)
            at = at.next
        return at is not None

    @property
    def is_without_axis(self) -> bool:
        """Does its leader lack the axis that it follows?"""
        leader = self.leader
        if leader is None or self.is_urdf:
            return False
        return self.leader_axis not in {"axis", "axis2"} or not leader.has(self.leader_axis)

    @property
    def next(self) -> Mimic | None:
        """The mimic of the axis that it follows: that axis follows another one, in turn."""
        leader = self.leader
        if leader is None or self.is_without_axis:
            return None
        return leader.axis2.mimic if self.leader_axis == "axis2" else leader.axis.mimic

    @property
    def leader_axis(self) -> str:
        """The axis of the leader that it follows: ``axis`` or ``axis2``."""
        return (self._text("axis") or "").strip() or "axis"

    multiplier = number("multiplier", 1.0)
    offset = number("offset", 0.0)
    reference = number(
        "reference", 0.0, "In SDFormat: the position of the leader at which this one is at the offset."
    )


def _endless(value: float) -> float:
    return math.copysign(math.inf, value) if abs(value) >= ENDLESS else float(value)


def _unlimited(value: float) -> float:
    return math.inf if value < 0 or value >= ENDLESS else float(value)


# Joints.


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
    def is_replaced(self) -> bool:
        """In URDF: do ``<gazebo>`` blocks give Gazebo a joint or frame of its name?"""
        extended = self.model.extended if self.model is not None else None
        others = (*extended.children("joint"), *extended.children("frame")) if extended is not None else ()
        return any(other.get("name") == self.name for other in others)

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
            from sdfcheck.source.text import is_expression

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
        key = without_sides(self.name)
        if key == self.name or self.model is None:
            return ()
        joints = self.model.joints
        return tuple(joint for joint in joints if joint is not self and without_sides(joint.name) == key)

    @property
    def mirror(self) -> Joint | None:
        """The joint whose name says left where its own says right; None without one."""
        name = mirrored(self.name)
        return self.model.joints_by_name.get(name) if name != self.name and self.model is not None else None

    @property
    def driver(self) -> Part | None:
        """One that moves it on command: its joint in ``ros2_control``, a transmission, or a plugin of Gazebo."""
        return self.model.drivers.get(self) if self.model is not None else None

    @property
    def moves(self) -> bool:
        """Is it of a type of URDF that lets its child move?"""
        return self.type in MOVING_IN_URDF if self.is_urdf else self.type != "fixed"

    @lazy
    def at_rest(self) -> Origin | None:
        """Its pose in its model with all joints at zero, in plain numbers; None where that is not known."""
        from sdfcheck.robot.motion.origin import in_model
        from sdfcheck.source.errors import DescriptionError

        try:
            return in_model(self)
        except DescriptionError:
            return None

    @property
    def direction(self) -> Triple | None:
        """The direction of its first axis in its model, of length 1, with all joints at zero; None if not known."""
        xyz = self.axis.xyz
        length = math.hypot(*xyz)
        frame = self.axis.expressed_in
        if len(xyz) != 3 or not 0 < length < math.inf or frame not in {"", MODEL_FRAME}:
            return None
        x, y, z = (number / length for number in xyz)
        if frame:
            return (x, y, z)
        return None if self.at_rest is None else self.at_rest.turned((x, y, z))

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
