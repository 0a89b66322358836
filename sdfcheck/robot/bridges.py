"""Bridges between ROS and Gazebo, in YAML and launch files of a project, beside the topics of its robots.

Source: gz-sensors 8 to 10 and the systems of gz-sim 8 to 10 for topics, ros_gz_bridge for YAML and arguments. Nothing
of a launch file runs: topics that it computes are not known, and then nothing is said about messages of that type.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence, Set
from itertools import chain, islice
from pathlib import Path
from typing import Any

from sdfcheck.files.library import library_of
from sdfcheck.files.packages import YAML, Packages
from sdfcheck.robot.controllers import LARGEST, UNKNOWN, composed, pairs, span_of
from sdfcheck.robot.graph import Plugin, Sensor
from sdfcheck.robot.ros_files import (
    DESCRIPTIONS,
    MOST_FILES,
    MOST_PARSED,
    REMARK,
    Simulations,
    absolute,
    project_files,
    project_texts,
    text_of,
)
from sdfcheck.source.document import Document, Value
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.text import Source, Span, pattern
from sdfcheck.xacro.language import syntax_tree
from sdfcheck.xacro.static.launches import launch_texts

_MOST_CARRIED = 1000
_DEEPEST = 8
_MOST_MERGED = 100
_KEYS = ("gz_topic_name", "ign_topic_name")
_TYPES = ("gz_type_name", "ign_type_name")
_ARGUMENT = pattern(r"([^\s@{}$\"'<>%]{1,300})@[\w/]{1,200}([@\[\]])(?:gz|ignition)\.msgs\.(\w+)")
"""An argument of ``parameter_bridge``: topic, type in ROS, direction, type in Gazebo."""
_TYPE = pattern(r"[@\[\]](?:gz|ignition)\.msgs\.(\w+)")
_ELSEWHERE = pattern(r"gz_topic_name|expand_gz_topic_names")
"""A program that writes a bridge, or a bridge that puts the name of the model before all topics."""
_WORD = pattern(r"[a-z]+|\d+")
_SAID = pattern(r">\s{0,50}/?([A-Za-z_~][\w./~-]{0,200})\s{0,50}<")
_MOST_TOPICS = 5_000
"""A description with more texts like topics may have any."""
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
_REFUSED_NAME = pattern(r"[^\w/~]|//|/\Z|(?:^|/)\d")


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
        files = ((path, text_of(path, LARGEST)) for path in project_files(packages, YAML))
        entries = ((path, text) for path, text in files if any(key in text for key in _TYPES))
        for path, text in self._within(entries):
            source, node = Source(path, text, is_foreign=True), composed(text)
            self._take(list(_of_yaml(source, node)))
            self.faults += islice(_faults(source, node), _MOST_CARRIED - len(self.faults))

    def _within(self, texts: Iterable[tuple[Path, str]]) -> Iterator[tuple[Path, str]]:
        """The first texts, as far as they may be parsed; with more of them all types are unknown."""
        left = MOST_PARSED
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
            texts = project_texts(self._packages, DESCRIPTIONS)
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


def _topics(text: str) -> tuple[frozenset[str], bool]:
    """The texts of a description that may be topics, and whether it has sensors whose topics are not known."""
    bare = REMARK.sub("", text)
    sensors = (after.partition("</sensor>")[0] for after in bare.split("<sensor")[1:])
    is_open = any("<topic>" not in each or "$" in each for each in sensors)
    topics = frozenset(each.rstrip("/") for each in _SAID.findall(bare))
    return (topics, is_open) if len(topics) < _MOST_TOPICS else (frozenset(), True)


def _of_launch(source: Source, unknown: set[str]) -> Iterator[Bridged]:
    """The topics that a launch file gives to its bridges; adds types of messages that it computes to ``unknown``."""
    text = REMARK.sub(lambda match: " " * len(match[0]), source.text)
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
    bridges = library.of_project(document.path, _Bridges) if library is not None else None
    if bridges is None or not bridges.carried or "" in bridges.unknown:
        return
    if not (ends := [*_of_sensors(sensors), *_of_systems(plugins)]):
        return
    sources = (document.source, *(end.part.element.span.source for end in ends))
    own = {Path(source.real_path) for source in sources} | {absolute(source.path) for source in sources}
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
    refused = library.of_project(document.path, _Bridges).faults if library is not None else ()
    ends = [*_of_sensors(sensors), *_of_systems(plugins)] if refused else ()
    found: dict[tuple[Path, str], BridgeFault] = {}
    for fault in refused if ends else ():
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
    for sensor in islice(sensors, MOST_FILES):
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
    for plugin in islice(plugins, MOST_FILES):
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


def unbridged_clock(document: Document) -> Span | None:
    """Where a launch file that names a robot takes the time of Gazebo, which no bridge of the project carries."""
    library = library_of(document)
    timed = library.of_project(document.path, Simulations).timed if library is not None else None
    if library is None or timed is None or document.path.name not in timed[1]:
        return None
    bridges = library.of_project(document.path, _Bridges)
    return timed[0] if bridges.carried and "" not in bridges.unknown else None
