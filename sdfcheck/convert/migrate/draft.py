"""A description on its way to another version: elements that change, with every character that does not."""

from __future__ import annotations

import re
from collections.abc import Iterator

from sdfcheck.convert.loss import refusal
from sdfcheck.convert.result import with_text
from sdfcheck.source.document import Document, Element
from sdfcheck.source.references import IN_QUOTES, escape, unescape

# Elements that can be changed, with every character of the file that is not.
#
# Text that no step touches is written back as it was: spaces, quotes, comments, entities.


_ATTRIBUTE = re.compile(r"""(?<!\s)(\s+)([^\s=<>/"']+)\s*=\s*("[^"]*"|'[^']*')""")
# A piece without an end goes on to the last character: many of them must not be searched one by one.
_PIECE = re.compile(
    r"<!--.*?(?:-->|\Z)|<\?.*?(?:\?>|\Z)|<!\[CDATA\[(?P<cdata>.*?)(?:\]\]>|\Z)|(?P<text>[^<]+)", re.DOTALL
)
_COMMENT = re.compile(r"<!--.*?(?:-->|\Z)", re.DOTALL)
_DEFAULT_INDENT = "  "


class Node:
    """An element of a draft: its tags as written, and between them texts and nodes.

    ``origin`` is the element of the source that it comes from, None for one that a step made. ``source`` is the
    element whose text it is, and ``written`` its start tag there.
    """

    __slots__ = ("closing", "name", "opening", "origin", "parent", "parts", "source", "written")

    def __init__(
        self, name: str, opening: str = "", closing: str | None = None, origin: Element | None = None
    ) -> None:
        self.name = name
        self.opening = opening or f"<{name}>"
        self.closing = f"</{name}>" if closing is None else closing
        self.origin = origin
        self.source = origin
        self.written = self.opening
        self.parent: Node | None = None
        self.parts: list[str | Node] = []

    def __repr__(self) -> str:
        return f"Node({self.opening})"

    @property
    def place(self) -> Element | None:
        """The nearest element of the source: where to point when speaking of this node."""
        at: Node | None = self
        while at is not None and at.origin is None:
            at = at.parent
        return at.origin if at is not None else None

    @property
    def is_custom(self) -> bool:
        return ":" in self.name

    def text(self) -> str:
        """The node as it is to be written."""
        return "".join(
            (self.opening, *(p if isinstance(p, str) else p.text() for p in self.parts), self.closing)
        )

    # Looking

    def children(self, name: str | None = None) -> list[Node]:
        return [p for p in self.parts if isinstance(p, Node) and (name is None or p.name == name)]

    def find(self, path: str) -> Node | None:
        """The first child of a name, or what a path of such steps leads to."""
        at: Node | None = self
        for step in path.split("/"):
            at = next((p for p in at.parts if isinstance(p, Node) and p.name == step), None) if at else None
        return at

    def walk(self) -> Iterator[Node]:
        """The node and all below it, in document order."""
        yield self
        for child in self.children():
            yield from child.walk()

    def standard(self) -> Iterator[Node]:
        """All nodes below this one that are the format's: nothing custom, nothing inside plugins."""
        for child in self.children():
            if not child.is_custom:
                yield child
                if child.name != "plugin":
                    yield from child.standard()

    def of(self, *names: str) -> list[Node]:
        """The standard nodes below this one that have one of the names."""
        return [node for node in self.standard() if node.name in names]

    @property
    def content(self) -> str:
        """The text as simulators read it: the first that is not blank, before any child."""
        for part in self.parts:
            if isinstance(part, Node):
                break
            for piece in _PIECE.finditer(part):
                raw = piece["cdata"] if piece["cdata"] is not None else unescape(piece["text"] or "")
                if raw.strip():
                    return raw.strip()
        return ""

    def attributes(self) -> dict[str, str]:
        found = _ATTRIBUTE.finditer(self.opening, len(self.name) + 1)
        return {match[2]: unescape(match[3][1:-1]) for match in found}

    def get(self, name: str) -> str | None:
        return self.attributes().get(name)

    # Changing

    def set(self, name: str, value: str) -> None:
        """Give an attribute a value; a new one comes last."""
        for match in _ATTRIBUTE.finditer(self.opening, len(self.name) + 1):
            if match[2] == name:
                quoted = _quoted(value, match[3][0])
                self.opening = self.opening[: match.start(3)] + quoted + self.opening[match.end(3) :]
                return
        kept = self.opening.removesuffix(">").removesuffix("/").rstrip()
        self.opening = f"{kept} {name}={_quoted(value)}{self.opening[len(kept) :]}"

    def unset(self, name: str) -> None:
        """Take an attribute out; what it says must be said elsewhere."""
        for match in _ATTRIBUTE.finditer(self.opening, len(self.name) + 1):
            if match[2] == name:
                self.opening = self.opening[: match.start()] + self.opening[match.end() :]
                return

    def rename_attribute(self, name: str, to: str) -> None:
        for match in _ATTRIBUTE.finditer(self.opening, len(self.name) + 1):
            if match[2] == name:
                self.opening = self.opening[: match.start(2)] + to + self.opening[match.end(2) :]
                return

    def rename(self, name: str) -> None:
        self.opening = f"<{name}{self.opening[len(self.name) + 1 :]}"
        if self.closing:
            self.closing = f"</{name}>"
        self.name = name

    def write(self, text: str) -> None:
        """Replace the content; spaces and comments around it stay."""
        self._open()
        written = escape(text)
        for number, part in enumerate(self.parts):
            if isinstance(part, Node):
                break
            for piece in _PIECE.finditer(part):
                raw = piece["cdata"] if piece["cdata"] is not None else piece["text"]
                if raw and raw.strip():
                    start = piece.start() + len(piece[0]) - len(piece[0].lstrip())
                    end = piece.start() + len(piece[0].rstrip())
                    self.parts[number] = part[:start] + written + part[end:]
                    return
        self.parts.insert(0, written)

    def copy(self) -> Node:
        """A copy of it, without a parent."""
        other = Node(self.name, self.opening, self.closing, self.origin)
        other.written = self.written
        for part in self.parts:
            other.parts.append(part if isinstance(part, str) else part.copy())
            if isinstance(inner := other.parts[-1], Node):
                inner.parent = other
        return other

    def remove(self) -> None:
        """Take the node out, with the line that it leaves empty."""
        parent = self.parent
        assert parent is not None
        at = parent.parts.index(self)
        del parent.parts[at]
        self.parent = None
        before = parent.parts[at - 1] if at else None
        after = parent.parts[at] if at < len(parent.parts) else ""
        if not isinstance(before, str) or before.rpartition("\n")[2].strip() or not isinstance(after, str):
            return
        if after.lstrip(" \t")[:1] in {"\n", "\r", ""}:
            parent.parts[at - 1] = before.rstrip(" \t").removesuffix("\n").removesuffix("\r")
        else:
            parent.parts[at] = after.lstrip(" \t")

    def replace(self, others: list[Node]) -> None:
        """Put others in the place of this node, each on a line of its own, after the comments in it."""
        parent, indent = self.parent, self.indent
        assert parent is not None
        at = parent.parts.index(self)
        comments = [c for part in self.parts if isinstance(part, str) for c in _COMMENT.findall(part)]
        row: list[str | Node] = []
        for comment in comments:
            row += [comment] if not row else ["\n" + indent + comment]
        for other in others:
            other.parent = parent
            other.shift(indent)
            row += [other] if not row else ["\n" + indent, other]
        parent.parts[at : at + 1] = row
        self.parent = None

    def append(self, child: Node, *, before: Node | None = None, after: Node | None = None) -> Node:
        """Put a child last, or beside a sibling, on a line of its own."""
        self._open()
        siblings = self.children()
        beside = before or after or (siblings[-1] if siblings else None)
        child.parent = self
        if beside is None:
            self._first(child)
            return child
        indent = beside.indent
        child.shift(indent)
        at = self.parts.index(beside)
        if before is not None:
            self.parts[at:at] = [child, "\n" + indent]
        else:
            self.parts[at + 1 : at + 1] = ["\n" + indent, child]
        return child

    def add(self, name: str, text: str = "", *, first: bool = False) -> Node:
        """A new last child, or a new first one."""
        child = Node(name)
        if text:
            child.parts.append(escape(text))
        siblings = self.children() if first else []
        return self.append(child, before=siblings[0] if siblings else None)

    def path(self, path: str) -> Node:
        """The node that a path leads to; steps that are missing are made."""
        at = self
        for step in path.split("/"):
            at = at.find(step) or at.add(step)
        return at

    @property
    def indent(self) -> str:
        """The spaces before the node on its line; empty if something else is there."""
        if self.parent is None:
            return ""
        at = self.parent.parts.index(self)
        before = self.parent.parts[at - 1] if at else ""
        if isinstance(before, Node) or "\n" not in before:
            return self.parent.indent
        blanks = before[before.rindex("\n") + 1 :]
        return blanks if not blanks.strip() else self.parent.indent

    def shift(self, indent: str) -> None:
        """Indent the lines below the first as for a node that is at ``indent``."""
        last = self.parts[-1] if self.parts else ""
        if not isinstance(last, str) or "\n" not in last or last[last.rindex("\n") :].strip():
            return
        old = last[last.rindex("\n") + 1 :]
        if old != indent:
            self._reindent("\n" + old, "\n" + indent)

    def _reindent(self, old: str, new: str) -> None:
        for number, part in enumerate(self.parts):
            if isinstance(part, str):
                self.parts[number] = part.replace(old, new)
            else:
                part._reindent(old, new)

    def _first(self, child: Node) -> None:
        own = self.indent
        if self.parts and "".join(p for p in self.parts if isinstance(p, str)).strip():
            self.parts += [child]
            return
        inner = own + self._step()
        child.shift(inner)
        self.parts = ["\n" + inner, child, "\n" + own]

    def _step(self) -> str:
        own, outer = self.indent, self.parent.indent if self.parent is not None else ""
        return own[len(outer) :] or _DEFAULT_INDENT

    def _open(self) -> None:
        """Give an element without end tag one."""
        if not self.closing:
            self.opening = self.opening.removesuffix("/>").rstrip() + ">"
            self.closing = f"</{self.name}>"


