"""A copy of a document that may be changed; what is wrong with it has its place where it was read."""

from __future__ import annotations

from copy import copy

from sdfcheck.source.document import Document, Element, Node, Spans
from sdfcheck.source.scanner.scan import ElementPlace, Scan
from sdfcheck.source.scanner.start_tag import StartTag
from sdfcheck.source.text import Source, Span, Step


class Altered(Document):
    """A document with the elements of another one, and what was brought into it from others.

    Its text is that of the other one, unchanged. :meth:`number` comes after the last change,
    before the first view.
    """

    __slots__ = ("copies", "origin", "original")

    def __init__(self, original: Document) -> None:
        self.original = original
        self.origin: dict[Element, Element] = {}
        """Element → what it is a copy of."""
        self.copies: dict[Element, Element] = {}
        """Element of the original → its copy."""
        for name in (
            "source",
            "problems",
            "library",
            "included_by",
            "is_referred_to",
            "is_wellformed",
            "kind",
        ):
            setattr(self, name, getattr(original, name))
        self.names, self.prolog, self.epilog = original.names, original.prolog, original.epilog
        self._scan, self._spans, self._views = None, None, {}
        self.root = None if original.root is None else self._copied(original.root, None)
        self.copies = {element: made for made, element in self.origin.items()}
        self.declared = {self.copies[element]: own for element, own in original.declared.items()}
        self.number()

    # Changes

    def add(self, parent: Element, element: Element, leave_out: frozenset[str] = frozenset()) -> Element:
        """Append a copy of an element of any document, without some of its attributes."""
        made = self._copied(element, parent, leave_out)
        made.tail = ""
        parent.nodes = [*parent.nodes, made]
        return made

    def replace(self, old: Element, element: Element, leave_out: frozenset[str] = frozenset()) -> Element:
        """Put a copy of an element of any document in the place of one."""
        assert old.parent is not None
        made = self._copied(element, old.parent, leave_out)
        made.tail = old.tail
        old.parent.nodes = [made if node is old else node for node in old.parent.nodes]
        return made

    def remove(self, element: Element) -> None:
        """Take out an element; the blanks after it replace those before it."""
        parent = element.parent
        assert parent is not None
        place = next(number for number, node in enumerate(parent.nodes) if node is element)
        if place:
            parent.nodes[place - 1].tail = parent.nodes[place - 1].tail.rstrip() + element.tail
        else:
            parent.text = parent.text.rstrip() + element.tail
        parent.nodes = [node for node in parent.nodes if node is not element]

    def write(self, element: Element, given: Element) -> None:
        """Give an element the text of another one, and its place."""
        holder: Node | None = None
        for node in element.nodes if not element.text.strip() else ():
            if node.name:
                break
            if node.tail.strip():
                holder = node
                break
        if holder is None:
            element.text = given.content
        else:
            holder.tail = given.content
        self.origin[element] = given

    def number(self) -> None:
        """List and number the elements anew, in their order."""
        self.elements = []
        waiting: list[Node] = [] if self.root is None else [self.root]
        while waiting:
            node = waiting.pop()
            node.index = len(self.elements)
            if isinstance(node, Element):
                self.elements.append(node)
                waiting += reversed(node.nodes)

    def _copied(
        self, element: Element, parent: Element | None, leave_out: frozenset[str] = frozenset()
    ) -> Element:
        attributes = {name: text for name, text in element.attributes.items() if name not in leave_out}
        made = Element(element.name, attributes, parent, self, 0)
        made.text, made.tail = element.text, element.tail
        self.origin[made] = element
        if element.nodes:
            made.nodes = [self._copied_node(node, made, leave_out) for node in element.nodes]
        return made

    def _copied_node(self, node: Node, parent: Element, leave_out: frozenset[str]) -> Node:
        if isinstance(node, Element):
            return self._copied(node, parent, leave_out)
        aside = copy(node)
        aside.parent = parent
        return aside

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
    """The element of a file that one was copied from; itself if it was not."""
    while isinstance(element.document, Altered) and element in element.document.origin:
        element = element.document.origin[element]
    return element


class _Spans(Spans):
    """Every place is that of the origin, in whichever file it is."""

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
        return read.document.spans.span(read, start, end)

    def start_tag(self, element: Element) -> StartTag:
        read = origin_of(element)
        return read.document.spans.start_tag(read)
