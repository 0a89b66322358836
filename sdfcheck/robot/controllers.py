"""Parameters of controllers of ros2_control and of MoveIt: joints and sensors that they ask for, wheels, limits.

They are in the file that a plugin of Gazebo names, or in those of MoveIt beside an SRDF file. Source: the parameters
that ros2_controllers and moveit2 declare, humble to rolling. Of such a file nothing is made but texts with their
places; substitutions in it are not known.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from fnmatch import fnmatchcase
from itertools import islice
from pathlib import Path
from typing import Any

from sdfcheck.files.library import library_of
from sdfcheck.files.packages import YAML
from sdfcheck.formats.near_names import Effort, misspelling_of, suggest
from sdfcheck.source.document import Document
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.text import Source, Span, pattern

LARGEST = 64 * 1024
"""Bytes of a file of parameters that is read: yaml takes a second for so many."""
UNKNOWN = pattern(r"[${}<>%]|^$")
"""A name with one of these is made later."""

_MANAGER = "controller_manager"
PARAMETERS = "ros__parameters"
_DEEPEST = 4
"""So deep are the names of nodes, with those of namespaces around them."""
_MOST_READ = 1_000
"""So many parameters of a controller are compared."""
_SIGNS = (
    {"joints", "command_interfaces"},
    {"joints", "interface_name"},
    {"left_wheel_names", "right_wheel_names"},
    {"sensor_name", "frame_id"},
)
"""Parameters that a controller has, and another node has not."""
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
    types: str = ""
    """Its parameters that have a type: that, then the patterns of their names, one after the other."""
    names: str = ""
    """All of its parameters, in any release, without those in mappings; empty where they are not known."""


_GROUP = ("joints",)
_LIMITS = "{0}.m??_velocity {0}.m??_acceleration* {0}.m??_deceleration* {0}.m??_jerk"
_ODOMETRY = (
    "text: odom_frame_id base_frame_id bool: open_loop position_feedback enable_odom_tf use_stamped_vel "
    "integer: velocity_rolling_window_size numbers: pose_covariance_diagonal twist_covariance_diagonal "
)
_FINGER = (
    "text: joint bool: allow_stalling "
    "number: action_monitor_rate goal_tolerance max_effort stall_velocity_threshold stall_timeout"
)
_TRAJECTORY = (
    "list: joints command_joints command_interfaces state_interfaces bool: allow_partial_joints_goal open_loop_control "
    "number: state_publish_rate action_monitor_rate cmd_timeout constraints.stopped_velocity_tolerance "
    "constraints.goal_time constraints.*.trajectory constraints.*.goal "
    "gains.*.p gains.*.i gains.*.d gains.*.i_clamp gains.*.ff_velocity_scale"
)
_FOR_FINGER = (
    "joint action_monitor_rate allow_stalling goal_tolerance max_effort stall_timeout "
    "stall_velocity_threshold"
)
_FOR_ODOMETRY = (
    "odom_frame_id base_frame_id open_loop position_feedback enable_odom_tf use_stamped_vel tf_frame_prefix "
    "velocity_rolling_window_size pose_covariance_diagonal twist_covariance_diagonal "
)
_FOR_TRAJECTORY = (
    "joints command_joints command_interfaces state_interfaces allow_partial_joints_goal open_loop_control "
    "state_publish_rate action_monitor_rate cmd_timeout constraints gains speed_scaling positions_upsampling "
    "allow_integration_in_goal_trajectories allow_nonzero_velocity_at_trajectory_end allow_trajectory_replacement "
    "interpolate_from_desired_state interpolation_method start_with_holding "
    "set_last_command_interface_value_as_state_on_activation"
)
_DRIVE = Kind(
    ("left_wheel_names", "right_wheel_names"),
    command="velocity",
    types=f"{_ODOMETRY} list: left_wheel_names right_wheel_names number: wheel_separation wheel_radius *_multiplier "
    f"cmd_vel_timeout publish_rate {_LIMITS.format('linear.x')} {_LIMITS.format('angular.z')}",
    names=f"{_FOR_ODOMETRY} left_wheel_names right_wheel_names wheel_separation wheel_radius wheels_per_side linear "
    "wheel_separation_multiplier left_wheel_radius_multiplier right_wheel_radius_multiplier wheel_radius_multiplier "
    "angular cmd_vel_timeout publish_rate publish_limited_velocity tf_frame_prefix_enable",
)
_MECANUM = Kind(
    tuple(
        f"{end}_wheel_command_joint_name" for end in ("front_left", "rear_left", "front_right", "rear_right")
    ),
    command="velocity",
    types="text: *_joint_name base_frame_id odom_frame_id bool: enable_odom_tf use_stamped_vel "
    "number: reference_timeout kinematics.*",
    names="front_left_wheel_command_joint_name rear_left_wheel_command_joint_name "
    "front_right_wheel_command_joint_name rear_right_wheel_command_joint_name front_left_wheel_state_joint_name "
    "rear_left_wheel_state_joint_name front_right_wheel_state_joint_name rear_right_wheel_state_joint_name kinematics "
    "linear angular reference_timeout base_frame_id odom_frame_id enable_odom_tf use_stamped_vel tf_frame_prefix "
    "tf_frame_prefix_enable pose_covariance_diagonal twist_covariance_diagonal",
)
_CAR = Kind(
    ("traction_joints_names",),
    command="velocity",
    steered=("steering_joints_names",),
    types=f"{_ODOMETRY} list: *_names number: reference_timeout wheelbase *wheel_track *_track_width *wheels_radius",
    names=f"{_FOR_ODOMETRY} front_steering reference_timeout wheelbase wheel_track front_wheel_track rear_wheel_track "
    "front_wheel_radius front_wheels_radius rear_wheel_radius rear_wheels_radius front_wheels_names rear_wheels_names "
    "front_wheels_state_names rear_wheels_state_names traction_joints_names traction_joints_state_names "
    "steering_joints_names steering_joints_state_names steering_track_width traction_track_width "
    "traction_wheel_radius traction_wheels_radius reduce_wheel_speed_until_steering_reached",
)
_JOINTS = Kind(_GROUP, types="list: joints", names="joints interface_name")
_SENSOR = Kind(sensor="sensor_name", types="text: sensor_name frame_id", names="sensor_name frame_id")
_BROADCASTER = "joint_state_broadcaster/JointStateBroadcaster"
_TRAJECTORIES = "joint_trajectory_controller/JointTrajectoryController"
_KINDS: Mapping[str, Kind] = {
    _TRAJECTORIES: Kind(
        _GROUP, "command_interfaces", "state_interfaces", types=_TRAJECTORY, names=_FOR_TRAJECTORY
    ),
    "forward_command_controller/ForwardCommandController": Kind(
        _GROUP, "interface_name", types="list: joints text: interface_name", names="joints interface_name"
    ),
    "position_controllers/JointGroupPositionController": _JOINTS._replace(command="position"),
    "velocity_controllers/JointGroupVelocityController": _JOINTS._replace(command="velocity"),
    "effort_controllers/JointGroupEffortController": _JOINTS._replace(command="effort"),
    "diff_drive_controller/DiffDriveController": _DRIVE,
    "mecanum_drive_controller/MecanumDriveController": _MECANUM,
    "ackermann_steering_controller/AckermannSteeringController": _CAR,
    "bicycle_steering_controller/BicycleSteeringController": _CAR,
    "tricycle_steering_controller/TricycleSteeringController": _CAR,
    "tricycle_controller/TricycleController": Kind(
        ("traction_joint_name",),
        command="velocity",
        steered=("steering_joint_name",),
        types=f"{_ODOMETRY} text: *_joint_name integer: cmd_vel_timeout number: wheelbase wheel_radius",
        names=f"{_FOR_ODOMETRY} traction_joint_name steering_joint_name wheelbase wheel_radius cmd_vel_timeout "
        "traction steering odom_only_twist publish_ackermann_command",
    ),
    "position_controllers/GripperActionController": Kind(
        ("joint",), command="position", types=_FINGER, names=_FOR_FINGER
    ),
    "effort_controllers/GripperActionController": Kind(
        ("joint",), command="effort", types=_FINGER, names=_FOR_FINGER
    ),
    "parallel_gripper_action_controller/GripperActionController": Kind(
        ("joint",),
        command="position",
        types=f"{_FINGER} max_velocity",
        names=f"{_FOR_FINGER} max_effort_interface max_velocity max_velocity_interface state_interfaces",
    ),
    "imu_sensor_broadcaster/IMUSensorBroadcaster": _SENSOR,
    "force_torque_sensor_broadcaster/ForceTorqueSensorBroadcaster": _SENSOR,
    "force_torque_sensor_broadcaster/ForceTorqueStateBroadcaster": _SENSOR,
    _BROADCASTER: Kind(types="list: joints interfaces bool: use_local_topics"),
}
_OTHER_TYPES = (
    "admittance_controller/AdmittanceController battery_state_broadcaster/BatteryStateBroadcaster "
    "chained_filter_controller/ChainedFilter forward_command_controller/MultiInterfaceForwardCommandController "
    "gpio_controllers/GpioCommandController gps_sensor_broadcaster/GPSSensorBroadcaster "
    "magnetometer_broadcaster/MagnetometerBroadcaster omni_wheel_drive_controller/OmniWheelDriveController "
    "motion_primitives_controllers/MotionPrimitivesForwardController pid_controller/PidController "
    "pose_broadcaster/PoseBroadcaster range_sensor_broadcaster/RangeSensorBroadcaster "
    "state_interfaces_broadcaster/StateInterfacesBroadcaster"
)
"""The controllers of ros2_controllers of which nothing but the type is known."""
_NEEDED: Mapping[str, str] = {
    _TRAJECTORIES: "joints command_interfaces state_interfaces",
    "forward_command_controller/ForwardCommandController": "joints interface_name",
    "position_controllers/JointGroupPositionController": "joints",
    "velocity_controllers/JointGroupVelocityController": "joints",
    "effort_controllers/JointGroupEffortController": "joints",
    "diff_drive_controller/DiffDriveController": "left_wheel_names right_wheel_names wheel_separation wheel_radius",
    "tricycle_controller/TricycleController": "wheelbase wheel_radius",
    "position_controllers/GripperActionController": "joint",
    "effort_controllers/GripperActionController": "joint",
    "parallel_gripper_action_controller/GripperActionController": "joint",
    "imu_sensor_broadcaster/IMUSensorBroadcaster": "sensor_name frame_id",
}
"""A type of controllers → the parameters without which one does not start, or does not move its joints."""
_GAINS = ("p", "i", "d", "ff_velocity_scale")
_FORMER_PACKAGES = {
    "force_torque_sensor_controller": "force_torque_sensor_broadcaster/ForceTorqueSensorBroadcaster",
    "imu_sensor_controller": "imu_sensor_broadcaster/IMUSensorBroadcaster",
    "joint_state_controller": _BROADCASTER,
}
"""Packages of ROS 1 that ROS 2 has under another name, with the types there."""
_FORMER_TYPES = {"JointTrajectoryController": _TRAJECTORIES}
"""Controllers of ROS 1 that were in several packages, with their types in ROS 2."""
_TYPES = (*_KINDS, *_OTHER_TYPES.split())
_OWN_JOINTS = "command_joints"
"""The parameter that names the joints of the hardware where they are called otherwise than those of a trajectory."""
_COUNTS = {"Ackermann": (2, 2), "Tricycle": (2, 1), "Bicycle": (1, 1)}
"""The joints that drive and those that steer."""
_CORRECTED: Mapping[str, tuple[str, ...]] = {
    "wheel_separation": ("wheel_separation_multiplier",),
    "wheel_radius": (
        "left_wheel_radius_multiplier",
        "right_wheel_radius_multiplier",
        "wheel_radius_multiplier",
    ),
}
"""A measure of a drive → the factors by which it is corrected."""
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


class Parameter(NamedTuple):
    """A parameter in a file of them, read as the element of a plugin that says the same."""

    name: str
    content: str
    span: Span

    @property
    def own_value(self) -> Parameter:
        """Itself: its place is that of its value."""
        return self

    @property
    def number(self) -> float:
        """The text as a number; nan if it is not a number."""
        try:
            return float(self.content)
        except ValueError:
            return float("nan")


class WrittenDrive(NamedTuple):
    """The wheels of a differential drive in a file of parameters."""

    controller: str
    lefts: tuple[Parameter, ...]
    rights: tuple[Parameter, ...]
    separation: Parameter | None
    radius: Parameter | None


class Mistyped(NamedTuple):
    """A parameter whose value is of another type than the one that is ``asked`` for, and how many more there are."""

    owner: str
    parameter: Parameter
    asked: str
    more: int = 0


class Misspelled(NamedTuple):
    """A name that nothing reads, and one that is read, is not there, and is called nearly so."""

    owner: str
    """The node or entry that has it."""
    reader: str
    name: str
    meant: str
    span: Span


class Lacking(NamedTuple):
    """A parameter that a controller cannot do without and does not get; its place is that of the controller's name.

    ``joint``: for which there are no gains; empty for another parameter.
    """

    owner: str
    kind: str
    name: str
    joint: str
    span: Span


class Unreached(NamedTuple):
    """A controller without parameters, or the controller manager itself.

    Their place is that of those that were probably meant; ``stray`` is the name under which they are, if not beside the
    type of the controller.
    """

    controller: str
    stray: str
    span: Span


class Miscounted(NamedTuple):
    """A drive with another number of joints than it takes: what it names, and how many it takes; with a place."""

    controller: str
    found: str
    asked: str
    span: Span


class ControllerFile(NamedTuple):
    """The controllers of a file of parameters, as far as they are known."""

    needs: tuple[ControllerNeed, ...] = ()
    drives: tuple[WrittenDrive, ...] = ()
    frames: tuple[Parameter, ...] = ()
    """The links that controllers carry about in tf."""
    broadcaster: str = ""
    """The controller that publishes the states of all joints."""
    mistyped: tuple[Mistyped, ...] = ()
    misspelled: tuple[Misspelled, ...] = ()
    lacking: tuple[Lacking, ...] = ()
    untyped: tuple[Parameter, ...] = ()
    """The names of nodes with the parameters of a controller, of which no type is declared."""
    unreached: tuple[Unreached, ...] = ()
    miscounted: tuple[Miscounted, ...] = ()
    manager: Parameter | None = None
    """The name of the controller manager's parameters, if they are for one without a namespace."""
    strange: tuple[Misspelled, ...] = ()
    """The controllers of a type that their package does not have, each with one that it has."""


