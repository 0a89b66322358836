"""XML as people write it: two spaces a level, attributes in order, numbers as their author spelled them."""

from __future__ import annotations

import re
from collections.abc import Container, Iterable, Iterator, Sequence
from pathlib import Path

from sdfcheck.source.document import Comment, Element
from sdfcheck.source.references import IN_ATTRIBUTE, escape
from sdfcheck.source.wrong_usage import WrongUsage

INDENT = "  "
_NOISE = 1e-15
"""Smaller numbers in a computed vector, or beside numbers of its scale, come from rounding."""


class Words:
    """A text between elements; an element that holds one is written without a space of ours."""

    __slots__ = ("text",)

    def __init__(self, text: str) -> None:
        self.text = text


class Node:
    """An element to be written. It holds text or children, in order; comments and words are children."""

    __slots__ = ("attributes", "children", "name", "text")

    def __init__(self, name: str, text: str | None = None, /, **attributes: str) -> None:
        self.name = name
        self.text = text
        self.attributes: dict[str, str] = attributes
        self.children: list[Node | Comment | Words] = []

    def add(self, name: str, text: str | None = None, /, **attributes: str) -> Node:
        """Append a child element and return it."""
        return self.append(Node(name, text, **attributes))

    def append(self, node: Node) -> Node:
        self.children.append(node)
        return node

    def say(self, text: str) -> None:
        """Have another value, and of the attributes the custom ones only."""
        self.text = text
        self.attributes = {name: value for name, value in self.attributes.items() if ":" in name}
        self.children = [child for child in self.children if not isinstance(child, Words)]

    def elements(self, name: str | None = None) -> Iterator[Node]:
        """The child elements, or those of that name."""
        return (c for c in self.children if isinstance(c, Node) and (name is None or c.name == name))

    def walk(self) -> Iterator[Node]:
        """The element, and all below it."""
        yield self
        for child in self.elements():
            yield from child.walk()

    def find(self, name: str) -> Node | None:
        """The first child element of that name."""
        return next(self.elements(name), None)

    def drop(self, names: Container[str]) -> None:
        """Take the child elements of some names out."""
        self.children = [c for c in self.children if not (isinstance(c, Node) and c.name in names)]

    def reach(self, *names: str) -> Node:
        """The element at the end of a path of names; what is missing is made."""
        node = self
        for name in names:
            node = node.find(name) or node.add(name)
        return node


def render(root: Node, before: Sequence[Comment] = (), after: Sequence[Comment] = ()) -> str:
    """The text of a file: declaration, comments, root, comments."""
    lines = ['<?xml version="1.0"?>']
    nodes: list[Node | Comment | Words] = [*before, root, *after]
    for node in nodes:
        _write(node, "", lines)
    return "\n".join(lines) + "\n"


def with_line_ends(text: str, source: str) -> str:
    """A rendered text with the line ends of the file that it comes from."""
    line, end, _ = source.partition("\n")
    return text.replace("\n", "\r\n") if end and line.endswith("\r") else text


def _write(node: Node | Comment | Words, indent: str, lines: list[str]) -> None:
    if not isinstance(node, Node) or any(isinstance(child, Words) for child in node.children or ()):
        lines.append(f"{indent}{_inline(node)}")
        return
    start = f"{indent}{_start(node)}"
    text = node.text if node.text and not node.text.isspace() else ""
    if not node.children:
        lines.append(f"{start}>{escape(text)}</{node.name}>" if text else f"{start}/>")
        return
    lines.append(f"{start}>")
    if text:
        lines.append(f"{indent}{INDENT}{escape(text.strip())}")
    for child in node.children:
        _write(child, indent + INDENT, lines)
    lines.append(f"{indent}</{node.name}>")


def _start(node: Node) -> str:
    start = f"<{node.name}"
    for name, value in node.attributes.items():
        start += f' {name}="{escape(value, IN_ATTRIBUTE)}"'
    return start


def _inline(node: Node | Comment | Words) -> str:
    """A node without lines and spaces but its own."""
    if isinstance(node, Words):
        return escape(node.text)
    if isinstance(node, Comment):
        return f"<!--{_harmless(node.text)}-->"
    inner = escape(node.text or "") + "".join(map(_inline, node.children))
    return f"{_start(node)}>{inner}</{node.name}>" if inner else f"{_start(node)}/>"


def _harmless(comment: str) -> str:
    """A comment's text without what would end it early."""
    text = re.sub("-(?=-)", "- ", comment)
    return f"{text} " if text.endswith("-") else text


