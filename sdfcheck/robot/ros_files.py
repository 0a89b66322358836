"""Topics and frames that YAML and launch files of a project name, beside those of its robots.

Source: gz-sensors 8 to 10 and the systems of gz-sim 8 to 10 for topics, ros_gz_bridge for YAML and arguments, and Nav2,
slam_toolbox and robot_localization for frames. Nothing of a launch file runs: topics that it computes are not known,
and then nothing is said about messages of that type.
"""

from __future__ import annotations

import ast
import os
import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence, Set
from itertools import chain, islice
from pathlib import Path
from typing import Any

from sdfcheck.files.library import library_of
from sdfcheck.files.packages import Packages, package_around
from sdfcheck.files.regular import read_regular
from sdfcheck.robot.controllers import LARGEST, PARAMETERS, UNKNOWN, Parameter, composed, pairs, span_of
from sdfcheck.robot.graph import Plugin, Sensor
from sdfcheck.robot.values import lazy
from sdfcheck.source.document import Document, Value
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.text import Source, Span
from sdfcheck.xacro.language import syntax_tree
from sdfcheck.xacro.static.launches import launch_texts

_MOST_FILES = 300
"""So many files of each kind are looked through, and so many of them with a bridge are read."""
_MOST_SAID = 256 * 1024
"""Bytes of a description of which the topics are known."""
_MOST_TEXT = 16 * 1024 * 1024
"""Bytes of descriptions and programs of a project that are searched for names; in more anything may be named."""
_MOST_PARSED = 256 * 1024
"""Bytes of YAML, and of launch files, that are parsed for a project; in more anything may be carried."""
_MOST_CARRIED = 1000
_DEEPEST = 8
_MOST_MERGED = 100
_KEYS = ("gz_topic_name", "ign_topic_name")
_TYPES = ("gz_type_name", "ign_type_name")
_ARGUMENT = re.compile(r"([^\s@{}$\"'<>%]{1,300})@[\w/]{1,200}([@\[\]])(?:gz|ignition)\.msgs\.(\w+)")
"""An argument of ``parameter_bridge``: topic, type in ROS, direction, type in Gazebo."""
_TYPE = re.compile(r"[@\[\]](?:gz|ignition)\.msgs\.(\w+)")
_REMARK = re.compile(r"^[ \t]*#.*$|<!--[\s\S]*?(?:-->|\Z)", re.MULTILINE)
_ELSEWHERE = re.compile(r"gz_topic_name|expand_gz_topic_names")
"""A program that writes a bridge, or a bridge that puts the name of the model before all topics."""
_NAME = re.compile(r"\w+")
_NAMES = re.compile(r"[\w.-]+")
"""Words, and names of files."""
_WORD = re.compile(r"[a-z]+|\d+")
_SAID = re.compile(r">\s{0,50}/?([A-Za-z_~][\w./~-]{0,200})\s{0,50}<")
_MOST_TOPICS = 5_000
"""A description with more texts like topics may have any."""
_DESCRIPTIONS = (".sdf", ".world", ".urdf", ".xacro", ".gazebo")

_BASE = re.compile(
    r"^[ \t]*(?:robot_base_frame|base_frame_id|base_frame|base_link_frame)[ \t]*:[ \t]*"
    r"[\"']?([A-Za-z]\w{0,99})\b[\"']?[ \t]*(?:#.*)?$",
    re.MULTILINE,
)
_NODE_OF = {"base_frame_id": "amcl", "base_frame": "slam_toolbox"}
"""Parameters for the base of a robot that are such a one in a node alone."""
_BESIDE = {"base_link_frame": "odom_frame"}
"""The same with the parameter that is beside it."""
_FILTER = "robot_localization"
_PROGRAMS = (".py", ".launch", ".xml", ".cpp", ".hpp", ".lua")

_PICTURE = {"Image": ("",), "CameraInfo": ("/../camera_info",)}
_LIDAR = {"LaserScan": ("",), "PointCloudPacked": ("/points",)}
_OF_SENSORS: Mapping[str, Mapping[str, tuple[str, ...]]] = {
    "air_pressure": {"FluidPressure": ("",)},
    "altimeter": {"Altimeter": ("",)},
    "camera": _PICTURE,
    "depth_camera": {**_PICTURE, "PointCloudPacked": ("/points",)},
    "force_torque": {"Wrench": ("",)},
    "gpu_lidar": _LIDAR,
    "gpu_ray": _LIDAR,
    "imu": {"IMU": ("",)},
    "lidar": _LIDAR,
    "magnetometer": {"Magnetometer": ("",)},
    "navsat": {"NavSat": ("",)},
    "ray": _LIDAR,
    "rgbd_camera": {
        "Image": ("/image", "/depth_image"),
        "PointCloudPacked": ("/points",),
        "CameraInfo": ("/camera_info",),
    },
    "thermal": _PICTURE,
    "thermal_camera": _PICTURE,
    "wideanglecamera": _PICTURE,
}
"""Type of a sensor → message → what follows its topic; ``/..`` is the topic without its last name."""

