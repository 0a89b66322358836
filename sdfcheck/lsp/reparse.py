"""The tree of a long text after an edit: the smallest element around the edit is read, all others stay as they are."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Callable, Iterable, Iterator
from itertools import chain

from sdfcheck.source.decode import DEPTH_LIMIT
from sdfcheck.source.document import Aside, Document, Element, fill
from sdfcheck.source.scanner.scan import ElementPlace, QuickScan, Scan
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Source

LONG = 50_000
"""Shorter texts are read in no time, and so is an element of such a length at most."""
_KINDS = frozenset({Kind.SDF, Kind.URDF})


def same_ends(old: str, new: str) -> tuple[int, int]:
    """How many characters two texts have in common at their beginning and, after those, at their end."""
    a, b = len(old), len(new)
    first = _most(min(a, b), lambda n, m: old[n:m] == new[n:m])
    return first, _most(min(a, b) - first, lambda n, m: old[a - m : a - n] == new[b - m : b - n])


def _most(limit: int, is_same: Callable[[int, int], bool]) -> int:
    """The greatest number up to a limit below which all is the same, as a test of ranges says."""
    known, step = 0, limit
    while step and known < limit:
        if is_same(known, min(known + step, limit)):
            known = min(known + step, limit)
        else:
            step //= 2
    return known


def around(document: Document, first: int, last: int) -> Iterator[tuple[Element, ElementPlace]]:
    """The elements of a well-formed text that have a range between their first and last character, innermost first."""
    scan = document.scan
    number = bisect_left(scan.starts, first) - 1
    element = document.elements[number] if number >= 0 else None
    while element is not None:
        place = scan.place(element.index)
        if last < place.close_end:
            yield element, place
        element = element.parent


def reparsed(old: Document, source: Source, kind: Kind) -> Document | None:
    """The document of a text, which takes over the tree of an earlier one; None where that is of no use."""
    text = source.text
    if old.kind is not kind or kind not in _KINDS or not old.is_wellformed or len(text) < LONG:
        return None
    kept, rest = same_ends(old.source.text, text)
    if kept == len(text) == len(old.source.text):  # as it was: any element will do
        kept = old.scan.starts[-1] + 1
        rest = len(text) - kept
    shift = len(text) - len(old.source.text)
    for element, place in around(old, kept, len(old.source.text) - rest):
        if element.parent is None or place.close_end + shift - place.start > LONG:
            return None
        piece = _Piece(Source(source.path, text[place.start : place.close_end + shift]), kind, [])
        if piece.is_wellformed:
            depth = sum(1 for _ in element.around)
            is_too_deep = any(sum(1 for _ in each.around) + depth >= DEPTH_LIMIT for each in piece.elements)
            return None if is_too_deep else _Reparsed(source, old, element, piece)
    return None


class _Piece(Document):
    """A text that is to be read as one element."""

    def _parse(self) -> None:
        self.is_wellformed = fill(self, self.source.text) is None


class _Reparsed(Document):
    """A document with the tree of an earlier one, but for an element that a piece of the new text replaces."""

    def __init__(self, source: Source, old: Document, gone: Element, piece: Document) -> None:
        self._taken = old, gone, piece
        super().__init__(source, old.kind, [])
        del self._taken

    def _parse(self) -> None:
        old, gone, piece = self._taken
        first, new, parent = gone.index, piece.elements[0], gone.parent
        after = max(first + 1, bisect_left(old.scan.starts, old.scan.closes[first]))
        shift = len(self.source.text) - len(old.source.text)
        self._scan = _Shifted(self.source, old.scan, gone, after, piece.scan, shift)
        self.is_wellformed = True
        self.root, self.elements, self.prolog, self.epilog = old.root, old.elements, old.prolog, old.epilog
        old.root, old.elements = None, []
        removed, self.elements[first:after] = self.elements[first:after], piece.elements
        self.declared = {each: own for each, own in old.declared.items() if each not in set(removed)}
        self.declared |= piece.declared
        is_rarer = not _names(removed, old).issubset(piece.names)
        self.names = {*(_names(self.elements, self) if is_rarer else old.names), *piece.names}
        assert parent is not None
        parent.nodes[parent.nodes.index(gone)] = new
        new.parent, new.tail = parent, gone.tail
        for node in chain.from_iterable(each.nodes for each in piece.elements):
            node.index += first if isinstance(node, Aside) else 0
        if added := len(piece.elements) - (after - first):
            nodes = chain(self.epilog, *(each.nodes for each in self.elements if each.document is old))
            for node in nodes:
                node.index += added if isinstance(node, Aside) and node.index >= after else 0
        for number, element in enumerate(self.elements):
            element.document, element.index = self, number


def _names(elements: Iterable[Element], document: Document) -> set[str]:
    """The names of elements and attributes."""
    found: set[str] = set()
    for element in elements:
        found.add(element.name)
        found.update(element.attributes)
        found.update(f"xmlns:{each}" if each else "xmlns" for each in document.declared.get(element, ()))
    return found


class _Shifted(QuickScan):
    """The scan of a text in which a piece replaces an element and what is in it, up to number ``after``."""

    __slots__ = ()

    def __init__(self, source: Source, old: Scan, gone: Element, after: int, piece: Scan, shift: int) -> None:
        first = gone.index
        start, end = old.starts[first], old.close_ends[first]

        def replaced(before: list[int], inside: list[int]) -> list[int]:
            return [*before[:first], *(start + at for at in inside), *(at + shift for at in before[after:])]

        self.starts, self.ends = replaced(old.starts, piece.starts), replaced(old.ends, piece.ends)
        self.closes = replaced(old.closes, piece.closes)
        self.close_ends = replaced(old.close_ends, piece.close_ends)
        for outer in gone.around:
            self.closes[outer.index] += shift
            self.close_ends[outer.index] += shift
        self.comments = [comment for comment in old.comments if comment[1] <= start]
        self.comments += ((start + a, start + b) for a, b in piece.comments)
        self.comments += ((a + shift, b + shift) for a, b in old.comments if a >= end)
        self._source = source
        self.problems, self.doubtful, self.odd, self.wellformed = [], [], {}, ""
