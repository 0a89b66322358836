"""Merged includes: what may be merged where, and the names that come with it.

Source: libsdformat 17's parser.cc: only links, nested models, joints, frames, grippers
and plugins move into the parent, and a world takes no links and no grippers.
"""

from __future__ import annotations

from collections.abc import Iterator

from sdfcheck.formats.sdf.survey import survey
from sdfcheck.robot.includes.included import Included, included, includes_of
from sdfcheck.robot.naming.name import Name, Namesakes
from sdfcheck.source.document import Document, Element, Value

_MOVED = frozenset({"link", "model", "joint", "frame", "gripper"})
"""The named parts that move into the parent."""
_NOT_INTO_WORLDS = frozenset({"link", "gripper"})

_Taken = dict[str, Name]
"""The names that are given already."""


def merged_namesakes(document: Document) -> list[Namesakes]:
    """The names that are taken where a document merges models."""
    pairs: list[Namesakes] = []
    for parent, group in _by_parent(document).items():
        if merged := [found for found in group if _is_merged(found, parent)]:
            pairs += _clashes(parent, merged, _taken(document, parent, group))
    return pairs


def _by_parent(document: Document) -> dict[Element, list[Included]]:
    """The includes of a document by the elements that they are in."""
    by_parent: dict[Element, list[Included]] = {}
    for include in includes_of(document):
        if include.parent is not None:
            by_parent.setdefault(include.parent, []).append(included(document, include))
    return by_parent


def _is_merged(found: Included, parent: Element) -> bool:
    """Is it a model that becomes part of its parent?"""
    if not found.merge or found.model is None or found.kind != "model":
        return False
    if parent.name == "world":
        return all(kind not in _NOT_INTO_WORLDS for kind, _, _ in moved(found))
    return parent.name == "model"


def moved(found: Included) -> Iterator[tuple[str, str, Element]]:
    """The named parts of a model that is merged, as its parameters change it."""
    model = found.model
    if model is None:
        return
    if model.name == "robot":
        children = [(child.name, child.attributes.get("name", ""), child) for child in model.children()]
    else:
        children = survey(model.document).named.get(model, [])
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
            own = [Name(kind, name, found.uri, parent, is_merged=True) for kind, name, _ in moved(found)]
            clash = next((name for name in own if name.name in taken), None)
            if clash is not None and found.name not in names:
                yield Namesakes(taken[clash.name], clash)
            for name in own:
                taken.setdefault(name.name, name)
        names.add(found.name)
