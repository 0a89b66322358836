"""Source and result as robots, to be compared model by model."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from sdfcheck.convert.loss import LossKind, loss_at
from sdfcheck.convert.migrate.down.flattening import flat_links
from sdfcheck.convert.migrate.migration import Migration
from sdfcheck.convert.result import Comparison
from sdfcheck.convert.verify import Correspondence
from sdfcheck.formats.sdf.version import Version
from sdfcheck.robot.poses import PoseError, Poses
from sdfcheck.robot.robot import Link, Robot
from sdfcheck.robot.rotations import Array
from sdfcheck.robot.scopes import Frame, Scope, scopes
from sdfcheck.robot.sdf_robot import canonical_link, read_sdf_robot
from sdfcheck.robot.urdf_robot import RobotError
from sdfcheck.source.document import Document


def comparisons(migration: Migration) -> list[Comparison]:
    """What there is to compare; a model whose source cannot be read is told of."""
    source, result = migration.draft.source, migration.draft.read()
    others = dict(models(result))
    compared = list(_worlds(migration, source, result))
    for name, scope in models(source):
        try:
            robot = comparable(migration, read_sdf_robot(scope))
        except (RobotError, PoseError) as error:
            place = scope.element if scope.element.document is source else scope.placed
            if place is not None and place.document is source:
                text = f"model `{scope.name}` cannot be compared with its result: {error}"
                migration.losses.append(loss_at(place, LossKind.NOT_VERIFIED, text))
            continue
        compared.append(Comparison(robot, _robot(others.get(name)), correspondence(migration, robot)))
    return compared


def _robot(scope: Scope | None) -> Robot:
    """The robot of a result; one that cannot be read is empty, so that everything is missing."""
    try:
        return read_sdf_robot(scope) if scope is not None else Robot("", {}, {})
    except (RobotError, PoseError):
        return Robot("", {}, {})


def models(document: Document) -> Iterator[tuple[str, Scope]]:
    """The models at the top and in worlds, by their names with that of the world."""
    for root in scopes(document).roots:
        if root.kind == "model":
            yield root.name, root
            continue
        for frame in root.frames.values():
            if frame.inner is not None:
                yield f"{root.name}::{frame.name}", frame.inner


def _worlds(migration: Migration, source: Document, result: Document) -> Iterator[Comparison]:
    """The worlds, with their models for links: where do they stand?"""
    results = {scope.name: scope for scope in scopes(result).roots if scope.kind == "world"}
    for scope in scopes(source).roots:
        other = results.get(scope.name)
        if scope.kind == "world" and other is not None:
            standing = _standing(scope, migration)
            if len(standing.links) > 1:
                yield Comparison(standing, _standing(other, None), Correspondence())


def _standing(world: Scope, migration: Migration | None) -> Robot:
    poses = Poses()
    robot = Robot(world.name, {"world": Link("world", np.eye(4), world.element)}, {})
    for name, frame in world.frames.items():
        if frame.kind != "model":
            continue
        try:
            robot.links[name] = Link(name, poses.in_scope(frame) @ _placement(frame), frame.element)
        except PoseError as error:
            if migration is not None and frame.element.document is migration.draft.source:
                text = f"the pose of model `{name}` cannot be compared: {error}"
                migration.losses.append(loss_at(frame.element, LossKind.NOT_VERIFIED, text))
    return robot


def _placement(frame: Frame) -> Array:
    """From a model's frame to its first link, which is what stands somewhere."""
    link = canonical_link(frame.inner) if frame.inner is not None else None
    if link is None or frame.inner is None:
        return np.eye(4)
    return Poses().reached(frame.inner, link)


def comparable(migration: Migration, robot: Robot) -> Robot:
    """A robot of the source without what is a loss."""
    if not migration.lost_mimics:
        return robot
    joints = {
        name: replace(joint, axes=tuple(replace(axis, mimic=None) for axis in joint.axes))
        for name, joint in robot.joints.items()
    }
    return replace(robot, joints=joints)


def correspondence(migration: Migration, source: Robot) -> Correspondence:
    """What became of the links and joints of a model."""
    joints = dict(migration.renamed_joints)
    links = dict(migration.moved_links)
    if migration.target < Version(1, 5):
        links |= flat_links(list(source.links))
        joints |= {name: name.replace("::", "__") for name in source.joints if "::" in name}
    return Correspondence(
        links,
        joints,
        dropped_geometries=frozenset(migration.dropped_shapes),
        changed_bodies=frozenset(source.links) if migration.changed_bodies else frozenset(),
    )
