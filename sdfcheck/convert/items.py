"""The items of a source, as messages call them, and whether the format has them where they are."""

from __future__ import annotations

from collections.abc import Container, Iterable, Iterator

from sdfcheck.robot.model import Model
from sdfcheck.robot.root import root_of
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element
from sdfcheck.source.sniff import Kind

_SHOWN = 30
_NAMED = frozenset({"joint", "link"})
"""Parts that share the names of a model."""


def models(document: Document) -> list[Model]:
    """The models at the top of a file and of its worlds, in document order."""
    tops = ((top,) if isinstance(top, Model) else top.nodes.values() for top in root_of(document).scopes)
    return [node for nodes in tops for node in nodes if isinstance(node, Model) and node.is_readable]


def belongs(element: Element) -> bool:
    """Does the format have an element of that name at that place?"""
    if element.document.kind is Kind.URDF:
        from sdfcheck.formats.urdf.misspellings import definition as urdf_definition

        return urdf_definition(element) is not None
    from sdfcheck.formats.sdf.schema import Definition, schema
    from sdfcheck.formats.sdf.version import NEWEST

    names = [each.name for each in (element, *element.around)]
    definition: Definition | None = schema(NEWEST).root
    for name in reversed(names[:-1]):
        definition = definition.children.get(name) if definition is not None else None
    return definition is not None


def texts(element: Element) -> Iterator[str]:
    """The texts right in an element that are not blank."""
    found = (element.text, *(node.tail for node in element.nodes))
    return (text for text in found if text and not text.isspace())


def shortened(text: str) -> str:
    """The beginning of a text, on one line."""
    words = " ".join(text.split())
    return words if len(words) <= _SHOWN else f"{words[:_SHOWN]}…"


def shown(element: Element) -> str:
    """The name of an element in a sentence, with its value if that is short, and its parent."""
    text = element.content
    value = ""
    if text and len(text) <= _SHOWN and next(element.children(), None) is None:
        value = f" ({text})"
    where = f" in {element.parent.title}" if element.parent is not None else ""
    return f"{element.title}{value}{where}"


def other_shapes(element: Element) -> list[Element]:
    """The shapes beside a shape in its geometry, which can have one; empty for any other element."""
    at = element.parent
    return (
        [child for child in at.children() if child is not element]
        if at is not None and at.name == "geometry"
        else []
    )


def part_names(elements: Iterable[object]) -> frozenset[str | None]:
    """The names of the links and joints among some nodes."""
    return frozenset(
        element.get("name") for element in elements if isinstance(element, Element) and element.name in _NAMED
    )


def is_namesake(element: Element, names: Container[str | None]) -> bool:
    """Is it a link or joint whose name is another one's? Then nothing can refer to this one."""
    return element.name in _NAMED and element.get("name") in names
