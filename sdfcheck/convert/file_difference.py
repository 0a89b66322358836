"""Differences between two files: the models in them, where they are, and each robot."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass

from sdfcheck.convert.comparison import TOLERANCE, Change, ChangeKind, compare, pose_texts
from sdfcheck.convert.include_expansion import needs_writing_out
from sdfcheck.convert.ledger import models
from sdfcheck.convert.matching import same_pose, shifted_model
from sdfcheck.convert.migrate.migrate import written_out
from sdfcheck.convert.settings_tree import Contents, divergences, of_model, of_urdf, of_world
from sdfcheck.robot.graph import Model
from sdfcheck.robot.motion.flatten import mechanism_of
from sdfcheck.robot.motion.mechanism import Mechanism
from sdfcheck.robot.motion.poses import Array, inverse, written_pose
from sdfcheck.robot.root import root_of
from sdfcheck.source.document import Document
from sdfcheck.source.sniff import Kind


@dataclass(frozen=True, slots=True)
class Placed:
    """A model of a file: the robot, its settings, its 4×4 pose in the world, and whether it is static."""

    robot: Mechanism
    contents: Contents
    pose: Array
    is_static: bool = False


@dataclass(frozen=True, slots=True)
class FileDifference:
    """The changes by model (by its new name), and how much was compared."""

    changes: tuple[tuple[str, tuple[Change, ...]], ...]
    models: int
    links: int
    joints: int
    settings: Mapping[str, int]
    """How many sensors, plugins and the like were compared."""


def placed_models(document: Document) -> dict[str, Placed]:
    """The models at the top of a document or in its world.

    Raises DescriptionError or PoseError where one cannot be read.
    """
    if document.kind is Kind.URDF:
        found = {}
        for model in root_of(document).models:
            robot = _as_sdf_has_it(mechanism_of(model, vendors=True))
            found[robot.name] = Placed(robot, of_urdf(model), *_placement(document))
        return found
    if needs_writing_out(document):
        document, _ = written_out(document)
    return {model.name: _placed(model, model.root.poses.in_scope(model)) for model in models(document)}


def compare_files(
    a: Document, b: Document, *, tolerance: float = TOLERANCE, across_formats: bool = False
) -> FileDifference:
    """The changes from one document to another.

    ``across_formats``: compare as if their formats differed, as :func:`compare` has it.

    Raises DescriptionError or PoseError where one of them cannot be read.
    """
    before, after = placed_models(a), placed_models(b)
    across = across_formats or a.kind is not b.kind
    names = _counterparts(before, after)
    changes: list[tuple[str, tuple[Change, ...]]] = []
    for name, placed in before.items():
        if name not in names:
            changes.append((name, (Change(ChangeKind.REMOVED, "model", name),)))
            continue
        found = _compare(name, placed, names[name], after[names[name]], across, tolerance)
        if found:
            changes.append((names[name], tuple(found)))
    kept = set(names.values())
    changes += [(name, (Change(ChangeKind.ADDED, "model", name),)) for name in after if name not in kept]
    changes += _worlds(a, b)
    robots = [placed.robot for placed in after.values()]
    links, joints = sum(len(robot.links) for robot in robots), sum(len(robot.joints) for robot in robots)
    settings: Counter[str] = Counter()
    for placed in after.values():
        settings.update(placed.contents.count())
    return FileDifference(tuple(changes), len(robots), links, joints, settings)


def _worlds(a: Document, b: Document) -> list[tuple[str, tuple[Change, ...]]]:
    """The changes in the worlds themselves, where both files have one."""
    found = []
    for before, after in zip(root_of(a).worlds, root_of(b).worlds, strict=False):
        apart = divergences(of_world(before), of_world(after))
        changes = [
            Change(ChangeKind.CHANGED, "world", after.name, one.path, one.before, one.after) for one in apart
        ]
        if before.name != after.name:
            changes.insert(0, Change(ChangeKind.RENAMED, "world", after.name, "", before.name, after.name))
        if changes:
            found.append((after.name, tuple(changes)))
    return found


def _placed(scope: Model, pose: Array) -> Placed:
    robot = mechanism_of(scope, vendors=True)
    if scope.is_static:  # a static model needs no joint to the world
        anchors = {j.name for j in robot.joints.values() if j.kind == "fixed" and j.parent == "world"}
        robot.joints = {name: joint for name, joint in robot.joints.items() if name not in anchors}
    return Placed(robot, of_model(scope), pose, scope.is_static)


def _as_sdf_has_it(robot: Mechanism) -> Mechanism:
    """Without an empty link ``world``, and without joints that leave all free: SDFormat has neither."""
    world = robot.links.get("world")
    is_place = world is not None and world.body is None and not world.geometries
    links = {name: link for name, link in robot.links.items() if not (is_place and name == "world")}
    joints = {name: joint for name, joint in robot.joints.items() if joint.kind != "floating"}
    return Mechanism(robot.name, links, joints, robot.frames)


def _placement(document: Document) -> tuple[Array, bool]:
    """Where a URDF's extensions place the robot, and whether they fix it there."""
    assert document.root is not None
    blobs = [blob for blob in document.root.children("gazebo") if not blob.attributes.get("reference")]
    pose = next((pose for blob in blobs if (pose := blob.find("pose")) is not None), None)
    static = next((static for blob in blobs if (static := blob.find("static")) is not None), None)
    return written_pose(pose), static is not None and static.content.lower() in {"true", "1"}


def _counterparts(before: dict[str, Placed], after: dict[str, Placed]) -> dict[str, str]:
    """By name; a last one on both sides is the same with another name if it shares a link or has none."""
    names = {name: name for name in before if name in after}
    gone = [name for name in before if name not in names]
    new = [name for name in after if name not in names]
    if len(gone) == len(new) == 1:
        old_links, new_links = before[gone[0]].robot.links, after[new[0]].robot.links
        if old_links.keys() & new_links.keys() or len(before) == len(after) == 1:
            names[gone[0]] = new[0]
    return names


def _compare(name: str, a: Placed, other: str, b: Placed, across: bool, tolerance: float) -> list[Change]:
    changes: list[Change] = []
    if name != other:
        changes.append(Change(ChangeKind.RENAMED, "model", name, "", name, other))
    if a.is_static is not b.is_static:
        texts = ("true" if placed.is_static else "false" for placed in (a, b))
        changes.append(Change(ChangeKind.CHANGED, "model", other, "static", *texts))
    both = (a.contents, b.contents)
    found = compare(a.robot, b.robot, contents=both, across_formats=across, tolerance=tolerance)
    if same_pose(a.pose, b.pose, tolerance):
        return changes + found
    moved = [Change(ChangeKind.CHANGED, "model", other, "pose", *pose_texts(a.pose, b.pose)), *found]
    # Perhaps only the model's frame has moved, and the robot is where it was.
    in_place = shifted_model(b.robot, inverse(a.pose) @ b.pose)
    stayed = compare(a.robot, in_place, contents=both, across_formats=across, tolerance=tolerance)
    return changes + min(moved, stayed, key=len)
