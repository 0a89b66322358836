"""Reads an SDF model for physics: the reader of the converter's source and of its result.

Nested and included models are part of the robot, with names such as ``arm::hand``.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from sdfcheck.formats.sdf.numbers import leading_float
from sdfcheck.formats.sdf.survey import survey
from sdfcheck.formats.sdf.values import floats
from sdfcheck.formats.sdf.version import Version
from sdfcheck.robot.geometry import read_geometry
from sdfcheck.robot.inertials import read_inertial, solid_of
from sdfcheck.robot.poses import PoseError, Poses, written_pose
from sdfcheck.robot.robot import Axis, Body, Joint, Link, Mimic, Robot
from sdfcheck.robot.rotations import Array, inverse
from sdfcheck.robot.scopes import Frame, Scope
from sdfcheck.robot.urdf_robot import RobotError
from sdfcheck.source.element import Element

_FIVE, _SEVEN = Version(1, 5), Version(1, 7)
DEFAULT_DENSITY = 1000.0
_ENDLESS = 1e15
"""Limits from here on mean none: before 1.10 the format writes 1e16 for infinity."""


def read_sdf_robot(scope: Scope) -> Robot:
    """The robot of a model's scope.

    Raises RobotError or PoseError where a pose, name or number cannot be worked out.
    """
    return _Reader(scope).read()


class _Reader:
    def __init__(self, scope: Scope) -> None:
        self.scope = scope
        self.poses = Poses()
        self.robot = Robot(scope.name, {}, {})

    def read(self) -> Robot:
        frames = list(_frames(self.scope, ""))
        for name, frame in frames:
            if frame.kind == "link":
                self.robot.links[name] = self.link(name, frame)
        for name, frame in frames:
            if frame.kind == "joint":
                self.robot.joints[name] = self.joint(name, frame)
        for name, frame in frames:
            if frame.kind == "frame":
                link = self.carrier(frame)
                if link in self.robot.links:
                    pose = inverse(self.robot.links[link].pose) @ self.pose(frame)
                    self.robot.frames[name] = (link, pose)
        return self.robot

    def pose(self, frame: Frame) -> Array:
        return self.poses.reached(self.scope, frame)

    # Links

    def link(self, name: str, frame: Frame) -> Link:
        element = frame.element
        if element.document.kind.value == "urdf":
            raise RobotError("an included URDF model is to be converted first", element)
        link = Link(name, self.pose(frame), element, body_of(frame, self.poses))
        for role in ("visual", "collision"):
            for part in element.children(role):
                geometry = read_geometry(role, part, self.poses.of_part(part, frame))
                if geometry is not None:
                    link.geometries.append(geometry)
        return link

    # Joints

    def joint(self, name: str, frame: Frame) -> Joint:
        element = frame.element
        kind = element.attributes.get("type", "").strip().lower()
        ends = [self.end(frame, role) for role in ("parent", "child")]
        axes = tuple(
            self.axis(frame, axis)
            for axis in (element.find("axis"), element.find("axis2"))
            if axis is not None and kind not in {"fixed", "ball"}
        )
        joint = Joint(name, kind, ends[0], ends[1], self.pose(frame), element, axes, _pitch(element))
        if kind == "revolute" and axes and math.isinf(axes[0].lower) and math.isinf(axes[0].upper):
            joint.kind = "continuous"
        return joint

    def end(self, joint: Frame, role: str) -> str:
        element = joint.element.find(role)
        if element is None:
            raise RobotError(f"joint {joint.name} has no {role}", joint.element)
        if element.content == "world" and role == "parent":
            return "world"
        found = joint.scope.find(element.content)
        if found is None:
            raise RobotError(f"{role} {element.content!r} of joint {joint.name} is unknown", element)
        return self.carrier(found)

    def carrier(self, frame: Frame) -> str:
        """The name of the link that a frame moves with."""
        seen: set[Frame] = set()
        while frame.kind != "link":
            if frame in seen:
                raise RobotError(f"frame {frame.name} is attached to itself", frame.element)
            seen.add(frame)
            frame = self.next_carrier(frame)
        return next((name for name, other in _frames(self.scope, "") if other is frame), "")

    def next_carrier(self, frame: Frame) -> Frame:
        found: Frame | None = None
        if frame.kind == "model" and frame.inner is not None:
            found = canonical_link(frame.inner)
        elif frame.kind == "joint" and (child := frame.element.find("child")) is not None:
            found = frame.scope.find(child.content)
        elif frame.kind == "frame":
            attached = frame.element.attributes.get("attached_to", "").strip()
            found = frame.scope.find(attached) if attached else frame.scope.own
        if found is None:
            raise RobotError(f"frame {frame.name} leads to no link", frame.element)
        return found

    def axis(self, joint: Frame, axis: Element) -> Axis:
        limit, dynamics, mimic = axis.find("limit"), axis.find("dynamics"), axis.find("mimic")
        return Axis(
            self.direction(joint, axis),
            _limit(limit, "lower", -math.inf),
            _limit(limit, "upper", math.inf),
            _bound(limit, "effort"),
            _bound(limit, "velocity"),
            _value(dynamics, "damping", 0.0),
            _value(dynamics, "friction", 0.0),
            None
            if mimic is None
            else Mimic(
                _prefixed(joint, mimic.attributes.get("joint", ""), self.scope),
                _value(mimic, "multiplier", 1.0),
                _value(mimic, "offset", 0.0),
                _value(mimic, "reference", 0.0),
            ),
        )

    def direction(self, joint: Frame, axis: Element) -> Array:
        """The axis, turned into the joint's frame and of length 1."""
        xyz = axis.find("xyz")
        text = xyz.content if xyz is not None else ""
        numbers = floats(text) if text else (0.0, 0.0, 1.0)
        if numbers is None or len(numbers) < 3:
            raise RobotError(f"the axis of joint {joint.name} is not 3 numbers", axis)
        direction = np.array(numbers[:3])
        length = math.hypot(*direction)
        if length == 0:
            raise RobotError(f"the axis of joint {joint.name} has no direction", axis)
        direction /= length
        here = self.poses.in_scope(joint)[:3, :3]
        version = survey(axis.document).version
        expressed = xyz.attributes.get("expressed_in", "").strip() if xyz is not None else ""
        if expressed:
            frame = self.poses.named(joint.scope, expressed)[:3, :3]
            return np.asarray(here.T @ frame @ direction)
        if version < _SEVEN:
            flag = axis.find("use_parent_model_frame")
            in_model = version < _FIVE or (flag is not None and flag.content.lower() in {"true", "1"})
            return here.T @ direction if in_model else direction
        return direction


