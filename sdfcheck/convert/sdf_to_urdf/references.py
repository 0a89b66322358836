"""Names of links, joints and frames in sensors, plugins and custom elements: rewritten where they change."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.sdf_to_urdf.context import Context
from sdfcheck.convert.writer import Node
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.source.element import Element

_REFERENCES = re.compile(
    "joint|link|body|frame|parent|child|member|relative_to|attached_to|expressed_in", re.IGNORECASE
)
"""Words in the names of parameters that hold names of parts."""
_WORDS = re.compile(r"[^\s,;]+")
_OWN = frozenset({"name", "type", "filename", "reference"})


def follow_names(context: Context, node: Node, source: Element, scope: str) -> None:
    """Rewrite what a copy of ``source``, which was in a nested model ``scope``, calls by name."""
    done: dict[str, str] = {}
    doubtful: dict[str, str] = {}
    for holder, attribute, name, text in _texts(node, is_top=True):
        renamed = _WORDS.sub(lambda word, name=name: _new_name(context, word[0], name, scope), text)  # type: ignore[misc]
        if renamed == text:
            continue
        if "::" not in text and not _REFERENCES.search(name):
            doubtful[text.strip()] = renamed.strip()
            continue
        done[text.strip()] = renamed.strip()
        if attribute:
            holder.attributes[attribute] = renamed
        else:
            holder.text = renamed
    if done:
        message = f"names in {source.title} follow the parts that they name: {_list(done)}"
        context.ledger.note(LossKind.RENAMED, source, message, Severity.INFO)
    if doubtful:
        message = f"{source.title} may name what is renamed, and is left as it is: {_list(doubtful)}"
        context.ledger.note(LossKind.RENAMED, source, message)


def _texts(node: Node, *, is_top: bool = False) -> Iterator[tuple[Node, str, str, str]]:
    """Node, attribute or nothing, name of the parameter, and text, of all that may hold a name."""
    for attribute, text in list(node.attributes.items()):
        if not (is_top and attribute in _OWN) and not attribute.startswith("xmlns"):
            yield node, attribute, attribute if attribute not in _OWN | {"value"} else node.name, text
    if node.text and node.text.strip():
        yield node, "", node.name, node.text
    for child in node.elements():
        yield from _texts(child)


def _new_name(context: Context, text: str, parameter: str, scope: str) -> str:
    """The name in the URDF of what a text names, seen from a nested model; the text itself if it names nothing."""
    tables = [context.links, context.joints, context.frame_names]
    if "joint" in parameter.lower():
        tables.insert(0, context.joints)
    around = scope.split("::") if scope else []
    for depth in range(len(around), -1, -1):
        full = "::".join((*around[:depth], text))
        for table in tables:
            if (new := _within(table, full)) is not None:
                return new
    return text


def _within(table: Mapping[str, str], name: str) -> str | None:
    """The new name of a part, also where something in that part is named."""
    head, rest = name, ""
    while head:
        if head in table:
            return table[head] + rest
        head, delimiter, last = head.rpartition("::")
        rest = f"{delimiter}{last}{rest}"
    return None


def _list(names: Mapping[str, str]) -> str:
    shown = [f"`{old}` → `{new}`" for old, new in list(names.items())[:3]]
    return ", ".join(shown) + (" …" if len(names) > 3 else "")
