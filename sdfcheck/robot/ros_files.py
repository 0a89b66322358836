"""Nodes, worlds and frames that YAML and launch files of a project name, beside its robots.

Source: controller_manager and ros_gz_sim for nodes and arguments, and Nav2, slam_toolbox and robot_localization for
frames. Nothing of a launch file runs.
"""

from __future__ import annotations

import os
import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence, Set
from itertools import chain, islice
from pathlib import Path
from typing import Any

from sdfcheck.files.library import library_of
from sdfcheck.files.packages import YAML, Packages, package_around
from sdfcheck.files.regular import read_regular
from sdfcheck.robot.controllers import LARGEST, PARAMETERS, Parameter, composed, pairs, span_of
from sdfcheck.robot.values import lazy
from sdfcheck.source.document import Document
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.text import Source, Span, pattern
from sdfcheck.xacro.static.launches import launch_texts

MOST_FILES = 300
"""So many files of each kind are looked through, and so many of them with a bridge are read."""
_MOST_SAID = 256 * 1024
"""Bytes of a description of which the topics are known."""
_MOST_TEXT = 16 * 1024 * 1024
"""Bytes of descriptions and programs of a project that are searched for names; in more anything may be named."""
MOST_PARSED = 256 * 1024
"""Bytes of YAML, and of launch files, that are parsed for a project; in more anything may be carried."""
REMARK = pattern(r"^[ \t]*#.*$|<!--[\s\S]*?(?:-->|\Z)", re.MULTILINE)
_NAME = pattern(r"\w+")
_NAMES = pattern(r"[\w.-]+")
"""Words, and names of files."""
DESCRIPTIONS = (".sdf", ".world", ".urdf", ".xacro", ".gazebo")