def body_of(frame: Frame, poses: Poses) -> Body | None:
    """The mass properties of a link, in its frame; None where the file gives none.

    Raises RobotError where they cannot be worked out.
    """
    inertial = read_inertial(frame.element)
    if inertial is None:
        return None
    if inertial.is_automatic:
        return automatic_body(frame, poses)
    mass = 1.0 if inertial.mass is None else inertial.mass.number
    ixx, iyy, izz, ixy, ixz, iyz = inertial.tensor()
    moments = np.array([[ixx, ixy, ixz], [ixy, iyy, iyz], [ixz, iyz, izz]])
    if not math.isfinite(mass) or not np.isfinite(moments).all():
        raise RobotError("the inertia is not finite", inertial.element)
    pose = inertial.element.find("pose")
    # A reference on an inertial's pose is ignored: the pose is in the link, whatever is written.
    return Body(mass, np.zeros(3), moments).seen_from(written_pose(pose))


def automatic_body(frame: Frame, poses: Poses) -> Body:
    """The mass properties that ``auto="true"`` asks for: collisions filled evenly with their density.

    Raises RobotError for shapes that have no volume, and for meshes that cannot be measured.
    """
    inertial = frame.element.find("inertial")
    total: Body | None = None
    for collision in frame.element.children("collision"):
        density = collision.number("density") or (
            inertial.number("density") if inertial is not None else None
        )
        filled = _filled(collision, density.number if density is not None else DEFAULT_DENSITY)
        body = filled.seen_from(poses.of_part(collision, frame))
        total = body if total is None else total.joined_with(body)
    if total is None:
        raise RobotError("its inertia cannot be computed: the link has no collision", frame.element)
    wanted = inertial.number("mass") if inertial is not None else None
    if wanted is not None and wanted.number > 0 and total.mass > 0:
        factor = wanted.number / total.mass
        return Body(wanted.number, total.centre, total.moments * factor)
    return total


