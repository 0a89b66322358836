"""Joints between the world and a model, for versions that have joints in models only."""

from __future__ import annotations

from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.migrate import numbers
from sdfcheck.convert.migrate.migration import Migration, title
from sdfcheck.convert.migrate.node import Node
from sdfcheck.convert.migrate.places import Places
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.robot.motion.poses import PoseError
from sdfcheck.robot.motion.rotations import Array

_ENDS = ("parent", "child")


def move_world_joints(migration: Migration) -> None:
    """Below 1.10: into the one model that they are about; those of two models are lost."""
    places = Places(migration)
    for world in migration.root.children("world"):
        for joint in world.children("joint"):
            model = _only_model(world, joint)
            namesake = _namesake(joint, model) if model is not None else None
            if model is not None and namesake is None:
                _move(migration, places, joint, model)
            elif not migration.goes_below(7):
                reason = f"{migration.target} has no joints between models of a world"
                if model is not None and namesake is not None:
                    reason = (
                        f"{migration.target} has joints in models only, and in {title(model)} its name is that of a "
                        f"{namesake.name}"
                    )
                migration.drop(joint, f"{title(joint)} is left out: {reason}", severity=Severity.ERROR)


def _namesake(joint: Node, model: Node) -> Node | None:
    """The part of a model that has the name of a joint."""
    return next((other for other in model.children() if other.get("name") == joint.get("name")), None)


def _only_model(world: Node, joint: Node) -> Node | None:
    """The model that a joint connects with the world, or with itself."""
    ends = [end.content for name in _ENDS if (end := joint.find(name)) is not None]
    heads = {end.partition("::")[0] for end in ends if end != "world"}
    if len(ends) != len(_ENDS) or len(heads) != 1 or ends[1] == "world":
        return None
    models = {model.get("name"): model for model in world.children("model")}
    return models.get(heads.pop())


def _move(migration: Migration, places: Places, joint: Node, model: Node) -> None:
    try:
        pose, turns = _resolved(places, joint)
    except (PoseError, ValueError) as error:
        migration.lose(joint, f"the joint cannot be resolved: {error}", LossKind.UNKNOWN_REFERENCE)
        return
    if pose is not None and (own := joint.find("pose")) is not None:
        for name in ("relative_to", "rotation_format", "degrees"):
            own.unset(name)
        own.write(numbers.pose(pose))
    for xyz, direction in turns:
        xyz.unset("expressed_in")
        xyz.write(numbers.vector(direction))
    for end in filter(None, map(joint.find, _ENDS)):
        if end.content != "world":
            end.write(end.content.partition("::")[2] or "__model__")
    joint.remove()
    model.append(joint)
    text = f"{title(joint)} of the world is written into {title(model)}"
    migration.note(joint, text, LossKind.REORDERED)


def _resolved(places: Places, joint: Node) -> tuple[Array | None, list[tuple[Node, Array]]]:
    """Parts relative to frames of the world: the pose in the child, and axes in the joint."""
    own, frame = joint.find("pose"), places.frame(joint)
    refers = own is not None and bool((own.get("relative_to") or "").strip())
    turns: list[tuple[Node, Array]] = []
    for axis in (*joint.children("axis"), *joint.children("axis2")):
        xyz = axis.find("xyz")
        expressed = (xyz.get("expressed_in") or "").strip() if xyz is not None else ""
        if xyz is None or not expressed or frame is None:
            continue
        turn = places.poses.in_scope(frame)[:3, :3].T @ places.poses.named(frame.scope, expressed)[:3, :3]
        turns.append((xyz, turn @ [float(part) for part in (xyz.content or "0 0 1").split()]))
    return (places.plain(joint) if refers else None), turns
