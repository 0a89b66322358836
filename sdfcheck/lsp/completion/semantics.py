"""Which names of a robot are likely at a place of its SRDF: by its tree, by what is written already, by the order."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence

from sdfcheck.lsp.completion.context import Context
from sdfcheck.lsp.completion.likely import Usage
from sdfcheck.robot.graph import Model
from sdfcheck.robot.root import root_of
from sdfcheck.source.document import Document

_ATTRIBUTE = re.compile(r"(?<![\w:])([\w:]+)\s*=\s*[\"']([^\"'<>]*)[\"']")
_PAIR = re.compile(r"\slink1\s*=\s*[\"']([^\"']*)[\"']\s+link2\s*=\s*[\"']([^\"']*)[\"']")
_PARTNERS = {"link1": "link2", "link2": "link1"}
_UNLIKELY = 3.0


class Tree:
    """The links and joints of the robots that SRDF is about."""

    def __init__(self, documents: Iterable[Document]) -> None:
        self.parents: dict[str, str] = {}
        self.fixed: set[str] = set()
        for document in documents:
            for model in root_of(document).scopes[:1]:
                for joint in model.joints if isinstance(model, Model) else ():
                    self.parents.setdefault(joint.child_name or "", joint.parent_name or "")
                    if joint.type == "fixed":
                        self.fixed.add(joint.name)

    def above(self, link: str) -> list[str]:
        """The links between one and the root, the nearest first."""
        found: list[str] = []
        while (link := self.parents.get(link, "")) and link not in found:
            found.append(link)
        return found


def semantic_scores(
    text: str, context: Context, offset: int, usage: Usage, names: Sequence[str], tree: Tree
) -> dict[str, float]:
    """How much more or less likely each name is for what SRDF says there."""
    start, end = text.rfind("<", 0, offset), text.find(">", offset)
    given = dict(_ATTRIBUTE.findall(text[start : end if end >= 0 else len(text)]))
    attribute = context.attribute
    if attribute in _PARTNERS:
        neighbors = [usage.neighbors(f"{context.tag}@{each}", offset) for each in _PARTNERS]
        return _paired(attribute, given, _PAIR.findall(text), neighbors, names, tree)
    if context.tag in {"joint", "passive_joint"}:
        return _joints(text, context, offset, names, tree)
    if attribute == "child_link":
        return {name: 2.0 * (name not in tree.parents and name in tree.parents.values()) for name in names}
    if attribute == "tip_link":
        below = {name: tree.above(name) for name in names}
        deepest = max(map(len, below.values()), default=0) or 1
        base = given.get("base_link", "")
        return {name: 2.0 * len(above) / deepest + (base in above) for name, above in below.items()}
    if attribute == "parent_link":
        tips = set(re.findall(r"\stip_link\s*=\s*[\"']([^\"']*)[\"']", text))
        return {name: 2.0 * (name in tips) + len(tree.above(name)) / 20 for name in names}
    return {}


def _paired(
    attribute: str,
    given: Mapping[str, str],
    pairs: Iterable[tuple[str, str]],
    neighbors: Iterable[tuple[list[str], list[str]]],
    names: Sequence[str],
    tree: Tree,
) -> dict[str, float]:
    """Links that are not paired with the other one yet; pairs come in the order of their names."""
    partner = given.get(_PARTNERS[attribute], "")
    used = {name for pair in pairs if partner in pair for name in pair} | {partner}
    scores = {name: -_UNLIKELY * (name in used) for name in names}
    for name in names if given.get("reason") == "Adjacent" and partner else ():
        above, below = tree.above(name)[:2], tree.above(partner)[:2]
        scores[name] += 0.5 * (partner in above or name in below)
        scores[name] += 1.5 * (partner in above[:1] or name in below[:1])
    free = sorted(name for name in names if name not in used)
    first, second = neighbors
    if attribute == "link1":
        low, high = "".join(first[0][:1]), "".join(first[1][:1])
        likely = [name for name in (low, high) if name in scores]
        likely += [name for name in free if low < name < (high or name + " ")]
    else:
        low = second[0][0] if first[0][:1] == [partner] and second[0] else partner
        high = second[1][0] if first[1][:1] == [partner] and second[1] else ""
        likely = [name for name in free if low < name and (not high or name < high)]
    for number, name in enumerate(dict.fromkeys(likely)):
        scores[name] += 2.0 / (1 + number / 4)
    return scores


def _joints(text: str, context: Context, offset: int, names: Sequence[str], tree: Tree) -> dict[str, float]:
    """Joints that move; in a state those of its group, in their order."""
    scores = {name: -2.0 * (name in tree.fixed) for name in names}
    start = text.rfind("<group_state", 0, offset)
    if context.around[-1:] != ("group_state",) or start < 0:
        return scores
    group = dict(_ATTRIBUTE.findall(text[start : text.find(">", start)])).get("group", "")
    opened = re.search(rf"<group\s+name\s*=\s*[\"']{re.escape(group)}[\"']\s*>", text)
    inside = text[opened.end() : text.find("</group>", opened.end())] if opened else ""
    for name in re.findall(r"<joint\s+name\s*=\s*[\"']([^\"']*)[\"']", inside):
        if name in scores:
            scores[name] = 1.5
    return scores