_NOTHING = ControllerFile()


_MOST_PARSED = 4
"""So many files are parsed for a document."""


class _Parsed:
    """The files of parameters that a document names, by their paths."""

    def __init__(self, document: Document) -> None:
        self._document = document
        self._known: dict[str, ControllerFile] = {}

    def at(self, path: str) -> ControllerFile:
        if path not in self._known and len(self._known) < _MOST_PARSED:
            self._known[path] = self._read(path)
        return self._known.get(path, _NOTHING)

    def _read(self, path: str) -> ControllerFile:
        library = library_of(self._document)
        try:
            data = library.read(Path(path), self._document, LARGEST) if library is not None else b""
            return _controllers(Source(Path(path), data.decode("utf-8-sig"), is_foreign=True))
        except (OSError, UnicodeDecodeError):
            return _NOTHING


def controllers_in(document: Document, address: str) -> ControllerFile:
    """The controllers of a file that a description names; none where it cannot be read as one of parameters."""
    if library_of(document) is None or not address.endswith(YAML) or "$" in address:
        return _NOTHING
    from sdfcheck.files.uris import as_built, locate

    path = locate(document, address).path
    if path is None and os.path.isabs(address):
        path = as_built(document, address)
    return _NOTHING if path is None else document.view(_Parsed).at(str(path))


