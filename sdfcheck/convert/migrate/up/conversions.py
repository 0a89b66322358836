"""The conversions that libsdformat makes when it reads an older file.

Where its own interpreter loses something this one does not: a target that exists
already is kept, missing parents are made in full, and what is renamed keeps its
attributes and children.
"""

from __future__ import annotations

from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.migrate.migration import Migration, title
from sdfcheck.convert.migrate.node import Node
from sdfcheck.convert.migrate.up.operations import Operation, operations

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
            node.path(path).set(attribute, operation.value)
    elif name == "remove":
        for child in node.children(source):
            migration.merge(child)
    elif name == "remove_empty" and source[0] == "@" and node.get(source[1:]) == "":
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
        node.path(path).set(attribute, found.content)
    elif node.find(target) is not None:
        migration.lose(
            found, f"{title(found)} is left out: there is a `{target}` already", LossKind.DROPPED_ELEMENT
        )
    elif operation.name == "copy":
        node.path(target).write(found.content)
        return
    else:
        _move(node, found, target)
        return
    if operation.name != "copy":
        migration.merge(found)


def _move(node: Node, found: Node, target: str) -> None:
    *path, name = target.split("/")
    if not path and found.parent is node:
        found.rename(name)
        return
    beside = found
    while beside.parent is not node and beside.parent is not None:
        beside = beside.parent
    found.remove()
    found.rename(name)
    if path:
        node.path("/".join(path)).append(found)
    else:
        node.append(found, before=beside)


def _carry_attribute(node: Node, name: str, target: str) -> None:
    text = node.get(name)
    if text is None:
        return
    if target[0] == "@":
        if text.strip() and node.get(target[1:]) is None:
            node.rename_attribute(name, target[1:])
        else:
            node.unset(name)
    elif node.find(target) is None:
        node.add(target, text)
        node.unset(name)
