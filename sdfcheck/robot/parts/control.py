"""``<ros2_control>`` blocks: the hardware behind the joints, sensors and other signals of a robot.

Source: the component parser of ros2_control, humble to rolling.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, cast

from sdfcheck.formats.urdf.table import UrdfAttribute, UrdfElement, control, is_expression
from sdfcheck.robot.parts.actuation import JointNames
from sdfcheck.robot.values import lazy, parts

if TYPE_CHECKING:
    from sdfcheck.robot.model import Model
    from sdfcheck.robot.parts.control_component import ControlComponent
    from sdfcheck.source.element import Element, Value

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
    def known(self) -> tuple[tuple[Element, UrdfElement], ...]:
        """The elements that ros2_control reads, itself first, each with what is allowed in it."""
        return tuple(_known(self.element, control()))

    @property
    def lacking(self) -> Iterator[tuple[Element, str]]:
        """The attributes that its elements need and do not have."""
        for element, definition in self.known:
            for name in definition.required_attributes:
                if element.attribute(name) is None:
                    yield element, name

    @property
    def unsound(self) -> Iterator[tuple[Value, UrdfAttribute]]:
        """The attributes that are not of their kind, each with what it should be."""
        for element, definition in self.known:
            for name, attribute in definition.attributes.items():
                value = element.attribute(name)
                if value is not None and not _is_sound(value, attribute):
                    yield value, attribute

    @property
    def foreign(self) -> Iterator[tuple[Element, Element, UrdfElement]]:
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


def _known(element: Element, definition: UrdfElement) -> Iterator[tuple[Element, UrdfElement]]:
    yield element, definition
    for child in element.children():
        inner = definition.children.get(child.name)
        if inner is not None:
            yield from _known(child, inner)


def _is_sound(value: Value, attribute: UrdfAttribute) -> bool:
    """Is a value of the kind that ros2_control expects, or made by an expression?"""
    text = value.text.strip()
    if is_expression(text) or attribute.name == "type":
        return True
    if attribute.type == "bool":
        return text.lower() in {"true", "false"}
    if attribute.choices:
        return text in attribute.choices
    return attribute.name not in _COUNTS or (text.isdecimal() and int(text) > 0)