_DRIVE = (
    ("topic", "Twist", "/cmd_vel"),
    ("odom_topic", "Odometry", "/odometry"),
    ("tf_topic", "Pose_V", "/tf"),
)
_OF_SYSTEMS: Mapping[str, tuple[tuple[str, str, str], ...]] = {
    "gz-sim-ackermann-steering-system": _DRIVE,
    "gz-sim-diff-drive-system": _DRIVE,
    "gz-sim-joint-controller-system": (("topic", "Double", "/cmd_vel"),),
    "gz-sim-joint-position-controller-system": (("topic", "Double", "/cmd_pos"),),
    "gz-sim-joint-state-publisher-system": (("topic", "Model", "/joint_state"),),
    "gz-sim-mecanum-drive-system": _DRIVE,
    "gz-sim-odometry-publisher-system": (
        ("odom_topic", "Odometry", "/odometry"),
        ("tf_topic", "Pose_V", "/pose"),
    ),
    "gz-sim-tracked-vehicle-system": _DRIVE,
    "gz-sim-velocity-control-system": (("topic", "Twist", "/cmd_vel"),),
}
"""System → parameter, message, and the end of the topic that it makes of the model's name."""
_OTHERWISE = frozenset(("sub_topic", "steering_only", "use_actuator_msg"))
"""Parameters with which a system takes other topics."""
_COMMANDS = frozenset(("Double", "Twist"))
_INFO = "CameraInfo"
_PAIRS: Mapping[str, str] = {
    "actuator_msgs": "Actuators",
    "builtin_interfaces": "Time",
    "geometry_msgs": "Point=Vector3d Pose PoseArray=Pose_V PoseStamped=Pose PoseWithCovariance Quaternion "
    "PoseWithCovarianceStamped=PoseWithCovariance Transform=Pose TransformStamped=Pose Twist TwistStamped=Twist "
    "TwistWithCovariance TwistWithCovarianceStamped=TwistWithCovariance Vector3=Vector3d Wrench WrenchStamped=Wrench",
    "nav_msgs": "Odometry Odometry=OdometryWithCovariance",
    "rosgraph_msgs": "Clock",
    "sensor_msgs": "BatteryState CameraInfo FluidPressure Image Imu=IMU JointState=Model Joy LaserScan "
    "MagneticField=Magnetometer NavSatFix=NavSat PointCloud2=PointCloudPacked",
    "std_msgs": "Bool=Boolean ColorRGBA=Color Empty Float32=Float Float64=Double Header Int32 String=StringMsg UInt32",
    "tf2_msgs": "TFMessage=Pose_V",
    "trajectory_msgs": "JointTrajectory",
}
"""Package of ROS → its messages that a bridge carries, each with the one of Gazebo if that has another name."""
_WAYS = {"gz": ("BIDIRECTIONAL", "GZ_TO_ROS", "ROS_TO_GZ"), "ign": ("IGN_TO_ROS", "ROS_TO_IGN")}
_REFUSED_NAME = re.compile(r"[^\w/~]|//|/\Z|(?:^|/)\d")


# Bridges between ROS and Gazebo.


class Bridged(NamedTuple):
    """A topic of Gazebo that a bridge carries, without slashes around it."""

    topic: str
    message: str
    span: Span
    direction: str
    """``[`` from Gazebo, ``]`` to Gazebo, ``@`` both ways."""

    def goes(self, direction: str) -> bool:
        return self.direction in {direction, "@"}


class BridgeGap(NamedTuple):
    """A sensor or system whose topics no bridge carries, and what a bridge carries instead, for nobody."""

    part: Sensor | Plugin
    message: str
    parameter: str
    """The element that gives its topic."""
    topic: str
    """Where it publishes or listens; empty for a topic that Gazebo makes of names."""
    value: Value | None
    bridged: Bridged
    names: str
    """Those of link and sensor in a topic that Gazebo makes of them, where a bridge has others; else empty."""
    is_backwards: bool = False
    """Is it the right topic, carried in the wrong direction alone?"""

    @property
    def is_command(self) -> bool:
        """Do its messages go to Gazebo?"""
        return self.message in _COMMANDS


class BridgeFault(NamedTuple):
    """An entry of a bridge that it does not take: words about it, and how many more there are of the kind."""

    part: Sensor | Plugin
    """That whose topic it is."""
    words: str
    span: Span
    more: int


class _Fault(NamedTuple):
    """An entry that a bridge does not take, with its topic in Gazebo; ``kind``: what all such have in common."""

    topic: str
    kind: str
    words: str
    span: Span


def _words(text: str) -> Set[str]:
    return frozenset(_WORD.findall(text.lower()))


def _is_made(topic: str) -> bool:
    """Does Gazebo make a topic of names?"""
    return topic.startswith(("model/", "world/"))


class _Bridges:
    """The topics that the bridges of a project carry."""

    __slots__ = ("_is_open", "_packages", "_said", "carried", "faults", "unknown")

    def __init__(self, packages: Packages) -> None:
        self._packages = packages
        self._said: dict[Path, tuple[frozenset[str], bool]] | None = None
        self._is_open = False
        self.carried: list[Bridged] = []
        self.faults: list[_Fault] = []
        self.unknown: set[str] = set()
        """Types of messages that are carried on topics which are not known; empty text: all types."""
        launches = (each for each in launch_texts(packages) if ".msgs." in each[1] or "_bridge" in each[1])
        for path, text in self._within(launches):
            self._take(list(_of_launch(Source(path, text, is_foreign=True), self.unknown)))
        files = ((path, _text(path, LARGEST)) for path in _files(packages, (".yaml", ".yml")))
        entries = ((path, text) for path, text in files if any(key in text for key in _TYPES))
        for path, text in self._within(entries):
            source, node = Source(path, text, is_foreign=True), composed(text)
            self._take(list(_of_yaml(source, node)))
            self.faults += islice(_faults(source, node), _MOST_CARRIED - len(self.faults))

    def _within(self, texts: Iterable[tuple[Path, str]]) -> Iterator[tuple[Path, str]]:
        """The first texts, as far as they may be parsed; with more of them all types are unknown."""
        left = _MOST_PARSED
        for path, text in texts:
            left -= len(text)
            if left < 0:
                self.unknown.add("")
                return
            yield path, text

    def _take(self, found: Iterable[Bridged]) -> None:
        for each in found:
            if UNKNOWN.search(each.topic):
                self.unknown.add(each.message)
            elif len(self.carried) < _MOST_CARRIED:
                self.carried.append(each)

    def is_said(self, topic: str, own: set[Path]) -> bool:
        """May another description of the project publish on a topic, or listen to it?"""
        if self._said is None:
            texts = _texts(self._packages, _DESCRIPTIONS)
            self._said = {} if texts is None else {path: _topics(text) for path, text in texts.items()}
            self._is_open = texts is None
        if self._is_open:
            return True
        names = topic.split("/")
        around = {"/".join(names[:count]) for count in range(1, len(names))}
        return any(
            topic in topics or (path not in own and (is_open or not around.isdisjoint(topics)))
            for path, (topics, is_open) in self._said.items()
        )