def copied(element: Element, *, verbatim: bool = False) -> Node:
    """An element of a document with all that is in it, comments too, names as written.

    Words between elements, and all in an element that says so (``xml:space``), keep every blank.
    """
    node = Node(element.name)
    node.attributes.update(declared_prefixes(element))
    node.attributes.update(element.attributes)
    verbatim = (verbatim or has_mixed_content(element)) and not _gives_up_blanks(element)
    if verbatim and element.text:
        node.children.append(Words(element.text))
    elif not verbatim:
        node.text = element.content or None
    for child in element.nodes:
        if isinstance(child, Comment):
            node.children.append(child)
        elif isinstance(child, Element):
            node.children.append(copied(child, verbatim=verbatim))
        if verbatim and child.tail:
            node.children.append(Words(child.tail))
    return node


_SPACE = "xml:space"


def keeps_blanks(element: Element) -> bool:
    """Does an element say itself that its spaces matter?"""
    return element.attributes.get(_SPACE) == "preserve"


def has_mixed_content(element: Element) -> bool:
    """Are there words between the elements in an element, or does it keep its spaces?"""
    if keeps_blanks(element):
        return True
    words = sum(
        bool(text and not text.isspace()) for text in (element.text, *(node.tail for node in element.nodes))
    )
    return words > 1 or (words == 1 and any(True for _ in element.children()))


def _gives_up_blanks(element: Element) -> bool:
    return element.attributes.get(_SPACE) == "default" and not has_mixed_content(element)


def declared_prefixes(element: Element) -> dict[str, str]:
    """The prefixes that an element itself declares, as attributes."""
    parent = element.parent
    known = parent.namespaces if element.declared and parent is not None else {}
    return {
        f"xmlns:{prefix}" if prefix else "xmlns": uri
        for prefix, uri in element.declared.items()
        if known.get(prefix) != uri and not uri.startswith("http://www.w3.org/XML/")
    }


def declare(node: Node, element: Element, prefix: str, top: dict[str, str]) -> None:
    """Let a node that gets data of an element say what the prefix is there, unless the ``top`` of the result does.

    ``top`` is prefix → URI; a prefix that is not in it gets what the root of the source says.
    """
    uri = element.namespaces.get(prefix)
    root = element.document.root
    if uri is None or prefix == "xml" or root is None:
        return
    if top.setdefault(prefix, root.declared.get(prefix) or uri) != uri:
        node.attributes.setdefault(f"xmlns:{prefix}", uri)
    elif node.attributes.get(f"xmlns:{prefix}") == uri:
        del node.attributes[f"xmlns:{prefix}"]


def undeclared_prefixes(root: Node) -> set[str]:
    """The prefixes of names below a node that nothing declares there."""
    found: set[str] = set()
    waiting: list[tuple[Node, tuple[str, ...]]] = [(root, ("xml", "xmlns"))]
    while waiting:
        node, declared = waiting.pop()
        if names := [name.split(":", 1) for name in (node.name, *node.attributes) if ":" in name]:
            declared = (*declared, *(name for prefix, name in names if prefix == "xmlns"))
            found.update(prefix for prefix, _ in names if prefix not in declared)
        waiting += [(child, declared) for child in node.elements()]
    return found


def number(value: float) -> str:
    """The shortest text that reads back as the same number; whole numbers without a point."""
    if value == 0:
        return "0"
    return repr(float(value)).removesuffix(".0")


def numbers(values: Iterable[float]) -> str:
    """Computed numbers, separated by spaces; the dust of rounding is swept to 0."""
    return " ".join(number(settled(float(value))) for value in values)


def settled(value: float, scale: float = 1.0) -> float:
    """A computed number; 0 if it comes from rounding beside numbers of a scale."""
    return 0.0 if abs(value) < _NOISE * scale else value


def spaced(text: str) -> str:
    """An author's numbers as they are, separated by single spaces."""
    return " ".join(text.split())


def write_atomically(path: Path, text: str, *, instead: bool = False) -> None:
    """Write a file whole or not at all; ``instead``: of the source.

    Raises:
        WrongUsage: it cannot be written.
    """
    from sdfcheck.files.overwrite import overwrite, why_not

    try:
        overwrite(path, text.encode("utf-8", "surrogateescape"), instead=instead)
    except OSError as error:
        raise WrongUsage(why_not(path, error)) from None
