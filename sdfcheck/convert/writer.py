"""XML as people write it: two spaces a level, attributes in order, numbers as their author spelled them."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path

from sdfcheck.robot.motion.mechanism import Geometry, Mechanism
from sdfcheck.source.altered import Xml
from sdfcheck.source.document import Aside, Element, Instruction, Node
from sdfcheck.source.errors import WrongUsage
from sdfcheck.source.text import IN_ATTRIBUTE, escape

_INDENT = "  "
_NOISE = 1e-15
"""Smaller numbers in a computed vector, or beside numbers of its scale, come from rounding."""


def render(
    root: Element, before: Iterable[Aside] = (), after: Iterable[Aside] = (), *, keeps_lines: bool = False
) -> str:
    """The text of a file: declaration, comments, root, comments.

    ``keeps_lines``: blank lines (one at most) and comments at the end of a line stay where their
    author put them.
    """
    lines = ['<?xml version="1.0"?>']
    lines += map(aside_text, before)
    _Writer(lines, keeps_lines).write(root, "", is_free=False)
    lines += map(aside_text, after)
    return "\n".join(lines) + "\n"


def with_line_ends(text: str, source: str) -> str:
    """A rendered text with the line ends of the file that it comes from."""
    line, end, _ = source.partition("\n")
    return text.replace("\n", "\r\n") if end and line.endswith("\r") else text


class _Writer:
    def __init__(self, lines: list[str], keeps_lines: bool) -> None:
        self.lines = lines
        self.keeps_lines = keeps_lines

    def write(self, element: Element, indent: str, *, is_free: bool) -> None:
        """Write an element; ``is_free``: it is in a plugin or a custom element.

        Words between elements there, and all in an element that says so (``xml:space``), keep every blank.
        """
        is_free = is_free or element.name == "plugin" or element.is_custom
        if _keeps_blanks(element) or (is_free and element.nodes and _has_mixed_content(element)):
            self.lines.append(f"{indent}{_inline(element)}")
            return
        start, text = f"{indent}{start_of(element)}", element.text.strip()
        if not element.nodes:
            self.lines.append(f"{start}>{escape(text)}</{element.name}>" if text else f"{start}/>")
            return
        self.lines.append(f"{start}>")
        inner = indent + _INDENT
        if text:
            self.lines.append(f"{inner}{escape(text)}")
        before = element.text
        for place, node in enumerate(element.nodes):
            breaks = before[len(before.rstrip()) :].count("\n")
            if self.keeps_lines and breaks > 1 and (text or place):
                self.lines.append("")
            if isinstance(node, Element):
                self.write(node, inner, is_free=is_free)
            elif self.keeps_lines and not breaks:
                self.lines[-1] += f" {aside_text(node)}"
            else:
                self.lines.append(f"{inner}{aside_text(node)}")
            if words := node.tail.strip():
                self.lines.append(f"{inner}{escape(words)}")
            before = node.tail
        self.lines.append(f"{indent}</{element.name}>")


def start_of(element: Element) -> str:
    """The start tag of an element, but for its end."""
    start = f"<{element.name}"
    for name, text in element.attributes.items():
        start += f' {name}="{escape(text, IN_ATTRIBUTE)}"'
    for prefix, uri in element.declared.items():
        start += f' {f"xmlns:{prefix}" if prefix else "xmlns"}="{escape(uri, IN_ATTRIBUTE)}"'
    return start


def _inline(node: Node) -> str:
    """A node without lines and spaces but its own."""
    if not isinstance(node, Element):
        return aside_text(node)
    if _gives_up_blanks(node):
        inner = escape(node.content) + "".join(map(_inline, node.nodes))
    else:
        inner = escape(node.text) + "".join(_inline(child) + escape(child.tail) for child in node.nodes)
    return f"{start_of(node)}>{inner}</{node.name}>" if inner else f"{start_of(node)}/>"


def aside_text(node: Aside) -> str:
    """A comment, without what would end it early, or a processing instruction."""
    if isinstance(node, Instruction):
        return f"<?{node.target} {node.text}?>" if node.text else f"<?{node.target}?>"
    text = re.sub("-(?=-)", "- ", node.text)
    return f"<!--{text} -->" if text.endswith("-") else f"<!--{text}-->"


_SPACE = "xml:space"


def _keeps_blanks(element: Element) -> bool:
    """Does an element say itself that its spaces matter?"""
    return element.attributes.get(_SPACE) == "preserve"


def _has_mixed_content(element: Element) -> bool:
    """Are there words between the elements in an element, or does it keep its spaces?"""
    if _keeps_blanks(element):
        return True
    words = sum(
        bool(text and not text.isspace()) for text in (element.text, *(node.tail for node in element.nodes))
    )
    return words > 1 or (words == 1 and any(True for _ in element.children()))


def _gives_up_blanks(element: Element) -> bool:
    return element.attributes.get(_SPACE) == "default" and not _has_mixed_content(element)


def declare(node: Xml, element: Element, prefix: str, top: dict[str, str]) -> None:
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


def undeclared_prefixes(root: Xml) -> set[str]:
    """The prefixes of names below a node that nothing declares there."""
    found: set[str] = set()
    waiting: list[tuple[Xml, tuple[str, ...]]] = [(root, ("xml", "xmlns"))]
    while waiting:
        node, declared = waiting.pop()
        if names := [name.split(":", 1) for name in (node.name, *node.attributes) if ":" in name]:
            declared = (*declared, *(name for prefix, name in names if prefix == "xmlns"))
            found.update(prefix for prefix, _ in names if prefix not in declared)
        waiting += [(child, declared) for child in node.children()]
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


# The marks by which SDFormat that was URDF becomes the same URDF again: attributes and elements under ``urdf:``.
#
# They say nothing of the robot, and are not compared.

JOINT, PARENT = "urdf:joint", "urdf:parent"
"""On a frame that was a link: the frame that was its joint, and what that joint was fixed to."""
LINK = "urdf:link"
"""On a shape, sensor or end of a joint: the link that it was of."""
INERTIAL = "urdf:inertial"
"""In a frame that was a link, or a link that others became part of: its own inertial."""
PACKAGES = "urdf:packages"
"""On a model: the packages whose files are named as those of models."""
EMPTY = "urdf:empty"
"""In an element that is kept under the prefix: its attributes without a value, of which libsdformat complains."""
BLOCK = "urdf:block"
"""On an element that is kept under the prefix: it was in a ``<gazebo>`` block."""
WAS, NONE = "urdf:was", "none"
"""On a parameter of a plugin about a link: its text before the link became part of another."""
MERGED, NOTHING = "urdf:merged", "urdf:nothing"
"""For the way back alone: a joint that was merged, and the inertial of a link that has none."""
SCRIPTS = "file://media/materials/scripts/gazebo.material"
"""Where the scripts are that a ``<material>`` of a ``<gazebo>`` block names."""
MARKS = frozenset({BLOCK, EMPTY, JOINT, PARENT, LINK, INERTIAL, PACKAGES, WAS, MERGED, NOTHING})


def is_mark(element: Element) -> bool:
    """Is an element a mark? An ``inertial`` elsewhere is one that its author wrote in the wrong place."""
    holder = element.parent
    is_marked = element.name != INERTIAL or (holder is not None and holder.name in {"link", "frame"})
    return element.name in MARKS and is_marked


# Shapes without extent, which no consumer of SDFormat takes as they are: 1 m goes in the place of each size.

_SIZED = frozenset({"box", "capsule", "cylinder", "ellipsoid", "sphere"})


def is_empty(geometry: Geometry) -> bool:
    """Is a size of it 0, or less?"""
    return geometry.kind in _SIZED and not all(size > 0 for size in geometry.size)


def without_empty_shapes(robot: Mechanism) -> Mechanism:
    """The robot without such shapes; the same object if it has none."""
    if not any(is_empty(shape) for link in robot.links.values() for shape in link.geometries):
        return robot
    links = {
        name: replace(link, geometries=type(link.geometries)(g for g in link.geometries if not is_empty(g)))
        for name, link in robot.links.items()
    }
    return replace(robot, links=links)
