"""Steps to a newer version: the conversions that libsdformat makes when it reads an older file, and others.

Where its own interpreter loses something this one does not: a target that exists
already is kept, missing parents are made in full, and what is renamed keeps its
attributes and children.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import numpy as np

from sdfcheck.convert.comparison import Counterpart
from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.migrate import migration as numbers
from sdfcheck.convert.migrate.migration import (
    Migration,
    Node,
    Places,
    rename_in_plugins,
    title,
    write_defaults,
)
from sdfcheck.convert.writer import number
from sdfcheck.formats.version import Version
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.robot.motion.origin import PoseError
from sdfcheck.robot.motion.poses import Array, inverse, written_pose
from sdfcheck.robot.root import root_of
from sdfcheck.source.altered import Xml
from sdfcheck.source.document import Comment, Element
from sdfcheck.source.record import NamedTuple

# The changes that libsdformat makes when it reads an older file, from data/migration.txt.


_FILE = Path(__file__).parents[1] / "data" / "migration.txt"


class Operation(NamedTuple):
    """One line: at a place, from here to there; ``@x`` is the attribute ``x`` of the element before it."""

    minor: int
    name: str
    at: str
    source: str
    target: str
    value: str


@cache
def operations(minor: int) -> tuple[Operation, ...]:
    """Those that lead to 1.``minor``, in the order of effect."""
    lines = (line for line in _FILE.read_text("utf-8").splitlines() if not line.startswith("#"))
    rows = ((line + "\t" * 5).split("\t")[:6] for line in lines)
    return tuple(Operation(int(first), *rest) for first, *rest in rows if int(first) == minor)


_TRUE = {"true", "1"}


def convert_to(migration: Migration, minor: int) -> None:
    """Carry out the operations that lead to 1.``minor``."""
    for operation in operations(minor):
        for node in _places(migration.root, operation.at):
            _apply(migration, operation, node)


def _places(root: Node, at: str) -> list[Node]:
    if at.startswith("//"):
        first, *steps = at[2:].split("/")
        found = root.of(first)
    else:
        found, steps = [root], at.split("/")
    for step in steps:
        found = [child for node in found for child in node.children(step)]
    return found


def _apply(migration: Migration, operation: Operation, node: Node) -> None:
    name, source, target = operation.name, operation.source, operation.target
    if name in {"move", "copy", "rename"}:
        _carry(migration, node, operation)
    elif name == "add":
        if target and node.find(target) is None:
            node.add(target, operation.value)
    elif name == "map":
        flag = node.find(source)
        if flag is not None and flag.content.lower() in _TRUE:
            path, _, attribute = target.partition("/@")
            node.reach(*path.split("/")).attributes[attribute] = operation.value
    elif name == "remove":
        for child in node.children(source):
            migration.merge(child)
    elif name == "remove_empty" and source[0] == "@" and node.attributes.get(source[1:]) == "":
        node.unset(source[1:])


def _carry(migration: Migration, node: Node, operation: Operation) -> None:
    source, target = operation.source, operation.target
    if source[0] == "@":
        _carry_attribute(node, source[1:], target)
        return
    found = node.find(source)
    if found is None:
        return
    path, _, attribute = target.partition("/@")
    if attribute:
        node.reach(*path.split("/")).attributes[attribute] = found.content
    elif node.find(target) is not None:
        migration.lose(
            found, f"{title(found)} is left out: there is a `{target}` already", LossKind.DROPPED_ELEMENT
        )
    elif operation.name == "copy":
        node.reach(*target.split("/")).write(found.content)
        return
    else:
        _move(node, found, target)
        return
    if operation.name != "copy":
        migration.merge(found)


def _move(node: Node, found: Node, target: str) -> None:
    *path, name = target.split("/")
    if not path and found.parent is node:
        found.name = name
        return
    beside = found
    while beside.parent is not node and beside.parent is not None:
        beside = beside.parent
    found.take_out()
    found.name = name
    if path:
        node.reach(*path).enter(found)
    else:
        node.enter(found, before=beside)


def _carry_attribute(node: Node, name: str, target: str) -> None:
    text = node.attributes.get(name)
    if text is None:
        return
    if target[0] == "@":
        if text.strip() and node.attributes.get(target[1:]) is None:
            node.rename_attribute(name, target[1:])
        else:
            node.unset(name)
    elif node.find(target) is None:
        node.add(target, text)
        node.unset(name)


# Names that 1.7 does not allow any more: those of two things at once, and reserved ones.


_NAMED = ("link", "joint", "frame", "model")
_ENDS = ("parent", "child", "gripper_link", "palm_link")


def rename_clashing(migration: Migration) -> None:
    """The links, joints, frames and models of a model share one name space, as models and frames of a world do.

    libsdformat renames the joint, then the frame; references go on to name the other part.
    """
    for model in migration.root.of("model", "world"):
        taken = {child.attributes.get("name") for child in _named(model) if child.name in {"link", "model"}}
        for kind in ("joint", "frame"):
            for child in model.children(kind):
                name = child.attributes.get("name")
                if name and name in taken:
                    new = _rename(migration, model, child, "the name is taken")
                    if kind == "joint":
                        migration.renamed_joints[_prefix(model) + name] = _prefix(model) + new
            taken |= {child.attributes.get("name") for child in model.children(kind)}


def rename_reserved(migration: Migration) -> None:
    """``world`` and ``__x__`` are the format's own."""
    for model in migration.root.of("model", "world"):
        for child in _named(model):
            name = child.attributes.get("name", "")
            if not _is_reserved(name):
                continue
            new = _rename(migration, model, child, "the name is reserved from 1.7 on")
            if child.name == "joint":
                migration.renamed_joints[_prefix(model) + name] = _prefix(model) + new
            elif child.name == "link":
                migration.moved_links[_prefix(model) + name] = Counterpart(_prefix(model) + new)
                _refer(model, name, new)
            elif child.name == "frame":
                _refer(model, name, new)


