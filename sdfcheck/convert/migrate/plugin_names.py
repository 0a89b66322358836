"""References of plugins and custom elements to links and joints that get another name.

A vendor's table says what its elements mean. Nobody says it of those of a plugin, or of other
custom ones: one that is called after a kind of thing (``joint_name``, ``link``) and holds the name
of one means it; others are reported.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.migrate.draft import Node
from sdfcheck.convert.migrate.migration import Migration, title
from sdfcheck.formats.vendor.table import tag_of

_WORDS = {"joint": ("joint",), "link": ("link", "body", "frame"), "model": ("model",)}


def rename_in_plugins(migration: Migration, model: Node, names: Mapping[tuple[str, str], str]) -> None:
    """Follow new names in the plugins and custom elements of a model; ``names`` are new ones by kind and old name."""
    for plugin in _plugins(model):
        for node in plugin.walk():
            for attribute, text in list(node.attributes.items()):
                if node is plugin and (not node.is_custom or attribute == "name"):
                    continue
                found = _meant(migration, plugin, node, f"{node.name}/{attribute}", text, names)
                if found is not None:
                    node.attributes[attribute] = found
            if next(node.children(), None) is None and (
                found := _meant(migration, plugin, node, node.name, node.content, names)
            ):
                node.write(found)


def _named_kinds(node: Node, attribute: str) -> list[str]:
    """The kinds of thing that a vendor's tag names in an attribute, or in its text; none if no table knows it."""
    tag = tag_of(node.document, node.name, "sdf")
    if tag is None:
        return []
    slot = tag.attributes.get(attribute) if attribute else next((place.slot for place in tag.places), None)
    return list(slot.references) if slot is not None else []


def _plugins(node: Node) -> Iterator[Node]:
    for child in node.children():
        if child.name == "plugin" or child.is_custom:
            yield child
        elif child.name != "model":
            yield from _plugins(child)


def _meant(
    migration: Migration,
    plugin: Node,
    node: Node,
    called: str,
    text: str,
    names: Mapping[tuple[str, str], str],
) -> str | None:
    """The new name of what a text names; None if it names nothing that changes, or nobody knows."""
    new = {kind: names[kind, text] for kind in _WORDS if (kind, text) in names}
    if not new:
        return None
    kinds = _named_kinds(node, called.partition("/")[2]) or [
        kind for kind, words in _WORDS.items() if any(word in called.lower() for word in words)
    ]
    if not kinds and "::" in text and len(new) == 1:
        kinds = list(new)  # nothing else is called so
    for kind in kinds:
        if kind in new:
            say = f"`{text}` in {title(plugin)} is written as `{new[kind]}`, as the {kind} is called now"
            migration.note(node, say, LossKind.RENAMED)
            return new[kind]
    if not kinds:
        kind, name = next(iter(new.items()))
        say = f"`{called}` in {title(plugin)} says `{text}`: is it the {kind} that is called `{name}` now?"
        migration.lose(node, say, LossKind.RENAMED)
    return None