def _quoted(value: str, quote: str = '"') -> str:
    return quote + escape(value, {quote: IN_QUOTES[quote]}) + quote


# A description on its way to another version: nodes that change, and what they mean at the moment.


_ENCODING = re.compile(
    r"""(<\?xml[^<>]*?encoding\s*=\s*["'])(?!utf-8["']|(?:us-)?ascii["'])[\w.:-]+""", re.IGNORECASE
)
_LONE = re.compile(r"(?<!\r)\n")


class Draft:
    """The nodes of a document, and the document that they make when written."""

    def __init__(self, document: Document) -> None:
        assert document.root is not None
        self.source = document
        self.root = _nodes(document)
        place = document.spans.place(document.root)
        # Results are written as UTF-8, whatever the source was.
        self._before = _ENCODING.sub(r"\1UTF-8", document.source.text[: place.start])
        self._after = document.source.text[place.close_end :]
        whole = document.source.text
        self._has_crlf = "\r\n" in whole and not _LONE.search(whole)
        self.document = document
        self._elements: dict[Node, Element] = {}
        self._pair()

    def text(self) -> str:
        text = self._before + self.root.text() + self._after
        return _LONE.sub("\r\n", text) if self._has_crlf else text

    def read(self) -> Document:
        """Read what has been written so far; nodes and elements know each other again."""
        if (text := self.text()) != self.document.source.text:
            self.document = with_text(self.source, text)
            self._pair()
        return self.document

    def element(self, node: Node) -> Element:
        """The element of a node, as of the last reading."""
        return self._elements[node]

    def _pair(self) -> None:
        root = self.document.root
        assert root is not None
        try:
            pairs = list(zip(self.root.walk(), root.walk(), strict=True))
        except ValueError:
            # A parser guesses otherwise at broken text once something around it has changed.
            raise refusal(root, "the text is broken, so that it cannot be changed and read again") from None
        self._elements = dict(pairs)


def _nodes(document: Document) -> Node:
    text, spans = document.source.text, document.spans

    def build(element: Element) -> Node:
        place = spans.place(element)
        node = Node(element.name, text[place.start : place.end], text[place.close : place.close_end], element)
        at = place.end
        for child in element.children():
            inner = build(child)
            start = spans.place(child)
            if start.start > at:
                node.parts.append(text[at : start.start])
            inner.parent = node
            node.parts.append(inner)
            at = start.close_end
        if place.close > at:
            node.parts.append(text[at : place.close])
        return node

    assert document.root is not None
    return build(document.root)