def _files(packages: Packages, suffixes: Iterable[str]) -> Iterator[Path]:
    for suffix in suffixes:
        yield from packages.files(suffix, _MOST_FILES)


def _absolute(path: Path) -> Path:
    """A path as the files of a project are listed: the one that was named may be relative."""
    return Path(os.path.abspath(path))


def _text(path: Path, most: int) -> str:
    try:
        return read_regular(path, most).decode("utf-8-sig", "replace")
    except OSError:
        return ""


def _texts(packages: Packages, suffixes: Iterable[str]) -> dict[Path, str] | None:
    """The texts of the files of some suffixes; None where there is too much of them."""
    found: dict[Path, str] = {}
    left = _MOST_TEXT
    for path in _files(packages, suffixes):
        found[path] = _text(path, _MOST_SAID)
        left -= len(found[path])
        if left < 0:
            return None
    return found


def _topics(text: str) -> tuple[frozenset[str], bool]:
    """The texts of a description that may be topics, and whether it has sensors whose topics are not known."""
    bare = _REMARK.sub("", text)
    sensors = (after.partition("</sensor>")[0] for after in bare.split("<sensor")[1:])
    is_open = any("<topic>" not in each or "$" in each for each in sensors)
    topics = frozenset(each.rstrip("/") for each in _SAID.findall(bare))
    return (topics, is_open) if len(topics) < _MOST_TOPICS else (frozenset(), True)


def _of_launch(source: Source, unknown: set[str]) -> Iterator[Bridged]:
    """The topics that a launch file gives to its bridges; adds types of messages that it computes to ``unknown``."""
    text = _REMARK.sub(lambda match: " " * len(match[0]), source.text)
    if _ELSEWHERE.search(text):
        unknown.add("")
    if "image_bridge" in text:
        unknown.add("Image")
    found = [match for match in _ARGUMENT.finditer(text) if _is_alone(text, match)]
    if source.path.suffix == ".py" and found:
        whole = _whole_texts(text)
        found = [match for match in found if match[0] in whole]
    types = [match[1] for match in _TYPE.finditer(text)]
    for match in found:
        types.remove(match[3])
        start = match.start()
        yield Bridged(match[1].strip("/"), match[3], Span(source, start, start + len(match[1])), match[2])
    unknown.update(types)


def _is_alone(text: str, match: re.Match[str]) -> bool:
    """Does nothing but a quote or a blank stand around an argument?"""
    around = text[match.start() - 1 : match.start()] + text[match.end() : match.end() + 1]
    return not around.strip("\"' \t\n")


def _whole_texts(text: str) -> frozenset[str]:
    """The texts of a program that are elements of lists in which no text is a piece of a longer one."""
    try:
        tree = syntax_tree(text, "exec")
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return frozenset()
    lists = (node.elts for node in ast.walk(tree) if isinstance(node, ast.List | ast.Tuple))
    return frozenset(
        each.value
        for elements in lists
        if all(map(_is_whole, elements))
        for each in elements
        if isinstance(each, ast.Constant) and isinstance(each.value, str)
    )


def _is_whole(node: ast.expr) -> bool:
    if isinstance(node, ast.Constant):
        return "@" in str(node.value) or str(node.value).startswith("-")
    return not isinstance(node, ast.Call | ast.Name)


def _entries(node: Any) -> Iterator[tuple[Any, dict[str, Any], Any, Any]]:
    """The entries for a bridge in YAML: the mapping, its values, the topic in Gazebo and its type."""
    for entry in _mappings(node, 0, set()):
        given = dict(pairs(entry))
        topic = next((given[key] for key in (*_KEYS, "topic_name", "ros_topic_name") if key in given), None)
        kind = next((given[key] for key in _TYPES if key in given), None)
        if topic is not None and topic.id == "scalar" and kind is not None and kind.id == "scalar":
            yield entry, given, topic, kind


def _of_yaml(source: Source, node: Any) -> Iterator[Bridged]:
    """The topics that a file in YAML gives to a bridge."""
    for _, given, topic, kind in _entries(node):
        ways = [each.value for each in (given.get("direction"),) if each is not None and each.id == "scalar"]
        direction = {"GZ_TO_ROS": "[", "ROS_TO_GZ": "]"}.get("".join(ways), "@")
        yield Bridged(
            topic.value.strip("/ "), kind.value.rpartition(".")[2], span_of(source, topic), direction
        )


def _faults(source: Source, node: Any) -> Iterator[_Fault]:
    """The entries of a bridge's file that it does not take, each with the first reason."""
    for entry, given, topic, kind in _entries(node):
        texts = {name: value.value for name, value in given.items() if value.id == "scalar"}
        found = None if any(map(UNKNOWN.search, texts.values())) else _refused(texts)
        if entry is node:
            found = "list", "is one mapping, and a bridge reads a list of them", ""
        if found is not None:
            reason, words, parameter = found
            span = span_of(source, given.get(parameter, topic if entry is node else kind))
            yield _Fault(topic.value.strip("/ "), reason, words, span)


