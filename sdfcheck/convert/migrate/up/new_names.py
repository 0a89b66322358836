"""Names that 1.7 does not allow any more: those of two things at once, and reserved ones."""

from __future__ import annotations

from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.migrate.migration import Migration, title
from sdfcheck.convert.migrate.node import Node
from sdfcheck.convert.migrate.plugin_names import rename_in_plugins
from sdfcheck.convert.verify import Counterpart

_NAMED = ("link", "joint", "frame", "model")
_ENDS = ("parent", "child", "gripper_link", "palm_link")


def rename_clashing(migration: Migration) -> None:
    """The links, joints, frames and models of a model share one name space, as models and frames of a world do.

    libsdformat renames the joint, then the frame; references go on to name the other part.
    """
    for model in migration.root.of("model", "world"):
        taken = {child.get("name") for child in _named(model) if child.name in {"link", "model"}}
        for kind in ("joint", "frame"):
            for child in model.children(kind):
                name = child.get("name")
                if name and name in taken:
                    new = _rename(migration, model, child, "the name is taken")
                    if kind == "joint":
                        migration.renamed_joints[_prefix(model) + name] = _prefix(model) + new
            taken |= {child.get("name") for child in model.children(kind)}


def rename_reserved(migration: Migration) -> None:
    """``world`` and ``__x__`` are the format's own."""
    for model in migration.root.of("model", "world"):
        for child in _named(model):
            name = child.get("name") or ""
            if not _is_reserved(name):
                continue
            new = _rename(migration, model, child, "the name is reserved from 1.7 on")
            if child.name == "joint":
                migration.renamed_joints[_prefix(model) + name] = _prefix(model) + new
            elif child.name == "link":
                migration.moved_links[_prefix(model) + name] = Counterpart(_prefix(model) + new)
                _refer(model, name, new)
            elif child.name == "frame":
                _refer(model, name, new)


def _named(model: Node) -> list[Node]:
    return [child for child in model.children() if child.name in _NAMED]


def _is_reserved(name: str) -> bool:
    return name == "world" or (len(name) > 3 and name[:2] == name[-2:] == "__")


def _rename(migration: Migration, model: Node, child: Node, why: str) -> str:
    name = child.get("name") or ""
    taken = {other.get("name") for other in _named(model)}
    new = f"{name}_{child.name}"
    while new in taken:
        new += "_"
    migration.lose(child, f"{title(child)} is called `{new}`: {why}", LossKind.RENAMED)
    child.set("name", new)
    rename_in_plugins(migration, model, {(child.name, name): new})
    return new


def _refer(model: Node, old: str, new: str) -> None:
    """Follow the new name of a link or frame."""
    for user in model.children():
        for end in user.of(*_ENDS):
            if end.content == old:
                end.write(new)
        for pose in user.of("pose"):
            if (pose.get("frame") or "").strip() == old:
                pose.set("frame", new)


def _prefix(model: Node) -> str:
    names, at = "", model
    while at.parent is not None and at.parent.name == "model":
        names, at = f"{at.get('name')}::{names}", at.parent
    return names
