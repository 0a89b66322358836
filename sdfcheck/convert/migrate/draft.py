"""A description on its way to another version: elements that change, with every character that does not."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from sdfcheck.convert.loss import refusal
from sdfcheck.convert.result import with_text
from sdfcheck.convert.writer import aside_text, start_of
from sdfcheck.source.altered import Altered, Xml, copied_as
from sdfcheck.source.document import Aside, Comment, Document, Element
from sdfcheck.source.document import Node as Read
from sdfcheck.source.text import IN_QUOTES, escape

# Elements that can be changed, on lines of their own.


_DEFAULT_INDENT = "  "


class Node(Xml):
    """An element of a draft; ``source`` is the element as which it is written if nothing changes.

    ``origin`` is the element of the source that it comes from, None for one that a step made.
    """

    __slots__ = ("source",)
    parent: Node | None

    def __init__(self, name: str, text: str | None = None, /, **attributes: str) -> None:
        super().__init__(name, text, **attributes)
        self.source: Element | None = None

    if TYPE_CHECKING:

        def children(self, name: str | None = None) -> Iterator[Node]: ...
        def walk(self) -> Iterator[Node]: ...
        def reach(self, *names: str) -> Node: ...

    @property
    def place(self) -> Element | None:
        """The nearest element of the source: where to point when speaking of this node."""
        at: Node | None = self
        while at is not None and at.origin is None:
            at = at.parent
        return at.origin if at is not None else None

    @property
    def is_as_read(self) -> bool:
        """Is its start tag the one of its source?"""
        source = self.source
        return source is not None and (self.name, self.attributes) == (source.name, source.attributes)

    # Looking

    def find(self, path: str) -> Node | None:
        """The first child of a name, or what a path of such steps leads to."""
        at: Node | None = self
        for step in path.split("/"):
            at = next(at.children(step), None) if at is not None else None
        return at

    def standard(self) -> Iterator[Node]:
        """All nodes below this one that are the format's: nothing custom, nothing inside plugins."""
        waiting: list[Read] = [self]
        while waiting:
            node = waiting.pop()
            if isinstance(node, Node):
                if node is not self:
                    yield node
                if node.name != "plugin":
                    waiting += [
                        inner for inner in reversed(node.nodes) if inner.name and ":" not in inner.name
                    ]

    def of(self, *names: str) -> list[Node]:
        """The standard nodes below this one that have one of the names."""
        return [node for node in self.standard() if node.name in names]

    # Changing

    def unset(self, name: str) -> None:
        """Take an attribute out; what it says must be said elsewhere."""
        self.attributes.pop(name, None)

    def rename_attribute(self, name: str, to: str) -> None:
        self.attributes = {to if key == name else key: text for key, text in self.attributes.items()}

    def copy(self) -> Node:
        """A copy of it, without a parent."""
        made = copied_as(Node, self)
        for one, other in zip(made.walk(), self.walk(), strict=True):
            one.origin, one.source = other.origin, other.source
        return made

    def take_out(self) -> None:
        """Take the node out of its parent, with the line that it leaves empty."""
        parent = self.parent
        assert parent is not None
        place = parent.nodes.index(self)
        before, after = self._before, self.tail
        is_beside = place > 0 and isinstance(parent.nodes[place - 1], Aside) and "\n" not in before
        if before and not is_beside and not before.rpartition("\n")[2].strip():
            follows = place + 1 < len(parent.nodes) and isinstance(parent.nodes[place + 1], Aside)
            rest = after.lstrip(" \t")
            if rest[:1] in {"\n", "\r"} or not (rest or follows):
                before = before.rstrip(" \t").removesuffix("\n").removesuffix("\r")
            else:
                after = rest
        del parent.nodes[place]
        if place:
            parent.nodes[place - 1].tail = before + after
        else:
            parent.text = before + after
        self.parent = None

    def exchange(self, others: list[Node]) -> None:
        """Put others in the place of this node, each on a line of its own, after the comments in it."""
        parent, indent = self.parent, self.indent
        assert parent is not None
        row: list[Read] = [*(node for node in self.nodes if isinstance(node, Comment)), *others]
        for node in row:
            node.parent, node.tail = parent, "\n" + indent
        for other in others:
            other.shift(indent)
        row[-1].tail = self.tail
        place = parent.nodes.index(self)
        parent.nodes[place : place + 1] = row
        self.parent = None

    def enter(self, child: Node, *, before: Node | None = None, after: Node | None = None) -> Node:
        """Put a child last, or beside a sibling, on a line of its own."""
        siblings = list(self.children())
        beside = before or after or (siblings[-1] if siblings else None)
        child.parent = self
        if beside is None:
            self._enter_first(child)
            return child
        indent = beside.indent
        child.shift(indent)
        place = self.nodes.index(beside)
        if before is not None:
            child.tail = "\n" + indent
            self.nodes.insert(place, child)
        else:
            child.tail, beside.tail = beside.tail, "\n" + indent
            self.nodes.insert(place + 1, child)
        return child

    def _enter_first(self, child: Node) -> None:
        child.tail = ""
        if self.nodes or self.text.strip():
            self.nodes.append(child)
            return
        own = self.indent
        inner = own + self._step
        child.shift(inner)
        self.text, child.tail = "\n" + inner, "\n" + own
        self.nodes = [child]

    def add(self, name: str, text: str | None = None, /, **attributes: str) -> Node:
        """A new last child."""
        return self.enter(Node(name, text, **attributes))

    def add_first(self, name: str) -> Node:
        """A new first child."""
        return self.enter(Node(name), before=next(self.children(), None))

    # Lines

    @property
    def _before(self) -> str:
        """The text between it and the node before it."""
        assert self.parent is not None
        place = self.parent.nodes.index(self)
        return self.parent.nodes[place - 1].tail if place else self.parent.text

    @property
    def indent(self) -> str:
        """The spaces before the node on its line; empty if something else is there."""
        if self.parent is None:
            return ""
        _, line, blanks = self._before.rpartition("\n")
        return blanks if line and not blanks.strip() else self.parent.indent

    @property
    def _step(self) -> str:
        own, outer = self.indent, self.parent.indent if self.parent is not None else ""
        return own[len(outer) :] or _DEFAULT_INDENT

    def shift(self, indent: str) -> None:
        """Indent the lines below the first as for a node that is at ``indent``."""
        last = self.nodes[-1].tail if self.nodes else self.text
        _, line, old = last.rpartition("\n")
        if line and not old.strip() and old != indent:
            self._reindent("\n" + old, "\n" + indent)

    def _reindent(self, old: str, new: str) -> None:
        self.text = self.text.replace(old, new)
        for node in self.nodes:
            node.tail = node.tail.replace(old, new)
            if isinstance(node, Node):
                node._reindent(old, new)
            else:
                node.text = node.text.replace(old, new)