def _refused(texts: Mapping[str, str]) -> tuple[str, str, str] | None:
    """Why a bridge does not take an entry: the reason in a word and in a clause, and the parameter that shows it."""
    ros = next((key for key in ("ros_topic_name", "topic_name", *_KEYS) if key in texts), "")
    way = texts.get("direction", "GZ_TO_ROS")
    if (both := {"topic_name", "ros_topic_name", *_KEYS}.intersection(texts)) > {"topic_name"}:
        other = min(both - {"topic_name"})
        return "both", f"has both `topic_name` and `{other}`, which exclude each other", "topic_name"
    if match := _REFUSED_NAME.search(texts.get(ros, "")):
        begins = "a part of it begins with a digit" if match[0][-1:].isdigit() else f"it has `{match[0]}`"
        return "name", f"gives the topic `{texts[ros]}`, which ROS refuses: {begins}", ros
    if not any(way in ways for ways in _WAYS.values()):
        return (
            "direction",
            f"gives the direction `{way}`, one of {', '.join(_WAYS['gz'])} is asked for",
            "direction",
        )
    if "ros_type_name" not in texts:
        return "type", "gives a topic without `ros_type_name`", ""
    return _unpaired(texts["ros_type_name"], next(texts[key] for key in _TYPES if key in texts))


def _unpaired(ros: str, gazebo: str) -> tuple[str, str, str] | None:
    """Words about two types of messages that no bridge has, where it is known which one it has instead."""
    package, _, name = ros.replace("/msg/", "/").rpartition("/")
    space, _, other = gazebo.rpartition(".")
    known = [each.partition("=")[::2] for each in _PAIRS.get(package, "").split()]
    partners = [one for one, partner in known if (partner or one) == other]
    if other and space not in {"gz.msgs", "ignition.msgs"} and space.rpartition("_")[2] == "msgs":
        return "pair", f"has the type `{gazebo}`, and Gazebo calls it `gz.msgs.{other}`", _TYPES[0]
    if not partners or name in {one for one, _ in known if one in partners} or package == "sensor_msgs":
        return None
    words = f"bridges `{ros}` with `{gazebo}`, whose partner is `{package}/msg/{partners[0]}`"
    return "pair", words, "ros_type_name"


def _mappings(node: Any, depth: int, seen: set[int]) -> Iterator[Any]:
    """The mappings in a node, each once."""
    kind = getattr(node, "id", "")
    if depth > _DEEPEST or id(node) in seen or kind not in {"mapping", "sequence"}:
        return
    seen.add(id(node))
    if kind == "mapping":
        yield node
    for each in node.value if kind == "sequence" else (value for _, value in pairs(node)):
        yield from _mappings(each, depth + 1, seen)


class _End(NamedTuple):
    """A sensor or system, and its topics by the messages on them; None: they are not known."""

    part: Sensor | Plugin
    topics: Mapping[str, tuple[str, ...]] | None
    usual: str
    """A part of the topics that Gazebo makes of names; empty where a topic is given."""
    messages: tuple[str, ...]
    parameter: str
    value: Value | None

    def takes(self, carried: Bridged) -> bool:
        """Is it what a bridge carries?"""
        return carried.goes(self.way) and self.is_of(carried)

    def is_of(self, carried: Bridged) -> bool:
        """Has it the topic that a bridge carries, in one direction or the other?"""
        if carried.message not in self.messages:
            return False
        if self.usual:
            return self.usual in f"/{carried.topic}/" and _is_made(carried.topic)
        return self.topics is None or carried.topic in self.topics.get(carried.message, ())

    def may_be_meant_by(self, carried: Bridged) -> bool:
        """May a topic that nobody has be meant for it: one that a person chose, or one made of its name?"""
        own = (f"model/{self.model}/{each}" for each in chain.from_iterable((self.topics or {}).values()))
        is_named = not _is_made(carried.topic) or f"/sensor/{self.part.name}/" in carried.topic
        return (is_named or carried.topic in own) and carried.goes(self.way)

    def has(self, topic: str) -> bool:
        """Is it that of a topic, as far as that is known?"""
        if self.usual:
            return self.usual in f"/{topic}/" and f"/{self.model}/" in f"/{topic}/"
        return any(topic in topics for topics in (self.topics or {}).values())

    @property
    def model(self) -> str:
        """The name of its model."""
        holder = self.part.holder
        while holder is not None and holder.kind != "model":
            holder = holder.holder
        return getattr(holder, "name", "")

    @property
    def way(self) -> str:
        """The direction in which a bridge carries its messages."""
        return "[" if _COMMANDS.isdisjoint(self.messages) else "]"

    @property
    def words(self) -> Set[str]:
        """The words in its names and topics."""
        topics = chain.from_iterable((self.topics or {}).values())
        names = (self.part.name, *(child.content for child in self.part.children("joint_name")))
        return _words(" ".join((*topics, *names)))


def gaps(document: Document, sensors: Iterable[Sensor], plugins: Iterable[Plugin]) -> Iterator[BridgeGap]:
    """The sensors and systems of a document whose messages no bridge of the project carries, though one means to."""
    library = library_of(document)
    ends = [*_of_sensors(sensors), *_of_systems(plugins)] if library is not None else []
    if library is None or not ends:
        return
    bridges = library.of_project(document.path, _Bridges)
    if "" in bridges.unknown:
        return
    sources = (document.source, *(end.part.element.span.source for end in ends))
    own = {Path(source.real_path) for source in sources} | {_absolute(source.path) for source in sources}
    open_types = {message for end in ends if end.topics is None for message in end.messages} | bridges.unknown
    lacking = [(end, _lacking(end, ends, bridges.carried, open_types)) for end in ends]
    for each in bridges.carried:
        if each.message in open_types or any(end.takes(each) for end in ends):
            continue
        if (backwards := next((end for end in ends if end.is_of(each)), None)) is not None:
            if not any(map(backwards.takes, bridges.carried)):
                yield BridgeGap(
                    backwards.part,
                    each.message,
                    backwards.parameter,
                    each.topic,
                    backwards.value,
                    each,
                    "",
                    True,
                )
            continue
        meant = [one for one in lacking if each.message in one[1] and one[0].may_be_meant_by(each)]
        if meant and not bridges.is_said(each.topic, own):
            words = _words(each.topic)
            end, messages = max(meant, key=lambda one: len(one[0].words & words))
            messages.discard(each.message)
            topic = next(iter((end.topics or {}).get(each.message, ())), "")
            names = end.usual.strip("/") if _is_made(each.topic) else ""
            yield BridgeGap(end.part, each.message, end.parameter, topic, end.value, each, names)


