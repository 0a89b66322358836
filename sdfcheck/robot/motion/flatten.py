"""Makes one mechanism of a model: nested and included models become names of links and joints."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import replace

import numpy as np

from sdfcheck.robot.graph import Axis, Joint, Link, Model
from sdfcheck.robot.motion import mechanism
from sdfcheck.robot.motion.mechanism import Geometry, Mechanism, Mimic
from sdfcheck.robot.motion.origin import numbers_of, urdf_number
from sdfcheck.robot.motion.poses import Array, inverse, origin_of
from sdfcheck.robot.part import Node
from sdfcheck.robot.values import Number
from sdfcheck.source.document import Element
from sdfcheck.source.errors import DescriptionError

# Joints that only one simulator knows: ``drake:joint``.


_IN_SDF = frozenset({"curvilinear", "planar"})
_IN_URDF = _IN_SDF | {"ball", "screw", "universal"}


def joints_of_vendors(model: Model) -> Iterator[Joint]:
    """Those directly in a model.

    One that a URDF file also has for libsdformat, in a ``<gazebo>`` block, is left out.
    """
    kept = {joint.name for block in model.gazebo_blocks for joint in block.joints}
    for element in model.children("drake:joint"):
        joint = model.part(element)
        if not isinstance(joint, Joint):
            continue
        if joint.type in (_IN_URDF if joint.is_urdf else _IN_SDF) and joint.name not in kept:
            yield joint


def mimic_of_vendors(joint: Joint) -> tuple[str, float, float] | None:
    """Leader, multiplier and offset of Drake's own way to say that a joint of SDFormat follows another."""
    mimic = joint.find("drake:mimic")
    if mimic is None:
        return None
    numbers = (mimic.attribute(name) for name in ("multiplier", "offset"))
    multiplier, offset = (math.nan if value is None else value.number for value in numbers)
    if math.isnan(multiplier) or math.isnan(offset):
        return None
    return mimic.attributes.get("joint", "").strip(), multiplier, offset


def as_vendors_have_it(made: mechanism.Joint, joint: Joint) -> mechanism.Joint:
    """The joint of a URDF file with the axes and the pitch that Drake gives it.

    A universal joint turns about x, then y, whatever its axis says.
    """
    axis = made.axes[0]
    if made.kind == "universal":
        made.axes = tuple(replace(axis, direction=np.eye(3)[number]) for number in (0, 1))
    elif made.kind in {"ball", "curvilinear"}:
        made.axes = ()
    elif made.kind == "screw":
        pitch = joint.find("drake:screw_thread_pitch")
        made.pitch = 0.0 if pitch is None else urdf_number(pitch, "value", 0.0) / (2 * math.pi)
    return made


_WITH_FILES = frozenset(("mesh", "heightmap", "image"))


def mechanism_of(model: Model, *, vendors: bool = False) -> Mechanism:
    """The links and joints of a model and of all models in it, as numbers.

    ``vendors``: also the joints that only one simulator knows (``drake:joint``).

    Raises DescriptionError where a pose, name or number cannot be worked out.
    """
    if not model.is_urdf:
        return _Flattened(model, vendors=vendors).made
    links: dict[str, mechanism.Link] = {}
    for link in model.links:
        if link.name not in links:
            links[link.name] = _link(link, link.name, np.eye(4))
    joints = {joint.name: _urdf_joint(joint) for joint in model.joints}
    if vendors:
        for joint in joints_of_vendors(model):
            joints[joint.name] = as_vendors_have_it(_urdf_joint(joint), joint)
    made = Mechanism(model.name, links, joints)
    _place(made)
    return made