def _controllers(source: Source) -> ControllerFile:
    top = composed(source.text)
    paths = dict(_nodes(top, "", 0, set()))
    nodes = {path.rpartition("/")[2]: parameters for path, (_, parameters) in paths.items()}
    found = [(name, node) for name, node in pairs(nodes.get(_MANAGER)) if node.id == "mapping"]
    types = {name: _texts(_get(entry, "type")) for name, entry in found}
    declared = {
        name: types.get(name) or _texts(_get(parameters, "type")) for name, parameters in nodes.items()
    }
    known = [(name, kind, nodes[name]) for name in nodes if (kind := _kind(declared[name])) is not None]
    needs = (
        need for name, kind, parameters in known for need in _of_controller(source, name, kind, parameters)
    )
    unreached = () if "**" in nodes else tuple(_unreached(source, paths, nodes, found))
    strays = {each.stray.rpartition("/")[2] for each in unreached} | ({*nodes} if "**" in nodes else set())
    misspelled = tuple(_misspelled(source, top, paths, nodes, declared))
    meant = {(each.owner, each.meant) for each in misspelled}
    lacking = _lacking(source, paths, declared)
    key = paths.get(_MANAGER)
    is_alone = key is not None and "**" not in paths and not any("/" in path for path in paths)
    return ControllerFile(
        tuple(islice(needs, _MOST)),
        tuple(filter(None, (_drive(source, name, kind, each) for name, kind, each in known))),
        tuple(filter(None, (_carried(source, name, kind, each) for name, kind, each in known))),
        next((name for name, declared in types.items() if _is_broadcaster(declared)), ""),
        tuple(_mistyped(source, [(_MANAGER, _FOR_MANAGER, nodes.get(_MANAGER)), *known])),
        misspelled,
        tuple(each for each in lacking if (each.owner, each.name) not in meant and "**" not in nodes),
        tuple(
            each
            for each in _untyped(source, paths, declared)
            if any(types.values()) and each.name not in strays
        ),
        unreached,
        tuple(each for name in nodes for each in _miscounted(source, name, declared[name], nodes[name])),
        Parameter("name", _MANAGER, span_of(source, key[0])) if key is not None and is_alone else None,
        tuple(_strange(source, {**types, **declared})),
    )