def _named(model: Node) -> list[Node]:
    return [child for child in model.children() if child.name in _NAMED]


def _is_reserved(name: str) -> bool:
    return name == "world" or (len(name) > 3 and name[:2] == name[-2:] == "__")


def _rename(migration: Migration, model: Node, child: Node, why: str) -> str:
    name = child.attributes.get("name", "")
    taken = {other.attributes.get("name") for other in _named(model)}
    new = f"{name}_{child.name}"
    while new in taken:
        new += "_"
    migration.lose(child, f"{title(child)} is called `{new}`: {why}", LossKind.RENAMED)
    child.attributes["name"] = new
    rename_in_plugins(migration, model, {(child.name, name): new})
    return new


def _refer(model: Node, old: str, new: str) -> None:
    """Follow the new name of a link or frame."""
    for user in model.children():
        for end in user.of(*_ENDS):
            if end.content == old:
                end.write(new)
        for pose in user.of("pose"):
            if pose.attributes.get("frame", "").strip() == old:
                pose.attributes["frame"] = new


def _prefix(model: Node) -> str:
    names, at = "", model
    while at.parent is not None and at.parent.name == "model":
        names, at = f"{at.attributes.get('name')}::{names}", at.parent
    return names


# ``A::link`` in a model of 1.7 becomes ``link`` in a nested model ``A``, as 1.8 has it.
#
# Unlike libsdformat this compares whole names, reaches models at the top of a file, and
# keeps in the outer model what refers out of the nested one.


_MOVED = frozenset({"frame", "joint", "link", "model", "gripper"})
_REFERENCES = (("pose", "relative_to"), ("xyz", "expressed_in"))


def unflatten(migration: Migration) -> None:
    """Do it in all models, from the outside in."""
    while True:
        model = next((m for m in migration.root.of("model") if _heads(m)), None)
        if model is None:
            return
        for head in _heads(model):
            _gather(migration, model, head)


def _heads(model: Node) -> list[str]:
    names = [child.attributes.get("name", "") for child in model.children() if child.name in _MOVED]
    return list(dict.fromkeys(name.partition("::")[0] for name in names if "::" in name and name[:2] != "::"))


