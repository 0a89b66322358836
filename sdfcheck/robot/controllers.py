"""Joints and sensors that controllers of ros2_control ask for, by the file of parameters that a plugin of Gazebo names.

Source: the parameters that ros2_controllers declare, humble to rolling. Of a parameter file nothing is made but texts
with their places; substitutions in it are not known.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from itertools import islice
from pathlib import Path
from typing import Any

from sdfcheck.files.library import library_of
from sdfcheck.source.document import Document
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.text import Source, Span

_LARGEST = 64 * 1024
"""Bytes of a file of parameters that is read: yaml takes a second for so many."""
_UNKNOWN = re.compile(r"[${}<>%]|^$")
"""A name with one of these is made later."""

_MANAGER = "controller_manager"
_PARAMETERS = "ros__parameters"
_DEEPEST = 4
"""So deep are the names of nodes, with those of namespaces around them."""
_MOST = 10_000
"""So many needs are known of one file."""


class Kind(NamedTuple):
    """The parameters of a kind of controller that name joints, sensors and interfaces; ``command`` is a fixed one."""

    joints: tuple[str, ...] = ()
    commands: str = ""
    states: str = ""
    command: str = ""
    sensor: str = ""
    steered: tuple[str, ...] = ()
    """Parameters that name joints which steer, to the left by positive angles."""


_GROUP = ("joints",)
_CAR = Kind(("traction_joints_names",), command="velocity", steered=("steering_joints_names",))
_KINDS: Mapping[str, Kind] = {
    "joint_trajectory_controller/JointTrajectoryController": Kind(
        _GROUP, "command_interfaces", "state_interfaces"
    ),
    "forward_command_controller/ForwardCommandController": Kind(_GROUP, "interface_name"),
    "position_controllers/JointGroupPositionController": Kind(_GROUP, command="position"),
    "velocity_controllers/JointGroupVelocityController": Kind(_GROUP, command="velocity"),
    "effort_controllers/JointGroupEffortController": Kind(_GROUP, command="effort"),
    "diff_drive_controller/DiffDriveController": Kind(
        ("left_wheel_names", "right_wheel_names"), command="velocity"
    ),
    "ackermann_steering_controller/AckermannSteeringController": _CAR,
    "bicycle_steering_controller/BicycleSteeringController": _CAR,
    "tricycle_steering_controller/TricycleSteeringController": _CAR,
    "tricycle_controller/TricycleController": Kind(
        ("traction_joint_name",), command="velocity", steered=("steering_joint_name",)
    ),
    "position_controllers/GripperActionController": Kind(("joint",), command="position"),
    "effort_controllers/GripperActionController": Kind(("joint",), command="effort"),
    "parallel_gripper_action_controller/GripperActionController": Kind(("joint",), command="position"),
    "imu_sensor_broadcaster/IMUSensorBroadcaster": Kind(sensor="sensor_name"),
    "force_torque_sensor_broadcaster/ForceTorqueStateBroadcaster": Kind(sensor="sensor_name"),
}
_OWN_JOINTS = "command_joints"
"""The parameter that names the joints of the hardware where they are called otherwise than those of a trajectory."""
_ENDS = ("rear_wheels_names", "front_wheels_names")
"""The former names of the parameters of cars: the wheels that drive and those that steer, or the other way about."""


class ControllerNeed(NamedTuple):
    """A joint or sensor that a controller names at a place, and its ``interface``; none: only that it is there."""

    controller: str
    what: str
    name: str
    span: Span
    interface: str = ""
    is_command: bool = False
    steers: bool = False
    """Does the controller steer the robot by the joint, to the left by positive angles?"""


def needs_of(document: Document, address: str) -> tuple[ControllerNeed, ...]:
    """The needs of the controllers in a file of parameters; none where the file cannot be read as one."""
    library = library_of(document)
    if library is None or not address.endswith((".yaml", ".yml")) or "$" in address:
        return ()
    from sdfcheck.files.uris import locate

    path = locate(document, address).path
    if path is None:
        return ()
    try:
        text = library.read(path, document, _LARGEST).decode("utf-8-sig")
    except (OSError, UnicodeDecodeError):
        return ()
    return tuple(islice(_needs(Source(Path(path), text, is_foreign=True)), _MOST))


def _needs(source: Source) -> Iterator[ControllerNeed]:
    nodes = dict(_nodes(composed(source.text), "", 0, set()))
    types = {name: _texts(_get(entry, "type")) for name, entry in pairs(nodes.get(_MANAGER))}
    for name, parameters in nodes.items():
        declared = types.get(name) or _texts(_get(parameters, "type"))
        kind = _KINDS.get(declared[0].value) if declared else None
        if kind is not None:
            yield from _of_controller(source, name, kind, parameters)


def _of_controller(source: Source, name: str, kind: Kind, parameters: Any) -> Iterator[ControllerNeed]:
    """The needs of one controller."""
    for scalar in _texts(_get(parameters, kind.sensor)) if kind.sensor else ():
        yield ControllerNeed(name, "sensor", scalar.value, span_of(source, scalar))
    commands = [scalar.value for scalar in _texts(_get(parameters, kind.commands))] if kind.commands else []
    states = [scalar.value for scalar in _texts(_get(parameters, kind.states))] if kind.states else []
    wanted = [(each, True) for each in (*commands, kind.command) if each] + [(each, False) for each in states]
    driven, steered = _joints(kind, parameters)
    for scalar in driven:
        yield from _of_joint(source, name, scalar, wanted)
    for scalar in steered:
        yield from _of_joint(source, name, scalar, [("position", True)], steers=True)


def _of_joint(
    source: Source, name: str, scalar: Any, wanted: Iterable[tuple[str, bool]], *, steers: bool = False
) -> Iterator[ControllerNeed]:
    span = span_of(source, scalar)
    yield ControllerNeed(name, "joint", scalar.value, span)
    for interface, is_command in wanted:
        yield ControllerNeed(name, "joint", scalar.value, span, interface, is_command, steers)


def _joints(kind: Kind, parameters: Any) -> tuple[list[Any], list[Any]]:
    """The joints that a controller moves, and those by which it steers."""
    if kind.joints == _GROUP and (own := _texts(_get(parameters, _OWN_JOINTS))):
        return own, []
    driven = [scalar for each in kind.joints for scalar in _texts(_get(parameters, each))]
    steered = [scalar for each in kind.steered for scalar in _texts(_get(parameters, each))]
    if kind is _CAR and not driven and not steered:
        is_front = [scalar.value for scalar in _texts(_get(parameters, "front_steering"))] != ["false"]
        driven, steered = (_texts(_get(parameters, each)) for each in (_ENDS if is_front else _ENDS[::-1]))
    return driven, steered


# YAML as nodes: nothing in it is constructed.


def composed(text: str) -> Any:
    """The nodes of a text; None where it cannot be read as YAML."""
    import yaml

    try:
        return yaml.compose(text, Loader=yaml.SafeLoader)  # the one in C crashes on many brackets
    except (yaml.YAMLError, RecursionError, ValueError):
        return None


def _nodes(mapping: Any, name: str, depth: int, seen: set[int]) -> Iterator[tuple[str, Any]]:
    """The names of nodes of ROS, each with its parameters; ``seen``: where an alias would lead again."""
    for key, value in pairs(mapping):
        if key == _PARAMETERS:
            yield name.rpartition("/")[2], value
        elif depth < _DEEPEST and id(value) not in seen:
            seen.add(id(value))
            yield from _nodes(value, key, depth + 1, seen)


def pairs(mapping: Any) -> Iterator[tuple[str, Any]]:
    """The entries of a mapping whose keys are texts."""
    if getattr(mapping, "id", "") == "mapping":
        yield from ((key.value, value) for key, value in mapping.value if key.id == "scalar")


def _get(mapping: Any, name: str) -> Any:
    return next((value for key, value in pairs(mapping) if key == name), None)


def _texts(node: Any) -> list[Any]:
    """The scalar that a node is, or those in its list, without what is made later."""
    kind = getattr(node, "id", "")
    nodes = [node] if kind == "scalar" else node.value if kind == "sequence" else ()
    return [each for each in nodes if each.id == "scalar" and not _UNKNOWN.search(each.value)]


def span_of(source: Source, scalar: Any) -> Span:
    """The place of a text, without its quotes."""
    quotes = 1 if scalar.style in {"'", '"'} else 0
    return Span(source, scalar.start_mark.index + quotes, scalar.end_mark.index - quotes)
