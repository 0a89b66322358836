"""Children by name, looked up once for each element: a group may have any number of members."""

from __future__ import annotations

from sdfcheck.source.document import Document
from sdfcheck.source.element import Element


class FirstChildren:
    """The first child of each name, of the elements of a document."""

    __slots__ = ("_by_name", "_by_value")

    def __init__(self, document: Document) -> None:
        self._by_name: dict[Element, dict[str, Element]] = {}
        self._by_value: dict[tuple[Element, str, str], dict[str, Element]] = {}

    def of(self, parent: Element) -> dict[str, Element]:
        """The first children of an element by their names as written."""
        known = self._by_name.get(parent)
        if known is None:
            known = self._by_name[parent] = {}
            for child in parent.children():
                known.setdefault(child.name, child)
        return known

    def with_value(self, parent: Element, name: str, attribute: str) -> dict[str, Element]:
        """The first children of a name by the value of an attribute."""
        key = (parent, name, attribute)
        known = self._by_value.get(key)
        if known is None:
            known = self._by_value[key] = {}
            for child in parent.children(name):
                value = child.attribute(attribute)
                if value is not None:
                    known.setdefault(value.text, child)
        return known


def first_child(parent: Element, name: str) -> Element | None:
    """The first child of a name; the same as ``parent.find(name)``, where it is asked of every child."""
    return parent.document.view(FirstChildren).of(parent).get(name)
