"""``A::link`` in a model of 1.7 becomes ``link`` in a nested model ``A``, as 1.8 has it.

Unlike libsdformat this compares whole names, reaches models at the top of a file, and
keeps in the outer model what refers out of the nested one.
"""

from __future__ import annotations

from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.migrate import numbers
from sdfcheck.convert.migrate.migration import Migration, title
from sdfcheck.convert.migrate.node import Node
from sdfcheck.convert.migrate.places import Places
from sdfcheck.robot.motion.poses import PoseError
from sdfcheck.robot.motion.rotations import Array, inverse

_MOVED = frozenset({"frame", "joint", "link", "model", "gripper"})
_ENDS = ("parent", "child", "gripper_link", "palm_link")
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
    names = [child.get("name") or "" for child in model.children() if child.name in _MOVED]
    return list(dict.fromkeys(name.partition("::")[0] for name in names if "::" in name and name[:2] != "::"))


def _gather(migration: Migration, model: Node, head: str) -> None:
    prefix = f"{head}::"
    members = [c for c in model.children() if c.name in _MOVED and (c.get("name") or "").startswith(prefix)]
    poses = _poses(migration, members, f"{prefix}__model__")
    nested = Node("model")
    nested.set("name", head)
    model.append(nested, before=members[0])
    for member in members:
        name = (member.get("name") or "")[len(prefix) :]
        if name == "__model__" and member.name == "frame":
            _dissolve(migration, nested, member, prefix)
        elif _refers_out(member, prefix):
            kept = f"{head}__{name}"
            text = f"{title(member)} is called `{kept}`: it joins {head} with what is outside"
            migration.lose(member, text, LossKind.RENAMED)
            if member.name == "joint":
                migration.renamed_joints[f"{prefix}{name}"] = kept
            member.set("name", kept)
        else:
            member.remove()
            member.set("name", name)
            _cut(member, prefix)
            if member in poses:
                own = member.find("pose") or member.add("pose")
                own.unset("relative_to")
                if member.get("attached_to"):
                    own.set("relative_to", "__model__")  # else it would be in what it is attached to
                own.write(numbers.pose(poses[member]))
            nested.append(member)


def _poses(migration: Migration, members: list[Node], own: str) -> dict[Node, Array]:
    """The poses in the nested model of what is placed in the outer one."""
    places = Places(migration)
    frame = next((m for m in members if m.get("name") == own), None)
    found: dict[Node, Array] = {}
    for member in members:
        pose = member.find("pose")
        reference = (pose.get("relative_to") or "").strip() if pose is not None else ""
        attached = member.get("attached_to") if member.name == "frame" else None
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
    attached = (frame.get("attached_to") or "").strip()
    if attached.startswith(prefix):
        nested.set("canonical_link", attached[len(prefix) :])
    pose = frame.find("pose")
    migration.merge(frame)
    if pose is not None:
        pose.remove()
        nested.append(pose)


def _refers_out(member: Node, prefix: str) -> bool:
    if member.name == "joint":
        ends = [end.content for end in (member.find("parent"), member.find("child")) if end is not None]
        return any(not end.startswith(prefix) for end in ends)
    if member.name == "frame":
        return not (member.get("attached_to") or prefix).startswith(prefix)
    if member.name == "gripper":
        return any(not n.content.startswith(prefix) for n in member.of("gripper_link", "palm_link"))
    return False


def _cut(member: Node, prefix: str) -> None:
    attached = member.get("attached_to") or ""
    if attached.startswith(prefix):
        member.set("attached_to", attached[len(prefix) :])
    for node in member.standard():
        if node.name in _ENDS and node.content.startswith(prefix):
            node.write(node.content[len(prefix) :])
        for name, attribute in _REFERENCES:
            reference = node.get(attribute) or ""
            if node.name == name and reference.startswith(prefix):
                node.set(attribute, reference[len(prefix) :])
