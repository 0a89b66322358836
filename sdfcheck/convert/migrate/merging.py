"""Includes written out, for versions that do not merge them."""

from __future__ import annotations

from sdfcheck.convert.loss import LossKind, refusal
from sdfcheck.convert.migrate import numbers
from sdfcheck.convert.migrate.including import brought, brought_by
from sdfcheck.convert.migrate.migration import Migration, title
from sdfcheck.convert.migrate.node import Node
from sdfcheck.model.includes import Included
from sdfcheck.model.poses import PoseError, Poses
from sdfcheck.model.scopes import Frame, scopes

_MOVED = frozenset({"link", "model", "include", "joint", "frame", "gripper", "plugin"})
_MODEL = "__model__"


def write_out_merges(migration: Migration) -> None:
    """Put what merged includes bring in their place; a frame stands for the merged model."""
    for include in migration.root.of("include"):
        parent = include.parent
        if (include.get("merge") or "").strip().lower() not in {"true", "1"} or parent is None:
            continue
        if not migration.goes_below(9 if parent.name == "model" else 10):
            continue
        found = brought_by(migration, include)
        if isinstance(found, str):
            assert include.place is not None
            raise refusal(include.place, f"an include that {found} cannot be merged in {migration.target}")
        _write_out(migration, include, found)


def _write_out(migration: Migration, include: Node, found: Included) -> None:
    name = f"_merged__{found.name}__model__"
    frame = _own_frame(migration, include, name)
    model = brought(migration, include, found)
    parts = [child for child in model.children() if child.name in _MOVED or child.is_custom]
    first = next((part.get("name") for part in parts if part.name == "link"), "")
    for part in parts:
        part.remove()
        part.origin = include.origin
        _settle(part, name)
    own = Node("frame")
    own.set("name", name)
    if link := (model.get("canonical_link") or first):
        own.set("attached_to", link)
    own.add("pose", frame).set("relative_to", "world" if _in_world(include) else _MODEL)
    own.origin = include.origin
    text = f"what {title(include)} of {found.name} brings is written out: {migration.target} does not merge"
    migration.note(include, text, LossKind.EXPANDED_INCLUDE)
    include.replace([own, *parts])


def _in_world(include: Node) -> bool:
    return include.parent is not None and include.parent.name == "world"


def _own_frame(migration: Migration, include: Node, name: str) -> str:
    """The pose of the merged model's own frame in what it is merged into."""
    element = migration.draft.element(include)
    scope = scopes(element.document).of(element)
    frame: Frame | None = scope.frames.get(name) if scope is not None else None
    if frame is None:
        return "0 0 0 0 0 0"
    try:
        return numbers.pose(Poses().in_scope(frame))
    except PoseError as error:
        migration.lose(include, f"the pose cannot be resolved: {error}", LossKind.UNKNOWN_REFERENCE)
        return "0 0 0 0 0 0"


def _settle(part: Node, name: str) -> None:
    """Say of what the poses and axes of a part were relative to when it had a model of its own."""
    for node in (part, *part.standard()):
        for attribute in ("relative_to", "attached_to", "expressed_in"):
            if (node.get(attribute) or "").strip() == _MODEL:
                node.set(attribute, name)
    if part.name == "frame" and not (part.get("attached_to") or "").strip():
        part.set("attached_to", name)
    elif part.name in {"link", "model", "include"}:
        pose = part.find("pose") or part.add("pose", "0 0 0 0 0 0", first=True)
        if not (pose.get("relative_to") or "").strip():
            pose.set("relative_to", name)


__all__ = ["write_out_merges"]
