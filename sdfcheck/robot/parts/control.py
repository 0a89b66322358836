"""Actuation of a URDF robot: ``<ros2_control>`` blocks and transmissions."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import takewhile
from typing import TYPE_CHECKING, cast

from sdfcheck.formats.schema import AttributeDefinition, Definition
from sdfcheck.formats.urdf.schema import control
from sdfcheck.robot.graph import Part
from sdfcheck.robot.values import Number, lazy, parts
from sdfcheck.source.text import is_expression

if TYPE_CHECKING:
    from sdfcheck.robot.graph import Model
    from sdfcheck.robot.parts.joint import Joint, Mimic
    from sdfcheck.robot.parts.sensor import Sensor
    from sdfcheck.source.document import Element, Value


# Actuation of the joints of a URDF robot.


class JointNames(Part):
    """Something that names joints."""

    __slots__ = ()

    @property
    def model(self) -> Model:
        """The robot."""
        holder = self.holder
        while holder is not None and holder.kind != "model":
            holder = holder.holder
        return cast("Model", holder)

    @property
    def joint_elements(self) -> tuple[Element, ...]:
        """Its ``joint`` elements."""
        return tuple(self.children("joint"))

    @property
    def joint_names(self) -> tuple[Value, ...]:
        """The names of joints that it writes, with their places."""
        values = (joint.attribute("name") for joint in self.joint_elements)
        return tuple(value for value in values if value is not None and value.text)

    @property
    def unresolved(self) -> tuple[Value, ...]:
        """The names that no joint of the robot has; what is yet to be expanded is left out."""
        known = self.model.driven
        return tuple(v for v in self.joint_names if v.text not in known and not is_expression(v.text))


class Transmission(JointNames):
    """A transmission between joints and actuators."""

    __slots__ = ()
    kind = "transmission"

    @property
    def type_value(self) -> Value | None:
        """Its type with its place: a child element, or an attribute."""
        child = self.find("type")
        return child.own_value if child is not None else self.attribute("type")

    @property
    def actuators(self) -> tuple[Element, ...]:
        """Its ``actuator`` elements."""
        return tuple(self.children("actuator"))

    @property
    def reductions(self) -> tuple[Value, ...]:
        """The values of ``mechanicalReduction`` in it and its actuators, with the places."""
        holders = (self.element, *self.actuators)
        return tuple(
            found.own_value for holder in holders for found in holder.children("mechanicalReduction")
        )


# Joints, sensors and other signals of ``<ros2_control>`` blocks, and their interfaces.


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


# ``<ros2_control>`` blocks: the hardware behind the joints, sensors and other signals of a robot.
#
# Source: the component parser of ros2_control, humble to rolling.


COMPONENTS = frozenset(("joint", "sensor", "gpio"))

GAZEBO_SYSTEMS = frozenset(
    ("gazebo_ros2_control/GazeboSystem", "gz_ros2_control/GazeboSimSystem", "ign_ros2_control/IgnitionSystem")
)
"""The plugins whose hardware is a joint of a simulator."""


_COUNTS = frozenset(("size", "thread_priority"))
"""The attributes that are whole numbers from 1 on."""


class Ros2Control(JointNames):
    """A ``ros2_control`` block: one piece of hardware."""

    __slots__ = ()
    kind = "ros2_control"

    @property
    def type(self) -> str:
        """``system``, ``actuator`` or ``sensor``."""
        return self._text("type") or ""

    @property
    def type_value(self) -> Value | None:
        """Its type with its place."""
        return self.attribute("type")

    @property
    def hardware(self) -> Element | None:
        """The element ``hardware``."""
        return self.find("hardware")

    @property
    def plugin_value(self) -> Value | None:
        """The name of the plugin that drives the hardware, with its place; None where no element holds one."""
        element = self.hardware.find("plugin") if self.hardware is not None else None
        return None if element is None else element.own_value

    @property
    def is_simulated(self) -> bool:
        """Is its hardware a simulator's?"""
        plugin = self.plugin_value
        return plugin is not None and plugin.text in GAZEBO_SYSTEMS

    @lazy
    def components(self) -> tuple[ControlComponent, ...]:
        """Its joints, sensors and other signals, in the order of the file."""
        return tuple(
            cast("ControlComponent", self.part(child))
            for child in self.children()
            if child.name in COMPONENTS
        )

    @lazy
    def joints(self) -> dict[str, ControlComponent]:
        """Name → its joint, of several the first."""
        found: dict[str, ControlComponent] = {}
        for component in self.components:
            if component.what == "joint":
                found.setdefault(component.name, component)
        return found

    @lazy
    def known(self) -> tuple[tuple[Element, Definition], ...]:
        """The elements that ros2_control reads, itself first, each with what is allowed in it."""
        return tuple(control().known(self.element))

    @property
    def lacking(self) -> Iterator[tuple[Element, str]]:
        """The attributes that its elements need and do not have."""
        for element, definition in self.known:
            for name in definition.required_attributes:
                if element.attribute(name) is None:
                    yield element, name

    @property
    def unsound(self) -> Iterator[tuple[Value, AttributeDefinition]]:
        """The attributes that are not of their kind, each with what it should be."""
        for element, definition in self.known:
            for name, attribute in definition.attributes.items():
                value = element.attribute(name)
                if value is not None and not _is_sound(value, attribute):
                    yield value, attribute

    @property
    def foreign(self) -> Iterator[tuple[Element, Element, Definition]]:
        """The elements that ros2_control does not know, each with the one that it is in."""
        for element, definition in self.known:
            for child in element.children():
                if child.name not in definition.children:
                    yield child, element, definition

    @property
    def without_plugin(self) -> Iterator[Element]:
        """Itself if it has no hardware, and its hardware and transmissions without a plugin."""
        if self.hardware is None:
            yield self.element
        for holder in self.children():
            if holder.name in {"hardware", "transmission"}:
                plugin = holder.find("plugin")
                if plugin is None or not plugin.content:
                    yield holder if plugin is None else plugin

    transmissions: lazy[tuple[ControlTransmission, ...]] = parts("transmission", "Its transmissions.")

    @property
    def first_of_name(self) -> Ros2Control | None:
        """The block before it that has its name."""
        if not self.name or is_expression(self.name):
            return None
        first = self.model.control_by_name.get(self.name, self)
        return None if first is self else first


class ControlTransmission(JointNames):
    """A transmission in a ``ros2_control`` block: its plugin is the hardware's business."""

    __slots__ = ()
    kind = "transmission"

    @property
    def block(self) -> Ros2Control:
        """The block that it is in."""
        return cast("Ros2Control", self.holder)

    @property
    def model(self) -> Model:
        return self.block.model

    @property
    def unresolved(self) -> tuple[Value, ...]:
        """The names that no joint of the block has."""
        known = self.block.joints
        return tuple(v for v in self.joint_names if v.text not in known and not is_expression(v.text))


def _is_sound(value: Value, attribute: AttributeDefinition) -> bool:
    """Is a value of the kind that ros2_control expects, or made by an expression?"""
    text = value.text.strip()
    if is_expression(text) or attribute.name == "type":
        return True
    if attribute.type == "bool":
        return text.lower() in {"true", "false"}
    if attribute.listed:
        return text in attribute.listed
    return attribute.name not in _COUNTS or (text.isdecimal() and int(text) > 0)
