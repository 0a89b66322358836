"""The tree of a document: plain objects, with the names, values and places that robot descriptions need."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterator, Mapping, Sequence
from operator import attrgetter
from typing import TYPE_CHECKING, Literal, TypeAlias, TypeVar, cast, overload

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


class Aside:
    """A comment or a processing instruction, and the text after it.

    ``index`` is the number of the next element.
    """

    __slots__ = ("index", "parent", "tail", "text")
    name: Literal[""] = ""
    parent: Element | None
    index: int

    def __init__(self, text: str) -> None:
        self.text = text
        self.tail = ""


class Comment(Aside):
    """A comment."""

    __slots__ = ()


class Instruction(Aside):
    """A processing instruction, ``<?target text?>``."""

    __slots__ = ("target",)

    def __init__(self, target: str, text: str) -> None:
        super().__init__(text)
        self.target = target


class Element:
    """An element of a document.

    Names are *as written*: ``link``, ``drake:joint``. Whether a prefix is declared
    does not matter, as it does not to libsdformat and Drake, which read text.
    ``text`` is what is before its first node, ``tail`` what is after it before the next node
    of its parent; ``attributes`` do not hold the declarations of prefixes. ``index`` is its
    number in the document, in the order of start tags.
    """

    __slots__ = ("attributes", "document", "index", "name", "nodes", "parent", "tail", "text")
    nodes: list[Node]
    """The child elements, and the comments and instructions between them."""

    def __init__(
        self, name: str, attributes: dict[str, str], parent: Element | None, document: Document, index: int
    ) -> None:
        self.name = name
        self.attributes = attributes
        self.parent = parent
        self.document = document
        self.index = index
        self.text = self.tail = ""
        self.nodes = _NO_NODES

    def __repr__(self) -> str:
        return f"<Element {self.name} {self.attributes}>"

    @property
    def title(self) -> str:
        """The element in a sentence: ``joint `elbow```, or ```axis``` without a name of its own."""
        own = self.attributes.get("name", "").strip()
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
    def around(self) -> Iterator[Element]:
        """The elements around it, the innermost first."""
        at = self.parent
        while at is not None:
            yield at
            at = at.parent

    @property
    def below(self) -> Iterator[Element]:
        """All elements in it, in the order of the document."""
        waiting = [node for node in reversed(self.nodes) if node.name]
        while waiting:
            element = cast("Element", waiting.pop())
            yield element
            if element.nodes:
                waiting += [node for node in reversed(element.nodes) if node.name]

    def walk(self) -> Iterator[Element]:
        """Itself and all elements in it, in the order of the document."""
        yield self
        yield from self.below

    @property
    def before(self) -> Sequence[Node]:
        """The nodes before it in its parent; those of the root are before the description."""
        return self.document.prolog if self.parent is None else self.parent.nodes[: self._place]

    @property
    def after(self) -> Sequence[Node]:
        """The nodes after it in its parent."""
        return self.document.epilog if self.parent is None else self.parent.nodes[self._place + 1 :]

    @property
    def _place(self) -> int:
        """Its place among the nodes of its parent."""
        assert self.parent is not None
        nodes = self.parent.nodes
        place = bisect_left(nodes, self.index, key=attrgetter("index"))
        while nodes[place] is not self:
            place += 1
        return place

    @property
    def declared(self) -> Mapping[str, str]:
        """The prefixes that the element itself declares, with their namespaces; the default one has no name."""
        return self.document.declared.get(self, {})

    @property
    def namespaces(self) -> dict[str, str]:
        """The prefixes that are declared on it or around it, with their namespaces."""
        found = dict(self.declared)
        if self.document.declared:
            for element in self.around:
                found = {**element.declared, **found}
        return found

    @property
    def content(self) -> str:
        """The text as simulators read it: the first text that is not blank, before any child element."""
        if text := self.text.strip():
            return text
        for node in self.nodes:
            if node.name:
                break
            if text := node.tail.strip():
                return text
        return ""

    def children(self, name: str | None = None) -> Iterator[Element]:
        """The child elements, or those of one name; comments are ignored."""
        if name is None:
            return iter([node for node in self.nodes if node.name])  # type: ignore[misc]
        return iter([node for node in self.nodes if node.name == name])  # type: ignore[misc]

    def find(self, name: str) -> Element | None:
        """The first child element of that name (as written, prefix included)."""
        for node in self.nodes:
            if node.name == name:
                return node  # type: ignore[return-value]
        return None

    def has(self, name: str) -> bool:
        """Is there a child element of that name?"""
        return self.find(name) is not None

    def next(self, name: str | None = None) -> Element | None:
        """The next sibling element, of that name if one is given."""
        for node in self.after:
            if isinstance(node, Element) and (name is None or node.name == name):
                return node
        return None

    @overload
    def text_of(self, name: str) -> str | None: ...
    @overload
    def text_of(self, name: str, default: str) -> str: ...
    def text_of(self, name: str, default: str | None = None) -> str | None:
        """The text of the attribute of that name (as written, prefix included)."""
        return self.attributes.get(name, default)

    def attribute(self, name: str) -> Value | None:
        """The attribute of that name (as written, prefix included)."""
        text = self.attributes.get(name)
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

    @overload
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

Node: TypeAlias = Element | Aside
_NO_NODES = cast("list[Node]", ())