def _filled(collision: Element, density: float) -> Body:
    """A collision as a solid of a density (kg/m³), in its own frame."""
    geometry = collision.find("geometry")
    solid = solid_of(geometry) if geometry is not None else None
    if solid is not None:
        mass = density * solid.volume
        ixx, iyy, izz, ixy, ixz, iyz = solid.moments.times(mass)
        moments = np.array([[ixx, ixy, ixz], [ixy, iyy, iyz], [ixz, iyz, izz]])
        return Body(mass, np.array([0.0, 0.0, solid.centre]), moments)
    mesh = geometry.find("mesh") if geometry is not None else None
    if mesh is None:
        raise RobotError("its inertia cannot be computed: the collision is no solid", collision)
    from sdfcheck.robot.mesh_mass import MeshError, mesh_body

    try:
        return mesh_body(mesh, density)
    except MeshError as error:
        raise RobotError(f"its inertia cannot be computed: {error}", mesh) from None


def canonical_link(scope: Scope) -> Frame | None:
    """The link that a model's own frame moves with."""
    named = scope.element.attributes.get("canonical_link", "").strip()
    if named:
        return scope.find(named)
    first = next(scope.links(), None)
    if first is not None:
        return first
    return next((link for inner in scope.inner if (link := canonical_link(inner)) is not None), None)


def _frames(scope: Scope, prefix: str) -> Iterator[tuple[str, Frame]]:
    for name, frame in scope.frames.items():
        yield prefix + name, frame
        if frame.inner is not None:
            yield from _frames(frame.inner, f"{prefix}{name}::")


def _prefixed(joint: Frame, name: str, top: Scope) -> str:
    """A joint's name as it is called from the top of the robot."""
    scope, parts = joint.scope, [name]
    while scope is not top and scope.parent is not None:
        parts.insert(0, next(n for n, f in scope.parent.frames.items() if f.inner is scope))
        scope = scope.parent
    return "::".join(parts)


def _value(element: Element | None, name: str, default: float) -> float:
    found = element.value(name) if element is not None else None
    if found is None or not found.text.strip():
        return default
    number = leading_float(found.text.strip())
    if number is None:
        raise RobotError(f"{name} {found.text!r} is not a number", found.element)
    return number.value


def _limit(limit: Element | None, name: str, default: float) -> float:
    value = _value(limit, name, default)
    return math.copysign(math.inf, value) if abs(value) >= _ENDLESS else value


def _bound(limit: Element | None, name: str) -> float:
    """Effort and velocity: anything negative means no limit."""
    value = _value(limit, name, math.inf)
    return math.inf if value < 0 or value >= _ENDLESS else value


def _pitch(joint: Element) -> float:
    """Of a screw, in m per radian; ``thread_pitch`` is in radians per m, and left-handed."""
    pitch = joint.number("screw_thread_pitch")
    if pitch is not None:
        return pitch.number / (2 * math.pi)
    thread = joint.number("thread_pitch")
    if thread is not None and thread.number != 0:
        return -1.0 / thread.number
    return 0.0


__all__ = ["PoseError", "RobotError", "automatic_body", "body_of", "canonical_link", "read_sdf_robot"]