def faults(document: Document, sensors: Iterable[Sensor], plugins: Iterable[Plugin]) -> Iterator[BridgeFault]:
    """The entries of bridges that are not taken, and are for sensors and systems of a document."""
    library = library_of(document)
    ends = [*_of_sensors(sensors), *_of_systems(plugins)] if library is not None else []
    if library is None or not ends:
        return
    found: dict[tuple[Path, str], BridgeFault] = {}
    for fault in library.of_project(document.path, _Bridges).faults:
        key = fault.span.source.path, fault.kind
        if (first := found.get(key)) is not None:
            found[key] = first._replace(more=first.more + 1)
        elif (end := next((each for each in ends if each.has(fault.topic)), None)) is not None:
            found[key] = BridgeFault(end.part, fault.words, fault.span, 0)
    yield from found.values()


def _lacking(end: _End, ends: Iterable[_End], carried: Sequence[Bridged], open_types: Set[str]) -> set[str]:
    """The messages of a sensor or system that no bridge carries, as far as that is known.

    Where one carries the pictures of the only camera, its calibration is looked at alone.
    """
    if open_types.isdisjoint(end.messages) and not any(map(end.takes, carried)):
        return set(end.messages)
    is_only = _INFO in end.messages and sum(_INFO in each.messages for each in ends) == 1
    is_carried = any(each.message == _INFO and end.takes(each) for each in carried)
    return {_INFO} if is_only and not is_carried else set()


def _of_sensors(sensors: Iterable[Sensor]) -> Iterator[_End]:
    for sensor in islice(sensors, _MOST_FILES):
        follow = _OF_SENSORS.get(sensor.type)
        if follow is None or sensor.plugins:
            continue
        value, topic = sensor.value("topic"), sensor.topic.strip("/ ")
        is_known = value is None or not UNKNOWN.search(value.span.text.strip("/ "))
        topics = {message: tuple(_joined(topic, end) for end in ends) for message, ends in follow.items()}
        camera = sensor.find("camera")
        info = camera.find("camera_info_topic") if camera is not None and sensor.type == "camera" else None
        if info is not None:
            topics[_INFO] = (info.content.strip("/ "),)
            is_known = is_known and "$" not in info.span.text
        usual = "" if topic else f"/link/{_carrier(sensor)}/sensor/{sensor.name}/"
        yield _End(
            sensor, (topics if topic else {}) if is_known else None, usual, tuple(follow), "topic", value
        )


def _carrier(sensor: Sensor) -> str:
    """The link that Gazebo has a sensor in: of URDF the one that fixed joints merge its link into."""
    link = sensor.link
    for _ in range(_MOST_MERGED):
        joint = next(iter(link.parent_joints), None) if link is not None else None
        if joint is None or not joint.is_lumped or joint.parent_link is None:
            break
        link = joint.parent_link
    return link.name if link is not None else ""


def _joined(topic: str, end: str) -> str:
    if end.startswith("/.."):
        return (topic.rpartition("/")[0] + end[3:]).strip("/")
    return topic + end


def _of_systems(plugins: Iterable[Plugin]) -> Iterator[_End]:
    for plugin in islice(plugins, _MOST_FILES):
        rows = _OF_SYSTEMS.get(plugin.known.file, ()) if plugin.known is not None else ()
        if not rows or any(plugin.has(name) for name in _OTHERWISE):
            continue
        for parameter, message, end in rows:
            value = plugin.value(parameter)
            topic = "" if value is None else value.text.strip("/ ")
            is_known = value is None or not UNKNOWN.search(value.span.text.strip("/ "))
            topics = {message: (topic,)} if topic else {}
            yield _End(
                plugin, topics if is_known else None, "" if topic else f"{end}/", (message,), parameter, value
            )


# Controllers.

_TYPED_ELSEWHERE = re.compile(
    r"controller[-_]type|params?[-_]file|[\"' ]-[tp][\"' ]|set_parameters|yaml\.(?:safe_)?load"
)
"""A launch file that gives a controller its type, or other files of parameters."""


class _Started:
    """The words of the launch files of a project that start controllers, and its files of parameters with types."""

    def __init__(self, packages: Packages) -> None:
        self.words: set[str] = set()
        self.is_open = False
        for _, text in launch_texts(packages):
            if "controller" in text:
                self.words.update(_NAMES.findall(text))
                self.is_open |= _TYPED_ELSEWHERE.search(text) is not None
        files = ((path, _text(path, LARGEST)) for path in _files(packages, (".yaml", ".yml")))
        self.typed = {path: frozenset(_NAMES.findall(text)) for path, text in files if "type:" in text}


def started_untyped(document: Document, nodes: Sequence[Parameter]) -> Iterator[Parameter]:
    """The nodes with parameters of a controller that launch files start, and to which no file gives a type."""
    library = library_of(document)
    started = library.of_project(document.path, _Started) if library is not None and nodes else None
    if started is None or started.is_open:
        return
    for node in nodes:
        own = _absolute(node.span.source.path)
        others = (words for path, words in started.typed.items() if path != own)
        if node.name in started.words and not any(node.name in words for words in others):
            yield node


_MANAGER = "ros2_control_node"
_GAZEBO = re.compile(r"\b(?:gazebo_ros|ros_gz_sim|ros_ign_gazebo|spawn_entity)\b")
_CONDITION = re.compile(
    r"\b(?:If|Unless)\w*Condition\b|\bcondition\s*=|\b(?:if|unless)\s*=\s*[\"']|OpaqueFunction"
)


