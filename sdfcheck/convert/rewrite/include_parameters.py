"""``experimental:params`` of an include, carried out on what it brings.

:mod:`sdfcheck.robot.includes.parameters` checks their effects; here they are sound.
Source: libsdformat 17's ParamPassing.cc.
"""

from __future__ import annotations

from collections.abc import Iterator

from sdfcheck.convert.rewrite.tidy_tree import Branch, Remark
from sdfcheck.formats.sdf.survey import PARAMETERS

_OWN = frozenset({"element_id", "action"})


def apply_parameters(model: Branch, include: Branch) -> None:
    """Change a model, in which nothing is included any more, as the parameters of its include say."""
    for block in include.children:
        if block.name == PARAMETERS:
            for entry in block.children:
                _apply(model, entry)


def _apply(model: Branch, entry: Branch) -> None:
    element_id, action = entry.attributes.get("element_id", ""), entry.attributes.get("action", "")
    if action == "add":
        holder = _find(model, element_id, "") if element_id else (model, model)
        if holder is not None:
            holder[1].parts.append(_plain(entry))
        return
    found = _find(model, element_id, entry.name)
    if found is None:
        return
    parent, target = found
    if action == "replace":
        _replace(parent, target, entry)
    elif action == "remove":
        _remove(parent, target, entry)
    elif action == "modify":
        _modify(target, entry)
    else:
        for child in entry.children:
            _change_child(target, child)


def _change_child(target: Branch, child: Branch) -> None:
    action = child.attributes.get("action", "")
    if action == "add":
        target.parts.append(_plain(child))
        return
    part = _part(target, child, may_rename=action == "modify")
    if part is None:
        return
    if action == "replace":
        _replace(target, part, child)
    elif action == "remove":
        _remove(target, part, child)
    elif action == "modify":
        _modify(part, child)


def _modify(target: Branch, wanted: Branch) -> None:
    """Take over attributes and values; what is not mentioned stays."""
    target.attributes.update({k: v for k, v in wanted.attributes.items() if k not in _OWN})
    if wanted.text.strip():
        target.text = wanted.text
        return
    for child in wanted.children:
        part = _part(target, child, may_rename=True)
        if part is not None:
            _modify(part, child)


def _remove(parent: Branch, target: Branch, wanted: Branch) -> None:
    """Remove the target, or of its children those that are listed."""
    if next(wanted.children, None) is None and not wanted.text.strip():
        _drop(parent, target)
    for child in wanted.children:
        part = _part(target, child)
        if part is not None:
            _drop(target, part)


def _replace(parent: Branch, target: Branch, entry: Branch) -> None:
    new = _plain(entry)
    new.after_gap = target.after_gap
    parent.parts = [new if part is target else part for part in parent.parts]


def _drop(parent: Branch, target: Branch) -> None:
    parent.parts = [part for part in parent.parts if part is not target]


def _find(model: Branch, element_id: str, kind: str) -> tuple[Branch, Branch] | None:
    """The element that an ``element_id`` names, with its parent; the longest beginning goes first."""
    fitting = [child for child in _named(model) if _begins(element_id, child.attributes["name"])]
    for child in sorted(fitting, key=lambda child: -len(child.attributes["name"])):
        name = child.attributes["name"]
        if element_id != name:
            deeper = _find(child, element_id[len(name) + 2 :], kind)
            if deeper is not None:
                return deeper
        elif kind in {"", child.name}:
            return model, child
    return None


def _begins(element_id: str, name: str) -> bool:
    return element_id == name or element_id.startswith(f"{name}::")


def _named(model: Branch) -> Iterator[Branch]:
    return (child for child in model.children if child.attributes.get("name"))


def _part(target: Branch, wanted: Branch, *, may_rename: bool = False) -> Branch | None:
    """The child that is meant: of that kind and name, or the first of that kind where no name is to fit."""
    parts = [child for child in target.children if child.name == wanted.name]
    name = wanted.attributes.get("name")
    named = [part for part in parts if part.attributes.get("name") == name]
    if name is not None and (named or not may_rename):
        parts = named
    return parts[0] if parts else None


def _plain(entry: Branch) -> Branch:
    """A copy without what speaks to the include alone."""
    copy = Branch(entry.name)
    copy.attributes = {k: v for k, v in entry.attributes.items() if k not in _OWN}
    copy.origin = entry.origin
    copy.parts = [_plain(p) if isinstance(p, Branch) else p for p in entry.parts if not isinstance(p, Remark)]
    return copy