def _gather(migration: Migration, model: Node, head: str) -> None:
    prefix = f"{head}::"
    members = [
        c for c in model.children() if c.name in _MOVED and c.attributes.get("name", "").startswith(prefix)
    ]
    poses = _poses(migration, members, f"{prefix}__model__")
    nested = Node("model")
    nested.attributes["name"] = head
    model.enter(nested, before=members[0])
    for member in members:
        name = member.attributes.get("name", "")[len(prefix) :]
        if name == "__model__" and member.name == "frame":
            _dissolve(migration, nested, member, prefix)
        elif _refers_out(member, prefix):
            kept = f"{head}__{name}"
            text = f"{title(member)} is called `{kept}`: it joins {head} with what is outside"
            migration.lose(member, text, LossKind.RENAMED)
            if member.name == "joint":
                migration.renamed_joints[f"{prefix}{name}"] = kept
            member.attributes["name"] = kept
        else:
            member.take_out()
            member.attributes["name"] = name
            _cut(member, prefix)
            if member in poses:
                own = member.find("pose") or member.add("pose")
                own.unset("relative_to")
                if member.attributes.get("attached_to"):
                    own.attributes["relative_to"] = "__model__"  # else it would be in what it is attached to
                own.write(numbers.pose(poses[member]))
            nested.enter(member)


def _poses(migration: Migration, members: list[Node], own: str) -> dict[Node, Array]:
    """The poses in the nested model of what is placed in the outer one."""
    places = Places(migration)
    frame = next((m for m in members if m.attributes.get("name") == own), None)
    found: dict[Node, Array] = {}
    for member in members:
        pose = member.find("pose")
        reference = pose.attributes.get("relative_to", "").strip() if pose is not None else ""
        attached = member.attributes.get("attached_to") if member.name == "frame" else None
        if member.name not in {"link", "frame", "model"} or member is frame or (attached and not reference):
            continue
        if reference.startswith(own.removesuffix("__model__")) or (frame is None and not reference):
            continue
        inner, outer = places.frame(member), places.frame(frame) if frame is not None else None
        try:
            if inner is not None:
                at = places.poses.in_scope(inner)
                found[member] = inverse(places.poses.in_scope(outer)) @ at if outer is not None else at
        except PoseError as error:
            migration.lose(member, f"the pose cannot be resolved: {error}", LossKind.UNKNOWN_REFERENCE)
    return found


def _dissolve(migration: Migration, nested: Node, frame: Node, prefix: str) -> None:
    """The frame that stood for the model says where it is and by which link it moves."""
    attached = frame.attributes.get("attached_to", "").strip()
    if attached.startswith(prefix):
        nested.attributes["canonical_link"] = attached[len(prefix) :]
    pose = frame.find("pose")
    migration.merge(frame)
    if pose is not None:
        pose.take_out()
        nested.enter(pose)


def _refers_out(member: Node, prefix: str) -> bool:
    if member.name == "joint":
        ends = [end.content for end in (member.find("parent"), member.find("child")) if end is not None]
        return any(not end.startswith(prefix) for end in ends)
    if member.name == "frame":
        return not (member.attributes.get("attached_to", prefix)).startswith(prefix)
    if member.name == "gripper":
        return any(not n.content.startswith(prefix) for n in member.of("gripper_link", "palm_link"))
    return False


def _cut(member: Node, prefix: str) -> None:
    attached = member.attributes.get("attached_to", "")
    if attached.startswith(prefix):
        member.attributes["attached_to"] = attached[len(prefix) :]
    for node in member.standard():
        if node.name in _ENDS and node.content.startswith(prefix):
            node.write(node.content[len(prefix) :])
        for name, attribute in _REFERENCES:
            reference = node.attributes.get(attribute, "")
            if node.name == name and reference.startswith(prefix):
                node.attributes[attribute] = reference[len(prefix) :]


# Parts that newer versions write otherwise and libsdformat does not convert.