class _Managers:
    """The places where a launch file of a project starts Gazebo and a controller manager, in any case."""

    def __init__(self, packages: Packages) -> None:
        self.found: list[tuple[Span, frozenset[str]]] = []
        said: dict[str, frozenset[str]] = {}
        for path, text in launch_texts(packages):
            bare = _REMARK.sub(lambda match: " " * len(match[0]), text)
            if _CONDITION.search(bare):
                continue
            words = frozenset(_NAMES.findall(bare))
            said[path.name] = words if path.name not in said else frozenset()
            start = bare.find(_MANAGER)
            if start >= 0 and _GAZEBO.search(bare) and len(self.found) < _MOST_FILES:
                span = Span(Source(path, text, is_foreign=True), start, start + len(_MANAGER))
                self.found.append((span, words))
        self.found = [
            (span, words.union(*(said[name] for name in words if name in said))) for span, words in self.found
        ]


def second_manager(document: Document) -> Span | None:
    """Where a launch file that names a document starts a controller manager beside that of Gazebo."""
    library = library_of(document)
    managers = library.of_project(document.path, _Managers).found if library is not None else ()
    return next((span for span, words in managers if document.path.name in words), None)


# Worlds in which launch files start robots.

_NEW_GAZEBO = re.compile(r"\bros_(?:gz|ign)_(?:sim|gazebo)\b")
_CREATED = re.compile(r"(?:executable|exec)\s*=\s*[\"']create[\"']")
_INTO = re.compile(r"[\"']-world[\"']\s*,\s*[\"'](\w{1,100})[\"']")
_WORLDS = (".sdf", ".world")
_WORLD = re.compile(r"<world\s[^<>]{0,200}?name\s{0,20}=\s{0,20}[\"']([^\"'<>]{1,100})[\"']")
_SUPPORT = re.compile(r"<include|xacro:|<static>|<gravity|\$[{(]|<%|type\s*=\s*[\"']fixed[\"']")
"""Words of a world in which something may be there to stand on, or of which not all is known."""
_SYSTEM = re.compile(r"(?:gz-sim|ignition-gazebo)\d*-([a-z][\w-]{1,60}?)-system\b")
_TIME = "use_sim_time"
_TIMED = re.compile(
    r"use_sim_time[\"']?\s{0,20}(?:[:,=]|value\s{0,20}=)\s{0,20}(?:\(\s{0,20})?[\"']?[Tt]rue\b"
)
_CLOCK = re.compile(r"clock", re.IGNORECASE)
_SHARE = re.compile(
    r"(?:get_package_share_(?:directory|path)|FindPackageShare)\(\s*(?:package\s*=\s*)?([\"']?\w+)|"
    r"\$\(find-pkg-share\s+(\w+)"
)
_GIVEN = re.compile(r"\b(\w{1,100})\s{0,20}=\s{0,20}[\"'](\w{1,100})[\"']")
_CLOCKLESS = frozenset(("ros_gz_sim", "ros_ign_gazebo", "slam_toolbox", "nav2_bringup", "robot_localization"))
"""Packages whose launch files start no bridge for the clock."""


class LaunchedWorld(NamedTuple):
    """The world in which a launch file creates a robot, by the name of its file and its own."""

    file: str
    name: str
    systems: frozenset[str]
    """The systems of Gazebo that it lists, by what is special in the names of their files, such as ``physics``."""
    is_bare: bool
    """Is nothing in it static, as far as all of it is known?"""
    span: Span
    """The place in the launch file where the robot is created."""
    wanted: str
    """The name of the world in which it is to be created; empty for the one that runs."""


class _Simulations:
    """The launch files of a project that start the new Gazebo, with their words and those of what they include."""

    def __init__(self, packages: Packages) -> None:
        said: dict[str, frozenset[str]] = {}
        found: list[tuple[Path, str, frozenset[str]]] = []
        for path, text in launch_texts(packages):
            bare = _REMARK.sub(lambda match: " " * len(match[0]), text)
            words = frozenset(_NAMES.findall(bare))
            said[path.name] = words if path.name not in said else frozenset()
            if _NEW_GAZEBO.search(bare) and len(found) < _MOST_FILES:
                found.append((path, bare, words))
        self.launches = [
            (
                Source(path, bare, is_foreign=True),
                words.union(*(said[name] for name in words if name in said)),
            )
            for path, bare, words in found
        ]
        self.creations = [each for source, words in self.launches for each in _creations(source, words)]
        worlds: dict[str, str] = {}
        self.systems: frozenset[str] = frozenset()
        """The systems that any description of the project lists."""
        if self.launches:
            texts = _texts(packages, (*_DESCRIPTIONS, ".erb")) or {}
            for path, text in texts.items():
                if path.suffix in _WORLDS and "<world" in text:
                    worlds[path.name] = "" if path.name in worlds else _REMARK.sub("", text)
            self.systems = frozenset(name for text in texts.values() for name in _SYSTEM.findall(text))
        named = {file for each in self.creations for file in each.files}
        self.worlds = {name: _world(text) for name, text in worlds.items() if name in named}
        """Name of a file that a launch file names → the only world in it, if no other file has that name."""
        self.timed = self._timed(packages)

    def _timed(self, packages: Packages) -> tuple[Span, frozenset[str]] | None:
        """Where nodes are given the time of Gazebo, and the words there, if nothing in the project has a clock."""
        found = next(
            (
                (Span(source, match.start(), match.start() + len(_TIME)), words)
                for source, words in self.launches
                if (match := _TIMED.search(source.text)) is not None and _is_clockless(source.text, packages)
            ),
            None,
        )
        texts = _texts(packages, (*_PROGRAMS, ".yaml", ".yml")) if found is not None else None
        if texts is None or any(_CLOCK.search(_REMARK.sub("", text)) for text in texts.values()):
            return None
        return found


def _is_clockless(text: str, packages: Packages) -> bool:
    """Does a launch file include none of a package that may start a bridge for the clock?"""
    if "nclude" not in text:
        return True
    given = dict(_GIVEN.findall(text))
    names = {
        given.get(quoted, "") if quoted and quoted[0] not in "\"'" else quoted.strip("\"'") or plain
        for quoted, plain in _SHARE.findall(text)
    }
    return all(packages.find(name) is not None for name in names - _CLOCKLESS)


