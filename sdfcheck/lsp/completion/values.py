"""Values that the formats and their consumers know."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from sdfcheck.formats import plugins, srdf
from sdfcheck.formats.describe import spot
from sdfcheck.formats.vendor.definitions import Vendor
from sdfcheck.formats.version import Version
from sdfcheck.lsp.completion.context import Context, Where
from sdfcheck.lsp.completion.item import Item, Sort
from sdfcheck.lsp.completion.tags import slots_at

_SENSED = tuple(
    f"{quantity}.{axis}"
    for quantity in ("force", "torque", "position", "orientation", "angular_velocity", "linear_acceleration")
    for axis in ("xyzw" if quantity == "orientation" else "xyz")
)
_HARDWARE = {
    "gz_ros2_control/GazeboSimSystem": "Gazebo",
    "ign_ros2_control/IgnitionSystem": "Gazebo Fortress",
    "gazebo_ros2_control/GazeboSystem": "Gazebo classic",
    "mock_components/GenericSystem": "no hardware, for tests",
    "mujoco_ros2_control/MujocoSystem": "MuJoCo",
    "topic_based_ros2_control/TopicBasedSystem": "topics",
}
_XACRO_COMMANDS = ("arg ", "find ", "env ", "optenv ", "eval ", "dirname", "cwd", "anon ")


def value_items(context: Context, version: Version, vendors: Sequence[Vendor]) -> Iterator[Item]:
    """The values of an attribute or text, where they are a closed list or well known."""
    tag, attribute = context.tag, context.attribute
    if tag == "plugin" and attribute == "filename":
        yield from (Item(name, Sort.FILE, name, detail="Gazebo") for name in plugins.systems())
        return
    yield from (_of_control(context) if "ros2_control" in context.around else ()) or _of_format(
        context, version
    )
    if ":" in tag or ":" in attribute:
        slots = slots_at(tag, attribute, vendors)
        for choice in dict.fromkeys(choice for slot in slots for choice in slot.choices):
            yield Item(choice, Sort.CHOICE, choice, rank=2)
    if tag == "sdf" and attribute == "version":
        yield from (
            Item(f"1.{minor}", Sort.CHOICE, f"1.{minor}", rank=20 - minor) for minor in range(12, 1, -1)
        )


def _of_control(context: Context) -> list[Item]:
    """Values in a block of ``ros2_control`` that depend on more than the place."""
    tag, attribute = context.tag, context.attribute
    if tag == "state_interface" and attribute == "name" and "sensor" in context.around:
        return [Item(name, Sort.CHOICE, name, rank=2) for name in _SENSED]
    if tag == "plugin" and context.where is Where.TEXT:
        return [Item(name, Sort.CHOICE, name, detail=what, rank=2) for name, what in _HARDWARE.items()]
    return []


def _of_format(context: Context, version: Version) -> Iterator[Item]:
    around = context.around if context.where is Where.TEXT else (*context.around, context.tag)
    place = spot(around, version)
    if place is None:
        return
    own = place.definition.attributes.get(context.attribute) if context.attribute else place.definition
    if own is None:
        return
    choices, default = own.listed or own.usual, own.given_default
    yield from (Item(choice, Sort.CHOICE, choice, rank=2) for choice in choices if choice)
    if own.type == "bool" and not choices:
        yield from (Item(word, Sort.CHOICE, word, rank=2) for word in ("true", "false"))
    if default and not choices and own.type != "bool":
        yield Item(default, Sort.CHOICE, default, detail="default", rank=7)


def semantic_values(context: Context) -> Iterator[Item]:
    """The values of SRDF that are a closed list."""
    place = srdf.at((*context.around, context.tag))
    own = place.attributes.get(context.attribute) if place is not None else None
    for choice in own.listed if own is not None else ():
        yield Item(choice, Sort.CHOICE, choice, detail="SRDF", rank=2)


def command_items() -> Iterator[Item]:
    """The beginnings of a substitution of xacro."""
    yield from (
        Item(f"$({word.strip()} …)", Sort.WORD, f"$({word}", detail="xacro") for word in _XACRO_COMMANDS
    )