_ENCODING = re.compile(
    r"""(<\?xml[^<>]*?encoding\s*=\s*["'])(?!utf-8["']|(?:us-)?ascii["'])[\w.:-]+""", re.IGNORECASE
)
_LONE = re.compile(r"(?<!\r)\n")
_ATTRIBUTE = re.compile(r"""(?<!\s)(\s+)([^\s=<>/"']+)\s*=\s*("[^"]*"|'[^']*')""")
# A piece without an end goes on to the last character: many of them must not be searched one by one.
_ASIDE = re.compile(r"<!--.*?(?:-->|\Z)|<\?.*?(?:\?>|\Z)|(<!\[CDATA\[.*?(?:\]\]>|\Z))", re.DOTALL)
_NAME = re.compile(r"<[^\s/>]*")
_Run = tuple[str | tuple[str], ...]
"""The texts and (as tuples) the comments and instructions between two elements."""
_Runs = dict[tuple[_Run, Element | None], str]
"""A run, and the element after it → how it is spelled in the file."""


class Draft(Altered):
    """A document whose elements change. Text that no step touches is written as it was: spaces, quotes, entities.

    ``text`` is that of the file, where the document has another one with the same places.
    """

    root: Node
    _seen: Altered
    """The document as it was read last."""

    def __init__(self, document: Document, raw: str | None = None) -> None:
        super().__init__(document, Node)
        self._raw = document.source.text if raw is None else raw
        self._laid: dict[Element, Element] = {}
        """Element of the document → the one with its places, where it has none in the text."""
        read = document
        if isinstance(document, Altered):
            read = with_text(document, self._raw)
            self._laid = dict(zip(document.elements, read.elements, strict=True))
        for node in self.root.walk():
            node.source = node.origin
        assert read.root is not None
        place = read.spans.place(read.root)
        # Results are written as UTF-8, whatever the source was.
        self._head = _ENCODING.sub(r"\1UTF-8", self._raw[: place.start])
        self._end = self._raw[place.close_end :]
        self._has_crlf = "\r\n" in self._raw and not _LONE.search(self._raw)

    def read(self) -> Altered:
        """The document as it is now, in which no later change is."""
        self.number()
        self._seen = Altered(self)
        return self._seen

    def element(self, node: Node) -> Element:
        """The element of a node, as of the last reading."""
        return self._seen.copies[node]

    def reread(self, text: str) -> Document:
        """The document as which the text of the draft is read."""
        if text == self.original.source.text:
            return self.original
        made = with_text(self.original, text)
        root = made.root
        if root is None or [one.name for one in root.walk()] != [one.name for one in self.root.walk()]:
            # A parser guesses otherwise at broken text once something around it has changed.
            place = self.original.root
            assert place is not None
            raise refusal(place, "the text is broken, so that it cannot be changed and read again")
        return made

    # Writing

    def text(self) -> str:
        text = f"{self._head}{self._written(self.root)}{self._end}"
        return _LONE.sub("\r\n", text) if self._has_crlf else text

    def _written(self, node: Node) -> str:
        start, runs, end = f"{start_of(node)}>", _Runs(), f"</{node.name}>"
        if node.source is not None:
            start, runs, end = self._as_read(node, node.source)
        spelled: dict[str, str] | None = None
        pieces: list[str] = []
        for run, child in _runs(node):
            raw = runs.get((run, child.source if isinstance(child, Node) else None))
            if raw is None:
                if spelled is None:
                    spelled = dict(
                        word for (known, _), text in runs.items() for word in _spelled(known, text)
                    )
                raw = "".join(_respelled(one, spelled) for one in run)
            pieces.append(raw)
            if isinstance(child, Node):
                pieces.append(self._written(child))
        inner = "".join(pieces)
        if inner and start.endswith("/>"):
            start, end = f"{start.removesuffix('/>').rstrip()}>", f"</{node.name}>"
        return f"{start}{inner}{end}"

    def _as_read(self, node: Node, source: Element) -> tuple[str, _Runs, str]:
        """The start tag of a node, its texts as its source has them, and the end tag."""
        read = self._laid.get(source, source)
        text = self._raw if source.document is self.original else read.document.source.text
        spans = read.document.spans
        place = spans.place(read)
        start, end = text[place.start : place.end], text[place.close : place.close_end]
        is_renamed = source is self.original.root and self._raw is not self.original.source.text
        if is_renamed or node.name != source.name:
            start = _NAME.sub(f"<{node.name}", start, count=1)
            end = f"</{node.name}>" if end else ""
        if not node.is_as_read:
            start = _changed(start, node.attributes, source.attributes)
        runs = _Runs()
        at = place.end
        for (run, child), own in zip(_runs(read), (*source.children(), None), strict=True):
            inner = spans.place(child) if child is not None else None
            runs[run, own] = text[at : place.close if inner is None else inner.start]
            at = at if inner is None else inner.close_end
        return start, runs, end