def _kind(declared: Sequence[Any]) -> Kind | None:
    return _KINDS.get(declared[0].value) if declared else None


def _is_broadcaster(declared: Sequence[Any]) -> bool:
    return bool(declared) and declared[0].value == _BROADCASTER


def _of_controller(source: Source, name: str, kind: Kind, parameters: Any) -> Iterator[ControllerNeed]:
    """The needs of one controller."""
    for scalar in _texts(_get(parameters, kind.sensor)) if kind.sensor else ():
        yield ControllerNeed(name, "sensor", scalar.value, span_of(source, scalar))
    commands = [scalar.value for scalar in _texts(_get(parameters, kind.commands))] if kind.commands else []
    states = [scalar.value for scalar in _texts(_get(parameters, kind.states))] if kind.states else []
    if kind is _DRIVE and not _is(parameters, "open_loop", "true"):
        states = ["velocity" if _is(parameters, "position_feedback", "false") else "position"]
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
        is_front = not _is(parameters, "front_steering", "false")
        driven, steered = (_texts(_get(parameters, each)) for each in (_ENDS if is_front else _ENDS[::-1]))
    return driven, steered


def _drive(source: Source, name: str, kind: Kind, parameters: Any) -> WrittenDrive | None:
    """The wheels of a drive; what a factor corrects is not known."""
    if kind not in {_DRIVE, _MECANUM}:
        return None
    half = len(kind.joints) // 2
    sides = [
        tuple(wheel for each in names for wheel in _written(source, parameters, each))
        for names in (kind.joints[:half], kind.joints[half:])
    ]
    if not sides[0] or len(sides[0]) != len(sides[1]):
        return None
    separation, radius = (
        next(iter(_written(source, parameters, each)), None) if _is_plain(parameters, factors) else None
        for each, factors in _CORRECTED.items()
    )
    return WrittenDrive(name, sides[0], sides[1], separation, radius)


def _is_plain(parameters: Any, factors: Sequence[str]) -> bool:
    return all(
        not (found := _texts(_get(parameters, each))) or found[0].value in {"1", "1.0"} for each in factors
    )


def _written(source: Source, parameters: Any, name: str) -> tuple[Parameter, ...]:
    return tuple(
        Parameter(name, each.value, span_of(source, each)) for each in _texts(_get(parameters, name))
    )


def _carried(source: Source, name: str, kind: Kind, parameters: Any) -> Parameter | None:
    """The link that a drive carries about in tf, as it is written."""
    if _ODOMETRY not in kind.types or _is(parameters, "enable_odom_tf", "false"):
        return None
    given = _written(source, parameters, "base_frame_id")
    return given[0]._replace(name=name) if given else None


def _miscounted(source: Source, name: str, declared: Sequence[Any], parameters: Any) -> Iterator[Miscounted]:
    """The joints of a drive, where they are not as many as it takes."""
    kind = _kind(declared)
    if any(UNKNOWN.search(each.value) for _, node in _flat(parameters, "", 0) for each in _scalars(node)):
        return
    if kind is _DRIVE:
        lefts, rights = (_written(source, parameters, each) for each in _DRIVE.joints)
        if lefts and rights and len(lefts) != len(rights):
            yield Miscounted(
                name, f"{len(lefts)} left and {len(rights)} right", "as many of each", lefts[0].span
            )
    elif kind is _CAR:
        asked = next(count for word, count in _COUNTS.items() if word in declared[0].value)
        driven, steered = _joints(kind, parameters)
        if driven and steered and (len(driven), len(steered)) != asked:
            found = f"{len(driven)} driven and {len(steered)} steered"
            yield Miscounted(name, found, "{} and {}".format(*asked), span_of(source, driven[0]))


def _unreached(
    source: Source, paths: Mapping[str, Any], nodes: Mapping[str, Any], declared: Sequence[tuple[str, Any]]
) -> Iterator[Unreached]:
    """The controllers that need parameters and have none, while the same file has some that nothing reads."""
    names = {name for name, _ in declared}
    strays = [
        (path, key) for path, (key, _) in paths.items() if path.rpartition("/")[2] not in {*names, _MANAGER}
    ]
    for name, entry in declared:
        kind = _kind(_texts(_get(entry, "type")))
        if kind is None or not kind.joints or name in nodes:
            continue
        inner = next((each for each in kind.joints if _get(entry, each) is not None), None)
        fitting = [(path, key) for path, key in strays if any(_joints(kind, paths[path][1]))]
        if inner is not None:
            yield Unreached(name, "", span_of(source, next(k for k, _ in entry.value if k.value == inner)))
        elif len(fitting) == 1:
            yield Unreached(name, fitting[0][0], span_of(source, fitting[0][1]))


