"""Nested models written into the model around them, for versions without: ``arm::hand`` is ``arm__hand``."""

from __future__ import annotations

import numpy as np

from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.migrate import numbers
from sdfcheck.convert.migrate.migration import Migration, title
from sdfcheck.convert.migrate.node import Node
from sdfcheck.convert.migrate.plugin_names import rename_in_plugins
from sdfcheck.convert.verify import Counterpart
from sdfcheck.robot.motion.rotations import Array, from_rpy, transform

_NAMED = frozenset({"link", "joint", "gripper", "model"})
_MOVED = _NAMED | {"plugin"}
_ENDS = ("parent", "child", "gripper_link", "palm_link")


def flatten(migration: Migration) -> None:
    """Below 1.5, with all poses plain: put nested models into those around them, the inmost first."""
    migration.draft.read()
    for top in [*migration.root.children("model"), *_in_worlds(migration.root)]:
        for nested in reversed([m for m in top.of("model") if not _is_inserted(m)]):
            _into_parent(migration, nested)


def _in_worlds(root: Node) -> list[Node]:
    return [model for world in root.children("world") for model in world.children("model")]


def _is_inserted(node: Node) -> bool:
    return any(part.name in {"state", "population"} for part in _above(node))


def _above(node: Node) -> list[Node]:
    found, at = [], node.parent
    while at is not None:
        found.append(at)
        at = at.parent
    return found


def _into_parent(migration: Migration, nested: Node) -> None:
    name = nested.get("name") or ""
    outer = _pose(nested)
    _rename_ends(nested, name)
    _rename_in_plugins(migration, nested, name)
    parts: list[Node] = []
    own = {child.get("name") for child in nested.children() if child.name in _NAMED}
    turn = outer[:3, :3]
    for part in nested.children():
        if part.name not in _MOVED and not part.is_custom:
            if part.name not in {"pose", "static"}:
                text = f"{title(part)} of nested model `{name}` is left out: {migration.target} does not nest"
                migration.drop(part, text)
            continue
        part.remove()
        _rename(part, name, own)
        if part.name == "link":
            inner = _pose(part)
            if np.abs(outer - np.eye(4)).max() > 0:
                (part.find("pose") or part.add("pose", first=True)).write(numbers.pose(outer @ inner))
        elif part.name == "joint" and np.abs(turn - np.eye(3)).max() > 0:
            _turn_axes(part, turn)
        parts.append(part)
    migration.note(nested, f"nested model `{name}` is written into the one around it", LossKind.MERGED_MODEL)
    for part in [nested, *nested.children()]:
        migration.enter_alone(part)
    if parts:
        nested.replace(parts)
    else:
        nested.remove()


def _rename_in_plugins(migration: Migration, nested: Node, name: str) -> None:
    inside = [child for child in nested.children() if child.name in _NAMED]
    own = {(child.name, child.get("name") or ""): f"{name}__{child.get('name')}" for child in inside}
    rename_in_plugins(migration, nested, own)
    assert nested.parent is not None
    outside = {(kind, f"{name}::{old}"): new for (kind, old), new in own.items()}
    rename_in_plugins(migration, nested.parent, outside)


def _rename_ends(nested: Node, name: str) -> None:
    """In the model around it, what refers into the nested one."""
    assert nested.parent is not None
    for user in (*nested.parent.children("joint"), *nested.parent.children("gripper")):
        for end in user.of(*_ENDS):
            if end.content.startswith(f"{name}::"):
                end.write(f"{name}__{end.content[len(name) + 2 :]}")


def _pose(node: Node) -> Array:
    pose = node.find("pose")
    if pose is None or not pose.content:
        return np.eye(4)
    values = [float(part) for part in pose.content.split()]
    return transform(from_rpy(*values[3:6]), values[:3])


def _turn_axes(joint: Node, turn: Array) -> None:
    """Axes are in the model's frame, which is another one now."""
    for axis in (*joint.children("axis"), *joint.children("axis2")):
        xyz = axis.find("xyz")
        text = xyz.content if xyz is not None and xyz.content else "0 0 1"
        turned = turn @ np.array([float(part) for part in text.split()])
        (xyz or axis.add("xyz")).write(numbers.vector(turned))


def _rename(part: Node, model: str, own: set[str | None]) -> None:
    if part.name in _NAMED:
        part.set("name", f"{model}__{part.get('name')}")
    for end in part.of(*_ENDS):
        first = end.content.partition("::")[0]
        if first in own:
            end.write(f"{model}__{end.content}")


def flat_links(names: list[str]) -> dict[str, Counterpart]:
    """Where verification finds the links of nested models."""
    return {name: Counterpart(name.replace("::", "__")) for name in names if "::" in name}
