"""Elements that can be changed, and a copy of a document made of them, which has the places of what was read."""

from __future__ import annotations

from collections.abc import Container, Iterable, Iterator, Mapping
from copy import copy
from typing import TYPE_CHECKING, TypeVar

from sdfcheck.source.document import Document, Element, Node, Spans, take_declarations
from sdfcheck.source.scanner.scan import ElementPlace, Scan
from sdfcheck.source.scanner.start_tag import StartTag
from sdfcheck.source.text import Source, Span, Step

X = TypeVar("X", bound="Xml")


class Xml(Element):
    """An element that can be changed; ``origin`` is what it is a copy of, None for a new one.

    Declarations of prefixes are attributes until it is numbered as a part of an :class:`Altered`
    document, which also sets ``parent``, ``document`` and ``index``.
    """

    __slots__ = ("origin",)
    origin: Element | None

    def __init__(self, name: str, text: str | None = None, /, **attributes: str) -> None:
        self.name = name
        self.attributes = attributes
        self.parent = self.origin = None
        self.index = 0
        self.text, self.tail = text or "", ""
        self.nodes = []

    if TYPE_CHECKING:

        def children(self, name: str | None = None) -> Iterator[Xml]: ...
        def find(self, name: str) -> Xml | None: ...
        def walk(self) -> Iterator[Xml]: ...

    @property
    def declared(self) -> Mapping[str, str]:
        return self.document.declared.get(self, {}) if hasattr(self, "document") else {}

    def add(self, name: str, text: str | None = None, /, **attributes: str) -> Xml:
        """Append a new child element and return it."""
        return self.append(Xml(name, text, **attributes))

    def append(self, element: Xml) -> Xml:
        """Append an element and return it."""
        element.parent, element.tail = self, ""
        self.nodes.append(element)
        return element

    def extend(self, *nodes: Node) -> None:
        """Append elements, and copies of comments."""
        self.insert(len(self.nodes), *nodes)

    def insert(self, place: int, *nodes: Node) -> None:
        """The same at a place among the nodes."""
        made = [node if isinstance(node, Element) else copy(node) for node in nodes]
        for node in made:
            node.parent, node.tail = self, ""
        self.nodes[place:place] = made

    def put(self, child: Xml) -> None:
        """Replace the first child of that name, or become the first one."""
        old = self.find(child.name)
        if old is None:
            self.insert(0, child)
        else:
            self.replace(old, child)

    def replace(self, old: Node, *others: Node) -> None:
        """Put others in the place of a node, each on a line of its own; the last one has the text after it."""
        place = self._at(old)
        self.nodes[place : place + 1] = others
        for other in others:
            other.parent = self
            other.tail = old.tail if other is others[-1] else "\n" * max(1, other.tail.count("\n"))

    def remove(self, node: Node) -> None:
        """Take out a node; the blanks after it replace those before it."""
        place = self._at(node)
        if place:
            self.nodes[place - 1].tail = self.nodes[place - 1].tail.rstrip() + node.tail
        else:
            self.text = self.text.rstrip() + node.tail
        del self.nodes[place]

    def drop(self, names: Container[str]) -> None:
        """Take out the child elements of some names."""
        for child in self.children():
            if child.name in names:
                self.remove(child)

    def reach(self, *names: str) -> Xml:
        """The element at the end of a path of names; what is missing is made."""
        at = self
        for name in names:
            at = at.find(name) or at.add(name)
        return at

    def write(self, text: str) -> None:
        """Replace the content, the first text before any element that is not blank; the blanks around it stay."""
        holder: Node = self
        for node in self.nodes if not self.text.strip() else ():
            if node.name:
                break
            if node.tail.strip():
                holder = node
                break
        before = self.text if holder is self else holder.tail
        written = before.replace(before.strip(), text, 1) if before.strip() else text + before
        if holder is self:
            self.text = written
        else:
            holder.tail = written

    def say(self, text: str) -> None:
        """Have no other text than this, and of the attributes the custom ones only."""
        self.text = text
        self.attributes = {name: value for name, value in self.attributes.items() if ":" in name}
        for node in self.nodes:
            node.tail = ""

    def _at(self, wanted: Node) -> int:
        return next(place for place, node in enumerate(self.nodes) if node is wanted)