def _runs(element: Element) -> Iterator[tuple[_Run, Element | None]]:
    """The texts and comments before each element in one, and those after the last."""
    run: list[str | tuple[str]] = [element.text]
    for node in element.nodes:
        if isinstance(node, Element):
            yield tuple(run), node
            run = [node.tail]
        else:
            run += [(aside_text(node),), node.tail]
    yield tuple(run), None


def _spelled(run: _Run, raw: str) -> Iterator[tuple[str, str]]:
    """Each text and comment of a run, without blanks around it, and how it is spelled in the file."""
    ends = [0, *(place for match in _ASIDE.finditer(raw) if not match[1] for place in match.span()), len(raw)]
    for one, start, end in zip(run, ends, ends[1:], strict=False):
        yield (one.strip() if isinstance(one, str) else one[0]), raw[start:end].strip()


def _respelled(one: str | tuple[str], spelled: dict[str, str]) -> str:
    """A text or comment as it is spelled in the file, as far as it was there."""
    if not isinstance(one, str):
        return spelled.get(one[0], one[0])
    words = one.strip()
    return one.replace(words, spelled.get(words, escape(words))) if words else one


def _changed(tag: str, now: dict[str, str], before: dict[str, str]) -> str:
    """A start tag with the attributes that an element has now."""
    pairs = zip(before.items(), now.items(), strict=False)
    renamed = {
        old: new for (old, text), (new, same) in pairs if text == same and not (old in now or new in before)
    }
    found = {match[2]: match for match in _ATTRIBUTE.finditer(tag)}
    for name, match in sorted(found.items(), key=lambda pair: -pair[1].start()):
        to = renamed.get(name, name)
        if name not in before:
            continue
        if to not in now:
            tag = tag[: match.start()] + tag[match.end() :]
        elif now[to] != before[name]:
            tag = tag[: match.start(3)] + _quoted(now[to], match[3][0]) + tag[match.end(3) :]
        elif to != name:
            tag = tag[: match.start(2)] + to + tag[match.end(2) :]
    kept = tag.removesuffix(">").removesuffix("/").rstrip()
    known = {*found, *renamed.values()}
    added = (name for name in now if name not in known and now[name] != before.get(name))
    return kept + "".join(f" {name}={_quoted(now[name])}" for name in added) + tag[len(kept) :]


def _quoted(value: str, quote: str = '"') -> str:
    return quote + escape(value, {quote: IN_QUOTES[quote]}) + quote
