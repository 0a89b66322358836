"""Sensors and lights."""

from __future__ import annotations

from typing import TYPE_CHECKING

from sdfcheck.robot.graph import Node, Part, Setting
from sdfcheck.robot.naming.name import DEFAULT, UnknownName
from sdfcheck.robot.values import Vector, is_true, lazy, number, parts

if TYPE_CHECKING:
    from sdfcheck.robot.graph import Setting
    from sdfcheck.robot.motion.poses import Pose
    from sdfcheck.robot.parts.joint import Joint
    from sdfcheck.robot.parts.link import Link
    from sdfcheck.robot.parts.plugin import Plugin
    from sdfcheck.source.document import Element, Value


# Lights.


class Light(Part):
    """A light of a world or link, or one that is a whole file."""

    __slots__ = ()
    kind = "light"

    @property
    def type(self) -> str:
        """``point``, ``spot`` or ``directional``."""
        return (self._text("type") or "point").strip()

    @property
    def direction(self) -> Vector:
        """Where it shines to."""
        return self._vector("direction", (0.0, 0.0, -1.0))

    @property
    def diffuse(self) -> Vector:
        """Red, green, blue, alpha."""
        return self._vector("diffuse", (1.0, 1.0, 1.0, 1.0))

    @property
    def specular(self) -> Vector:
        """Red, green, blue, alpha."""
        return self._vector("specular", (0.1, 0.1, 0.1, 1.0))

    intensity = number("intensity", 1.0, "A factor.")

    def pose(self, relative_to: str | None = None) -> Pose:
        """Its pose in what it is in, or relative to what a reference names there; raises PoseError."""
        from sdfcheck.robot.motion.poses import of_part

        return of_part(self, self.within(Node), relative_to)


# Sensors.


SETTINGS = {
    "camera": "camera",
    "depth": "camera",
    "depth_camera": "camera",
    "multicamera": "camera",
    "rgbd": "camera",
    "rgbd_camera": "camera",
    "thermal": "camera",
    "thermal_camera": "camera",
    "segmentation": "camera",
    "segmentation_camera": "camera",
    "boundingbox": "camera",
    "boundingbox_camera": "camera",
    "wideanglecamera": "camera",
    "ray": "ray",
    "gpu_ray": "ray",
    "lidar": "lidar",
    "gpu_lidar": "lidar",
    "gps": "gps",
    "navsat": "navsat",
}
"""Type → the element that holds its settings, where they are not called alike."""


class Contact(Part):
    """The collisions that a contact sensor, or a sound, listens to."""

    __slots__ = ()
    kind = "contact"

    @property
    def link(self) -> Link | None:
        """The link whose collisions it names."""
        from sdfcheck.robot.parts.link import Link

        holder = self.holder.holder if self.holder is not None else None
        return holder if isinstance(holder, Link) else None

    @property
    def collision_names(self) -> tuple[Value, ...]:
        """The names of collisions that it writes, with their places."""
        return tuple(name.own_value for name in self.children("collision") if name.content)

    @property
    def unresolved(self) -> tuple[UnknownName, ...]:
        """The names that no collision of the link has. Scoped ones are spelled in ways that differ by simulator."""
        if self.link is None:
            return ()
        names = tuple(
            collision.attributes.get("name", "").strip() for collision in self.link.children("collision")
        )
        return tuple(
            UnknownName(value, "collision", self.link.element, names)
            for value in self.collision_names
            if value.text.strip() not in (DEFAULT, *names) and "::" not in value.text
        )


class Sensor(Part):
    """A sensor of a link or joint; in URDF files it is in a ``<gazebo>`` block."""

    __slots__ = ()
    kind = "sensor"

    @property
    def type(self) -> str:
        """The type as written, without spaces around it."""
        return (self._text("type") or "").strip()

    @property
    def type_value(self) -> Value | None:
        """The type with its place."""
        return self.attribute("type")

    @property
    def link(self) -> Link | None:
        """The link that it is on; None if it is on a joint, or on nothing known."""
        from sdfcheck.robot.parts.link import Link

        owner = self.owner
        return owner if isinstance(owner, Link) else None

    @property
    def owner(self) -> Link | Joint | None:
        """The link or joint that it is on; None for one in a ``<gazebo>`` block that names neither."""
        from sdfcheck.robot.parts.gazebo import GazeboBlock
        from sdfcheck.robot.parts.joint import Joint
        from sdfcheck.robot.parts.link import Link

        found = self.holder.subject if isinstance(self.holder, GazeboBlock) else self.holder
        return found if isinstance(found, Link | Joint) else None

    update_rate = number("update_rate", 0.0, "Hz; 0: as often as the simulation steps.")

    @property
    def topic(self) -> str:
        """The topic that it publishes on; empty where the simulator chooses one."""
        topic = self.find("topic")
        text = topic.content if topic is not None else ""
        return "" if text == DEFAULT else text

    @property
    def always_on(self) -> bool:
        """Does it run whether or not somebody listens?"""
        element = self.find("always_on")
        return element is not None and is_true(element.content)

    @property
    def settings_names(self) -> tuple[str, ...]:
        """The elements that may configure a sensor of its type; empty for a type that is not known."""
        from sdfcheck.formats.sdf.sensors import SETTINGS as NAMES

        return NAMES.get(self.type, ())

    @property
    def given_settings(self) -> tuple[Element, ...]:
        """Its elements that configure sensors, of whatever type."""
        from sdfcheck.formats.sdf.sensors import ALL_SETTINGS

        return tuple(child for child in self.children() if child.name in ALL_SETTINGS)

    @property
    def settings(self) -> Setting | None:
        """The part of its type: ``camera``, ``lidar``, ``imu`` …; None without one."""
        names = (SETTINGS.get(self.type, self.type), "lidar", "ray", "camera", "gps", "navsat")
        element = next((found for name in names if name and (found := self.find(name)) is not None), None)
        part = None if element is None else self.part(element)
        return part if isinstance(part, Setting) else None

    plugins: lazy[tuple[Plugin, ...]] = parts("plugin", "Its plugins.")

    def pose(self, relative_to: str | None = None) -> Pose:
        """Its pose in the frame of its link or joint, or relative to what a reference names; raises PoseError."""
        from sdfcheck.robot.motion.poses import of_part

        return of_part(self, self.owner, relative_to)