class _Flattened:
    """An SDF model while its parts get their names from the top."""

    def __init__(self, model: Model, *, vendors: bool) -> None:
        self.model = model
        nodes = list(model.all_nodes())
        self.names: dict[Node, str] = {}
        self.carriers: dict[Node, Node] = {}
        for name, node in nodes:
            self.names.setdefault(node, name)
        self.made = Mechanism(model.name, {}, {})
        for name, node in nodes:
            if isinstance(node, Link):
                if node.is_urdf:
                    raise DescriptionError("an included URDF model is to be converted first", node.element)
                self.made.links[name] = _link(node, name, self.pose(node))
        for name, node in nodes:
            if isinstance(node, Joint):
                self.made.joints[name] = self.joint(name, node)
        if vendors:
            self.add_vendor_mimics(node for _, node in nodes if isinstance(node, Joint))
            self.add_vendor_joints((model, *(node for _, node in nodes if isinstance(node, Model))))
        for name, node in nodes:
            if node.kind == "frame" and (link := self.carrier(node)) in self.made.links:
                pose = inverse(self.made.links[link].pose) @ self.pose(node)
                self.made.frames[name] = (link, pose)

    def pose(self, node: Node) -> Array:
        return self.model.root.poses.reached(self.model, node)

    def joint(self, name: str, joint: Joint) -> mechanism.Joint:
        parent, child = self.end(joint, "parent"), self.end(joint, "child")
        kind = joint.type
        given = () if kind in {"fixed", "ball"} else (joint.axis, joint.axis2)
        axes = tuple(self.axis(axis) for axis in given if axis.is_given)
        if kind == "revolute" and axes and math.isinf(axes[0].lower) and math.isinf(axes[0].upper):
            kind = "continuous"
        pose = self.pose(joint)
        return mechanism.Joint(name, kind, parent, child, pose, joint.element, axes, _pitch(joint))

    def add_vendor_joints(self, models: Iterable[Model]) -> None:
        for joint in (joint for model in models for joint in joints_of_vendors(model)):
            name = self.prefixed(joint, joint.name)
            self.made.joints[name] = self.vendor_joint(name, joint)

    def add_vendor_mimics(self, joints: Iterable[Joint]) -> None:
        for joint in joints:
            made = self.made.joints[self.names[joint]]
            found = mimic_of_vendors(joint)
            if found is not None and made.axes and made.axes[0].mimic is None:
                leader, multiplier, offset = found
                mimic = Mimic(self.prefixed(joint, leader), multiplier, offset)
                made.axes = (replace(made.axes[0], mimic=mimic), *made.axes[1:])

    def vendor_joint(self, name: str, joint: Joint) -> mechanism.Joint:
        """It is where the frame is that it names as its parent."""
        ends: list[str] = []
        start = np.eye(4)
        for end, node in (("parent", joint.parent), ("child", joint.child)):
            if node is None:
                raise DescriptionError(f"{end} of joint {joint.name} is unknown", joint.element)
            ends.append("world" if node.kind == "world" else self.carrier(node))
        if joint.parent is not None and joint.parent.kind != "world":
            start = self.pose(joint.parent)
        axes = (mechanism.Axis(np.array((0.0, 0.0, 1.0))),) if joint.type == "planar" else ()
        return mechanism.Joint(name, joint.type, ends[0], ends[1], start, joint.element, axes)

    def end(self, joint: Joint, role: str) -> str:
        element = joint.find(role)
        if element is None:
            raise DescriptionError(f"joint {joint.name} has no {role}", joint.element)
        if element.content == "world" and role == "parent":
            return "world"
        found = joint.scope.resolve(element.content)
        if found is None:
            raise DescriptionError(f"{role} {element.content!r} of joint {joint.name} is unknown", element)
        return self.carrier(found)

    def carrier(self, node: Node) -> str:
        """The name of the link that a node moves with."""
        seen: dict[Node, None] = {}
        while node.kind != "link" and node not in self.carriers:
            if node in seen:
                raise DescriptionError(f"frame {node.name} is attached to itself", node.element)
            seen[node] = None
            onward = node.attachment
            if onward is None:
                raise DescriptionError(f"frame {node.name} leads to no link", node.element)
            node = onward
        link = self.carriers.get(node, node)
        self.carriers.update(dict.fromkeys(seen, link))
        return self.names.get(link, "")

    def axis(self, axis: Axis) -> mechanism.Axis:
        limit, dynamics, mimic = axis.limit, axis.dynamics, axis.mimic
        for number in (limit.lower, limit.upper, limit.effort, limit.velocity):
            _require(number)
        lower, upper = limit.range
        return mechanism.Axis(
            direction_of(axis),
            lower,
            upper,
            limit.greatest_effort,
            limit.greatest_velocity,
            _require(dynamics.damping),
            _require(dynamics.friction),
            None
            if mimic is None
            else Mimic(
                self.prefixed(axis.joint, mimic.leader_name),
                _require(mimic.multiplier),
                _require(mimic.offset),
                _require(mimic.reference),
            ),
        )

    def prefixed(self, joint: Joint, name: str) -> str:
        """A joint's name as it is called from the top of the mechanism."""
        scope = joint.scope
        return name if scope is self.model else f"{self.names[scope]}::{name}"


