"""Joints of a URDF robot: their ends and limits, and whom they follow."""

from __future__ import annotations

from collections.abc import Iterator

from sdfcheck.formats.suggest import suggest_in
from sdfcheck.robot import joint_problems as kinds
from sdfcheck.robot.urdf_tree import UrdfJoint, UrdfTree, tree
from sdfcheck.source.document import Document
from sdfcheck.source.element import Value


def problems(document: Document) -> Iterator[object]:
    """Everything wrong with the joints of a URDF document, in no particular order."""
    robot = tree(document)
    unknown = robot.unknown_ends
    # What has lost its name is reported there, not wherever it is missed.
    explained = set(robot.misnamed()) | robot.missed()
    for joint in robot.joints:
        if joint.parent is not None and joint.child is not None and joint.parent.text == joint.child.text:
            yield kinds.SelfJoint(joint.child, joint.parent, joint.element)
        else:
            yield from _world_as_child(robot, joint)
        yield from _mimic(robot, joint)
    for name, (first, *others) in unknown.items():
        if name not in explained:
            yield _unknown_end(robot, first, tuple(others))
    for link, joints in robot.parents.items():
        yield from _several_parents(link, joints)
    for loop in robot.loops():
        yield _loop(robot, loop)
    yield from _mimic_cycles(robot)


def _unknown_end(robot: UrdfTree, first: Value, others: tuple[Value, ...]) -> kinds.UnknownJointEnd:
    end = first.element
    joint = end.parent
    assert joint is not None
    ends = (joint.find("parent"), joint.find("child"))
    taken = {each.attributes.get("link") for each in ends if each is not None}
    free = (name for name in robot.links if name not in taken)
    near = suggest_in(end.document, first.text, free)
    return kinds.UnknownJointEnd(first, joint, end.name, near, others=others)


def _world_as_child(robot: UrdfTree, joint: UrdfJoint) -> Iterator[object]:
    if joint.child is not None and joint.child.text == "world" and "world" in robot.links:
        yield kinds.WorldAsChild(joint.child, joint.element)


def _several_parents(link: str, joints: list[UrdfJoint]) -> Iterator[object]:
    first, *others = joints
    for joint in others:
        if joint.name == first.name:
            continue  # that there are two of one name is said already
        assert first.child is not None
        assert joint.child is not None
        names = tuple(each.name for each in joints)
        yield kinds.SeveralParents(joint.child, first.child, link, names, refused=True)


def _loop(robot: UrdfTree, loop: list[UrdfJoint]) -> kinds.JointLoop:
    """The loop, beginning with its first joint in the document."""
    order = {id(joint): number for number, joint in enumerate(robot.joints)}
    start = min(range(len(loop)), key=lambda number: order[id(loop[number])])
    ends = [joint.child for joint in (*loop[start:], *loop[:start]) if joint.child is not None]
    return kinds.JointLoop(tuple(ends), tuple(end.text for end in ends), refused=True)


def _leader(joint: UrdfJoint) -> Value | None:
    mimic = joint.element.find("mimic")
    value = mimic.attribute("joint") if mimic is not None else None
    return value if value is not None and value.text else None


def _mimic(robot: UrdfTree, joint: UrdfJoint) -> Iterator[object]:
    value = _leader(joint)
    if value is None:
        return
    if joint.type == "fixed":
        return
    leader = robot.joint_named.get(value.text)
    if leader is None:
        candidates = [name for name in robot.joint_named if name != joint.name]
        yield kinds.UnknownMimicLeader(
            value, joint.element, suggest_in(joint.element.document, value.text, candidates)
        )


def _mimic_cycles(robot: UrdfTree) -> Iterator[object]:
    leaders = {name: value for name, joint in robot.joint_named.items() if (value := _leader(joint))}
    done: set[str] = set()
    for start in leaders:
        path: dict[str, Value] = {}
        name = start
        while name in leaders and name not in done and name not in path:
            path[name] = leaders[name]
            name = leaders[name].text
        if name in path:
            cycle = list(path)[list(path).index(name) :]
            yield kinds.MimicCycle(tuple(path[each] for each in cycle), tuple(cycle))
        done.update(path)
