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
    for holder, node, attribute in list(_places(model)):
        called = f"{node.name}/{attribute}" if attribute else node.name
        text = node.attributes[attribute] if attribute else node.content
        found = _meant(migration, holder, node, called, text, names)
        if found is not None and attribute:
            node.attributes[attribute] = found
        elif found is not None:
            node.write(found)


def _named_kinds(node: Node, attribute: str) -> list[str]:
    """The kinds of thing that a vendor's tag names in an attribute, or in its text; none if no table knows it."""
    is_tag = not attribute or ":" in attribute
    tag = tag_of(node.document, attribute if attribute and is_tag else node.name, "sdf")
    if tag is None:
        return []
    slot = next((place.slot for place in tag.places), None) if is_tag else tag.attributes.get(attribute)
    return list(slot.references) if slot is not None else []


def _places(node: Node, around: Node | None = None) -> Iterator[tuple[Node, Node, str]]:
    """The custom attributes, and the values in plugins and custom elements: what holds it, element, attribute."""
    for child in node.children():
        holder = child if around is None and (child.name == "plugin" or child.is_custom) else around
        for name in child.attributes:
            if ":" in name or (
                holder is not None and (child is not holder or (child.is_custom and name != "name"))
            ):
                yield holder or child, child, name
        if holder is not None and next(child.children(), None) is None:
            yield holder, child, ""
        if holder is not None or child.name != "model":
            yield from _places(child, holder)


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
