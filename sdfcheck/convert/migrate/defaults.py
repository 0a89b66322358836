"""Defaults that differ between two versions, and dead content that would come alive.

A value that relies on a default that the target does not have is written out.
"""

from __future__ import annotations

from collections.abc import Iterator

from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.migrate.draft import Node
from sdfcheck.convert.migrate.migration import Migration, title
from sdfcheck.formats.schema import Definition
from sdfcheck.formats.sdf.schema import schema
from sdfcheck.formats.version import NEWEST, Version

_ALIKE = frozenset({"lower", "upper", "effort", "velocity", "topic", "dt"})
"""Their defaults are spelled differently and mean the same: no limit, no topic."""
_UNWRITABLE = {("mu", "-1"): "1e16", ("mu2", "-1"): "1e16"}
"""Old defaults that newer consumers refuse, and what means the same to them."""


def write_defaults(migration: Migration) -> None:
    """Give what relies on a default that changes its value in writing."""
    for node, old in list(defined(migration.root, migration.source)):
        new = schema(migration.target).at(old.place)
        if new is None or old.type is not None:
            continue
        for name, child in old.children.items():
            after = new.children.get(name)
            if after is None or not child.default or name in _ALIKE or after.default == child.default:
                continue
            if node.find(name) is None:
                value = _UNWRITABLE.get((name, child.default), child.default)
                node.add(name, value)
                text = f"`{name}` is written out: its default is {after.default} in {migration.target}"
                migration.note(
                    node, f"{text}, {child.default} in {migration.source}", LossKind.CHANGED_DEFAULT
                )


def drop_dead(migration: Migration) -> None:
    """Take out what no consumer of the source regards and a consumer of the target would."""
    for node, definition in list(defined(migration.root, migration.source)):
        now = schema(NEWEST).at(definition.place)
        then = schema(migration.target).at(definition.place)
        if then is None or now is None:
            continue
        dead = f"has no meaning in {migration.source} and is left out"
        for name in then.attributes.keys() - now.attributes.keys() - definition.attributes.keys():
            if node.attributes.get(name) is not None:
                text = f"attribute `{name}` of {title(node)} {dead}"
                migration.lose(node, text, LossKind.DROPPED_ELEMENT)
                node.unset(name)
        for child in node.children():
            name = child.name
            if name in then.children and name not in now.children and name not in definition.children:
                migration.drop(child, f"{title(child)} {dead}")


def defined(root: Node, version: Version) -> Iterator[tuple[Node, Definition]]:
    """The nodes that a version's table places, each with what the table says of it."""

    def walk(node: Node, definition: Definition) -> Iterator[tuple[Node, Definition]]:
        yield node, definition
        if definition.open:
            return
        for child in node.children():
            inner = definition.children.get(child.name)
            if inner is not None:
                yield from walk(child, inner)

    yield from walk(root, schema(version).root)
