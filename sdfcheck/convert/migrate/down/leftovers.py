"""Parts that the target's table does not have: taken out and reported, or kept on request.

A name that no version knows has as little effect as before, and stays. On the way up so does what is
newer than the target: consumers let a file use more than its version has.
"""

from __future__ import annotations

from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.migrate.migration import Migration, title
from sdfcheck.convert.migrate.node import Node
from sdfcheck.formats.sdf.schema import Definition, schema
from sdfcheck.formats.sdf.version import NEWEST, Version
from sdfcheck.lint.diagnostic import Severity

_SHAPES = frozenset({"box", "capsule", "cone", "cylinder", "ellipsoid", "sphere", "mesh", "polyline"})
_KINDS = {"mimic": LossKind.DROPPED_MIMIC, "frame": LossKind.DROPPED_FRAME, "plugin": LossKind.DROPPED_PLUGIN}


def drop_leftovers(migration: Migration) -> None:
    """Leave what the target allows; elements and attributes with a prefix are nobody's but the author's."""
    if not migration.keep_unknown:
        _drop_in(migration, migration.root, schema(migration.target).root)


def _drop_in(migration: Migration, node: Node, definition: Definition) -> None:
    for name in node.attributes():
        if ":" in name or name == "xmlns" or name in definition.attributes:
            continue
        if any(name in known.attributes for known in _meanings(migration, definition)):
            text = f"attribute `{name}` of {title(node)} is left out: {migration.target} does not have it"
            migration.lose(node, text, LossKind.DROPPED_ELEMENT)
            node.unset(name)
    if definition.open or definition.type is not None:
        return
    for child in node.children():
        if child.is_custom or child.parent is not node or child in migration.kept:
            continue
        inner = definition.children.get(child.name)
        if inner is not None:
            _drop_in(migration, child, inner)
        elif any(child.name in known.children for known in _meanings(migration, definition)):
            _drop(migration, child)


def _meanings(migration: Migration, definition: Definition) -> list[Definition]:
    """The parent definitions of a place in the versions that the source may have."""
    source, target = migration.source.minor, migration.target.minor
    minors = range(source, target) if source < target else range(source, NEWEST.minor + 1)
    found = (schema(Version(1, minor)).at(definition.place) for minor in minors)
    return [known for known in found if known is not None]


def _drop(migration: Migration, node: Node) -> None:
    parent = node.parent
    text = f"{title(node)} is left out: {migration.target} does not have it there"
    if (
        node.name in _SHAPES
        and parent is not None
        and parent.name == "geometry"
        and parent.parent is not None
    ):
        migration.dropped_shapes.add(node.name)
        text = f"{title(parent.parent)} is left out: {migration.target} does not have `{node.name}`"
        if parent.parent.parent is not None:
            migration.drop(parent.parent, text, LossKind.UNSUPPORTED_GEOMETRY)
        return
    severity = Severity.WARNING
    if node.name == "mimic":
        migration.lost_mimics = True
        severity = Severity.ERROR
    migration.drop(node, text, _KINDS.get(node.name, LossKind.DROPPED_ELEMENT), severity)