def unbridged_clock(document: Document) -> Span | None:
    """Where a launch file that names a robot takes the time of Gazebo, which no bridge of the project carries."""
    library = library_of(document)
    timed = library.of_project(document.path, _Simulations).timed if library is not None else None
    if library is None or timed is None or document.path.name not in timed[1]:
        return None
    bridges = library.of_project(document.path, _Bridges)
    return timed[0] if bridges.carried and "" not in bridges.unknown else None


def is_served(document: Document, systems: Collection[str]) -> bool:
    """Does a description of the project list one of some systems of Gazebo, by their files?"""
    library = library_of(document)
    listed = library.of_project(document.path, _Simulations).systems if library is not None else ()
    return any(f"gz-sim-{name}-system" in systems for name in listed)


class _Creation(NamedTuple):
    """The only place in a launch file where a robot is created, the words there, and the world if it is named."""

    span: Span
    words: frozenset[str]
    files: frozenset[str]
    """The words that may be files of worlds."""
    wanted: str


def _creations(source: Source, words: frozenset[str]) -> Iterator[_Creation]:
    """The place where a launch file creates a robot, if it is the only one."""
    created = list(islice(_CREATED.finditer(source.text), 2))
    if len(created) == 1:
        into = set(_INTO.findall(source.text))
        files = frozenset(word for word in words if word.endswith(_WORLDS))
        span = Span(source, created[0].start(), created[0].end())
        yield _Creation(span, words, files, into.pop() if len(into) == 1 else "")


def launched_world(document: Document) -> LaunchedWorld | None:
    """The world of the project in which a launch file creates the robot of a document, if it is the only one there."""
    library, name = library_of(document), document.path.name
    if library is None:
        return None
    simulations = library.of_project(document.path, _Simulations)
    for span, words, files, wanted in simulations.creations:
        others = files - {name} if name in words else ()
        file = next(iter(others)) if len(others) == 1 else ""
        if (world := simulations.worlds.get(file)) is not None:
            return LaunchedWorld(file, *world, span, wanted)
    return None


def _world(text: str) -> tuple[str, frozenset[str], bool] | None:
    """The name of the only world of a text, its systems, and whether nothing in it is static; else None."""
    names = _WORLD.findall(text)
    return (
        (names[0], frozenset(_SYSTEM.findall(text)), _SUPPORT.search(text) is None)
        if len(names) == 1
        else None
    )


# States of joints.

_STATES = re.compile(r"joint[-_]?states?|publish_?wheel_?tf|pose[-_]?publisher|ros2?_control", re.IGNORECASE)
"""Words of whatever may publish states, or transforms of wheels."""
_BRIDGE = re.compile(r"^.*_topic_name.*$|(?<![\w/])[\w/]{1,200}@[^\s\"']+", re.MULTILINE)
"""Entries of a bridge, which carries the states of others."""
_TRANSFORMER = "robot_state_publisher"
_NODE = re.compile(r"\b(?:package|pkg)\s*=\s*[\"']?(\w+)")
_PUBLISHERS = re.compile(r"joint_state_(?:publisher|broadcaster|controller)|ros2?_control")
_IMPORT = re.compile(r"^(?:from|import)\b.*$", re.MULTILINE)
_VIEWERS = frozenset((_TRANSFORMER, "rviz", "rviz2", "tf2_ros"))
"""Packages of nodes that show a robot, and have no states of joints."""


class _States:
    """The first place where a project makes transforms of the states of joints, if nothing in it has these."""

    def __init__(self, packages: Packages) -> None:
        self.started: Span | None = None
        self.is_shown = False
        """Is the robot shown by RViz, and does no launch file start a node of which that is not known?"""
        launches = {path: _without_bridges(text) for path, text in launch_texts(packages)}
        self.is_left_to_gazebo = any(_TRANSFORMER in text for text in launches.values()) and not any(
            map(_PUBLISHERS.search, launches.values())
        )
        """Are transforms made of states that no node publishes which a launch file starts?"""
        started = next((path for path, text in launches.items() if _TRANSFORMER in text), None)
        if started is None or any(map(_STATES.search, launches.values())):
            return
        texts = _texts(packages, (*_DESCRIPTIONS, *_PROGRAMS, ".yaml", ".yml"))
        if texts is None or any(map(_STATES.search, map(_without_bridges, texts.values()))):
            return
        start = launches[started].index(_TRANSFORMER)
        source = Source(started, launches[started], is_foreign=True)
        self.started = Span(source, start, start + len(_TRANSFORMER))
        nodes = {name for text in launches.values() for name in _NODE.findall(text)}
        is_alone = nodes <= _VIEWERS and not any(
            "nclude" in _without_imports(text) for text in launches.values()
        )
        self.is_shown = is_alone and not nodes.isdisjoint(("rviz", "rviz2"))


def _without_imports(text: str) -> str:
    return _IMPORT.sub("", text)


def _without_bridges(text: str) -> str:
    """A text with blanks in place of remarks and of entries of bridges."""
    bare = _REMARK.sub(lambda match: " " * len(match[0]), text)
    return (
        _BRIDGE.sub(lambda match: " " * len(match[0]), bare) if "_topic_name" in bare or "@" in bare else bare
    )


def lost_states(document: Document) -> Span | None:
    """Where a project makes transforms of the states of joints, although nothing in it publishes these."""
    library = library_of(document)
    if library is None or _STATES.search(_without_bridges(document.source.text)) is not None:
        return None
    return library.of_project(document.path, _States).started


def is_shown_alone(document: Document) -> bool:
    """Is all that the launch files of a project do to show a robot in RViz?"""
    library = library_of(document)
    return library is not None and library.of_project(document.path, _States).is_shown


