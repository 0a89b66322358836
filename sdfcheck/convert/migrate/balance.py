"""The parts of a source that are in a draft at the end: text that no step takes out is the author's."""

from __future__ import annotations

from collections.abc import Iterable

from sdfcheck.convert.ledger import EVERYTHING, TEXT
from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.migrate.migration import Migration
from sdfcheck.convert.migrate.node import Node


def close(migration: Migration) -> None:
    """Enter what the draft still has of its source, and report what is gone in silence."""
    ledger, source = migration.ledger, migration.draft.source
    for node in migration.root.walk():
        element = node.source
        if element is None or element.document is not source:
            continue
        if node.opening is node.written:
            ledger.take(element, EVERYTHING)
            continue
        # Of the format's own attributes steps take out what is said elsewhere.
        own = (name for name in element.attributes if ":" not in name)
        ledger.take(element, EVERYTHING, TEXT, *own, *node.attributes())
    if migration.brought:
        _enter_brought(migration)
    assert source.root is not None
    ledger.close(source.root)


def custom_names(nodes: Iterable[Node]) -> frozenset[str]:
    """The names of custom elements and attributes in nodes."""
    names = (name for top in nodes for node in top.walk() for name in (node.name, *node.attributes()))
    return frozenset(name for name in names if ":" in name and not name.startswith("xmlns"))


def _enter_brought(migration: Migration) -> None:
    """Custom data of includes, and of what they bring: is it there at the end?"""
    there = custom_names([migration.root])
    for include, names in migration.brought:
        for name in include.attributes:
            if name in there & names:
                migration.ledger.take(include, name)
        for child in include.children():
            if child.name in there & names:
                migration.ledger.take_whole(child)
        own = {*include.attributes, *(child.name for child in include.children())}
        for name in sorted(names - there - own):
            text = f"`{name}` in what is included is left out: it has no place in SDFormat {migration.target}"
            migration.ledger.note(LossKind.DROPPED_ELEMENT, include, text)
