"""Source and result as robots, to be compared model by model."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from sdfcheck.convert import items
from sdfcheck.convert.contents.entry import Contents
from sdfcheck.convert.contents.of_sdf import of_model, of_world
from sdfcheck.convert.loss import LossKind, loss_at
from sdfcheck.convert.migrate.down.flattening import flat_links
from sdfcheck.convert.migrate.migration import Migration
from sdfcheck.convert.result import Comparison
from sdfcheck.convert.verify import Correspondence
from sdfcheck.formats.sdf.version import Version
from sdfcheck.robot.errors import DescriptionError
from sdfcheck.robot.model import Model
from sdfcheck.robot.motion.flatten import mechanism_of
from sdfcheck.robot.motion.mechanism import Link, Mechanism
from sdfcheck.robot.motion.poses import PoseError
from sdfcheck.robot.motion.rotations import Array
from sdfcheck.robot.root import root_of
from sdfcheck.robot.scope import Scope
from sdfcheck.robot.world import World
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element


def comparisons(migration: Migration) -> list[Comparison]:
    """The models to compare; a model whose source cannot be read is reported."""
    source, result = migration.draft.source, migration.draft.read()
    others = dict(models(result))
    elsewhere = _translated(migration)
    compared = list(_worlds(migration, source, result, elsewhere))
    for name, scope in models(source):
        try:
            robot = comparable(migration, mechanism_of(scope))
        except (DescriptionError, PoseError) as error:
            place = scope.place
            if place.document is source:
                text = f"model `{scope.name}` cannot be compared with its result: {error}"
                migration.losses.append(loss_at(place, LossKind.NOT_VERIFIED, text))
            continue
        other = others.get(name)
        contents = None if other is None else (of_model(scope), of_model(other))
        compared.append(
            Comparison(robot, _robot(other), correspondence(migration, robot), contents, elsewhere)
        )
    return compared


def _robot(scope: Model | None) -> Mechanism:
    """The robot of a result; one that cannot be read is empty, so that everything is missing."""
    try:
        return mechanism_of(scope) if scope is not None else Mechanism("", {}, {})
    except (DescriptionError, PoseError):
        return Mechanism("", {}, {})


def models(document: Document) -> Iterator[tuple[str, Model]]:
    """The models at the top and in worlds, by their names with that of the world."""
    for model in items.models(document):
        world = model.holder
        yield f"{world.name}::{model.name}" if isinstance(world, World) else model.name, model


def _translated(migration: Migration) -> frozenset[Element]:
    """The elements that steps have renamed, moved or said in other words, and what is in them."""
    found = set(migration.ledger.entered)
    for node in migration.root.walk():
        element, parent = node.source, node.parent
        if element is None or parent is None:
            continue
        if parent.source is not None and parent.source.document is not element.document:
            continue  # the top of what is included
        if node.name != element.name or parent.source is not element.parent:
            found.update(element.walk())
    return frozenset(found)


def _worlds(
    migration: Migration, source: Document, result: Document, elsewhere: frozenset[Element]
) -> Iterator[Comparison]:
    """The worlds, with their models for links: where do they are?"""
    results = {scope.name: scope for scope in root_of(result).scopes if scope.kind == "world"}
    for scope in root_of(source).scopes:
        other = results.get(scope.name)
        if scope.kind == "world" and other is not None:
            standing = _standing(scope, migration)
            if len(standing.links) > 1:
                contents = (_of_world(scope), _of_world(other))
                yield Comparison(standing, _standing(other, None), Correspondence(), contents, elsewhere)


def _of_world(world: Scope) -> Contents:
    """The parts of a world beside its models."""
    found = Contents(world.name)
    if isinstance(world, World):
        found.add("model", "", of_world(world))
    return found


def _standing(world: Scope, migration: Migration | None) -> Mechanism:
    poses = world.root.poses
    robot = Mechanism(world.name, {"world": Link("world", np.eye(4), world.element)}, {})
    for name, model in world.nodes.items():
        if not isinstance(model, Model):
            continue
        try:
            robot.links[name] = Link(name, poses.in_scope(model) @ _placement(model), model.place)
        except PoseError as error:
            if migration is not None and model.place.document is migration.draft.source:
                text = f"the pose of model `{name}` cannot be compared: {error}"
                migration.losses.append(loss_at(model.place, LossKind.NOT_VERIFIED, text))
    return robot


def _placement(model: Model) -> Array:
    """From a model's frame to its first link, which is what has a place."""
    link = model.canonical_link
    return np.eye(4) if link is None else model.root.poses.reached(model, link)


def comparable(migration: Migration, robot: Mechanism) -> Mechanism:
    """A robot of the source without what is a loss."""
    if not migration.lost_mimics:
        return robot
    joints = {
        name: replace(joint, axes=tuple(replace(axis, mimic=None) for axis in joint.axes))
        for name, joint in robot.joints.items()
    }
    return replace(robot, joints=joints)


def correspondence(migration: Migration, source: Mechanism) -> Correspondence:
    """The new names of the links and joints of a model, and those that are lost."""
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