def unstarted_broadcaster(document: Document, broadcaster: str, others: Collection[str]) -> bool:
    """Do launch files start other controllers of a file of parameters, and not the one that publishes states?"""
    library = library_of(document)
    started = library.of_project(document.path, _Started) if library is not None else None
    if started is None or started.is_open or broadcaster in started.words:
        return False
    return not started.words.isdisjoint(others) and "spawner" in started.words


def has_other_states(document: Document) -> bool:
    """May a node that the project starts publish states of joints, or make no transforms of them at all?"""
    library = library_of(document)
    return library is None or not library.of_project(document.path, _States).is_left_to_gazebo


# Parameters that YAML does not take.

_TAB = re.compile(r"^ *\t[ \t]*(?=[\w\"'-])", re.MULTILINE)


def tabs_in_parameters(document: Document) -> Iterator[Span]:
    """The first tab before an entry of each file in YAML of the package of a document that cannot be read for it."""
    around = package_around(document.path)
    library = library_of(document)
    if around is not None and library is not None:
        folder = os.path.join(around[0], "")
        yield from (
            span
            for span in library.of_project(document.path, _Tabs).spans
            if os.fspath(span.source.path).startswith(folder)
        )


class _Tabs:
    """The first tab of each file in YAML of a project that cannot be read, and has one before an entry."""

    def __init__(self, packages: Packages) -> None:
        self.spans: list[Span] = []
        left = _MOST_PARSED
        for path in _files(packages, (".yaml", ".yml")):
            text = _text(path, LARGEST)
            match = _TAB.search(text)
            if match is None or PARAMETERS not in text or (left := left - len(text)) < 0:
                continue
            before = text[: match.start()]
            is_bare = sum(map(before.count, "[{")) == sum(map(before.count, "]}"))
            if is_bare and composed(text) is None:
                source = Source(path, text, is_foreign=True)
                self.spans.append(Span(source, match.start(), match.end()))


# Frames.


class BaseFrame(NamedTuple):
    """A frame that a node of ROS takes for the base of the robot; a parameter of no node is named itself."""

    node: str
    name: str
    span: Span
    is_odometry: bool = False
    """Does the node publish where the frame is in that of the odometry?"""


class _Frames:
    """The frames that nodes of a project take for the bases of its robots, and the names in its other files."""

    def __init__(self, packages: Packages) -> None:
        self._packages = packages
        self._named: Set[str] | None = None
        self._sources: list[Source] = []
        left = _MOST_PARSED
        for path in _files(packages, (".yaml", ".yml")):
            text = _text(path, LARGEST)
            if _BASE.search(text) and (left := left - len(text)) >= 0:
                self._sources.append(Source(path, text, is_foreign=True))
        self.names = frozenset(name for source in self._sources for name in _BASE.findall(source.text))

    @lazy
    def given(self) -> tuple[BaseFrame, ...]:
        """The frames that nodes give, by all files."""
        return tuple(each for source in self._sources for each in _bases(source))

    @lazy
    def filters(self) -> tuple[BaseFrame, ...]:
        """The filters of robot_localization that publish the odometry, and that a launch file starts with Gazebo."""
        texts = (_REMARK.sub("", text) for _, text in launch_texts(self._packages) if _FILTER in text)
        launches = [text for text in texts if _GAZEBO.search(text) and not _CONDITION.search(text)]
        words = frozenset(chain.from_iterable(map(_NAMES.findall, launches)))
        return tuple(
            each
            for source in self._sources
            if source.path.name in words
            for each in _bases(source)
            if each.is_odometry
        )

    def is_named(self, name: str) -> bool:
        """Does a description, launch file or program of the project have a name?"""
        if self._named is None:
            texts = _texts(self._packages, (*_DESCRIPTIONS, *_PROGRAMS))
            found = (self.names.intersection(_NAME.findall(text)) for text in (texts or {}).values())
            self._named = self.names if texts is None else frozenset().union(*found)
        return name in self._named


def _bases(source: Source) -> Iterator[BaseFrame]:
    """The frames that nodes take for the base of a robot, by a file of parameters."""
    waiting = [("", composed(source.text))]
    seen: set[int] = set()
    while waiting:
        node, mapping = waiting.pop()
        if id(mapping) in seen:
            continue
        seen.add(id(mapping))
        given = dict(pairs(mapping))
        waiting += [(node if name == PARAMETERS else name, value) for name, value in given.items()]
        for name in ("robot_base_frame", *_NODE_OF, *_BESIDE):
            value = given.get(name)
            is_meant = node.startswith(_NODE_OF.get(name, "")) and _BESIDE.get(name, name) in given
            if value is not None and value.id == "scalar" and is_meant:
                yield BaseFrame(node or name, value.value, span_of(source, value), _is_odometry(given))


def _is_odometry(given: Mapping[str, Any]) -> bool:
    """Does a filter with such parameters publish the transform of the odometry?"""
    texts = {
        name: getattr(given.get(name), "value", None) for name in ("odom_frame", "world_frame", "publish_tf")
    }
    is_off = str(texts["publish_tf"]).lower() == "false"
    return not is_off and texts["odom_frame"] is not None and texts["odom_frame"] == texts["world_frame"]


def odometry_filters(document: Document) -> tuple[BaseFrame, ...]:
    """The filters that publish the odometry of a robot, where a launch file of the project starts them with Gazebo."""
    library = library_of(document)
    return library.of_project(document.path, _Frames).filters if library is not None else ()


def missing_bases(document: Document, links: Collection[str]) -> Iterator[BaseFrame]:
    """The frames that nodes of the project take for the base of a robot, and that nothing in the project has."""
    library = library_of(document)
    if library is None:
        return
    frames = library.of_project(document.path, _Frames)
    for name in sorted(frames.names.difference(links)):
        is_prefixed = any(name.endswith(link) for link in links)
        if not is_prefixed and not frames.is_named(name):
            yield from (each for each in frames.given if each.name == name)
