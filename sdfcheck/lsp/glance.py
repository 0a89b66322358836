"""The first look at a world after an edit: at the model that has changed; what is known of the rest stays."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable
from itertools import chain
from typing import TYPE_CHECKING

from sdfcheck.formats.sdf.survey import Survey, survey
from sdfcheck.lint.engine import Dispatch, explain, lint_document
from sdfcheck.lsp.reparse import LONG, around, same_ends
from sdfcheck.source.document import Document, Element
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Source, Span

if TYPE_CHECKING:
    from collections.abc import Mapping

    from sdfcheck.lint.diagnostic import Diagnostic
    from sdfcheck.lsp.workspace import Buffer
    from sdfcheck.source.scanner.scan import ElementPlace


class Look(NamedTuple):
    """A look at all of a long world: its text, its tree with the names in it, and what was found."""

    source: Source
    root: Element
    named: Mapping[Element, list[tuple[str, str, Element]]]
    found: tuple[Diagnostic, ...]


def look(buffer: Buffer, found: tuple[Diagnostic, ...], last: Look | None) -> Look | None:
    """The state of a text for later glances; of a broken one its ``last`` tree. None where there are none."""
    document = buffer.made
    if document is None or document.kind is not Kind.SDF or len(document.source.text) < LONG:
        return None
    if document.is_wellformed and document.root is not None:
        return Look(document.source, document.root, survey(document).named, found)
    return None if last is None else last._replace(source=document.source, found=found)


def glance(buffer: Buffer, last: Look, dispatch: Dispatch) -> list[Diagnostic] | None:
    """The findings in a text that has changed in one part of its world since it was looked at.

    That part is judged by itself, with the names of the others; where the text is broken, its tags alone are.
    None where something else has changed, or too much.
    """
    source, document = buffer.source, buffer.soon
    if (changed := _changed(buffer, last)) is None or source.contains("sdfcheck:"):
        return None
    unit, start, end = changed
    if document is None:
        found = _of_tags(source, start, end, dispatch)
        start, rest = same_ends(last.source.text, source.text)
        end = len(source.text) - rest
    else:
        own = lint_document(_part(document, [unit], last), dispatch)
        found = [each for each in own if each.span.source is source and start <= each.span.start < end]
    shift = len(source.text) - len(last.source.text)

    def moved(span: Span) -> Span | None:
        """A place in the text before; None in what has changed."""
        if span.source is not last.source:
            return span
        if start < span.end and span.start < end - shift:
            return None
        by = shift if span.start >= end - shift else 0
        return source.span(span.start + by, span.end + by)

    tags = set() if document else {each.code for each in found}
    before = (_moved(each, moved) for each in last.found if each.code not in tags)
    kept = [each for each in before if each is not None]
    known = {(each.code, each.message) for each in kept}  # one may be about all that are alike
    return [*kept, *(each for each in found if (each.code, each.message) not in known)]


def near(buffer: Buffer, last: Look, offset: int) -> Document | None:
    """A text as far as it tells about a place, where it has changed in one part of its world; None: ask all of it."""
    document = buffer.soon
    changed = None if document is None else _changed(buffer, last)
    if document is None or changed is None:
        return None
    units = {changed[0]: None, **{unit: None for unit, _ in _unit(document, offset, offset)}}
    return _part(document, list(units), last)


def _changed(buffer: Buffer, last: Look) -> tuple[Element, int, int] | None:
    """The part of the world in which a text has changed, and its place."""
    source, document = buffer.source, buffer.soon
    base = document or buffer.last
    if base is None or base.root is not last.root:
        return None
    begin, rest = same_ends(last.source.text, source.text)
    first, after = (begin, rest) if document else same_ends(base.source.text, source.text)
    for unit, place in _unit(base, first, len(base.source.text) - after):
        end = place.close_end + len(source.text) - len(base.source.text)
        if end - place.start <= LONG and place.start < begin <= len(source.text) - rest < end:
            return unit, place.start, end
    return None


def _unit(document: Document, first: int, last: int) -> list[tuple[Element, ElementPlace]]:
    """The part of a world that has a range, with its place; nothing where there is none."""
    holders = list(around(document, first, last))
    return holders[-3:-2] if len(holders) > 2 and holders[-2][0].name == "world" else []


def _of_tags(source: Source, start: int, end: int, dispatch: Dispatch) -> list[Diagnostic]:
    """The problems of a broken text, of which a part is read by itself."""
    piece = Document(Source(source.path, source.text[start:end]), Kind.SDF, [])

    def moved(span: Span) -> Span:
        return source.span(start + span.start, start + span.end)

    found = (_moved(each, moved) for each in explain(piece.problems, piece, dispatch))
    return [each for each in found if each is not None]


def _moved(found: Diagnostic, moved: Callable[[Span], Span | None]) -> Diagnostic | None:
    """A diagnostic at other places, with those of its parts that have one."""
    span = moved(found.span)
    if span is None:
        return None
    labels = (each._replace(span=at) for each in found.labels if (at := moved(each.span)) is not None)
    edits = (
        [each._replace(span=at) for each in found.fix.edits if (at := moved(each.span))] if found.fix else []
    )
    if found.fix is not None:
        is_whole = len(edits) == len(found.fix.edits)
        found = found._replace(fix=found.fix._replace(edits=tuple(edits))) if is_whole else found.without_fix
    return found._replace(span=span, labels=tuple(labels), cause=found.cause and moved(found.cause))


class _Part(Document):
    """A document of which nothing is looked at but one part of a world."""

    def __init__(self, whole: Document, root: Element, surveyed: Survey | None = None) -> None:
        self._taken = whole, root, surveyed
        super().__init__(whole.source, whole.kind, [])
        self.library = whole.library

    def _parse(self) -> None:
        whole, self.root, surveyed = self._taken
        self._scan, self.elements = whole.scan, whole.elements
        self.names, self.declared = whole.names, whole.declared
        if surveyed is not None:
            self._views[Survey] = surveyed


def _part(whole: Document, units: list[Element], last: Look) -> Document:
    """A document as one that has only some parts in its world, but the names of all."""
    world, root = units[0].around
    outer = Element(root.name, root.attributes, None, whole, root.index)
    inner = Element(world.name, world.attributes, outer, whole, world.index)
    outer.nodes, inner.nodes = [inner], [*units]
    surveyed = Survey(_Part(whole, outer))
    named = defaultdict(list, last.named)
    for element in chain.from_iterable(unit.walk() for unit in units):
        named.pop(element, None)
    others = [each for each in named[world] if each[2] not in units and each[2].document is whole]
    named |= surveyed.named
    named[world] = sorted([*others, *named.pop(inner, ())], key=lambda each: each[2].index)
    surveyed.named = named
    surveyed.index.pop(root.name, None)
    surveyed.index.pop(world.name, None)
    return _Part(whole, root, surveyed)
