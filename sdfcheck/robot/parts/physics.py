"""How a world is simulated: physics profiles, states, actors, grippers."""

from __future__ import annotations

from typing import TYPE_CHECKING

from sdfcheck.robot.graph import Part, Scope
from sdfcheck.robot.naming.name import DEFAULT, UnknownName
from sdfcheck.robot.values import is_true, lazy, number, parts

if TYPE_CHECKING:
    from sdfcheck.robot.graph import Scope
    from sdfcheck.robot.parts.plugin import Plugin
    from sdfcheck.source.document import Element, Value


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

    max_step_size = number("max_step_size", 0.001, "s.")
    real_time_factor = number("real_time_factor", 1.0, "Simulated seconds per second.")


class State(Part):
    """The state to which a world is restored."""

    __slots__ = ()
    kind = "state"

    @property
    def world(self) -> Scope | None:
        """The world that it is a state of."""
        return self.holder if isinstance(self.holder, Scope) and self.holder.kind == "world" else None

    @property
    def world_value(self) -> Value | None:
        """The name of the world that it writes, with its place."""
        return self.attribute("world_name")

    @lazy
    def unresolved(self) -> tuple[UnknownName, ...]:
        """The name of a world that is another one, or else the names that no model of the world has."""
        world, value = self.world, self.world_value
        if world is None or not world.is_complete:
            return ()
        if value is not None and value.text.strip() not in {"", DEFAULT, world.name}:
            return (UnknownName(value, "world", self.root.element, (world.name,)),)
        models = tuple(name for name, node in world.nodes.items() if node.kind == "model")
        states = (state for kind in ("model", "model_state") for state in self.children(kind))
        names = (state.attribute("name") for state in states)
        return tuple(
            UnknownName(name, "model", world.element, models)
            for name in names
            if name is not None and "::" not in name.text and name.text not in models
        )


class Actor(Part):
    """A figure that moves along a trajectory."""

    __slots__ = ()
    kind = "actor"

    plugins: lazy[tuple[Plugin, ...]] = parts("plugin", "Its plugins.")

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

    @property
    def link_names(self) -> tuple[Value, ...]:
        """The names of links that it writes, with their places."""
        names = (name for kind in ("gripper_link", "palm_link") for name in self.children(kind))
        return tuple(name.own_value for name in names if name.content)

    @lazy
    def unresolved(self) -> tuple[UnknownName, ...]:
        """The names that are not those of links."""
        scope = self.holder
        if not isinstance(scope, Scope):
            return ()
        names = [value for value in self.link_names if not _is_link(scope, value.text)]
        links = tuple(link.name for link in scope.links) if names else ()
        return tuple(UnknownName(value, "link", scope.element, links) for value in names)


def _is_link(scope: Scope, name: str) -> bool:
    """Is it the name of a link, or may it be one? An element with an empty part is reported as that."""
    if name == DEFAULT or "" in name.split("::"):
        return True
    found = scope.resolve(name)
    return scope.may_hold(name) if found is None else found.kind == "link"