def _misspelled(
    source: Source,
    top: Any,
    paths: Mapping[str, Any],
    nodes: Mapping[str, Any],
    declared: Mapping[str, Sequence[Any]],
) -> Iterator[Misspelled]:
    """The names that nothing reads, and that are nearly those of parameters that are read and not there."""
    effort = Effort()
    for owner, mapping, names, reader in _readers(top, paths, nodes, declared):
        given = {key.value: key for key, _ in islice(_keys(mapping), _MOST_READ)}
        left = [name for name in names if name not in given]
        for name, key in given.items() if left else ():
            if name not in names and (meant := suggest(name, left, effort)) is not None:
                yield Misspelled(owner, reader, name, meant, span_of(source, key))


def _readers(
    top: Any, paths: Mapping[str, Any], nodes: Mapping[str, Any], declared: Mapping[str, Sequence[Any]]
) -> Iterator[tuple[str, Any, Sequence[str], str]]:
    """The mappings of a file with their names, empty for the file, the names that are read in them, and by whom."""
    for owner, parameters in nodes.items():
        if (kind := _kind(declared[owner])) is not None:
            word = declared[owner][0].value.rpartition("/")[2]
            yield owner, parameters, kind.names.split(), f"{'an' if word[0] in 'AEIO' else 'a'} {word}"
    manager, reader = nodes.get(_MANAGER), "the controller manager"
    yield _MANAGER, manager, ("update_rate",), reader
    for name, entry in pairs(manager):
        if not declared.get(name):
            yield name, entry, ("type",), reader
    known = {path.partition("/")[0] for path in paths}
    for name, node in islice(pairs(top), _MOST_READ):
        if name.strip("/").partition("/")[0] not in known:
            yield name, node, (PARAMETERS,), "ROS 2"
    if manager is None:
        yield "", top, (_MANAGER,), "the plugin of the simulator"


def _lacking(
    source: Source, paths: Mapping[str, Any], declared: Mapping[str, Sequence[Any]]
) -> Iterator[Lacking]:
    """The first parameter that each controller lacks, as far as it has parameters at all."""
    for path, (key, parameters) in paths.items():
        owner = path.rpartition("/")[2]
        types = declared[owner]
        needed = _NEEDED.get(types[0].value, "") if types else ""
        given = {each for each, _ in pairs(parameters)}
        if not needed or "<<" in given or not given - {"type"}:
            continue
        kind, span = types[0].value.rpartition("/")[2], span_of(source, key)
        missing = next((name for name in needed.split() if name not in given), None)
        if missing is not None:
            yield Lacking(owner, kind, missing, "", span)
        elif types[0].value == _TRAJECTORIES and (joint := _without_gains(parameters)):
            yield Lacking(owner, kind, "gains", joint, span)


def _without_gains(parameters: Any) -> str:
    """The first joint of a controller whose commands come of gains, and that has none; else empty."""
    commands = [each.value for each in _texts(_get(parameters, "command_interfaces"))]
    if commands not in (["velocity"], ["effort"]) or _is(parameters, "open_loop_control", "true"):
        return ""
    joints, gains = _scalars(_get(parameters, "joints")), dict(pairs(_get(parameters, "gains")))
    if any(UNKNOWN.search(name) for name in gains) or any(UNKNOWN.search(each.value) for each in joints):
        return ""
    return next((each.value for each in joints if not _is_gained(gains.get(each.value))), "")


def _is_gained(gains: Any) -> bool:
    """Is one of the gains of a joint another one than 0?"""
    texts = [each.value for name in _GAINS for each in _scalars(_get(gains, name))]
    return "<<" in dict(pairs(gains)) or any(text.strip("+-0.") for text in texts)


def _strange(source: Source, declared: Mapping[str, Sequence[Any]]) -> Iterator[Misspelled]:
    """The controllers whose package is one of ros2_controllers, or was one in ROS 1, and has no such type."""
    effort = Effort()
    first = {each.partition("/")[0]: each for each in reversed(_TYPES)} | _FORMER_PACKAGES
    for owner, types in declared.items():
        name = types[0].value if types else ""
        package, _, kind = name.partition("/")
        if not kind or name in _TYPES or effort.is_spent:
            continue
        near = None if package in _FORMER_PACKAGES else suggest(name, _TYPES, effort)
        if package in first:
            meant = _FORMER_TYPES.get(kind) or near or first[package]
            yield Misspelled(owner, "", name, meant, span_of(source, types[0]))
        elif near is not None and near.rpartition("/")[2] == kind:
            yield Misspelled(owner, "", name, near, span_of(source, types[0]))


def _untyped(
    source: Source, paths: Mapping[str, Any], declared: Mapping[str, Sequence[Any]]
) -> Iterator[Parameter]:
    """The nodes with parameters of a controller and without its type."""
    for path, (key, parameters) in paths.items():
        name = path.rpartition("/")[2]
        given = {each for each, _ in pairs(parameters)}
        if not declared[name] and name != _MANAGER and any(given.issuperset(one) for one in _SIGNS):
            yield Parameter(name, name, span_of(source, key))


# The types of parameters, as ROS 2 tells them apart: a number has a point, and takes no whole number in its place.

_INTEGER = pattern(r"[-+]?(0x[0-9a-fA-F]+|[0-9]+)")
_BOOLS = frozenset(
    "y Y yes Yes YES true True TRUE on On ON n N no No NO false False FALSE off Off OFF".split()
)
_FOR_MANAGER = Kind(types="integer: update_rate")


def _mistyped(source: Source, owners: Iterable[tuple[str, Kind, Any]]) -> Iterator[Mistyped]:
    """The parameters of another type than the one that is declared: for each owner and type the first."""
    for owner, kind, parameters in owners:
        found: dict[str, Mistyped] = {}
        declared = _declared(kind)
        for name, node in _flat(parameters, "", 0):
            asked = next((each for each, pattern in declared if fnmatchcase(name, pattern)), "")
            if asked and not _fits(node, asked):
                shown = Parameter(name, _shown(node), span_of(source, node))
                first = found.setdefault(asked, Mistyped(owner, shown, asked, -1))
                found[asked] = first._replace(more=first.more + 1)
        yield from found.values()