STATES = {"model": "model_state", "light": "light_state", "joint": "joint_state", "link": "link_state"}


def go_up(migration: Migration) -> None:
    """Take a draft to a newer version, step by step."""
    write_defaults(migration)
    for minor in range(migration.source.minor + 1, migration.target.minor + 1):
        for repair in _BEFORE.get(minor, ()):
            repair(migration)
        if minor == 8:
            unflatten(migration)
        convert_to(migration, minor)
    migration.root.attributes["version"] = str(migration.target)


def _allow_no_friction_limit(migration: Migration) -> None:
    """-1 meant endless friction up to 1.3; newer consumers refuse the file."""
    for mu in migration.root.of("mu", "mu2"):
        if mu.content.startswith("-"):
            migration.note(
                mu, f"{mu.name} {mu.content} is written as 1e16: both mean no limit", LossKind.CHANGED_LIMIT
            )
            mu.write("1e16")


def _fold_inner_frames(migration: Migration) -> None:
    """Frames inside links and their parts ended with 1.6; poses in them take them in."""
    document = migration.draft.read()
    frames = {
        m
        for m in migration.root.of("frame")
        if m.parent is not None and m.parent.name not in {"model", "world"}
    }
    if not frames or document is None:
        return
    for pose in migration.root.of("pose"):
        reference = pose.attributes.get("frame", "").strip()
        frame = _inner_frame(pose, reference, frames)
        if frame is None:
            continue
        own = frame.find("pose")
        try:
            outer = written_pose(migration.draft.element(own)) if own is not None else np.eye(4)
            pose.write(numbers.pose(outer @ written_pose(migration.draft.element(pose))))
        except PoseError as error:
            migration.lose(pose, f"the pose cannot be resolved: {error}", LossKind.UNKNOWN_REFERENCE)
        pose.unset("frame")
    for frame in frames:
        if frame.parent is not None:
            text = f"{title(frame)} is left out: frames inside `{frame.parent.name}` ended with 1.6"
            migration.drop(frame, text, LossKind.DROPPED_FRAME)


def _inner_frame(pose: Node, reference: str, frames: set[Node]) -> Node | None:
    at = pose.parent
    while at is not None and reference and at.name not in {"model", "world"}:
        for frame in at.children("frame"):
            if frame in frames and frame.attributes.get("name") == reference:
                return frame
        at = at.parent
    return None


def _move_moved_elements(migration: Migration) -> None:
    """imu/topic and ode/provide_feedback left in 1.7; what took their place is older."""
    for imu in migration.root.of("imu"):
        topic = imu.find("topic")
        if topic is not None and imu.parent is not None and imu.parent.find("topic") is None:
            topic.take_out()
            imu.parent.enter(topic, before=imu)
    for ode in migration.root.of("ode"):
        flag = ode.find("provide_feedback")
        if flag is not None and ode.parent is not None and ode.parent.find("provide_feedback") is None:
            flag.take_out()
            ode.parent.enter(flag, after=ode)


def _look_for_lost_ends(migration: Migration) -> None:
    for child in migration.root.of("child"):
        if child.content == "world" and child.parent is not None and child.parent.name == "joint":
            text = f"{title(child.parent)} has the world as child, which consumers refuse from 1.7 on"
            migration.lose(child, text, LossKind.UNKNOWN_REFERENCE, Severity.ERROR)


def _drop_inertial_references(migration: Migration) -> None:
    for inertial in migration.root.of("inertial"):
        pose = inertial.find("pose")
        if pose is not None and (reference := pose.attributes.get("relative_to", "").strip()):
            text = f"the reference `{reference}` of an inertial's pose is left out: no consumer regards it"
            migration.lose(pose, text, LossKind.UNKNOWN_REFERENCE)
            pose.unset("relative_to")


def _report_several_models(migration: Migration) -> None:
    for extra in [*migration.root.children("model")][1:]:
        text = f"{title(extra)} is not read: from 1.8 on a file has one model at its top"
        migration.lose(extra, text, LossKind.DROPPED_ELEMENT)


