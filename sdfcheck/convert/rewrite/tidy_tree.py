"""Elements, comments and texts, written with canonical indentation.

Blank lines (one at most) and comments at the end of a line stay where their author put them.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from sdfcheck.convert.writer import INDENT, declared_prefixes, has_mixed_content, keeps_blanks
from sdfcheck.source.document import Document
from sdfcheck.source.element import Aside, Element, Instruction
from sdfcheck.source.references import IN_ATTRIBUTE, escape


class Remark:
    """A comment, or a processing instruction; ``beside`` something that is before it on its line."""

    __slots__ = ("after_gap", "beside", "target", "text")

    def __init__(self, text: str, *, target: str = "", beside: bool = False) -> None:
        self.text = text
        self.target = target
        self.beside = beside
        self.after_gap = False

    def __str__(self) -> str:
        if self.target:
            return f"<?{self.target} {self.text}?>" if self.text else f"<?{self.target}?>"
        text = re.sub("-(?=-)", "- ", self.text)
        return f"<!--{text} -->" if text.endswith("-") else f"<!--{text}-->"


class Branch:
    """An element that can be changed; ``origin`` is what it was read from.

    ``parts`` are elements, remarks and texts, in order. ``verbatim``: every blank in it is its author's.
    """

    __slots__ = ("after_gap", "attributes", "name", "origin", "parts", "verbatim")

    def __init__(self, name: str, /, *texts: str, **attributes: str) -> None:
        self.name = name
        self.attributes: dict[str, str] = attributes
        self.parts: list[Branch | Remark | str] = list(texts)
        self.origin: Element | None = None
        self.after_gap = False
        self.verbatim = False

    def __repr__(self) -> str:
        return f"Branch({self.name})"

    @property
    def children(self) -> Iterator[Branch]:
        return (part for part in self.parts if isinstance(part, Branch))

    @property
    def text(self) -> str:
        """The first text before any element, as simulators read it."""
        for part in self.parts:
            if isinstance(part, Branch):
                break
            if isinstance(part, str):
                return part
        return ""

    @text.setter
    def text(self, text: str) -> None:
        for at, part in enumerate(self.parts):
            if isinstance(part, Branch):
                break
            if isinstance(part, str):
                self.parts[at] = text
                return
        self.parts.insert(0, text)

    def find(self, name: str) -> Branch | None:
        return next((child for child in self.children if child.name == name), None)

    def put(self, child: Branch) -> None:
        """Replace the first child of that name, or become the first part."""
        old = self.find(child.name)
        if old is None:
            self.parts.insert(0, child)
        else:
            child.after_gap = old.after_gap
            self.parts[self.parts.index(old)] = child

    def walk(self) -> Iterator[Branch]:
        yield self
        for child in self.children:
            yield from child.walk()


def branch_of(element: Element, *, is_free: bool = False) -> Branch:
    """A copy of an element and all in it; ``is_free``: it is in a plugin or custom element.

    Words between elements there, and all in an element that says so (``xml:space``), keep every blank.
    """
    branch = Branch(element.name)
    branch.origin = element
    branch.attributes = {**element.attributes, **declared_prefixes(element)}
    is_free = is_free or element.is_custom or element.name == "plugin"
    if keeps_blanks(element) or (is_free and has_mixed_content(element)):
        return _verbatim(branch, element)
    before = element.text
    for child in element.nodes:
        if before.strip():
            branch.parts.append(before.strip())
        blanks = before[len(before.rstrip()) :]
        beside = "\n" not in blanks
        part = (
            branch_of(child, is_free=is_free) if isinstance(child, Element) else _remark(child, beside=beside)
        )
        part.after_gap = blanks.count("\n") > 1
        branch.parts.append(part)
        before = child.tail
    if before.strip():
        branch.parts.append(before.strip())
    return branch


def _verbatim(branch: Branch, element: Element) -> Branch:
    branch.verbatim = True
    branch.parts += [element.text] if element.text else []
    for child in element.nodes:
        if isinstance(child, Element):
            inner = Branch(child.name)
            inner.origin = child
            inner.attributes = {**child.attributes, **declared_prefixes(child)}
            branch.parts.append(_verbatim(inner, child))
        else:
            branch.parts.append(_remark(child))
        branch.parts += [child.tail] if child.tail else []
    return branch


def render(root: Branch, document: Document) -> str:
    """The whole file: declaration, what is before the root, the root, what is after it."""
    assert document.root is not None
    lines = ['<?xml version="1.0"?>']
    lines += [str(_remark(node)) for node in document.prolog]
    _write(root, "", lines)
    lines += [str(_remark(node)) for node in document.epilog]
    return "\n".join(lines) + "\n"


def text_of(branch: Branch) -> str:
    """An element alone."""
    lines: list[str] = []
    _write(branch, "", lines)
    return "\n".join(lines)


def _remark(node: Aside, *, beside: bool = False) -> Remark:
    return Remark(node.text, target=node.target if isinstance(node, Instruction) else "", beside=beside)


def _write(branch: Branch, indent: str, lines: list[str]) -> None:
    if branch.verbatim:
        lines.append(f"{indent}{_inline(branch)}")
        return
    start, parts = f"{indent}{_start(branch)}", branch.parts
    if not parts:
        lines.append(f"{start}/>")
        return
    if len(parts) == 1 and isinstance(parts[0], str):
        lines.append(f"{start}>{escape(parts[0])}</{branch.name}>")
        return
    lines.append(f"{start}>")
    for number, part in enumerate(parts):
        if number and not isinstance(part, str) and part.after_gap:
            lines.append("")
        if isinstance(part, Branch):
            _write(part, indent + INDENT, lines)
        elif isinstance(part, Remark) and part.beside:
            lines[-1] += f" {part}"
        else:
            lines.append(f"{indent}{INDENT}{escape(part) if isinstance(part, str) else part}")
    lines.append(f"{indent}</{branch.name}>")


def _start(branch: Branch) -> str:
    attributes = "".join(
        f' {key}="{escape(value, IN_ATTRIBUTE)}"' for key, value in branch.attributes.items()
    )
    return f"<{branch.name}{attributes}"


def _inline(part: Branch | Remark | str) -> str:
    """A part with the spaces that it has, and no others."""
    if isinstance(part, str):
        return escape(part)
    if isinstance(part, Remark):
        return str(part)
    inner = "".join(map(_inline, part.parts))
    return f"{_start(part)}>{inner}</{part.name}>" if inner else f"{_start(part)}/>"
