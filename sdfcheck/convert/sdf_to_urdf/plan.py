"""The choices of a user, what is decided before anything is written, and the context of all that write."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from enum import Enum
from pathlib import Path

import numpy as np

from sdfcheck.convert.ledger import Ledger, models
from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.writer import PACKAGES, numbers
from sdfcheck.files.uris import scheme_of
from sdfcheck.formats.near_names import suggest
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.robot.graph import Model
from sdfcheck.robot.motion.mechanism import Joint, Mechanism
from sdfcheck.robot.motion.poses import Array, Poses, angle_between, inverse, to_rpy, written_pose
from sdfcheck.robot.part import Node as RobotNode
from sdfcheck.robot.resources import names_file
from sdfcheck.source.altered import Xml
from sdfcheck.source.document import Document, Element
from sdfcheck.source.errors import WrongUsage
from sdfcheck.source.text import relative_path

# The choices of a user about the URDF that an SDF model becomes.


class Unsupported(Enum):
    """The treatment of a joint or forest that URDF cannot express."""

    FLOATING = "floating"
    FIXED = "fixed"
    ERROR = "error"


class Loops(Enum):
    """The treatment of joints that close loops."""

    ERROR = "error"
    CUT = "cut"


class Planes(Enum):
    """The treatment of planes."""

    DROP = "drop"
    BOX = "box"


@dataclass(frozen=True, slots=True)
class Options:
    """Choices; the defaults lose the least."""

    model: str = ""
    """The model to convert, where the file has several."""
    keep_link_frames: bool = False
    """Links keep their frames; a link that is not at its joint gets a massless one in front."""
    frames: bool = False
    """Frames become massless links."""
    ball: Unsupported = Unsupported.FLOATING
    """The replacement of a ball joint."""
    forest: Unsupported = Unsupported.FLOATING
    """How free links are tied to the one root that URDF demands."""
    loops: Loops = Loops.ERROR
    """Whether a joint that closes a loop may be left to libsdformat."""
    planes: Planes = Planes.DROP
    """Whether a flat box may replace a plane."""
    unlimited: float = 1e16
    """The number that is written for an infinite limit."""
    package_uris: bool = False
    """Uris ``model://x`` are written ``package://x``, which consumers of URDF resolve."""


# Poses and directions as URDF writes them.

_ROUNDING = 1e-14
_SHORT = 12
"""A number that reads the same to 15 digits with so few characters was meant to be written so."""


def shortened(values: Array | tuple[float, ...]) -> str:
    """Numbers without the rounding in their last digits, separated by spaces."""
    return numbers(_shorter(float(value)) for value in values)


def _shorter(value: float) -> float:
    short = f"{value:.14g}"
    return float(short) if len(short) <= _SHORT else value


def add_origin(node: Xml, pose: Array, *authors: Element | None) -> None:
    """Write a pose, in the words of an author who wrote the same; that of the parent itself is not written."""
    found = (texts for element in authors if (texts := _in_words(element, pose)) is not None)
    position, angles = next(found, None) or (shortened(pose[:3, 3]), shortened(to_rpy(pose[:3, :3])))
    attributes = {}
    if position != "0 0 0":
        attributes["xyz"] = position
    if angles != "0 0 0":
        attributes["rpy"] = angles
    if attributes:
        node.add("origin", **attributes)


def _in_words(element: Element | None, pose: Array) -> tuple[str, str] | None:
    """Position and angles as a ``pose`` element has them, if it is this pose in plain numbers."""
    if element is None or element.attributes.get("rotation_format") or element.attributes.get("degrees"):
        return None
    words = ["0" if float(word) == 0 else word for word in element.content.split()]
    if len(words) != 6 or np.abs(written_pose(element) - pose).max() > _ROUNDING:
        return None
    return " ".join(words[:3]), " ".join(words[3:])


def pose_text(pose: Array) -> str:
    """A pose as SDF writes it."""
    return f"{shortened(pose[:3, 3])} {shortened(to_rpy(pose[:3, :3]))}"


def is_identity(pose: Array) -> bool:
    return bool(np.abs(pose - np.eye(4)).max() < 1e-12)


# Names in the URDF: one scope, in which links and joints share no name.


class Naming:
    """Hands out names that nobody has."""

    def __init__(self, taken: Iterable[str] = ()) -> None:
        self._taken = set(taken)

    def unique(self, wanted: str, otherwise: str = "") -> str:
        """The wanted name, or else the other one, or else a numbered one."""
        name = plain = wanted.replace("::", "__")
        if name in self._taken and otherwise:
            name = plain = otherwise.replace("::", "__")
        number = 2
        while name in self._taken:
            name = f"{plain}_{number}"
            number += 1
        self._taken.add(name)
        return name


