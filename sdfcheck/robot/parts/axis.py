"""Axes of joints: directions, limits, dynamics, and joints that follow others."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, cast

from sdfcheck.robot.part import Part
from sdfcheck.robot.values import Number, Vector, lazy, number

if TYPE_CHECKING:
    from sdfcheck.robot.parts.joint import Joint
    from sdfcheck.source.element import Value

ENDLESS = 1e15
"""Limits from here on mean none: before 1.10 the format writes 1e16 for infinity."""


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
        """The name of the frame in which the direction is written; empty: that of the joint."""
        xyz = self.find("xyz") if not self.is_urdf else None
        return xyz.attributes.get("expressed_in", "").strip() if xyz is not None else ""

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
