"""Values that the formats and their consumers know."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from sdfcheck.formats import srdf
from sdfcheck.formats.describe import spot
from sdfcheck.formats.vendor.definitions import Vendor
from sdfcheck.formats.version import Version
from sdfcheck.lsp.completion.context import Context, Where
from sdfcheck.lsp.completion.item import Item, Sort, plain
from sdfcheck.lsp.completion.tags import slots_at

_INTERFACES = ("position", "velocity", "effort", "acceleration", "torque", "force")
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
_SYSTEMS = """
    ackermann-steering air-pressure air-speed altimeter apply-joint-force apply-link-wrench battery
    breadcrumbs buoyancy buoyancy-engine camera-video-recorder collada-world-exporter comms-endpoint contact
    detachable-joint diff-drive dvl elevator follow-actor force-torque hydrodynamics imu joint-controller
    joint-position-controller joint-state-publisher joint-trajectory-controller kinetic-energy-monitor label
    lift-drag lighter-than-air-dynamics log linear-battery-plugin logical-audio-sensor-plugin logical-camera
    magnetometer mecanum-drive model-photo-shoot multicopter-control multicopter-motor-model navsat odometry-publisher
    optical-tactile-plugin particle-emitter performer-detector perfect-comms physics pose-publisher
    rf-comms scene-broadcaster sensors shader-param spacecraft-thruster-model thermal thermal-sensor thruster
    touchplugin track-controller tracked-vehicle trajectory-follower triggered-publisher user-commands
    velocity-control wheel-slip wind-effects
""".split()
_XACRO_COMMANDS = ("arg ", "find ", "env ", "optenv ", "eval ", "dirname", "cwd", "anon ")


def value_items(context: Context, version: Version, vendors: Sequence[Vendor]) -> Iterator[Item]:
    """The values of an attribute or text, where they are a closed list or well known."""
    tag, attribute = context.tag, context.attribute
    if tag == "plugin" and attribute == "filename":
        for name in _SYSTEMS:
            yield Item(f"gz-sim-{name}-system", Sort.FILE, f"gz-sim-{name}-system", detail="Gazebo")
        return
    if "ros2_control" in context.around or tag.endswith("_interface"):
        yield from _of_control(context)
        return
    yield from _of_format(context, version)
    if ":" in tag or ":" in attribute:
        slots = slots_at(tag, attribute, vendors)
        for choice in dict.fromkeys(choice for slot in slots for choice in slot.choices):
            yield Item(choice, Sort.CHOICE, choice, rank=2)
    if tag == "sdf" and attribute == "version":
        yield from (
            Item(f"1.{minor}", Sort.CHOICE, f"1.{minor}", rank=20 - minor) for minor in range(12, 1, -1)
        )


def _of_control(context: Context) -> Iterator[Item]:
    tag, attribute = context.tag, context.attribute
    if tag in {"command_interface", "state_interface"} and attribute == "name":
        names = _SENSED if "sensor" in context.around else _INTERFACES
        yield from (Item(name, Sort.CHOICE, name, rank=2) for name in names)
    elif tag == "plugin" and context.where is Where.TEXT:
        yield from (Item(name, Sort.CHOICE, name, detail=what, rank=2) for name, what in _HARDWARE.items())


_CONTROL = {
    "ros2_control": ("hardware", "joint", "sensor", "gpio"),
    "hardware": ("plugin", "param"),
    "joint": ("command_interface", "state_interface", "param"),
    "sensor": ("state_interface", "param"),
    "gpio": ("command_interface", "state_interface", "param"),
    "command_interface": ("param",),
    "state_interface": ("param",),
}
_CONTROL_ATTRIBUTES = {
    "ros2_control": ("name", "type"),
    "joint": ("name",),
    "sensor": ("name",),
    "gpio": ("name",),
    "command_interface": ("name",),
    "state_interface": ("name",),
    "param": ("name",),
}


def control_items(around: tuple[str, ...]) -> Iterator[Item]:
    """The elements of a ``ros2_control`` block, which are nobody's format but its own."""
    if "ros2_control" not in around:
        return
    for name in _CONTROL.get(around[-1], ()):
        if name in {"hardware", "plugin"}:
            text = f"{name}>$1</{name}>"
        elif name == "param":
            text = 'param name="$1">$2</param>'
        elif name.endswith("interface"):
            text = f'{name} name="${{1|{",".join(_INTERFACES[:3])}|}}"/>'
        else:
            text = f'{name} name="$1">\n\t$2\n</{name}>'
        item = Item(name, Sort.ELEMENT, plain(text), text, "ros2_control", 2)
        yield item._replace(is_repeatable=name not in {"hardware", "plugin"})


def control_attributes(context: Context) -> Iterator[Item]:
    """The attributes in a ``ros2_control`` block."""
    if "ros2_control" not in (*context.around, context.tag):
        return
    given = {name for name, _ in context.given}
    for name in _CONTROL_ATTRIBUTES.get(context.tag, ()):
        if name not in given:
            yield Item(name, Sort.ATTRIBUTE, f'{name}=""', f'{name}="$1"', "ros2_control", 1)


def _of_format(context: Context, version: Version) -> Iterator[Item]:
    around = context.around if context.where is Where.TEXT else (*context.around, context.tag)
    place = spot(around, version)
    if place is None:
        return
    own = place.definition.attributes.get(context.attribute) if context.attribute else place.definition
    if own is None:
        return
    choices, default = own.listed, own.given_default
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
