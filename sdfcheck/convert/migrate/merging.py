"""Includes written out, for versions that do not merge them."""

from __future__ import annotations

from sdfcheck.convert.loss import LossKind, refusal
from sdfcheck.convert.migrate import numbers
from sdfcheck.convert.migrate.migration import Migration, title
from sdfcheck.convert.migrate.node import Node
from sdfcheck.model.includes import Included, included
from sdfcheck.model.parameters import PARAMETERS
from sdfcheck.model.poses import PoseError, Poses
from sdfcheck.model.scopes import Frame, scopes

_MOVED = frozenset({"link", "model", "include", "joint", "frame", "gripper", "plugin"})
_MODEL = "__model__"


def refuse_includes(migration: Migration) -> None:
    """Below 1.5 an include stands in a world and says nothing but a uri."""
    for include in migration.root.of("include"):
        said = next(
            (child for child in include.children() if child.name != "uri" and not child.is_custom), None
        )
        place = include.place
        assert place is not None
        if said is not None or include.parent is None or include.parent.name != "world":
            where = f"with a `{said.name}`" if said is not None else "in a model"
            raise refusal(place, f"an include {where} cannot be written in {migration.target}")


def write_out_merges(migration: Migration) -> None:
    """Put what merged includes bring in their place; a frame stands for the merged model."""
    for include in migration.root.of("include"):
        parent = include.parent
        if (include.get("merge") or "").strip().lower() not in {"true", "1"} or parent is None:
            continue
        if not migration.goes_below(9 if parent.name == "model" else 10):
            continue
        document = migration.draft.read()
        found = included(document, migration.draft.element(include))
        if found.model is None or found.model.name != "model" or include.find(PARAMETERS) is not None:
            place = include.place
            assert place is not None
            why = "has parameters" if include.find(PARAMETERS) is not None else "brings no SDFormat model"
            raise refusal(place, f"an include that {why} cannot be merged in {migration.target}")
        _write_out(migration, include, found)


def _write_out(migration: Migration, include: Node, found: Included) -> None:
    from sdfcheck.convert.migrate.migrate import migrated

    assert found.model is not None
    name = f"_merged__{found.name}__model__"
    frame = _own_frame(migration, include, name)
    brought = migrated(found.model.document, migration.draft.version)
    brought.target = migration.target
    write_out_merges(brought)
    model = brought.root.find("model")
    assert model is not None
    migration.losses += brought.losses
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
        pose = part.find("pose") or part.add("pose", "0 0 0 0 0 0")
        if not (pose.get("relative_to") or "").strip():
            pose.set("relative_to", name)


__all__ = ["refuse_includes", "write_out_merges"]
