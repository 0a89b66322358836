"""Which class an element becomes, by its name and by what it is in."""

from __future__ import annotations

from functools import cache, lru_cache
from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from sdfcheck.robot.part import Part
    from sdfcheck.source.element import Element

_HOMES = {
    "actor": "parts.physics:Actor",
    "axis": "parts.axis:Axis",
    "axis2": "parts.axis:Axis",
    "collision": "parts.shape:Collision",
    "contact": "parts.sensor:Contact",
    "drake:frame": "frame:Frame",
    "drake:joint": "parts.joint:Joint",
    "dynamics": "parts.axis:Dynamics",
    "frame": "frame:Frame",
    "gazebo": "parts.gazebo:GazeboBlock",
    "geometry": "parts.shape:Geometry",
    "gripper": "parts.physics:Gripper",
    "include": "parts.include:Include",
    "inertial": "parts.inertial:Inertial",
    "joint": "parts.joint:Joint",
    "light": "parts.light:Light",
    "limit": "parts.axis:Limit",
    "link": "parts.link:Link",
    "material": "parts.material:Material",
    "mimic": "parts.axis:Mimic",
    "model": "model:Model",
    "origin": "parts.placement:Placement",
    "physics": "parts.physics:Physics",
    "plugin": "parts.plugin:Plugin",
    "pose": "parts.placement:Placement",
    "robot": "model:Model",
    "ros2_control": "parts.control:Ros2Control",
    "sensor": "parts.sensor:Sensor",
    "state": "parts.physics:State",
    "surface": "parts.shape:Surface",
    "transmission": "parts.actuation:Transmission",
    "visual": "parts.shape:Visual",
    "world": "world:World",
}
"""Element → where the class of its part is; all others make a :class:`Setting`, prefixed ones a :class:`Custom`."""

_OF_CONTROL = {
    "command_interface": "parts.control_component:ControlInterface",
    "gpio": "parts.control_component:ControlComponent",
    "joint": "parts.control_component:ControlComponent",
    "sensor": "parts.control_component:ControlComponent",
    "state_interface": "parts.control_component:ControlInterface",
    "transmission": "parts.control:ControlTransmission",
}
"""Names that mean this in a ``ros2_control`` block only → where the class is."""

_CONTROL = frozenset(("ros2_control", "component"))

_ELSEWHERE = {
    "contact": frozenset(("sensor", "audio_source")),
    "link": frozenset(("model", "robot", "gazebo")),
    "model": frozenset(("sdf", "world", "model", "gazebo")),
    "inertial": frozenset(("link",)),
    "joint": frozenset(("model", "world", "robot", "gazebo")),
    "frame": frozenset(("model", "world", "gazebo")),
    "gazebo": frozenset(("robot",)),
    "material": frozenset(("visual", "robot", "collision")),
    "physics": frozenset(("world",)),
    "plugin": frozenset(
        ("world", "model", "sensor", "visual", "gui", "actor", "light", "projector", "gazebo")
    ),
}
"""Names that mean something else elsewhere → the elements in which they mean this."""

_OF_JOINTS = {
    "axis": frozenset(("joint",)),
    "axis2": frozenset(("joint",)),
    "limit": frozenset(("axis", "joint")),
    "mimic": frozenset(("axis", "joint")),
    "dynamics": frozenset(("axis", "joint")),
}
"""Names that mean this only in a joint, or in an axis of one → the kinds of part."""

_SCOPES = frozenset(("gazebo", "link", "model", "world"))
_SCOPED = frozenset(("frame", "inertial", "joint", "link", "model"))
"""Names that mean this in such a part only, and not in a setting: the link of an actor, the model of a population."""

CLASSES = {
    name: home
    for home in {
        *_HOMES.values(),
        *_OF_CONTROL.values(),
        "custom:Custom",
        "part:Part",
        "parts.extended_model:ExtendedModel",
        "parts.resource:Resource",
        "parts.setting:Setting",
        "root:Root",
    }
    for name in (home.partition(":")[2],)
}
"""Class → where it is."""

ELEMENTS: dict[str, tuple[str, ...]] = {}
"""Class → the elements that become parts of it."""
for _element, _home in _HOMES.items():
    _class = _home.partition(":")[2]
    ELEMENTS[_class] = (*ELEMENTS.get(_class, ()), _element)


def part_class(holder: Part, element: Element) -> type[Part]:
    """The class of the part that an element in a holder makes."""
    return _class_of(holder.element.name, holder.kind, element.name) or _class_in(
        _place(holder), holder.kind, element.name
    )


@lru_cache(maxsize=1000)
def _class_of(holder: str, kind: str, tag: str) -> type[Part] | None:
    """The same for names without a colon; None for others."""
    names = holder + tag
    return _class_in(holder, kind, tag) if names.isascii() and "{" not in names and ":" not in names else None


def _place(holder: Part) -> str:
    """The name of the holder's element; a macro of xacro counts as the link or joint that it writes."""
    place = holder.element.name
    return holder.kind if place.startswith("xacro:") else place


@lru_cache(maxsize=1000)
def _class_in(holder: str, kind: str, name: str) -> type[Part]:
    if kind in _CONTROL and name in _OF_CONTROL:
        return class_named(_OF_CONTROL[name].partition(":")[2])
    home = _HOMES.get(name)
    if home is not None and (kind != "setting" or holder not in _SCOPES or name not in _SCOPED):
        wanted = _OF_JOINTS.get(name)
        at = holder if wanted is None else kind
        wanted = wanted or _ELSEWHERE.get(name)
        if wanted is None or at in wanted:
            return class_named(home.partition(":")[2])
    return class_named("Custom" if ":" in name else "Setting")


@cache
def class_named(name: str) -> type[Part]:
    """A class of the model by its name."""
    module, _, attribute = CLASSES[name].partition(":")
    found: type[Part] = getattr(import_module(f"sdfcheck.robot.{module}"), attribute)
    return found
