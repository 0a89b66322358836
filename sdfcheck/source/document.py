"""One file: its text, its tree of elements with their places, and what other layers have worked out about it."""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Callable, Collection, Iterator, Mapping, Set
from operator import attrgetter
from pathlib import Path
from pyexpat import ExpatError, ParserCreate
from typing import TYPE_CHECKING, Any, Literal, TypeAlias, TypeVar, cast, overload

from sdfcheck.source.decode import ATTRIBUTE_LIMIT, DEPTH_LIMIT, LENGTH_LIMIT, decode
from sdfcheck.source.sniff import HEAD, MADE_BY_XACRO, Kind, sniff
from sdfcheck.source.text import Source, Span, Step, pattern

if TYPE_CHECKING:
    from sdfcheck.source.problems import Problem
    from sdfcheck.source.scanner.scan import ElementPlace, Scan
    from sdfcheck.source.scanner.start_tag import AttributePlace, StartTag


# The tree of a document: plain objects, with the names, values and places that robot descriptions need.


V = TypeVar("V", str, int, float, bool)


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

    def to(self, type: type[V]) -> V:
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
    def before(self) -> Iterator[Node]:
        """The nodes before it in its parent, the nearest first; those of the root are before the description."""
        if self.parent is None:
            yield from reversed(self.document.prolog)
        else:
            nodes = self.parent.nodes
            yield from (nodes[place] for place in range(self._place - 1, -1, -1))

    @property
    def after(self) -> Iterator[Node]:
        """The nodes after it in its parent."""
        if self.parent is None:
            yield from self.document.epilog
        else:
            nodes = self.parent.nodes
            yield from (nodes[place] for place in range(self._place + 1, len(nodes)))

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
    def get(self, name: str, type: type[V]) -> V | None: ...
    def get(self, name: str, type: type[V] | type[str] = str) -> V | str | None:
        """The typed value of an attribute, else of a child element; None if there is neither.

        ``type`` is str, int, float or bool. Raises ValueError, with the place, for a
        text that is not of the type.
        """
        found = self.value(name)
        return None if found is None else found.to(type)  # type: ignore[type-var]


_BOOLEANS = {"true": True, "1": True, "false": False, "0": False}

Node: TypeAlias = Element | Aside
_NO_NODES = cast("list[Node]", ())


# From an element to its characters.


_PIECE = pattern(
    r"<!--.*?(?:-->|\Z)|<!\[CDATA\[(?P<cdata>.*?)(?:\]\]>|\Z)|<\?.*?(?:\?>|\Z)|(?P<markup><)|(?P<text>[^<]+)",
    re.DOTALL,
)
_WORD = pattern(r"\S+")
_FIRST = pattern(r"<[A-Za-z_:][\w:.-]* ([A-Za-z_]\w*)=\"([^\"<]+)\"")
"""A start tag and its first attribute, as they are usually written."""
_LONG = 1000
"""Characters of a start tag that is kept."""


