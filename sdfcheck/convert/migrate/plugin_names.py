"""What plugins say of links and joints that get another name.

No format says what the elements of a plugin mean. One that is called after a kind of thing
(``joint_name``, ``link``) and holds the name of one means it; others are reported.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.migrate.migration import Migration, title
from sdfcheck.convert.migrate.node import Node

_WORDS = {"joint": ("joint",), "link": ("link", "body", "frame"), "model": ("model",)}


def rename_in_plugins(migration: Migration, model: Node, names: Mapping[tuple[str, str], str]) -> None:
    """Follow new names in the plugins of a model; ``names`` are new ones by kind and old name."""
    for plugin in _plugins(model):
        for node in plugin.walk():
            for attribute, text in node.attributes().items() if node is not plugin else ():
                found = _meant(migration, plugin, node, f"{node.name}/{attribute}", text, names)
                if found is not None:
                    node.set(attribute, found)
            if not node.children() and (
                found := _meant(migration, plugin, node, node.name, node.content, names)
            ):
                node.write(found)


def _plugins(node: Node) -> Iterator[Node]:
    for child in node.children():
        if child.name == "plugin":
            yield child
        elif child.name != "model" and not child.is_custom:
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
    kinds = [kind for kind, words in _WORDS.items() if any(word in called.lower() for word in words)]
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