def _declared(kind: Kind) -> list[tuple[str, str]]:
    """The types and the patterns of the names that have them."""
    found, asked = [], ""
    for word in kind.types.split():
        if word.endswith(":"):
            asked = word[:-1]
        else:
            found.append((asked, word))
    return found


def _fits(node: Any, asked: str) -> bool:
    """Is a value of a type, as far as that is known?"""
    if asked == "numbers" and node.id == "sequence":
        return {_type(each) for each in node.value} != {"integer"}
    return _type(node) in {"", "list" if asked == "numbers" else asked}


def _type(node: Any) -> str:
    """The type of a value; empty where it is made later."""
    if node.id != "scalar":
        return "list" if node.id == "sequence" else ""
    text = node.value
    if UNKNOWN.search(text) or node.tag.endswith((":null", ":timestamp")):
        return ""
    if node.style is not None:
        return "text"
    if text in _BOOLS:
        return "bool"
    if _INTEGER.fullmatch(text):
        return "integer"
    try:
        float(text.lower().replace(".inf", "inf").replace(".nan", "nan"))
    except ValueError:
        return "text"
    return "number"


def _shown(node: Any) -> str:
    return (
        str(node.value)
        if node.id == "scalar"
        else f"[{', '.join(each.value for each in node.value if each.id == 'scalar')}]"
    )


def _flat(node: Any, name: str, depth: int) -> Iterator[tuple[str, Any]]:
    """The values in a mapping, by the names of those around them, with points between."""
    for key, value in pairs(node):
        inner = f"{name}.{key}" if name else key
        if value.id == "mapping" and depth < _DEEPEST:
            yield from _flat(value, inner, depth + 1)
        elif value.id != "mapping":
            yield inner, value


# The files of MoveIt beside an SRDF file.

LIMITS, SOLVERS, SENT, STARTED, PLANNERS, SENSORS, SERVO = MOVEIT_FILES = (
    "joint_limits.yaml",
    "kinematics.yaml",
    "moveit_controllers.yaml",
    "ros2_controllers.yaml",
    "ompl_planning.yaml",
    "sensors_3d.yaml",
    "servo.yaml",
)
_SENT_TYPES = ("FollowJointTrajectory", "GripperCommand", "ParallelGripperCommand")
_OCTOMAPS: Mapping[str, tuple[str, ...]] = {
    "PointCloudOctomapUpdater": (
        "point_cloud_topic",
        "max_range",
        "padding_offset",
        "padding_scale",
        "point_subsample",
        "max_update_rate",
        "filtered_cloud_topic",
    ),
    "DepthImageOctomapUpdater": ("image_topic",),
}
"""A plugin that makes MoveIt's map of what is around → the parameters without which it does not."""
_SERVO = ("move_group_name", "ee_frame_name", "robot_link_command_frame")
_ADAPTERS = {"humble": "default_planner_request_adapters", "jazzy": "response_adapters"}
_SENDER = "moveit_simple_controller_manager"
_MANAGERS = (
    f"{_SENDER}/MoveItSimpleControllerManager",
    "moveit_ros_control_interface/Ros2ControlManager",
    "moveit_ros_control_interface/Ros2ControlMultiManager",
)
_SOLVER_TYPES = (
    "bio_ik/BioIKKinematicsPlugin",
    "cached_ik_kinematics_plugin/CachedKDLKinematicsPlugin",
    "cached_ik_kinematics_plugin/CachedSrvKinematicsPlugin",
    "cached_ik_kinematics_plugin/CachedTRACKinematicsPlugin",
    "kdl_kinematics_plugin/KDLKinematicsPlugin",
    "lma_kinematics_plugin/LMAKinematicsPlugin",
    "pick_ik/PickIkPlugin",
    "srv_kinematics_plugin/SrvKinematicsPlugin",
    "trac_ik_kinematics_plugin/TRAC_IKKinematicsPlugin",
)
_OF_FILES = ("joint_limits", "moveit_controller_manager", _SENDER)
_OF_JOINTS = tuple(
    name.format(kind)
    for kind in ("position", "velocity", "acceleration", "deceleration", "jerk")
    for name in ("has_{}_limits", "max_{}", "min_{}")[: 3 if kind == "position" else 2]
)
_OF_SOLVERS = ("kinematics_solver", "kinematics_solver_search_resolution", "kinematics_solver_timeout")
"""What MoveIt reads of its files, of the limits of a joint, and of the solver of a group."""
_SWITCHED = ("velocity", "acceleration", "jerk")
_JOINT_LIMITS = Kind(types="bool: has_*_limits number: m??_velocity m??_acceleration m??_jerk m??_position")


class SentController(NamedTuple):
    """A controller to which MoveIt sends trajectories or commands for grippers, and the joints that it has for it."""

    name: Parameter
    joints: tuple[Parameter, ...]
    is_of_trajectories: bool

    @property
    def own_name(self) -> str:
        """Its name without that of its namespace."""
        return self.name.content.rpartition("/")[2]


class RefusedEntry(NamedTuple):
    """A controller, sensor or parameter that MoveIt leaves out, in words, with a place."""

    words: str
    span: Span


