"""The result, read by SDFormat's own parser, and what it is to be compared with."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from sdfcheck.convert.result import read_result
from sdfcheck.convert.urdf_to_sdf.context import Context
from sdfcheck.convert.urdf_to_sdf.plan import Plan, free_joints
from sdfcheck.convert.verify import Correspondence, Counterpart
from sdfcheck.convert.writer import Node, render
from sdfcheck.robot.motion.flatten import mechanism_of
from sdfcheck.robot.motion.mechanism import Axis, Link, Mechanism
from sdfcheck.robot.root import root_of
from sdfcheck.source.document import Document
from sdfcheck.source.sniff import Kind

_BRINGING = frozenset({"include", "model"})


def read_back(written: Document, context: Context, sdf: Node) -> Mechanism:
    """The robot of what was written, without what the source has for Gazebo only."""
    own = written
    if (rest := _without_brought(sdf)) is not None:
        own = read_result(render(rest), written, Kind.SDF)
    robot = mechanism_of(root_of(own).models[0], vendors=True)
    for name in context.own_links:
        robot.links.pop(name, None)
    return robot


def _without_brought(sdf: Node) -> Node | None:
    """The result without models that ``<gazebo>`` blocks bring, and joints to them; None if there are none."""
    model = next(sdf.elements())
    if not any(child.name in _BRINGING for child in model.elements()):
        return None
    kept, outer = Node(model.name, None, **model.attributes), Node(sdf.name, None, **sdf.attributes)
    kept.children = [
        child
        for child in model.children
        if not (isinstance(child, Node) and (child.name in _BRINGING or _reaches_into(child)))
    ]
    outer.append(kept)
    return outer


def _reaches_into(joint: Node) -> bool:
    ends = (joint.find(name) for name in ("parent", "child")) if joint.name == "joint" else ()
    return any(end is not None and "::" in (end.text or "") for end in ends)


def expected(robot: Mechanism, plan: Plan, context: Context) -> Mechanism:
    """The source with what was reported, and what it has for Gazebo.

    That is masses supplied, limits that mean none, joints that do not follow.
    """
    links = dict(robot.links)
    for name in plan.supplied - plan.automatic:
        for part in plan.parts(name):
            link = links[part]
            body = plan.bodies[name] if part == name else None
            links[part] = Link(link.name, link.pose, link.element, body, link.geometries)
    joints = {}
    free = free_joints(plan, context.options)
    for name, joint in robot.joints.items():
        if name in free:
            continue  # what floats stays where it is, whatever moves
        changes: dict[str, Any] = dict(context.overruled.get(plan.names.joints[name], {}))
        axes = tuple(_unbounded(replace(axis, **changes)) for axis in joint.axes)
        if name in context.lost_mimics:
            axes = tuple(replace(axis, mimic=None) for axis in axes)
        joints[name] = replace(joint, axes=axes)
    return Mechanism(robot.name, links, joints, robot.frames)


def _unbounded(axis: Axis) -> Axis:
    """Negative effort and velocity mean no limit."""
    effort = axis.effort if axis.effort >= 0 else float("inf")
    velocity = axis.velocity if axis.velocity >= 0 else float("inf")
    return replace(axis, effort=effort, velocity=velocity)


def correspondence(plan: Plan, context: Context) -> Correspondence:
    """The outcomes of the source's links and joints."""
    names = plan.names
    links = {
        name: Counterpart(names.links[survivor], offset) for name, (survivor, offset) in plan.home.items()
    }
    dropped = {name for name, (survivor, _) in plan.home.items() if survivor not in context.links}
    return Correspondence(
        links,
        names.joints,
        dropped_links=frozenset(dropped),
        dropped_joints=frozenset(free_joints(plan, context.options)),
        dropped_geometries=frozenset(context.dropped_shapes),
        changed_bodies=frozenset(plan.automatic),
    )
