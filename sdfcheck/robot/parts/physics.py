"""How a world is simulated: physics profiles, states, actors, grippers."""

from __future__ import annotations

from typing import TYPE_CHECKING

from sdfcheck.robot.part import Part
from sdfcheck.robot.values import Number, is_true

if TYPE_CHECKING:
    from sdfcheck.robot.parts.plugin import Plugin
    from sdfcheck.source.element import Element


class Physics(Part):
    """A physics profile of a world."""

    __slots__ = ()
    kind = "physics"

    @property
    def type(self) -> str:
        """The engine: ``ode``, ``bullet``, ``dart`` …"""
        return (self._text("type") or "").strip()

    @property
    def is_default(self) -> bool:
        """Is it the profile that is used?"""
        return is_true(self._text("default") or "")

    @property
    def max_step_size(self) -> Number:
        """s."""
        return self._number("max_step_size", 0.001)

    @property
    def real_time_factor(self) -> Number:
        """Simulated seconds per second."""
        return self._number("real_time_factor", 1.0)


class State(Part):
    """The state to which a world is restored."""

    __slots__ = ()
    kind = "state"


class Actor(Part):
    """A figure that moves along a trajectory."""

    __slots__ = ()
    kind = "actor"

    @property
    def plugins(self) -> tuple[Plugin, ...]:
        """Its plugins."""
        return tuple(self._parts("plugin"))

    @property
    def animations(self) -> tuple[Element, ...]:
        """Its animations."""
        return tuple(self.children("animation"))

    @property
    def trajectories(self) -> tuple[Element, ...]:
        """The trajectories of its script."""
        script = self.find("script")
        return tuple(script.children("trajectory")) if script is not None else ()


class Gripper(Part):
    """A gripper of a model."""

    __slots__ = ()
    kind = "gripper"