class Spans:
    """Places of one document's elements, attributes and texts.

    Element number ``n`` of the tree, in document order, is start tag ``n`` of the scan.
    """

    __slots__ = ("_last", "_long", "scan", "source")

    def __init__(self, source: Source, scan: Scan) -> None:
        self.source = source
        self.scan = scan
        self._long: dict[int, StartTag] = {}
        """Tags that take a while to read, such as those of macros with many parameters."""
        self._last: tuple[int, StartTag] | None = None
        """The number of a start tag, and the tag: what is asked about next is mostly in the same one."""

    def place(self, element: Element) -> ElementPlace:
        """Offsets of the element's start and end tags in its :meth:`home`."""
        scan, index = self.found(element)
        return scan.place(index)

    def found(self, element: Element) -> tuple[Scan, int]:
        """The scan that has the element, and its number there."""
        return self.scan, element.index

    def home(self, element: Element) -> Source:
        """The text in which the element is."""
        return self.source

    def span(self, element: Element, start: int, end: int) -> Span:
        """A range of the text in which the element is."""
        return self.source.span(start, end)

    def name(self, element: Element) -> Span:
        tag = self.start_tag(element)
        return self.span(element, tag.name_start, tag.name_end)

    def whole(self, element: Element) -> Span:
        """From the start tag's ``<`` to after the end tag."""
        place = self.place(element)
        return self.span(element, place.start, place.close_end)

    def end_name(self, element: Element) -> Span | None:
        """The name in the end tag; None if there is no end tag."""
        place = self.place(element)
        if place.close == place.close_end:
            return None
        name = self.start_tag(element).name
        return self.span(element, place.close + 2, place.close + 2 + len(name))

    def start_tag(self, element: Element) -> StartTag:
        from sdfcheck.source.scanner.scan import parse_start_tag

        number = element.index
        if self._last is None or self._last[0] != number:
            start = self.scan.starts[number]
            tag = (
                self._long.get(number) or self.scan.odd.get(number) or parse_start_tag(self.source, start)[0]
            )
            self._last = number, tag
            if tag.end - start > _LONG:
                self._long[number] = tag
        return self._last[1]

    def attribute_name(self, element: Element, name: str) -> Span:
        place = self._attribute(element, name)
        return self.span(element, place.name_start, place.name_end) if place else self.name(element)

    def attribute_value(self, element: Element, name: str) -> Span:
        """The value between its quotes; the attribute's name where the value is empty."""
        scan, index = self.found(element)
        first = _FIRST.match(self.home(element).text, scan.starts[index])
        if first is not None and first[1] == name:
            return self.span(element, *first.span(2))
        place = self._attribute(element, name)
        if place is None:
            return self.name(element)
        if place.value_start == place.value_end:
            return self.span(element, place.name_start, place.name_end)
        return self.span(element, place.value_start, place.value_end)

    def attribute_whole(self, element: Element, name: str) -> Span:
        """Name, equals sign and quoted value, with the spaces before them: what deleting it takes."""
        place = self._attribute(element, name)
        if place is None:
            return self.name(element)
        text = self.home(element).text
        start = place.name_start
        while text[start - 1].isspace():
            start -= 1
        end = place.value_end
        if text[end : end + 1] in {'"', "'"}:
            end += 1
        return self.span(element, start, end)

    def text(self, element: Element) -> Span:
        """The text that simulators read, without spaces around it; the element's name if there is none."""
        scan, index = self.found(element)
        for piece in _PIECE.finditer(self.home(element).text, *scan.inside(index, self.start_tag(element))):
            if piece["markup"]:
                break
            group = "cdata" if piece["cdata"] is not None else "text"
            raw = piece[group] or ""
            if raw.strip():
                start = piece.start(group) + len(raw) - len(raw.lstrip())
                return self.span(element, start, start + len(raw.strip()))
        return self.name(element)

    def part(self, span: Span, index: int) -> Span:
        """The ``index``-th word inside a span; the whole span if it has fewer."""
        for number, word in enumerate(_WORD.finditer(span.source.text, span.start, span.end)):
            if number == index:
                return span.source.span(word.start(), word.end())
        return span

    def _attribute(self, element: Element, name: str) -> AttributePlace | None:
        return next((a for a in self.start_tag(element).attributes if a.name == name), None)


# Fills the tree of a document: one pass of a parser in C, which takes names as text.


_LONG_TAG = pattern(rf"<[^<]{{{5 * ATTRIBUTE_LIMIT}}}")
"""A tag in which there is room for so many attributes."""
_LONG_TEXT = pattern(rf"<(?:[^<]{{{LENGTH_LIMIT}}}|!\[CDATA\[)")
"""A tag or a text with room for so many characters, or a section, which may have all characters."""
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
    take_declarations(document)
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
    from sdfcheck.source.scanner.start_tag import is_name

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


def take_declarations(document: Document) -> None:
    """Take the declarations of prefixes out of the attributes."""
    names = [name for name in document.names if name.partition(":")[0] == _DECLARATION]
    for element in document.elements if names else ():
        attributes = element.attributes
        if own := {name.partition(":")[2]: attributes.pop(name) for name in names if name in attributes}:
            document.declared[element] = own


def _is_overloaded(document: Document, text: str) -> bool:
    """Has an element more attributes, or longer texts, than are looked at?"""
    if text.count("=") > ATTRIBUTE_LIMIT and _LONG_TAG.search(text) is not None:
        given = (len(element.attributes) + len(element.declared) for element in document.elements)
        if max(given, default=0) > ATTRIBUTE_LIMIT:
            return True
    if len(text) > LENGTH_LIMIT and _LONG_TEXT.search(text) is not None:
        return any(map(_is_too_long, document.elements))
    return False


def _is_too_long(element: Element) -> bool:
    texts = (element.text, *element.attributes.values(), *(node.tail for node in element.nodes))
    return max(map(len, texts)) > LENGTH_LIMIT


def _check_version(version: str, *_: object) -> None:
    if version[:2] != "1." or not version[2:].isdecimal():
        raise Refused