class MoveItFiles(NamedTuple):
    """The content of the files of parameters of MoveIt."""

    limits: tuple[Parameter, ...] = ()
    """The joints with limits; the content is ``accelerated`` for those that have one of their acceleration."""
    solvers: tuple[Parameter, ...] = ()
    """The groups that have a solver."""
    sent: tuple[SentController, ...] = ()
    started: tuple[tuple[str, frozenset[str]], ...] = ()
    """The controllers of trajectories that the controller manager starts, each with its joints."""
    mistyped: tuple[Mistyped, ...] = ()
    release: str = ""
    """For which releases its pipeline of planners is written: before ``jazzy``, or from then on; empty if not known."""
    refused: tuple[RefusedEntry, ...] = ()
    handled: frozenset[str] = frozenset()
    """The joints of all controllers that MoveIt knows."""
    servo: tuple[Parameter, ...] = ()
    """The group and the links of MoveIt's servo."""
    allowed: tuple[tuple[str, Parameter], ...] = ()
    """The joints and the bounds of positions and speeds that take the place of those of the robot."""
    misspelled: tuple[RefusedEntry, ...] = ()

    def started_instead(self, sent: SentController) -> str:
        """The controller that is started for the joints of one that is not started, and to which nothing is sent."""
        joints = {each.content for each in sent.joints}
        known = {each.own_name for each in self.sent}
        if sent.own_name in dict(self.started) or not sent.is_of_trajectories:
            return ""
        return next((name for name, own in self.started if own == joints and name not in known), "")


def moveit_files(texts: Mapping[str, Source]) -> MoveItFiles:
    """The content of files by their names, some of which may be missing."""
    nodes = {name: composed(source.text) for name, source in texts.items()}
    limits, solvers, sent = (nodes.get(name) for name in (LIMITS, SOLVERS, SENT))
    started = _controllers(texts[STARTED]) if STARTED in texts else _NOTHING
    joints: dict[str, set[str]] = {}
    for need in started.needs:
        if need.what == "joint":
            joints.setdefault(need.controller, set()).add(need.name)
    return MoveItFiles(
        tuple(_limited(texts[LIMITS], limits)) if limits is not None else (),
        tuple(_solved(texts[SOLVERS], solvers)) if solvers is not None else (),
        tuple(_sent(texts[SENT], sent)) if sent is not None else (),
        tuple((name, frozenset(found)) for name, found in joints.items()),
        _first(list(_mistyped(texts[LIMITS], _read_limits(limits)))) if limits is not None else (),
        next(
            (
                since
                for since, word in _ADAPTERS.items()
                if PLANNERS in texts and word in texts[PLANNERS].text
            ),
            "",
        ),
        (
            *(_refused_sent(texts[SENT], sent) if sent is not None else ()),
            *(_refused_sensors(texts[SENSORS], nodes[SENSORS]) if nodes.get(SENSORS) is not None else ()),
        ),
        frozenset(_handled(sent)),
        tuple(_servo(texts[SERVO], nodes[SERVO], 0)) if nodes.get(SERVO) is not None else (),
        tuple(_allowed(texts[LIMITS], limits)) if limits is not None else (),
        tuple(
            each
            for name in (LIMITS, SOLVERS, SENT)
            if nodes.get(name) is not None
            for each in _miswritten(texts[name], nodes[name])
        ),
    )


def _miswritten(source: Source, node: Any) -> Iterator[RefusedEntry]:
    """The parameters and plugins in one of its files that are called nearly as those that MoveIt has."""
    effort = Effort()

    def keys(mapping: Any, known: Sequence[str], whose: str) -> Iterator[RefusedEntry]:
        given = {name for name, _ in pairs(mapping)}
        left = [name for name in known if name not in given]
        for key, _ in islice(_keys(mapping), _MOST_READ):
            if key.value not in known and (meant := suggest(key.value, left, effort)) is not None:
                yield RefusedEntry(
                    f"has `{key.value}`{whose}, and MoveIt reads `{meant}`", span_of(source, key)
                )

    def plugins(mapping: Any, name: str, known: Sequence[str], whose: str) -> Iterator[RefusedEntry]:
        for each in _texts(_get(mapping, name)):
            if each.value not in known and (meant := misspelling_of(each.value, known)) is not None:
                words = f"has `{each.value}` as `{name}`{whose}, and MoveIt has `{meant}`"
                yield RefusedEntry(words, span_of(source, each))

    yield from keys(node, _OF_FILES, "")
    yield from plugins(node, "moveit_controller_manager", _MANAGERS, "")
    yield from keys(_get(node, _SENDER), ("controller_names",), f" in `{_SENDER}`")
    for joint, limits in pairs(_get(node, "joint_limits")):
        yield from keys(limits, _OF_JOINTS, f" for joint `{joint}`")
    for group, solver in pairs(node):
        yield from keys(solver, _OF_SOLVERS, f" for group `{group}`")
        yield from plugins(solver, "kinematics_solver", _SOLVER_TYPES, f" of group `{group}`")


def _first(found: Sequence[Mistyped]) -> tuple[Mistyped, ...]:
    """The first of several, and how many more there are."""
    return tuple(each._replace(more=sum(other.more + 1 for other in found) - 1) for each in found[:1])


def _limited(source: Source, node: Any) -> Iterator[Parameter]:
    for key, limits in _keys(_get(node, "joint_limits")):
        is_given = (
            _is(limits, "has_acceleration_limits", "true") and _get(limits, "max_acceleration") is not None
        )
        yield Parameter(key.value, "accelerated" if is_given else "", span_of(source, key))


def _read_limits(node: Any) -> Iterator[tuple[str, Kind, Any]]:
    """The limits of joints that MoveIt reads: those that are switched on, and positions."""
    for name, limits in pairs(_get(node, "joint_limits")):
        off = tuple(f"_{kind}" for kind in _SWITCHED if not _is(limits, f"has_{kind}_limits", "true"))
        types = (word for word in _JOINT_LIMITS.types.split() if not word.endswith(off))
        yield name, Kind(types=" ".join(types)), limits


def _allowed(source: Source, node: Any) -> Iterator[tuple[str, Parameter]]:
    for name, limits in pairs(_get(node, "joint_limits")):
        off = "velocity" if _is(limits, "has_velocity_limits", "false") else "-"
        for key in ("max_velocity", "min_position", "max_position"):
            for value in _texts(_get(limits, key)) if not key.endswith(off) else ():
                yield name, Parameter(key, value.value, span_of(source, value))


