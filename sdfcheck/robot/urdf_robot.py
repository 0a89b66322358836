"""Reads a URDF robot for physics: the reader of the converter's source and of its result."""

from __future__ import annotations

import math

import numpy as np

from sdfcheck.robot.geometry import read_geometry
from sdfcheck.robot.robot import Axis, Body, Joint, Link, Mimic, Robot
from sdfcheck.robot.rotations import Array, from_quaternion, from_rpy, transform
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element


class RobotError(ValueError):
    """A description from which no robot can be read; ``element`` is where."""

    def __init__(self, message: str, element: Element) -> None:
        super().__init__(message)
        self.element = element


def read_urdf_robot(document: Document) -> Robot:
    """The robot of a URDF document.

    Raises RobotError where a number is none or the joints make no forest.
    """
    root = document.root
    assert root is not None
    links: dict[str, Link] = {}
    for element in root.children("link"):
        name = element.attributes.get("name", "")
        if name not in links:
            links[name] = _link(name, element)
    joints = [_joint(element) for element in root.children("joint")]
    robot = Robot(root.attributes.get("name", ""), links, {joint.name: joint for joint in joints})
    _place(robot)
    return robot


def origin_of(element: Element) -> Array:
    """The 4×4 transform of an element's ``origin``; none is no displacement."""
    origin = element.find("origin")
    if origin is None:
        return np.eye(4)
    position = _numbers(origin, "xyz", (0.0, 0.0, 0.0))
    if "quat_xyzw" in origin.attributes:
        x, y, z, w = _numbers(origin, "quat_xyzw", (0.0, 0.0, 0.0, 1.0))
        return transform(from_quaternion(x, y, z, w), position)
    roll, pitch, yaw = _numbers(origin, "rpy", (0.0, 0.0, 0.0))
    return transform(from_rpy(roll, pitch, yaw), position)


def _link(name: str, element: Element) -> Link:
    link = Link(name, np.eye(4), element, _body(element))
    for role in ("visual", "collision"):
        for part in element.children(role):
            geometry = read_geometry(role, part, origin_of(part))
            if geometry is not None:
                link.geometries.append(geometry)
    return link


def _body(link: Element) -> Body | None:
    inertial = link.find("inertial")
    if inertial is None:
        return None
    mass, inertia = inertial.find("mass"), inertial.find("inertia")
    weight = _number(mass, "value", 0.0) if mass is not None else 0.0
    moments = np.zeros((3, 3))
    if inertia is not None:
        ixx, ixy, ixz, iyy, iyz, izz = (
            _number(inertia, n, 0.0) for n in ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")
        )
        moments = np.array([[ixx, ixy, ixz], [ixy, iyy, iyz], [ixz, iyz, izz]])
    return Body(weight, np.zeros(3), moments).seen_from(origin_of(inertial))


def _joint(element: Element) -> Joint:
    kind = element.attributes.get("type", "").strip()
    ends = []
    for role in ("parent", "child"):
        end = element.find(role)
        ends.append(end.attributes.get("link", "") if end is not None else "")
    axes = () if kind in {"fixed", "floating"} else (_axis(element, kind),)
    return Joint(
        element.attributes.get("name", ""), kind, ends[0], ends[1], origin_of(element), element, axes
    )


def _axis(joint: Element, kind: str) -> Axis:
    axis, limit = joint.find("axis"), joint.find("limit")
    dynamics, mimic = joint.find("dynamics"), joint.find("mimic")
    direction = np.array(_numbers(axis, "xyz", (1.0, 0.0, 0.0)) if axis is not None else (1.0, 0.0, 0.0))
    length = math.hypot(*direction)
    if length == 0 and kind in {"revolute", "continuous", "prismatic", "planar"}:
        raise RobotError("the axis has no direction", joint)
    # A bound that a limit leaves out is 0; without any limit only Drake reads the joint, as unlimited.
    bounded = kind in {"revolute", "prismatic"} and limit is not None
    return Axis(
        direction / (length or 1.0),
        _number(limit, "lower", 0.0) if bounded else -math.inf,
        _number(limit, "upper", 0.0) if bounded else math.inf,
        _number(limit, "effort", math.inf),
        _number(limit, "velocity", math.inf),
        _number(dynamics, "damping", 0.0),
        _number(dynamics, "friction", 0.0),
        None
        if mimic is None
        else Mimic(
            mimic.attributes.get("joint", ""),
            _number(mimic, "multiplier", 1.0),
            _number(mimic, "offset", 0.0),
        ),
    )


def _place(robot: Robot) -> None:
    """Turn joint poses, written in the parent link, into poses in the model, and give the links theirs."""
    placed = {"world"}
    for joint in robot.tree():
        parent = robot.links.get(joint.parent)
        joint.pose = (parent.pose if parent is not None else np.eye(4)) @ joint.pose
        robot.links[joint.child].pose = joint.pose
        placed.add(joint.name)
    for joint in robot.joints.values():
        if joint.name not in placed and (parent := robot.links.get(joint.parent)) is not None:
            joint.pose = parent.pose @ joint.pose


def _numbers(element: Element, name: str, default: tuple[float, ...]) -> tuple[float, ...]:
    text = element.attributes.get(name)
    if text is None:
        return default
    try:
        numbers = tuple(float(part) for part in text.split())
    except ValueError:
        numbers = ()
    if len(numbers) != len(default) or not all(map(math.isfinite, numbers)):
        raise RobotError(f"{name} {text!r} is not {len(default)} finite numbers", element)
    return numbers


def _number(element: Element | None, name: str, default: float) -> float:
    text = element.attributes.get(name) if element is not None else None
    if text is None or element is None:
        return default
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    # A limit may be infinite, which is none.
    if math.isnan(value) or (math.isinf(value) and element.name != "limit"):
        raise RobotError(f"{name} {text!r} is not a finite number", element)
    return value