def named(
    robot: Mechanism, frames: Iterable[str], kept: Iterable[str] = ()
) -> tuple[Naming, Mapping[str, str], Mapping[str, str], Mapping[str, str]]:
    """The names of links, of joints and of frames, by those of the source; ``kept`` are further joints.

    Names without a scope are given out first: they stay what they are.
    """
    naming = Naming({"world"})
    links = {name: naming.unique(name) for name in sorted(robot.links, key=_depth)}
    joints = {
        name: naming.unique(name, f"{name}_joint") for name in sorted([*robot.joints, *kept], key=_depth)
    }
    places = {name: naming.unique(name) for name in sorted(frames, key=_depth)}
    return naming, links, joints, places


def _depth(name: str) -> int:
    return name.count("::")


# The one model of a file that is to become a robot.


def choose(document: Document, name: str) -> Model:
    """The model of a name, or the only one.

    Raises: WrongUsage: the file has no model, or several and no name was given.
    """
    found = models(document)
    names = [scope.name for scope in found]
    if not found:
        raise WrongUsage(f"{document.path} has no model")
    if not name:
        if len(found) > 1:
            raise WrongUsage(f"{document.path} has several models; choose one with --model: {_list(names)}")
        return found[0]
    if name not in names:
        near = suggest(name, names)
        hint = f", did you mean `{near}`?" if near else f"; it has {_list(names)}"
        raise WrongUsage(f"{document.path} has no model `{name}`{hint}")
    return found[names.index(name)]


def _list(names: list[str]) -> str:
    shown = ", ".join(names[:20])
    return shown if len(names) <= 20 else f"{shown} and {len(names) - 20} more"


def others(document: Document, chosen: Model) -> Iterator[Element]:
    """The parts beside the chosen model: other models, lights, physics and the rest of its world."""
    at: Element | None = chosen.place
    while at is not None and at is not document.root:
        around = at.parent
        if around is not None:
            yield from (child for child in around.children() if child is not at and not child.is_custom)
        at = around


# Which joints make the tree that URDF demands, and which way round they go.


WORLD = "world"


@dataclass(frozen=True, slots=True)
class Edge:
    """A joint of the tree, from its parent there to its child there."""

    joint: Joint
    parent: str
    child: str

    @property
    def is_reversed(self) -> bool:
        """Is the joint's parent the child in the tree?"""
        return self.parent != self.joint.parent


@dataclass(slots=True)
class Arrangement:
    """A forest: its edges in document order, the tops of its trees, the joints left over."""

    edges: list[Edge]
    tops: list[str]
    """The links that no edge carries; the first is the one that holds the canonical link."""
    loops: list[Joint] = field(default_factory=list)
    has_world: bool = False

    @property
    def carriers(self) -> dict[str, Edge]:
        return {edge.child: edge for edge in self.edges}


def arrange(robot: Mechanism, canonical: str) -> Arrangement:
    """The forest in which every tree begins at the world, at the top above the canonical link, or where no
    joint carries a link."""
    chosen = robot.spanning()
    beside: dict[str, list[Joint]] = {}
    for joint in chosen:
        for end in (joint.parent, joint.child):
            beside.setdefault(end, []).append(joint)
    edges: dict[str, Edge] = {}
    tops: list[str] = []
    placed: set[str] = set()
    for start in (WORLD, _top(robot, canonical), *robot.roots(), *robot.links):
        if start in placed or (start not in robot.links and start not in beside):
            continue
        tops.append(start)
        for edge in _outwards(start, beside, placed):
            edges[edge.joint.name] = edge
    has_world = WORLD in tops
    if has_world:
        tops.remove(WORLD)
    kept = [edges[name] for name in robot.joints if name in edges]
    return Arrangement(kept, tops, robot.loops(), has_world)


def _outwards(start: str, beside: dict[str, list[Joint]], placed: set[str]) -> Iterator[Edge]:
    """The edges of one tree; nearest to its top first."""
    placed.add(start)
    waiting = [start]
    for here in waiting:
        for joint in beside.get(here, ()):
            there = joint.child if here == joint.parent else joint.parent
            if there not in placed:
                placed.add(there)
                waiting.append(there)
                yield Edge(joint, here, there)


def _top(robot: Mechanism, link: str) -> str:
    """The link at the top of the tree that a link is in."""
    carriers = {joint.child: joint for joint in robot.tree()}
    while link in carriers and carriers[link].parent != WORLD:
        link = carriers[link].parent
    return link


# Where the links of the URDF are: each at the joint that carries it.


SAME = 1e-12
"""Frames that are nearer than this (m, rad) are one."""


@dataclass(frozen=True, slots=True)
class Layout:
    """The frames of the URDF's links, as 4×4 poses in the model's frame, by the names of the source.

    ``joint_links`` are massless links before links which keep their frame, with
    the frames of those: the joint carries them.
    """

    frames: Mapping[str, Array]
    joint_links: Mapping[str, tuple[str, Array]]

    def within(self, link: str, pose: Array) -> Array:
        """A pose of the model's frame in the frame of a link."""
        return tidy(inverse(self.frames[link]) @ pose)