def _solved(source: Source, node: Any) -> Iterator[Parameter]:
    for key, parameters in _keys(node):
        if _get(parameters, "kinematics_solver") is not None:
            yield Parameter(key.value, key.value, span_of(source, key))


def _sent(source: Source, node: Any) -> Iterator[SentController]:
    sender = _get(node, _SENDER)
    for name in _texts(_get(sender, "controller_names")):
        entry = _get(sender, name.value)
        kind = next((each.value for each in _texts(_get(entry, "type"))), "")
        if kind in _SENT_TYPES:
            parameter = Parameter("controller_names", name.value, span_of(source, name))
            yield SentController(parameter, _written(source, entry, "joints"), kind == _SENT_TYPES[0])


def _refused_sent(source: Source, node: Any) -> Iterator[RefusedEntry]:
    """The controllers that MoveIt has in its list, and leaves out."""
    sender = _get(node, _SENDER)
    entries = dict(pairs(sender))
    for name in _texts(_get(sender, "controller_names")):
        entry = entries.get(name.value)
        kind = next((each.value for each in _texts(_get(entry, "type"))), None)
        given = {each for each, _ in pairs(entry)}
        lacked = next((each for each in ("action_ns", "type", "joints") if each not in given), None)
        if entry is None:
            words = f"lists controller `{name.value}`, and has no entry for it"
        elif lacked is not None:
            words = f"has no `{lacked}` for controller `{name.value}`"
        elif kind is not None and kind not in _SENT_TYPES:
            words = (
                f"has type `{kind}` for controller `{name.value}`, and MoveIt knows {', '.join(_SENT_TYPES)}"
            )
        else:
            continue
        yield RefusedEntry(words, span_of(source, name))


def _refused_sensors(source: Source, node: Any) -> Iterator[RefusedEntry]:
    """The sensors that MoveIt has in its list, and leaves out."""
    listed = _get(node, "sensors")
    for entry in listed.value if getattr(listed, "id", "") == "sequence" else ():
        if entry.id == "mapping" and _get(entry, "sensor_plugin") is not None:
            yield RefusedEntry(
                "lists a mapping in `sensors`, and MoveIt reads names there", span_of(source, entry)
            )
    entries = dict(pairs(node))
    for name in _texts(listed):
        entry = entries.get(name.value)
        plugin = next((each for each in _texts(_get(entry, "sensor_plugin"))), None)
        asked = _OCTOMAPS.get(plugin.value.rpartition("/")[2], ()) if plugin is not None else ()
        given = {each for each, _ in pairs(entry)}
        lacked = [f"`{each}`" for each in asked if each not in given]
        if lacked:
            words = f"has no {' and '.join(lacked)} for sensor `{name.value}`"
            yield RefusedEntry(words, span_of(source, plugin))


def _handled(node: Any) -> Iterator[str]:
    sender = _get(node, _SENDER)
    entries = dict(pairs(sender))
    for name in _texts(_get(sender, "controller_names")):
        yield from (each.value for each in _texts(_get(entries.get(name.value), "joints")))


def _servo(source: Source, node: Any, depth: int) -> Iterator[Parameter]:
    for name, value in pairs(node):
        if value.id == "mapping" and depth < _DEEPEST:
            yield from _servo(source, value, depth + 1)
        elif name in _SERVO:
            yield from (Parameter(name, each.value, span_of(source, each)) for each in _texts(value))


# YAML as nodes: nothing in it is constructed.


def composed(text: str) -> Any:
    """The nodes of a text; None where it cannot be read as YAML."""
    import yaml

    try:
        return yaml.compose(text, Loader=yaml.SafeLoader)  # the one in C crashes on many brackets
    except (yaml.YAMLError, RecursionError, ValueError):
        return None


def _nodes(
    mapping: Any, name: str, depth: int, seen: set[int], place: Any = None
) -> Iterator[tuple[str, Any]]:
    """The names of nodes of ROS, each with its place and its parameters; ``seen``: where an alias would lead again."""
    for key, value in _keys(mapping):
        if key.value == PARAMETERS and place is not None:
            yield name.strip("/"), (place, value)
        elif depth < _DEEPEST and id(value) not in seen:
            seen.add(id(value))
            yield from _nodes(value, f"{name}/{key.value.strip('/')}", depth + 1, seen, key)


def _keys(mapping: Any) -> Iterator[tuple[Any, Any]]:
    """The entries of a mapping whose keys are texts, with the places of these."""
    if getattr(mapping, "id", "") == "mapping":
        yield from ((key, value) for key, value in mapping.value if key.id == "scalar")


def pairs(mapping: Any) -> Iterator[tuple[str, Any]]:
    """The entries of a mapping whose keys are texts."""
    return ((key.value, value) for key, value in _keys(mapping))


def _get(mapping: Any, name: str) -> Any:
    return next((value for key, value in pairs(mapping) if key == name), None)


def _is(mapping: Any, name: str, text: str) -> bool:
    """Is a parameter written, and is it a word?"""
    return [each.value.lower() for each in _texts(_get(mapping, name))] == [text]


def _texts(node: Any) -> list[Any]:
    """The scalar that a node is, or those in its list, without what is made later."""
    return [each for each in _scalars(node) if not UNKNOWN.search(each.value)]


def _scalars(node: Any) -> list[Any]:
    kind = getattr(node, "id", "")
    nodes = [node] if kind == "scalar" else node.value if kind == "sequence" else ()
    return [each for each in nodes if each.id == "scalar"]


def span_of(source: Source, scalar: Any) -> Span:
    """The place of a text, without its quotes, or of a list."""
    quotes = 1 if getattr(scalar, "style", None) in {"'", '"'} else 0
    return Span(source, scalar.start_mark.index + quotes, scalar.end_mark.index - quotes)