def _refuse(*_: object) -> None:
    raise Refused


T = TypeVar("T")


LONG, LONGEST = 200_000, 20_000_000
"""Of texts of such a length that are broken, only the place of the fault is scanned, if that is enough."""

_LINTED = frozenset((Kind.SDF, Kind.URDF, Kind.XACRO, Kind.MODEL_CONFIG, Kind.SRDF))
_KINDS = {"sdf": Kind.SDF, "robot": Kind.URDF, "model": Kind.MODEL_CONFIG}


class Document:
    """A robot description as it was read.

    ``root`` is None only if the text holds no element at all; ``problems`` are those of
    the text, in order of place. Views (frames, names, …) are computed once, by
    :meth:`view`.
    """

    __slots__ = (
        "__dict__",
        "_scan",
        "_spans",
        "_views",
        "declared",
        "elements",
        "epilog",
        "included_by",
        "is_open",
        "is_referred_to",
        "is_wellformed",
        "kind",
        "library",
        "names",
        "problems",
        "prolog",
        "root",
        "source",
    )

    def __init__(self, source: Source, kind: Kind | None, problems: list[Problem]) -> None:
        self.source = source
        self.problems = problems
        self._scan: Scan | None = None
        self._spans: Spans | None = None
        self._views: dict[Callable[[Document], Any], Any] = {}
        self.library: object | None = None
        """Where files that this one refers to come from; None: nothing is looked up."""
        self.included_by: tuple[Value, ...] = ()
        """The uris through which the file was reached, from the outside in; empty for one that was asked for."""
        self.is_referred_to = False
        """Was another document reached through an include in it?"""
        self.is_open = False
        """Are links or joints missing in it, or the names of some, as they are not known?"""
        self.is_wellformed = False
        """Did a strict parser take the text as it is?"""
        self.root: Element | None
        self.elements: list[Element] = []
        """All elements, in the order of their start tags."""
        self.names: Set[str] = frozenset()
        """The names of elements and attributes."""
        self.declared: dict[Element, dict[str, str]] = {}
        """Element → the prefixes that it declares, with their namespaces."""
        self.prolog: list[Aside] = []
        """The comments and instructions before the root."""
        self.epilog: list[Aside] = []
        """Those after it."""
        self._parse()
        name = self.root.name if self.root is not None else ""
        self.kind = kind or _KINDS.get(name) or sniff(_encoded(source.text[:HEAD]), source.path)
        """The dialect; worked out from the text where the caller does not say."""

    def __repr__(self) -> str:
        return f"Document({str(self.path)!r}, {self.kind.value})"

    @property
    def path(self) -> Path:
        return self.source.path

    @property
    def version(self) -> str | None:
        """The text of the root element's ``version``."""
        return None if self.root is None else self.root.text_of("version")

    @property
    def is_recognized(self) -> bool:
        """Is this something that is linted?"""
        return self.kind in _LINTED

    @property
    def is_made_by_xacro(self) -> bool:
        """Does a remark above the root say that xacro has written it?"""
        return any(MADE_BY_XACRO in node.text for node in self.prolog)

    def is_doubtful(self, span: Span) -> bool:
        """Does a place lie where the text could only be read by a guess?

        There the problems of the text say what is wrong; whatever else seems to be
        follows from the guess.
        """
        if self._scan is None or span.source is not self.source:
            return False
        return any(start <= span.start < end for start, end in self._scan.doubtful)

    @property
    def scan(self) -> Scan:
        """The places of everything; made when first asked for."""
        if self._scan is None:
            from sdfcheck.source.scanner.scan import quick_scan

            self._scan = quick_scan(self.source)
        return self._scan

    def written(self, span: Span) -> Span:
        """The place that one in the text comes from: itself, but for texts that are made of others."""
        return span

    @property
    def spans(self) -> Spans:
        if self._spans is None:
            self._spans = Spans(self.source, self.scan)
        return self._spans

    @property
    def is_expanded(self) -> bool:
        """Whether the text was made from others, in which the places are."""
        return False

    def may_write(self, pattern: str) -> bool:
        """Whether the texts that it was made from have a place that fits, which may become a part of it."""
        return False

    def may_name(self, pattern: str, name: str) -> bool:
        """Do the texts that it was made from give a name, by the last group of the pattern, where it has nothing?"""
        return False

    def names_of_others(self, pattern: str, element: Element) -> Set[str]:
        """The names in the texts of other robots, if the one that an element is written in is a part of several."""
        return frozenset()

    def origins(self, element: Element) -> tuple[Step, ...]:
        """The macro calls and includes that led to an element, the nearest first."""
        return ()

    def view(self, compute: Callable[[Document], T]) -> T:
        """The result of ``compute(self)``, computed once."""
        if compute not in self._views:
            self._views[compute] = compute(self)
        return self._views[compute]  # type: ignore[no-any-return]

    def forget_views(self, kept: Collection[Callable[[Document], Any]]) -> None:
        """Drop the views but for some, since other documents have changed; how it was reached is forgotten, too."""
        self._views = {compute: view for compute, view in self._views.items() if compute in kept}
        self.included_by, self.is_referred_to = (), False

    def release(self) -> None:
        """Drop the tree and the views, which refer to one another; the text is kept."""
        for view in self._views.values():
            if (release := getattr(view, "release", None)) is not None:
                release()
        self._views.clear()
        if not self.is_referred_to:
            for element in self.elements:
                if element.nodes:
                    element.nodes.clear()
        self.root = self._spans = self._scan = self.library = None
        self.elements, self.declared = [], {}
        self.problems, self.included_by = [], ()

    def _parse(self) -> None:
        """Fill the tree from the text; from a repaired one where it is broken."""
        fault = fill(self, self.source.text)
        if fault is None:
            self.is_wellformed = True
            return
        if self._parse_without_hyphens(fault) or self._parse_locally(fault):
            return
        from sdfcheck.source.scanner.full_scan import scan

        self._scan = scan(self.source)
        found = self._scan.problems
        self.problems = [*self.problems, *found]
        if not found:
            self.problems += (unexplained := _unexplained(self.source))
            if not unexplained:
                self._scan.doubtful.clear()
        fill(self, self._scan.wellformed)

    def _parse_without_hyphens(self, fault: int) -> bool:
        """Try it with the hyphens of comments spaced out, of which there are too many."""
        text = self.source.text
        if text.rfind("<!--", 0, fault) <= text.rfind("-->", 0, fault):
            return False
        from sdfcheck.source.scanner.tokens import without_hyphens

        spaced = without_hyphens(self.source)
        if spaced is None:
            return False
        text, found = spaced
        if fill(self, text) is not None:
            return False
        self.problems = [*self.problems, *found]
        return True

    def _parse_locally(self, fault: int) -> bool:
        """Try it with a repair of the one place in which a long text is broken."""
        if not LONG <= len(self.source.text) <= LONGEST:
            return False
        from sdfcheck.source.scanner.full_scan import local_scan

        found = local_scan(self.source, fault)
        if found is None or fill(self, found.wellformed) is not None:
            return False
        if len(self.elements) != len(found.starts):
            return False
        self._scan = found
        self.problems = [*self.problems, *found.problems]
        return True