def lay_out(robot: Mechanism, made: Arrangement, world: Array, *, keep: bool, naming: Naming) -> Layout:
    """Frames for all links; ``world`` is the pose of the world in the model's frame."""
    frames: dict[str, Array] = {WORLD: world}
    joint_links: dict[str, tuple[str, Array]] = {}
    carriers = made.carriers
    for name, link in robot.links.items():
        edge = carriers.get(name)
        if edge is None or is_same(edge.joint.pose, link.pose):
            frames[name] = link.pose
        elif keep:
            frames[name] = link.pose
            joint_links[name] = (naming.unique(f"{name}__joint"), edge.joint.pose)
        else:
            frames[name] = edge.joint.pose
    return Layout(frames, joint_links)


def is_same(a: Array, b: Array) -> bool:
    near = float(np.linalg.norm(a[:3, 3] - b[:3, 3])) < SAME
    return near and angle_between(a[:3, :3], b[:3, :3]) < SAME


def tidy(pose: Array) -> Array:
    """The pose without the dust of rounding around zero and one."""
    result: Array = pose.copy()
    result[np.abs(result) < 1e-15] = 0.0
    turn = result[:3, :3]
    turn[np.abs(turn - 1) < 1e-15] = 1.0
    turn[np.abs(turn + 1) < 1e-15] = -1.0
    return result


# The shared state of the writers of links, joints and extensions.


@dataclass(slots=True)
class Context:
    """One conversion under way."""

    scope: Model
    poses: Poses
    read: Mechanism
    """The model as it was read."""
    robot: Mechanism
    """The model as it is understood."""
    frames: Mapping[str, RobotNode]
    """Links, joints, frames and nested models of the model, by name."""
    made: Arrangement
    layout: Layout
    naming: Naming
    links: Mapping[str, str]
    """Source name → name in the URDF."""
    joints: Mapping[str, str]
    frame_names: Mapping[str, str]
    options: Options
    folder: Path
    """That of the source, from where relative addresses of the result lead."""
    ledger: Ledger
    root: Xml
    dropped_shapes: set[Element] = field(default_factory=set)
    between: set[str] = field(default_factory=set)
    """Links of the URDF that are no more than a place between two joints, with a mass that is given to them."""
    heavier: set[str] = field(default_factory=set)
    """Source links whose mass is written as one that libsdformat takes for a mass."""
    begins_in_world: bool = False
    """Is the URDF's root a link for the world?"""
    blobs: dict[str, Xml] = field(default_factory=dict)
    """The ``gazebo`` elements by what they refer to, written last."""
    namespaces: dict[str, str] = field(default_factory=dict)
    """Prefix → what it is at the root of the result."""
    parts: dict[str, tuple[str, ...]] = field(default_factory=dict)
    """Source joint → the joints for each of its axes."""
    kept: set[str] = field(default_factory=set)
    """Source joints that are kept as SDFormat, with all that is in them."""
    floating: set[str] = field(default_factory=set)
    """Source joints whose positions have no equal in the result."""
    unmimicked: set[str] = field(default_factory=set)
    """Source joints that follow another, which URDF cannot say."""
    natives: frozenset[str] = frozenset()
    """Shapes that only Drake has, and that the description is written for."""
    actuators: dict[str, list[Xml]] = field(default_factory=dict)
    """Joint of the URDF → what vendors say of its actuator."""
    drake_frames: dict[str, str] = field(default_factory=dict)
    """Source link or frame → the frame that is written for Drake."""
    colors: dict[str, str] = field(default_factory=dict)
    """Color → the material that has it."""

    def link_name(self, name: str) -> str:
        return self.links.get(name, name)

    def blob(self, reference: str = "") -> Xml:
        """The ``gazebo`` element for a link or joint, or for the whole robot."""
        if reference not in self.blobs:
            self.blobs[reference] = Xml("gazebo", reference=reference) if reference else Xml("gazebo")
        return self.blobs[reference]


# Uris of meshes and textures, as they lead from beside the source.


def mesh_uri(context: Context, uri: str, element: Element) -> str:
    """The uri to write for a mesh or texture that an element of the source names."""
    package = uri.removeprefix("model://").partition("/")[0]
    given_back = package in context.scope.element.attributes.get(PACKAGES, "").split()
    if (context.options.package_uris or given_back) and uri.startswith("model://"):
        written = f"package://{uri.removeprefix('model://')}"
        context.ledger.note(
            LossKind.CHANGED_URI, element, f"`{uri}` is written as `{written}`", Severity.INFO
        )
        return written
    return _seen_from_source(context, uri, element)


def _seen_from_source(context: Context, uri: str, element: Element) -> str:
    """A relative path is meant from the file that it is in, which may be an included one."""
    here = element.document.path.parent
    if (
        not uri
        or scheme_of(uri)
        or uri.startswith("/")
        or os.path.realpath(here) == os.path.realpath(context.folder)
    ):
        return uri
    return Path(relative_path(here / uri, context.folder)).as_posix()


def find_files(context: Context) -> None:
    """Let copies of elements of included files lead to the files beside those."""
    for node in context.root.walk():
        if node.origin is not None and names_file(node):
            beside = os.path.join(node.origin.document.path.parent, node.content)
            if os.path.exists(beside):
                node.write(_seen_from_source(context, node.content, node.origin))
