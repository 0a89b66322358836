"""Worlds."""

from __future__ import annotations

from typing import TYPE_CHECKING

from sdfcheck.robot.scope import WORLD_FRAME, Scope

if TYPE_CHECKING:
    from sdfcheck.robot.parts.light import Light
    from sdfcheck.robot.parts.physics import Actor, Physics
    from sdfcheck.robot.parts.plugin import Plugin
    from sdfcheck.robot.values import Vector


class World(Scope):
    """A world."""

    __slots__ = ()
    kind = "world"
    own_name = WORLD_FRAME

    @property
    def physics(self) -> tuple[Physics, ...]:
        """The physics profiles."""
        return tuple(self._parts("physics"))

    @property
    def lights(self) -> tuple[Light, ...]:
        """The lights directly in it."""
        return tuple(self._parts("light"))

    @property
    def actors(self) -> tuple[Actor, ...]:
        """The actors."""
        return tuple(self._parts("actor"))

    @property
    def plugins(self) -> tuple[Plugin, ...]:
        """The plugins of the world itself."""
        return tuple(self._parts("plugin"))

    @property
    def gravity(self) -> Vector:
        """The acceleration of gravity (m/s²)."""
        return self._vector("gravity", (0.0, 0.0, -9.8))