_BASE = pattern(
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


# The files of a project, and their texts.


def project_files(packages: Packages, suffixes: Iterable[str]) -> Iterator[Path]:
    """The files of some suffixes, so many of each."""
    for suffix in suffixes:
        yield from packages.files(suffix, MOST_FILES)


def absolute(path: Path) -> Path:
    """A path as the files of a project are listed: the one that was named may be relative."""
    return Path(os.path.abspath(path))


def text_of(path: Path, most: int) -> str:
    """The text of a file of at most so many bytes; empty where it cannot be read."""
    try:
        return read_regular(path, most).decode("utf-8-sig", "replace")
    except OSError:
        return ""


def project_texts(packages: Packages, suffixes: Iterable[str]) -> dict[Path, str] | None:
    """The texts of the files of some suffixes; None where there is too much of them."""
    found: dict[Path, str] = {}
    left = _MOST_TEXT
    for path in project_files(packages, suffixes):
        found[path] = text_of(path, _MOST_SAID)
        left -= len(found[path])
        if left < 0:
            return None
    return found


# Controllers.

_TYPED_ELSEWHERE = pattern(
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
        files = ((path, text_of(path, LARGEST)) for path in project_files(packages, YAML))
        self.typed = {path: frozenset(_NAMES.findall(text)) for path, text in files if "type:" in text}


def started_untyped(document: Document, nodes: Sequence[Parameter]) -> Iterator[Parameter]:
    """The nodes with parameters of a controller that launch files start, and to which no file gives a type."""
    library = library_of(document)
    started = library.of_project(document.path, _Started) if library is not None and nodes else None
    if started is None or started.is_open:
        return
    for node in nodes:
        own = absolute(node.span.source.path)
        others = (words for path, words in started.typed.items() if path != own)
        if node.name in started.words and not any(node.name in words for words in others):
            yield node


_MANAGER = "ros2_control_node"
_GAZEBO = pattern(r"\b(?:gazebo_ros|ros_gz_sim|ros_ign_gazebo|spawn_entity)\b")
_CONDITION = pattern(
    r"\b(?:If|Unless)\w*Condition\b|\bcondition\s*=|\b(?:if|unless)\s*=\s*[\"']|OpaqueFunction"
)


class _Managers:
    """The places where a launch file of a project starts Gazebo and a controller manager, in any case."""

    def __init__(self, packages: Packages) -> None:
        self.found: list[tuple[Span, frozenset[str]]] = []
        said: dict[str, frozenset[str]] = {}
        for path, text in launch_texts(packages):
            bare = REMARK.sub(lambda match: " " * len(match[0]), text)
            if _CONDITION.search(bare):
                continue
            words = frozenset(_NAMES.findall(bare))
            said[path.name] = words if path.name not in said else frozenset()
            start = bare.find(_MANAGER)
            if start >= 0 and _GAZEBO.search(bare) and len(self.found) < MOST_FILES:
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

_NEW_GAZEBO = pattern(r"\bros_(?:gz|ign)_(?:sim|gazebo)\b")
_CREATED = pattern(r"(?:executable|exec)\s*=\s*[\"']create[\"']")
_INTO = pattern(r"[\"']-world[\"']\s*,\s*[\"'](\w{1,100})[\"']")
_WORLDS = (".sdf", ".world")
_WORLD = pattern(r"<world\s[^<>]{0,200}?name\s{0,20}=\s{0,20}[\"']([^\"'<>]{1,100})[\"']")
_SUPPORT = pattern(r"<include|xacro:|<static>|<gravity|\$[{(]|<%|type\s*=\s*[\"']fixed[\"']")
"""Words of a world in which something may be there to stand on, or of which not all is known."""
_SYSTEM = pattern(r"(?:gz-sim|ignition-gazebo)\d*-([a-z][\w-]{1,60}?)-system\b")
_TIME = "use_sim_time"
_TIMED = pattern(r"use_sim_time[\"']?\s{0,20}(?:[:,=]|value\s{0,20}=)\s{0,20}(?:\(\s{0,20})?[\"']?[Tt]rue\b")
_CLOCK = pattern(r"clock", re.IGNORECASE)
_SHARE = pattern(
    r"(?:get_package_share_(?:directory|path)|FindPackageShare)\(\s*(?:package\s*=\s*)?([\"']?\w+)|"
    r"\$\(find-pkg-share\s+(\w+)"
)
_GIVEN = pattern(r"\b(\w{1,100})\s{0,20}=\s{0,20}[\"'](\w{1,100})[\"']")
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


class Simulations:
    """The launch files of a project that start the new Gazebo, with their words and those of what they include."""

    def __init__(self, packages: Packages) -> None:
        said: dict[str, frozenset[str]] = {}
        found: list[tuple[Path, str, frozenset[str]]] = []
        for path, text in launch_texts(packages):
            bare = REMARK.sub(lambda match: " " * len(match[0]), text)
            words = frozenset(_NAMES.findall(bare))
            said[path.name] = words if path.name not in said else frozenset()
            if _NEW_GAZEBO.search(bare) and len(found) < MOST_FILES:
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
            texts = project_texts(packages, (*DESCRIPTIONS, ".erb")) or {}
            for path, text in texts.items():
                if path.suffix in _WORLDS and "<world" in text:
                    worlds[path.name] = "" if path.name in worlds else REMARK.sub("", text)
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
        texts = project_texts(packages, (*_PROGRAMS, *YAML)) if found is not None else None
        if texts is None or any(_CLOCK.search(REMARK.sub("", text)) for text in texts.values()):
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


def is_served(document: Document, systems: Collection[str]) -> bool:
    """Does a description of the project list one of some systems of Gazebo, by their files?"""
    library = library_of(document)
    listed = library.of_project(document.path, Simulations).systems if library is not None else ()
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
    simulations = library.of_project(document.path, Simulations)
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

_STATES = pattern(r"joint[-_]?states?|publish_?wheel_?tf|pose[-_]?publisher|ros2?_control", re.IGNORECASE)
"""Words of whatever may publish states, or transforms of wheels."""
_BRIDGE = pattern(r"^.*_topic_name.*$|(?<![\w/])[\w/]{1,200}@[^\s\"']+", re.MULTILINE)
"""Entries of a bridge, which carries the states of others."""
_TRANSFORMER = "robot_state_publisher"
_NODE = pattern(r"\b(?:package|pkg)\s*=\s*[\"']?(\w+)")
_PUBLISHERS = pattern(r"joint_state_(?:publisher|broadcaster|controller)|ros2?_control")
_IMPORT = pattern(r"^(?:from|import)\b.*$", re.MULTILINE)
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
        texts = project_texts(packages, (*DESCRIPTIONS, *_PROGRAMS, *YAML))
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
    bare = REMARK.sub(lambda match: " " * len(match[0]), text)
    return (
        _BRIDGE.sub(lambda match: " " * len(match[0]), bare) if "_topic_name" in bare or "@" in bare else bare
    )


def lost_states(document: Document) -> Span | None:
    """Where a project makes transforms of the states of joints, although nothing in it publishes these."""
    library = library_of(document)
    started = library.of_project(document.path, _States).started if library is not None else None
    if started is None or _STATES.search(_without_bridges(document.source.text)) is not None:
        return None
    return started


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

_TAB = pattern(r"^ *\t[ \t]*(?=[\w\"'-])", re.MULTILINE)


def tabs_in_parameters(document: Document) -> Iterator[Span]:
    """The first tab before an entry of each file in YAML of the package of a document that cannot be read for it."""
    library = library_of(document)
    spans = library.of_project(document.path, _Tabs).spans if library is not None else ()
    around = package_around(document.path) if spans else None
    if around is not None:
        folder = os.path.join(around[0], "")
        yield from (span for span in spans if os.fspath(span.source.path).startswith(folder))


class _Tabs:
    """The first tab of each file in YAML of a project that cannot be read, and has one before an entry."""

    def __init__(self, packages: Packages) -> None:
        self.spans: list[Span] = []
        left = MOST_PARSED
        for path in project_files(packages, YAML):
            text = text_of(path, LARGEST)
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
        left = MOST_PARSED
        for path in project_files(packages, YAML):
            text = text_of(path, LARGEST)
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
        texts = (REMARK.sub("", text) for _, text in launch_texts(self._packages) if _FILTER in text)
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
            texts = project_texts(self._packages, (*DESCRIPTIONS, *_PROGRAMS))
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
