"""Actuation of the joints of a URDF robot."""

from __future__ import annotations

from typing import TYPE_CHECKING, cast

from sdfcheck.formats.urdf.table import is_expression
from sdfcheck.robot.part import Part

if TYPE_CHECKING:
    from sdfcheck.robot.model import Model
    from sdfcheck.robot.parts.gazebo import GazeboBlock
    from sdfcheck.source.element import Element, Value


class JointNames(Part):
    """Something that names joints."""

    __slots__ = ()

    @property
    def model(self) -> Model:
        """The robot."""
        holder = self.holder
        if holder is not None and holder.kind == "gazebo":
            return cast("GazeboBlock", holder).model
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
        known = self.model.driven_names
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
