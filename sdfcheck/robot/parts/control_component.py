"""Joints, sensors and other signals of ``<ros2_control>`` blocks, and their interfaces."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import takewhile
from typing import TYPE_CHECKING, cast

from sdfcheck.formats.urdf.table import is_expression
from sdfcheck.robot.part import Part
from sdfcheck.robot.values import Number, lazy

if TYPE_CHECKING:
    from sdfcheck.robot.model import Model
    from sdfcheck.robot.parts.axis import Mimic
    from sdfcheck.robot.parts.control import Ros2Control
    from sdfcheck.robot.parts.joint import Joint
    from sdfcheck.robot.parts.sensor import Sensor
    from sdfcheck.source.element import Element, Value

LIMITED = frozenset(("position", "velocity", "effort", "acceleration", "jerk"))
"""The interfaces of joints whose minimum and maximum are limits."""


class ControlComponent(Part):
    """A joint, a sensor or other signals (``gpio``) of a ``ros2_control`` block, with their interfaces."""

    __slots__ = ()
    kind = "component"

    @property
    def what(self) -> str:
        """``joint``, ``sensor`` or ``gpio``."""
        return self.element.name

    @property
    def block(self) -> Ros2Control:
        """The block that it is in."""
        return cast("Ros2Control", self.holder)

    @property
    def model(self) -> Model:
        """The robot."""
        return self.block.model

    @lazy
    def joint(self) -> Joint | None:
        """The joint of the robot that it drives or reads; None without one."""
        return self.model.joints_by_name.get(self.name) if self.what == "joint" and self.name else None

    @lazy
    def sensor(self) -> Sensor | None:
        """The simulated sensor of its name."""
        if self.what != "sensor" or not self.name:
            return None
        blocks = self.model.gazebo_blocks
        return next((s for block in blocks for s in block.sensors if s.name == self.name), None)

    @lazy
    def interfaces(self) -> tuple[ControlInterface, ...]:
        """Its interfaces, in the order of the file."""
        names = ("command_interface", "state_interface")
        return tuple(
            cast("ControlInterface", self.part(child)) for child in self.children() if child.name in names
        )

    @property
    def commands(self) -> tuple[ControlInterface, ...]:
        """The interfaces that take commands."""
        return tuple(each for each in self.interfaces if each.is_command)

    @property
    def earlier(self) -> ControlComponent | None:
        """The joint before it in the block that has its name."""
        if self.what != "joint" or not self.name or is_expression(self.name):
            return None
        first = self.block.joints[self.name]
        return None if first is self else first

    @property
    def rivals(self) -> Iterator[tuple[ControlInterface, ControlInterface]]:
        """Its interfaces that a joint of the same name in an earlier block has, too, with those."""
        named = self.block.model.control_joints.get(self.name, ()) if not is_expression(self.name) else ()
        before = takewhile(lambda joint: joint.block is not self.block, named)
        others = [each for joint in before for each in joint.interfaces]
        for own in self.interfaces if others else ():
            for other in others:
                if own.is_readable and own.name == other.name and own.is_command == other.is_command:
                    yield own, other
                    break

    @property
    def mimic_parameters(self) -> tuple[Element, ...]:
        """The parameters that say which joint it follows, as releases before jazzy read them."""
        return tuple(each for each in self.children("param") if each.attributes.get("name") == "mimic")

    @property
    def mimic_value(self) -> Value | None:
        """Whether it follows another joint, where that is written here."""
        return self.attribute("mimic")

    @property
    def mimic(self) -> Mimic | None:
        """How it follows another joint, in the robot and not switched off here."""
        value = self.mimic_value
        if self.joint is None or (value is not None and value.text.strip().lower() == "false"):
            return None
        return self.joint.axis.mimic


class ControlInterface(Part):
    """An interface of a joint, sensor or other signals: one number to command or to read."""

    __slots__ = ()
    kind = "interface"

    @property
    def is_command(self) -> bool:
        """Does it take commands?"""
        return bool(self.element.name == "command_interface")

    @property
    def component(self) -> ControlComponent:
        """Its holder."""
        return cast("ControlComponent", self.holder)

    @property
    def is_readable(self) -> bool:
        """Has it a name, and not one that is yet to be expanded?"""
        return bool(self.name) and not is_expression(self.name)

    @property
    def is_limited(self) -> bool:
        """Do ``min`` and ``max`` limit it?"""
        return self.is_command and self.component.what == "joint" and self.name in LIMITED

    @property
    def twin(self) -> ControlInterface | None:
        """The interface of the same kind and name before it in its component."""
        if not self.is_readable:
            return None
        for other in self.component.interfaces:
            if other is self:
                return None
            if other.name == self.name and other.is_command == self.is_command:
                return other
        return None

    @lazy
    def minimum(self) -> Number:
        """The lowest value, in the unit of the interface; -inf where none is given."""
        return self._parameter("min", -math.inf)

    @lazy
    def maximum(self) -> Number:
        """The highest value, in the unit of the interface; inf where none is given."""
        return self._parameter("max", math.inf)

    @lazy
    def initial(self) -> Number:
        """The value to begin with; nan where none is given."""
        return self._parameter("initial_value", math.nan)

    @property
    def data_type(self) -> str:
        """The type of its values: ``double``, ``bool`` …"""
        return (self._text("data_type") or "double").strip()

    @property
    def malformed(self) -> tuple[tuple[str, Number], ...]:
        """Its minimum, maximum and initial value, as far as they are not numbers and should be."""
        found = [("min", self.minimum), ("max", self.maximum)] if self.is_limited else []
        if not self.is_command and self.data_type != "bool":
            found.append(("initial_value", self.initial))
        return tuple(
            (name, each)
            for name, each in found
            if each.text and not is_expression(each.text) and not _is_number(each)
        )

    @property
    def widened(self) -> Iterator[tuple[str, Number, Number]]:
        """Its minimum and maximum, as far as a stricter limit of the joint counts, with that limit."""
        joint = self.component.joint
        if joint is None or not self.is_limited:
            return
        limit = joint.axis.limit
        if self.name == "position" and limit.is_given and joint.type in {"revolute", "prismatic"}:
            if self.minimum.is_given and self.minimum.number < limit.lower.number and limit.lower.is_given:
                yield "min", self.minimum, limit.lower
            if self.maximum.is_given and self.maximum.number > limit.upper.number and limit.upper.is_given:
                yield "max", self.maximum, limit.upper
        elif self.name in {"velocity", "effort"}:
            bound = limit.velocity if self.name == "velocity" else limit.effort
            for name, number in (("min", self.minimum), ("max", self.maximum)):
                if bound.is_given and number.is_given and abs(number.number) > abs(bound.number):
                    yield name, number, bound

    def parameter(self, name: str) -> Element | None:
        """The last ``param`` of a name: it counts."""
        found = [each for each in self.children("param") if each.attributes.get("name", "").strip() == name]
        return found[-1] if found else None

    def _parameter(self, name: str, default: float) -> Number:
        element = self.parameter(name)
        if element is None:
            return Number.of(None, self.element, default)
        return Number.of(element.own_value, element, default)


def _is_number(number: Number) -> bool:
    """Is a text exactly one finite number?"""
    return math.isfinite(number.number) and "_" not in number.text
