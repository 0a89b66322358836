"""Merged includes: what may be merged where, and the names that come with it.

Source: libsdformat 17's parser.cc: only links, nested models, joints, frames, grippers
and plugins move into the parent, and a world takes no links and no grippers.
"""

from __future__ import annotations

from collections.abc import Iterator

from sdfcheck.formats.sdf.survey import survey
from sdfcheck.robot.include_problems import InvalidMerge
from sdfcheck.robot.includes import Included, included, includes_of
from sdfcheck.robot.names import Name, Namesakes
from sdfcheck.robot.parameters import PARAMETERS, parameters
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element, Value

_MOVED = frozenset({"link", "model", "joint", "frame", "gripper"})
"""What has a name and moves into the parent."""
_NOT_INTO_WORLDS = frozenset({"link", "gripper"})

_Taken = dict[str, Name]
"""The names that are given already."""


def merge_problems(document: Document) -> Iterator[object]:
    """What is wrong with the merged includes of a document."""
    for parent, group in _by_parent(document).items():
        for found in group:
            if found.merge and found.model is not None and (problem := _invalid(found, parent)) is not None:
                yield problem


def merged_namesakes(document: Document) -> list[Namesakes]:
    """The names that are taken where a document merges models."""
    pairs: list[Namesakes] = []
    for parent, group in _by_parent(document).items():
        merged = [found for found in group if found.merge and found.model is not None]
        sound = [found for found in merged if _invalid(found, parent) is None]
        if sound:
            pairs += _clashes(parent, sound, _taken(document, parent, group))
    return pairs


def _by_parent(document: Document) -> dict[Element, list[Included]]:
    """The includes of a document by the elements that they are in."""
    by_parent: dict[Element, list[Included]] = {}
    for include in includes_of(document):
        if include.parent is not None:
            by_parent.setdefault(include.parent, []).append(included(document, include))
    return by_parent


def _invalid(found: Included, parent: Element) -> InvalidMerge | None:
    merge, kind = found.include.attribute("merge"), found.kind or "model"
    if merge is None:
        return None
    if kind != "model" or parent.name not in {"model", "world"}:
        return InvalidMerge(merge, kind, parent)
    parts = [f"{k} `{name}`" for k, name, _ in _moved(found) if k in _NOT_INTO_WORLDS]
    return InvalidMerge(merge, kind, parent, tuple(parts)) if parts and parent.name == "world" else None


def _moved(found: Included) -> Iterator[tuple[str, str, Element]]:
    """The named parts of a model that is merged, after the changes by its parameters."""
    model = found.model
    if model is None:
        return
    if model.name == "robot":
        children = [(child.name, child.attributes.get("name", ""), child) for child in model.children()]
    else:
        children = survey(model.document).named.get(model, [])
    if found.include.has(PARAMETERS):
        children = list(parameters(found).alterations.named(model, found.include, children))
    for kind, name, child in children:
        if kind in _MOVED and name.strip():
            yield kind, name.strip(), child


def _taken(document: Document, parent: Element, group: list[Included]) -> _Taken:
    """The names that the parent gives itself, and those of the models that it includes whole."""
    taken: _Taken = {}
    for kind, name, child in survey(document).named.get(parent, ()):
        if kind != "plugin":
            taken.setdefault(name.strip(), Name(kind, name.strip(), Value(child, "name", name), parent))
    for found in group:
        if not found.merge and found.name and found.uri is not None:
            own = found.include.find("name")
            value = own.own_value if own is not None and own.content else found.uri
            taken.setdefault(found.name, Name(found.kind or "model", found.name, value, parent))
    return taken


def _clashes(parent: Element, merged: list[Included], taken: _Taken) -> Iterator[Namesakes]:
    """Of each merged model the first name that is taken; of two models of one name that name is reported."""
    names: set[str | None] = set()
    for found in merged:
        if found.uri is not None:
            own = [Name(kind, name, found.uri, parent, is_merged=True) for kind, name, _ in _moved(found)]
            clash = next((name for name in own if name.name in taken), None)
            if clash is not None and found.name not in names:
                yield Namesakes(taken[clash.name], clash)
            for name in own:
                taken.setdefault(name.name, name)
        names.add(found.name)
