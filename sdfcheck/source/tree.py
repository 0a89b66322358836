"""Fills the tree of a document: one pass of a parser in C, which takes names as text."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from pyexpat import ExpatError, ParserCreate
from typing import TYPE_CHECKING, cast

from sdfcheck.source.element import Aside, Comment, Element, Instruction, Node
from sdfcheck.source.limits import ATTRIBUTE_LIMIT, DEPTH_LIMIT, LENGTH_LIMIT

if TYPE_CHECKING:
    from sdfcheck.source.document import Document

_LONG_TAG = re.compile(rf"<[^<]{{{5 * ATTRIBUTE_LIMIT}}}")
"""A tag in which there is room for so many attributes."""
_DECLARATION = "xmlns"
_Handlers = tuple[
    Callable[[str, dict[str, str]], None],
    Callable[[str], None],
    Callable[[str], None],
    Callable[[Aside], None],
]


class Refused(Exception):
    """The text has what is not read: a document type, which may define entities, or an element that is too deep."""


def fill(document: Document, text: str) -> int | None:
    """Make the elements of a text those of the document.

    Returns None, or where the text stops to be well formed, in characters; then the elements up
    to there are the document's. A text with more than is looked at has its fault at its start.
    """
    fault = _parse(document, text)
    if fault is not None and not text.isascii() and (table := _younger_letters(text)):
        fault = _parse(document, text.translate(table))
        _translate(document, {spare: letter for letter, spare in table.items()})
    document.root = document.elements[0] if document.elements else None
    if declarations := [name for name in document.names if name.partition(":")[0] == _DECLARATION]:
        _take_declarations(document, declarations)
    return 0 if fault is None and _is_overloaded(document, text) else fault


def _parse(document: Document, text: str) -> int | None:
    document.declared = {}
    document.prolog, document.epilog = [], []
    document.elements = []
    names: dict[str, str] = {}
    data = text.encode("utf-8", "surrogatepass")
    parser = ParserCreate("utf-8", None, names)
    parser.buffer_text = True
    parser.buffer_size = max(len(data), 8192)  # so that each text comes in one piece
    start, end, characters, aside = _handlers(document)
    parser.StartElementHandler, parser.EndElementHandler = start, end
    parser.CharacterDataHandler = characters
    parser.CommentHandler = lambda text: aside(Comment(text))
    parser.ProcessingInstructionHandler = lambda target, text: aside(Instruction(target, text))
    parser.XmlDeclHandler = _check_version
    parser.StartDoctypeDeclHandler = _refuse
    fault = None
    try:
        parser.Parse(data, True)
    except (ExpatError, Refused):
        fault = len(data[: parser.ErrorByteIndex].decode("utf-8", "ignore"))
    names.pop(None, None)  # type: ignore[call-overload]  # the encoding that a declaration lacks
    document.names = names.keys()
    return fault


def _younger_letters(text: str) -> dict[int, int]:
    """Letter → one that the text lacks, for those that may be in names.

    The parser knows the names of the first editions of XML, which had the letters of an older Unicode.
    """
    from sdfcheck.source.scanner.xml_names import is_name

    letters = set(text)
    spare = (code for code in range(0x4E00, 0x9FA6) if chr(code) not in letters)
    return dict(
        zip((ord(letter) for letter in letters if letter > "\x7f" and is_name(letter)), spare, strict=False)
    )


def _translate(document: Document, table: Mapping[int, int]) -> None:
    """Exchange letters in all that was read."""
    for element in document.elements:
        element.name = element.name.translate(table)
        given = element.attributes.items()
        element.attributes = {name.translate(table): text.translate(table) for name, text in given}
        for node in (element, *element.nodes):
            node.text, node.tail = node.text.translate(table), node.tail.translate(table)
    for node in (*document.prolog, *document.epilog):
        node.text = node.text.translate(table)
    document.names = {name.translate(table) for name in document.names}


def _handlers(document: Document) -> _Handlers:
    """The handlers of a start tag, an end tag, a text, and a comment or instruction."""
    at: Element | None = None
    last: Node | None = None
    depth = 0
    elements = document.elements
    same = cast("dict[str, str]", {}).setdefault

    def start(name: str, attributes: dict[str, str]) -> None:
        nonlocal at, last, depth
        if (depth := depth + 1) > DEPTH_LIMIT:
            raise Refused
        element = Element(name, attributes, at, document, len(elements))
        elements.append(element)
        if last is not None:
            at.nodes.append(element)  # type: ignore[union-attr]
        elif at is not None:
            at.nodes = [element]
        at, last = element, None

    def end(_: str) -> None:
        nonlocal at, last, depth
        at, last, depth = at.parent, at, depth - 1  # type: ignore[union-attr]

    def characters(text: str) -> None:
        if last is None:
            at.text = same(text, text)  # type: ignore[union-attr]
        else:
            last.tail = same(text, text)

    def aside(node: Aside) -> None:
        nonlocal last
        last = _put(document, node, at, last)

    return start, end, characters, aside


def _put(document: Document, node: Aside, at: Element | None, last: Node | None) -> Node | None:
    """Put a comment or instruction after the last node of an element; returns the last one now."""
    node.parent, node.index = at, len(document.elements)
    if at is None:
        (document.epilog if document.elements else document.prolog).append(node)
        return last
    if last is None:
        at.nodes = [node]
    else:
        at.nodes.append(node)
    return node


def _take_declarations(document: Document, names: list[str]) -> None:
    """Take the declarations of prefixes out of the attributes."""
    for element in document.elements:
        attributes = element.attributes
        if own := {name.partition(":")[2]: attributes.pop(name) for name in names if name in attributes}:
            document.declared[element] = own


def _is_overloaded(document: Document, text: str) -> bool:
    """Has an element more attributes, or longer texts, than are looked at?"""
    if text.count("=") > ATTRIBUTE_LIMIT and _LONG_TAG.search(text) is not None:
        given = (len(element.attributes) + len(element.declared) for element in document.elements)
        if max(given, default=0) > ATTRIBUTE_LIMIT:
            return True
    return len(text) > LENGTH_LIMIT and any(map(_is_too_long, document.elements))


def _is_too_long(element: Element) -> bool:
    texts = (element.text, *element.attributes.values(), *(node.tail for node in element.nodes))
    return max(map(len, texts)) > LENGTH_LIMIT


def _check_version(version: str, *_: object) -> None:
    if version[:2] != "1." or not version[2:].isdecimal():
        raise Refused


def _refuse(*_: object) -> None:
    raise Refused
