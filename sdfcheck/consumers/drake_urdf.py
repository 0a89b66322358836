"""Drake's limits in URDF documents: what it refuses, passes over, or takes in its own way.

Source: Drake's parser (multibody/parsing), checked with pydrake 1.51.1.
"""

from __future__ import annotations

from collections.abc import Iterator

from sdfcheck.consumers.drake_ignored import ignored_parts
from sdfcheck.consumers.drake_meshes import unsupported_meshes
from sdfcheck.consumers.drake_problems import (
    CrashesDrake,
    MasslessLeaf,
    SpecialValue,
    UnactuatedJoint,
    UnsupportedJoint,
)
from sdfcheck.formats.sdf.values import number
from sdfcheck.formats.urdf.survey import UrdfSurvey, survey
from sdfcheck.formats.vendor.definitions import PASSED_OVER, REFUSED, Effect, Outcome
from sdfcheck.robot.urdf_tree import UrdfTree, tree
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element, Value

_CRASHES = Effect(Outcome.CRASH)
_ABORTS = Effect(Outcome.ABORT)
_OWN_TYPES = frozenset(("ball", "curvilinear", "screw", "universal"))
_ACTUATED = frozenset(("continuous", "prismatic", "revolute", "screw", "curvilinear"))
_SEVERAL_AXES = frozenset(("ball", "planar", "universal"))


def problems(document: Document) -> Iterator[object]:
    """Everything that Drake does not take as it is meant, in no particular order."""
    surveyed = survey(document)
    if surveyed.root is None:
        return
    yield from ignored_parts(surveyed.index, "urdf")
    yield from unsupported_meshes(surveyed.index.get("mesh", ()))
    for joint in surveyed.top("joint"):
        yield from _joint(joint)
    yield from _transmissions(surveyed)
    yield from _massless(tree(document))


def _joint(joint: Element) -> Iterator[object]:
    kind = joint.attribute("type")
    word = "" if kind is None else kind.text
    if kind is not None and word in _OWN_TYPES:
        yield UnsupportedJoint(kind, REFUSED, "drake:joint")
    elif kind is not None and word == "floating":
        yield UnsupportedJoint(kind, PASSED_OVER, "a link without joint")
    dynamics, limit = joint.find("dynamics"), joint.find("limit")
    damping = None if dynamics is None else dynamics.attribute("damping")
    if damping is not None and word != "planar" and (number(damping.text) or 0) < 0:
        yield CrashesDrake(damping, "a negative damping", REFUSED)
    if limit is not None:
        yield from _limit(limit, word)


def _limit(limit: Element, word: str) -> Iterator[object]:
    if word == "continuous":
        for name in ("lower", "upper"):
            value = limit.attribute(name)
            if value is not None:
                yield SpecialValue(value, "a limit, also for a continuous joint")
                break
    velocity = limit.attribute("velocity")
    speed = None if velocity is None else number(velocity.text)
    if velocity is None or speed is None or word not in {"continuous", "prismatic", "revolute"}:
        return
    if speed < 0:
        yield CrashesDrake(velocity, "a negative velocity limit", _ABORTS)
    elif speed == 0:
        yield SpecialValue(velocity, "a joint that must not move")


def _transmissions(surveyed: UrdfSurvey) -> Iterator[object]:
    root = surveyed.root
    assert root is not None
    joints = {
        joint.attributes.get("name", ""): joint
        for joint in root.children()
        if joint.name in {"joint", "drake:joint"}
    }
    actuated = False
    for transmission in surveyed.top("transmission"):
        yield from _reductions(transmission)
        found = _transmission(transmission, joints)
        if found is None:
            actuated = True
        elif not isinstance(found, str):
            yield found
    moving = [name for name, j in joints.items() if j.attributes.get("type", "") in _ACTUATED]
    if moving and not actuated and not surveyed.top("transmission"):
        first = joints[moving[0]]
        yield UnactuatedJoint(
            first, moving[0], "no transmission names it", PASSED_OVER, others=len(moving) - 1
        )


def _reductions(transmission: Element) -> Iterator[SpecialValue]:
    holders = [transmission, *transmission.children("actuator")]
    for holder in holders:
        for reduction in holder.children("mechanicalReduction"):
            if number(reduction.content) != 1:
                yield SpecialValue(reduction.own_value, "nothing")


def _transmission(transmission: Element, joints: dict[str, Element]) -> object:
    """What keeps a transmission from making an actuator; None: nothing; a word: somebody else tells."""
    kind = transmission.find("type")
    value = kind.own_value if kind is not None else transmission.attribute("type")
    if value is None:
        return UnactuatedJoint(transmission, "", "the transmission has no type", REFUSED)
    if not value.text.strip():
        return CrashesDrake(kind if kind is not None else value, "a transmission of empty type", _CRASHES)
    actuator, joint = transmission.find("actuator"), transmission.find("joint")
    name = None if joint is None else joint.attribute("name")
    named = "" if name is None else name.text
    if "SimpleTransmission" not in value.text:
        return UnactuatedJoint(value, named, "its transmission is no SimpleTransmission", PASSED_OVER)
    for part, what in ((actuator, "actuator"), (joint, "joint")):
        if part is None or part.attribute("name") is None:
            reason = f"the transmission has no {what}" if part is None else f"the {what} has no name"
            return UnactuatedJoint(transmission if part is None else part, named, reason, REFUSED)
    if name is None or named not in joints:
        return "unknown"
    return _effort(name, joints[named])


def _effort(name: Value, joint: Element) -> object:
    """Does the type and the effort of the joint let it have an actuator?"""
    kind = joint.attributes.get("type", "")
    if kind == "fixed":
        return UnactuatedJoint(name, name.text, "it is fixed", PASSED_OVER)
    if kind == "floating" or kind in _SEVERAL_AXES:
        return UnactuatedJoint(name, name.text, f"its type is {kind}", REFUSED)
    limit = joint.find("limit")
    effort = None if limit is None else limit.attribute("effort")
    force = None if effort is None else number(effort.text)
    if effort is None or force is None or kind in {"screw", "curvilinear"}:
        return None
    if force == 0:
        return UnactuatedJoint(effort, name.text, "its effort is 0", PASSED_OVER)
    return UnactuatedJoint(effort, name.text, "its effort is negative", REFUSED) if force < 0 else None


def _massless(robot: UrdfTree) -> Iterator[MasslessLeaf]:
    """The outermost links that move, with everything below them, without mass."""
    heavy = {name for name, link in robot.links.items() if _has_mass(link)}
    told: set[str] = set()
    tops = [(name, None) for name in robot.roots if name != "world"]
    moved = [
        (joint.child.text, joint.element)
        for joint in robot.joints
        if joint.type != "fixed" and joint.child is not None and robot.ends(joint) is not None
    ]
    for name, joint in (*tops, *moved):
        members = set(robot.below(name))
        if members & heavy or members & told:
            continue
        told |= members
        yield MasslessLeaf(robot.links[name], joint, len(members))


def _has_mass(link: Element) -> bool:
    """Unless it is 0 or not given; what is no number is somebody else's business."""
    inertial = link.find("inertial")
    mass = None if inertial is None else inertial.find("mass")
    value = None if mass is None else mass.attribute("value")
    return value is not None and number(value.text) != 0