def _convert_thread_pitch(migration: Migration) -> None:
    for joint in migration.root.of("joint"):
        old = joint.find("thread_pitch")
        if old is None or joint.find("screw_thread_pitch") is not None:
            continue
        try:
            pitch = -2 * math.pi / float(old.content)
        except (ValueError, ZeroDivisionError):
            continue
        old.name = "screw_thread_pitch"
        old.write(number(pitch))


def _rename_states(migration: Migration) -> None:
    for state in migration.root.of("state"):
        for node in [*state.standard()]:
            inside = node.parent is not None and node.parent.name in {
                "state",
                "model",
                "link",
                *STATES.values(),
            }
            if node.name in STATES and inside and not _is_inserted(node):
                node.name = STATES[node.name]


def _is_inserted(node: Node) -> bool:
    at = node.parent
    while at is not None and at.name != "state":
        if at.name == "insertions":
            return True
        at = at.parent
    return False


_BEFORE = {
    4: (_allow_no_friction_limit,),
    7: (
        _fold_inner_frames,
        rename_reserved,
        rename_clashing,
        _move_moved_elements,
        _look_for_lost_ends,
    ),
    8: (_drop_inertial_references, _report_several_models),
    10: (_convert_thread_pitch,),
    12: (_rename_states,),
}


# Parts of links in ``<gazebo>`` blocks as they were written up to 1.6, in today's words.

_SINCE = Version(1, 6)
"""From here on the noise of an imu is said for each axis."""
_RELATIVE = Version(1, 7)
"""From here on ``relative_to`` of a pose says what was its ``frame``."""
_IMU = "//imu"


def renew(node: Xml, version: Version, source: Element) -> Iterator[tuple[str, Severity]]:
    """Say the noise of the imus, and the frames of poses, in a copy of ``source`` as a version has them.

    Gives what there is to report: libsdformat ignores old words in URDF, and in files that declare a newer version.
    """
    root = root_of(source.document)
    if version >= _RELATIVE:
        for pose in [*_all(node)]:
            if pose.name == "pose" and (frame := pose.attributes.pop("frame", None)):
                pose.attributes.setdefault("relative_to", frame)
                if not root.is_older_than("1.7"):
                    text = f"a pose in {source.title} is relative to `{frame}` now"
                    yield f"{text}; libsdformat ignores its `frame` as it was", Severity.WARNING
    if version >= _SINCE:
        for imu in [*_all(node)]:
            noise = imu.find("noise") if imu.name == "imu" else None
            if noise is not None:
                _for_each_axis(imu, noise)
                text = f"the noise of {source.title} is written for each axis, as SDFormat has it since 1.6"
                if root.is_older_than("1.6"):
                    yield text, Severity.INFO
                else:
                    yield f"{text}; libsdformat ignores it as it was", Severity.WARNING


def _for_each_axis(imu: Xml, noise: Xml) -> None:
    for operation in operations(_SINCE.minor):
        if operation.at == _IMU and operation.target:
            _copy(imu, operation)
    imu.remove(noise)
    for part in _all(noise):
        for name, text in part.attributes.items():
            if ":" in name:
                imu.attributes.setdefault(name, text)
        imu.extend(*(node for node in part.nodes if isinstance(node, Comment) or _is_custom(node)))


def _copy(imu: Xml, operation: Operation) -> None:
    found: Xml | None = imu
    for name in operation.source.split("/"):
        found = found.find(name) if found is not None else None
    if found is None or not found.content:
        return
    path, _, attribute = operation.target.partition("/@")
    target = imu.reach(*path.split("/"))
    if attribute:
        target.attributes.setdefault(attribute, found.content)
    elif not target.content:
        target.write(found.content)


def _is_custom(child: object) -> bool:
    return isinstance(child, Xml) and ":" in child.name


def _all(node: Xml) -> Iterator[Xml]:
    """A node and those below it, but what is in plugins and custom ones."""
    if node.name == "plugin" or _is_custom(node):
        return
    yield node
    for child in node.children():
        yield from _all(child)