def read(data: bytes, path: Path, kind: Kind | None = None) -> Document:
    """Read a file's bytes. Never fails: what is wrong is in the document's ``problems``."""
    source, problems = decode(data, path)
    return Document(source, kind, list(problems))


def problems(document: Document) -> list[Problem]:
    """The problems of the text; of a text that is not a robot description, only that one."""
    if document.is_recognized:
        return document.problems
    from sdfcheck.source.scanner.recognition import unrecognized

    root = document.root
    found = (root.name, root.span) if root is not None else (None, None)
    return [unrecognized(document.source, document.kind, *found)]


def _encoded(text: str) -> bytes:
    return text.encode("utf-8", "surrogatepass")


def _unexplained(source: Source) -> list[Problem]:
    """The fault that another parser finds in a text where the scan knows none; it may take the text, too."""
    from lxml import etree

    from sdfcheck.source.problems import SyntaxDefect, SyntaxKind

    parser = etree.XMLParser(encoding="utf-8", resolve_entities=False, no_network=True, load_dtd=False)
    try:
        etree.fromstring(_encoded(source.text), parser)
    except etree.XMLSyntaxError:
        fatal = (entry for entry in parser.error_log if entry.level == etree.ErrorLevels.FATAL)
        for entry in fatal:
            if entry.type == etree.ErrorTypes.ERR_ATTRIBUTE_REDEFINED:
                continue  # reported as such
            at = source.offset(entry.line, max(entry.column, 1))
            words = entry.message.rstrip(". ")
            words = words[:1].lower() + words[1:]
            return [SyntaxDefect(source.span(at, at), SyntaxKind.OTHER, None, words)]
    return []
