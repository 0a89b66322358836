"""Worlds."""

from __future__ import annotations

from typing import TYPE_CHECKING

from sdfcheck.robot.reserved import WORLD_FRAME
from sdfcheck.robot.scope import Scope
from sdfcheck.robot.values import lazy, parts

if TYPE_CHECKING:
    from sdfcheck.robot.parts.light import Light
    from sdfcheck.robot.parts.physics import Actor, Physics
    from sdfcheck.robot.parts.plugin import Plugin
    from sdfcheck.robot.parts.sensor import Sensor
    from sdfcheck.robot.values import Vector


class World(Scope):
    """A world."""

    __slots__ = ()
    kind = "world"
    own_name = WORLD_FRAME

    physics: lazy[tuple[Physics, ...]] = parts("physics", "The physics profiles.")
    lights: lazy[tuple[Light, ...]] = parts("light", "The lights directly in it.")
    actors: lazy[tuple[Actor, ...]] = parts("actor", "The actors.")
    plugins: lazy[tuple[Plugin, ...]] = parts("plugin", "The plugins of the world itself.")

    @property
    def gravity(self) -> Vector:
        """The acceleration of gravity (m/s²)."""
        return self._vector("gravity", (0.0, 0.0, -9.8))

    @lazy
    def unserved_sensors(self) -> tuple[tuple[Sensor, tuple[str, ...]], ...]:
        """Its sensors that need a system of Gazebo which is not there, with those that would do.

        None where the world lists no system of gz-sim: Gazebo then brings its own.
        """
        elements = self.root.elements
        if not elements.get("sensor") or not elements.get("plugin"):
            return ()
        from sdfcheck.formats.plugins import GZ_SIM, served

        plugins: list[Plugin] = list(self.root.each("Plugin"))
        present = {plugin.known.file for plugin in plugins if plugin.known is not None}
        if not any(plugin.known is not None and plugin.known.generation == GZ_SIM for plugin in self.plugins):
            return ()
        needs = served()
        sensors: list[Sensor] = [s for s in self.root.each("Sensor") if s.within(World) is self]
        return tuple(
            (sensor, needs[sensor.type])
            for sensor in sensors
            if sensor.type in needs and present.isdisjoint(needs[sensor.type])
        )
