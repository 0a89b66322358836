"""Lays out the document of an example: one line in its rule, indented lines for those who read it."""

from __future__ import annotations

import re
from collections.abc import Iterator

from sdfcheck.lint.example import MARK_END, MARK_START

_INDENT = "  "
_SHORT = 60
"""Characters of an element that is kept on one line."""
_LONG = 100
"""Characters of a line that is broken, even if there are others."""
_DEEP = 40
"""More nested elements than this are not indented."""
_TOKEN = re.compile(f"{MARK_START}?<(?:!--.*?--|[^<>]*)>{MARK_END}?|[^<]+", re.DOTALL)


def laid_out(text: str) -> str:
    """The text with lines broken between tags; as it is if it has short lines already, or its tags do not match."""
    if "\n" in text.strip() and all(len(line) <= _LONG for line in text.splitlines()):
        return text
    tokens = [match[0] for match in _TOKEN.finditer(text)]
    if "".join(tokens) != text:
        return text
    top = _parsed(tokens)
    lines = [line for node in top for line in _lines(node, "")]
    return "\n".join(lines) + "\n" if len(lines) > 1 else text


class _Node:
    """An element, or a text or comment: a node without ``end`` and children."""

    def __init__(self, start: str) -> None:
        self.start = start
        self.end = ""
        self.children: list[_Node] = []

    @property
    def flat(self) -> str:
        return self.start + "".join(child.flat for child in self.children) + self.end

    @property
    def is_text(self) -> bool:
        return "<" not in self.start


def _parsed(tokens: list[str]) -> list[_Node]:
    """The nodes at the top; none if the tags do not match."""
    top = _Node("")
    open_nodes = [top]
    for token in tokens:
        bare = _unmarked(token)
        if bare.startswith("</"):
            node = open_nodes.pop()
            if not open_nodes or bare[2:-1].strip() != _tag(node.start):
                return []
            node.end = token
            continue
        node = _Node(token)
        open_nodes[-1].children.append(node)
        if bare.startswith("<") and bare[1] not in "!?" and not bare.endswith("/>"):
            open_nodes.append(node)
            if len(open_nodes) > _DEEP:
                return []
    return top.children if len(open_nodes) == 1 else []


def _tag(start: str) -> str:
    return re.split(r"[\s>]", _unmarked(start)[1:], maxsplit=1)[0]


def _unmarked(text: str) -> str:
    return text.replace(MARK_START, "").replace(MARK_END, "")


def _lines(node: _Node, indent: str) -> Iterator[str]:
    flat = node.flat
    is_mixed = any(child.is_text and child.start.strip() for child in node.children)
    is_nested = any(child.children for child in node.children)
    if is_mixed or not node.children or (indent and not is_nested and len(flat) <= _SHORT):
        if flat.strip():
            yield indent + (flat if is_mixed else flat.strip())
        return
    yield indent + node.start
    for child in node.children:
        yield from _lines(child, indent + _INDENT)
    yield indent + node.end