def direction_of(axis: Axis) -> Array:
    """An axis of SDFormat in its joint's frame, of length 1, shape (3,).

    Raises DescriptionError if it has no direction, PoseError if its frame is unknown.
    """
    joint, numbers = axis.joint, axis.xyz
    if len(numbers) < 3:
        raise DescriptionError(f"the axis of joint {joint.name} is not 3 numbers", axis.element)
    direction = np.array(numbers[:3])
    length = math.hypot(*direction)
    if length == 0:
        raise DescriptionError(f"the axis of joint {joint.name} has no direction", axis.element)
    direction /= length
    poses = joint.root.poses
    here = poses.in_scope(joint)[:3, :3]
    if not axis.expressed_in:
        return direction
    frame = poses.named(joint.scope, axis.expressed_in)[:3, :3]
    return np.asarray(here.T @ frame @ direction)


def _require(number: Number) -> float:
    if math.isnan(number):
        name = number.value.element.name if number.value is not None else "value"
        raise DescriptionError(f"{name} {number.text!r} is not a number", number.element)
    return float(number)


def _link(link: Link, name: str, pose: Array) -> mechanism.Link:
    made = mechanism.Link(name, pose, link.element, link.mass_properties)
    for shape in link.shapes:
        geometry = shape.geometry
        if geometry.shape:
            at = link.root.poses.of_part(shape.element, link)
            uri = geometry.uri if geometry.shape in _WITH_FILES else ""
            made.geometries.append(
                Geometry(shape.kind, geometry.meant, geometry.measures, at, shape.element, shape.name, uri)
            )
    return made


def _pitch(joint: Joint) -> float:
    """Of a screw, in m per radian; ``thread_pitch`` is in radians per m, and left-handed."""
    if joint.screw_thread_pitch.is_given:
        return joint.screw_thread_pitch / (2 * math.pi)
    if joint.thread_pitch.is_given and float(joint.thread_pitch) != 0:
        return -1.0 / joint.thread_pitch
    return 0.0


# URDF


def _urdf_joint(joint: Joint) -> mechanism.Joint:
    kind = joint.type.strip()
    axes = () if kind in {"fixed", "floating"} else (_urdf_axis(joint, kind),)
    ends = joint.parent_name, joint.child_name
    return mechanism.Joint(joint.name, kind, *ends, origin_of(joint.element), joint.element, axes)


def _urdf_axis(joint: Joint, kind: str) -> mechanism.Axis:
    element = joint.find("axis")
    numbers = numbers_of(element, "xyz", (1.0, 0.0, 0.0)) if element is not None else (1.0, 0.0, 0.0)
    length = math.hypot(*numbers)
    if length == 0 and kind in {"revolute", "continuous", "prismatic", "planar"}:
        raise DescriptionError("the axis has no direction", joint.element)
    limit, dynamics, mimic = joint.find("limit"), joint.find("dynamics"), joint.find("mimic")

    def number(element: Element | None, name: str, default: float) -> float:
        return default if element is None else urdf_number(element, name, default)

    # A bound that a limit leaves out is 0; without any limit only Drake reads the joint, as unlimited.
    bounded = kind in {"revolute", "prismatic"} and limit is not None
    damping = dynamics if kind != "planar" else None  # three numbers, of Drake's
    return mechanism.Axis(
        np.array(numbers) / (length or 1.0),
        number(limit, "lower", 0.0) if bounded else -math.inf,
        number(limit, "upper", 0.0) if bounded else math.inf,
        number(limit, "effort", math.inf),
        number(limit, "velocity", math.inf),
        number(damping, "damping", 0.0),
        number(dynamics, "friction", 0.0),
        None
        if mimic is None
        else Mimic(
            mimic.attributes.get("joint", ""), number(mimic, "multiplier", 1.0), number(mimic, "offset", 0.0)
        ),
    )


def _place(made: Mechanism) -> None:
    """Turn joint poses, written in the parent link, into poses in the model, and give the links theirs."""
    placed = {"world"}
    for joint in made.tree():
        parent = made.links.get(joint.parent)
        joint.pose = (parent.pose if parent is not None else np.eye(4)) @ joint.pose
        made.links[joint.child].pose = joint.pose
        placed.add(joint.name)
    for joint in made.joints.values():
        if joint.name not in placed and (parent := made.links.get(joint.parent)) is not None:
            joint.pose = parent.pose @ joint.pose