def copied(element: Element, without: Iterable[str] = ()) -> Xml:
    """A copy of an element with all that is in it, but for some attributes."""
    return copied_as(Xml, element, without)


def copied_as(kind: type[X], element: Element, without: Iterable[str] = ()) -> X:
    """The same, made of elements of a kind."""
    made = kind(element.name)
    made.attributes = element.attributes.copy()
    for name in without:
        made.attributes.pop(name, None)
    if element.declared:
        made.attributes |= declared_prefixes(element)
    made.text, made.tail, made.origin, made.index = element.text, element.tail, element, element.index
    for node in element.nodes:
        inner: Node = copied_as(kind, node, without) if isinstance(node, Element) else copy(node)
        inner.parent = made
        made.nodes.append(inner)
    return made


def declared_prefixes(element: Element) -> dict[str, str]:
    """The prefixes that an element itself declares, as attributes."""
    parent = element.parent
    known = parent.namespaces if element.declared and parent is not None else {}
    return {
        f"xmlns:{prefix}" if prefix else "xmlns": uri
        for prefix, uri in element.declared.items()
        if known.get(prefix) != uri and not uri.startswith("http://www.w3.org/XML/")
    }


class Altered(Document):
    """A document whose elements are copies of those of another one, and may be changed.

    Its text is that of the other one; what is wrong with an element has its place where that was read.
    :meth:`number` comes after the last change, before the first view.
    """

    __slots__ = ("copies", "original")
    root: Xml | None

    def __init__(self, original: Document, kind: type[Xml] = Xml) -> None:
        self.original = original
        for name in (
            "source",
            "problems",
            "library",
            "included_by",
            "is_referred_to",
            "is_open",
            "is_wellformed",
            "kind",
        ):
            setattr(self, name, getattr(original, name))
        self.prolog, self.epilog = original.prolog, original.epilog
        self._scan, self._spans, self._views = None, None, {}
        self.declared, self.names = {}, original.names
        self.root = None if original.root is None else copied_as(kind, original.root)
        self.elements = [] if self.root is None else list(self.root.walk())
        for element in self.elements:
            element.document = self
        take_declarations(self)
        self.copies = dict(zip(original.elements, self.elements, strict=True))
        """Element of the original → its copy."""

    def number(self) -> None:
        """List and number the elements anew, in their order; take the declarations out of their attributes."""
        self.elements = []
        names: dict[str, None] = {}
        waiting: list[Node] = [] if self.root is None else [self.root]
        while waiting:
            node = waiting.pop()
            node.index = len(self.elements)
            if isinstance(node, Element):
                node.document = self
                self.elements.append(node)
                names[node.name] = None
                names |= dict.fromkeys(node.attributes)
                for inner in node.nodes:
                    inner.parent = node
                waiting += reversed(node.nodes)
        self.names = names.keys()
        take_declarations(self)

    # Places

    @property
    def spans(self) -> Spans:
        if self._spans is None:
            self._spans = _Spans(self.source)
        return self._spans

    @property
    def is_expanded(self) -> bool:
        return self.original.is_expanded

    def is_doubtful(self, span: Span) -> bool:
        return self.original.is_doubtful(span)

    def origins(self, element: Element) -> tuple[Step, ...]:
        read = origin_of(element)
        return read.document.origins(read)


def origin_of(element: Element) -> Element:
    """The element of a file that one was copied from; of a new one, that of the element around it."""
    while isinstance(element, Xml):
        origin = element.parent if element.origin is None else element.origin
        if origin is None:
            break
        element = origin
    return element


class _Spans(Spans):
    """Every place is that of the origin, in whichever file it is; in a new element, the name of that."""

    __slots__ = ()

    def __init__(self, source: Source) -> None:
        self.source = source

    def place(self, element: Element) -> ElementPlace:
        read = origin_of(element)
        return read.document.spans.place(read)

    def found(self, element: Element) -> tuple[Scan, int]:
        read = origin_of(element)
        return read.document.spans.found(read)

    def home(self, element: Element) -> Source:
        read = origin_of(element)
        return read.document.spans.home(read)

    def span(self, element: Element, start: int, end: int) -> Span:
        read = origin_of(element)
        is_new = isinstance(element, Xml) and element.origin is None
        return read.span if is_new else read.document.spans.span(read, start, end)

    def start_tag(self, element: Element) -> StartTag:
        read = origin_of(element)
        return read.document.spans.start_tag(read)
