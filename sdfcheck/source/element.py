"""Elements: lxml's, with the names, values and places that robot descriptions need."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, ClassVar, TypeVar, overload

from lxml import etree

from sdfcheck.source.rewritten import COLON, written_name
from sdfcheck.source.text import Span

if TYPE_CHECKING:
    from sdfcheck.source.document import Document

T = TypeVar("T", str, int, float, bool)


class Value:
    """The text of an attribute, or of an element, together with its place.

    ``attribute`` is None for the text of the element itself.
    """

    __slots__ = ("attribute", "element", "text")

    def __init__(self, element: Element, attribute: str | None, text: str) -> None:
        self.element = element
        self.attribute = attribute
        self.text = text

    def __repr__(self) -> str:
        at = f"@{self.attribute}" if self.attribute else ""
        return f"Value({self.element.name}{at}={self.text!r})"

    @property
    def number(self) -> float:
        """The text as a number; nan if it is not a number."""
        try:
            return float(self.text)
        except ValueError:
            return float("nan")

    def to(self, type: type[T]) -> T:
        """The text as str, int, float or bool; raises ValueError, with the place, if it has another type."""
        try:
            if type is bool:
                return _BOOLEANS[self.text.strip().lower()]
            return type(self.text)
        except (ValueError, KeyError):
            line, column = self.span.begin
            place = f"{self.span.source.path}:{line}:{column}"
            named = self.attribute or self.element.name
            raise ValueError(f"{place}: {named} is {self.text!r}, not {type.__name__}") from None

    @property
    def span(self) -> Span:
        """The value without its quotes or surrounding spaces; the name where it is empty."""
        spans = self.element.document.spans
        if self.attribute is not None:
            return spans.attribute_value(self.element, self.attribute)
        return spans.text(self.element)

    def part(self, index: int) -> Span:
        """The place of the ``index``-th word of the value."""
        return self.element.document.spans.part(self.span, index)

    @property
    def name_span(self) -> Span:
        """The name of the attribute, or of the element."""
        if self.attribute is not None:
            return self.element.document.spans.attribute_name(self.element, self.attribute)
        return self.element.span


class Element(etree.ElementBase):
    """An element of a document.

    Names are *as written*: ``link``, ``drake:joint``. Whether a prefix is declared
    does not matter, as it does not to libsdformat and Drake, which read text.
    Nothing here modifies the document.
    """

    # Each document has a subclass of its own that carries it: lxml makes and drops element proxies at
    # any time, so they cannot hold anything themselves.
    document: ClassVar[Document]

    if TYPE_CHECKING:
        # A parser makes all elements of a document of this class; comments have a function for a tag.
        tag: Any

        def __iter__(self) -> Iterator[Element]: ...  # type: ignore[override]
        def iterchildren(self, *tags: Any) -> Iterator[Any]: ...  # type: ignore[override]
        def items(self) -> list[tuple[str, str]]: ...

    @property
    def name(self) -> str:
        tag: str = self.tag
        return written_name(tag, self.prefix) if tag[0] == "{" or COLON in tag else tag

    @property
    def title(self) -> str:
        """The element in a sentence: ``joint `elbow```, or ```axis``` without a name of its own."""
        own = self.text_of("name", "").strip()
        return f"{self.name} `{own}`" if own else f"`{self.name}`"

    @property
    def is_custom(self) -> bool:
        """Prefixed, so not part of the standard (custom-elements proposal, SDFormat 1.7)."""
        return ":" in self.name

    @property
    def span(self) -> Span:
        """The place of the name in the start tag."""
        return self.document.spans.name(self)

    @property
    def parent(self) -> Element | None:
        return self.getparent()  # type: ignore[return-value]

    @property
    def around(self) -> Iterator[Element]:
        """The elements around it, the innermost first."""
        return self.iterancestors()  # type: ignore[return-value]

    @property
    def content(self) -> str:
        """The text as simulators read it: the first text that is not blank, before any child element."""
        text = self.text
        if text and (text := text.strip()):
            return text
        for node in self:
            if isinstance(node.tag, str):
                break
            if node.tail and (text := node.tail.strip()):
                return text
        return ""

    @property
    def attributes(self) -> dict[str, str]:
        """All attributes by their names as written; declarations of prefixes are not among them."""
        items = self.items()
        for key, _ in items:
            if key[0] == "{" or COLON in key:
                return self._as_written(items)
        return dict(items)

    def _as_written(self, items: list[tuple[str, str]]) -> dict[str, str]:
        prefixes = {uri: prefix for prefix, uri in self.nsmap.items() if prefix}
        prefixes["http://www.w3.org/XML/1998/namespace"] = "xml"
        names: dict[str, str] = {}
        for key, text in items:
            prefix = prefixes.get(key[1 : key.index("}")]) if key[0] == "{" else None
            names[written_name(key, prefix)] = text
        return names

    def children(self, name: str | None = None) -> Iterator[Element]:
        """The child elements, or those of one name; comments are ignored."""
        if name is None or ":" not in name:
            # A name without a colon is in no namespace: lxml compares such names itself.
            return self.iterchildren(name or "*")
        return (child for child in self.children() if child.name == name)

    def find(self, name: str) -> Element | None:  # type: ignore[override]
        """The first child element of that name (as written, prefix included)."""
        children = self.children(name) if ":" in name else self.iterchildren(name)
        return next(children, None)

    def has(self, name: str) -> bool:
        """Is there a child element of that name?"""
        return self.find(name) is not None

    def next(self, name: str | None = None) -> Element | None:
        """The next sibling element, of that name if one is given."""
        for node in self.itersiblings():
            if isinstance(node, Element) and (name is None or node.name == name):
                return node
        return None

    @overload
    def text_of(self, name: str) -> str | None: ...
    @overload
    def text_of(self, name: str, default: str) -> str: ...
    def text_of(self, name: str, default: str | None = None) -> str | None:
        """The text of the attribute of that name (as written, prefix included)."""
        return super().get(name, default) if ":" not in name else self.attributes.get(name, default)

    def attribute(self, name: str) -> Value | None:
        """The attribute of that name (as written, prefix included)."""
        text = super().get(name) if ":" not in name else self.attributes.get(name)
        return None if text is None else Value(self, name, text)

    def value(self, name: str) -> Value | None:
        """The attribute or else the child element of that name, as a value."""
        found = self.attribute(name)
        if found is None and (child := self.find(name)) is not None:
            return Value(child, None, child.content)
        return found

    def number(self, name: str) -> Value | None:
        """Like :meth:`value`, but None also when the text is not a number."""
        found = self.value(name)
        return found if found is not None and found.number == found.number else None

    @property
    def own_value(self) -> Value:
        """The text of this element as a value."""
        return Value(self, None, self.content)

    @overload  # type: ignore[override]
    def get(self, name: str) -> str | None: ...
    @overload
    def get(self, name: str, type: type[T]) -> T | None: ...
    def get(self, name: str, type: type[T] | type[str] = str) -> T | str | None:
        """The typed value of an attribute, else of a child element; None if there is neither.

        ``type`` is str, int, float or bool. Raises ValueError, with the place, for a
        text that is not of the type.
        """
        found = self.value(name)
        return None if found is None else found.to(type)  # type: ignore[type-var]


_BOOLEANS = {"true": True, "1": True, "false": False, "0": False}
