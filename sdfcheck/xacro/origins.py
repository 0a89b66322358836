"""Where the elements of an expanded document were written."""

from __future__ import annotations

import os
import re
from bisect import bisect_right
from collections.abc import Iterator, Mapping, Sequence, Set
from itertools import chain, islice
from pathlib import Path

from sdfcheck.files.library import library_of
from sdfcheck.files.regular import Bounds, read_regular
from sdfcheck.source.decode import decode
from sdfcheck.source.document import Document, Element, Spans
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.scanner.scan import Scan, parse_start_tag, quick_scan
from sdfcheck.source.scanner.start_tag import START, StartTag
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Source, Span, Step, relative_path
from sdfcheck.xacro.language import is_literal, may_become
from sdfcheck.xacro.static.definitions import visible_definitions
from sdfcheck.xacro.static.project import names_beside, possible_files

_CALLED = (
    r"<xacro:macro\s[^<>]*?\bname\s*=\s*[\"'](?P<macro>[^\"'<>]+)[\"']|(?P<end></xacro:macro)|"
    r"<xacro:(?P<call>[\w.-]+)"
)
"""The beginning and the end of a macro, and what may be a call of one."""
_MOST_NAMES = 500
"""With so many names that hold expressions in other branches anything may be a name."""
_MOST_FILES = 100
"""So many files are looked at for names that another expansion may bring."""
_COMMENT = re.compile(r"<!--.*?-->", re.DOTALL)
_WORD = re.compile(r"(?:\$\{[^}]*(?:\}|\Z)|\$\([^)]*(?:\)|\Z)|\S)+")


class OriginSpan(Span):
    """A place in a xacro file, reached by macro calls and includes: ``origins``, the nearest first.

    Reached in another way it is another place.
    """

    origins: tuple[Step, ...] = ()
    value: str | None = None
    """The result, in the expansion, of the text there, where it has expressions."""

    def __eq__(self, other: object) -> bool:
        return tuple.__eq__(self, other) is True and self.origins == getattr(other, "origins", ())

    def __ne__(self, other: object) -> bool:
        return not self == other

    __hash__ = Span.__hash__

    @classmethod
    def of(cls, span: Span, origins: tuple[Step, ...]) -> Span:
        if not origins:
            return span
        placed = cls(*span)
        placed.origins = origins
        return placed

    @classmethod
    def with_value(cls, span: Span, value: str | None) -> Span:
        """The same place with the value of its expressions; a place without any as it is."""
        if value is None or "$" not in span.text:
            return span
        placed = cls(*span)
        placed.origins = getattr(span, "origins", ())
        placed.value = value
        return placed


class Call(NamedTuple):
    """A macro call or include as the expansion reports it; ``outer`` is the row of the one around it."""

    kind: str
    name: str
    file: int
    line: int
    column: int
    outer: int


class Sources:
    """The files that took part, read once; ``top`` is read already, as are the ``texts`` by their paths.

    Others are named by the process that expands, which code in a file may have taken over: they are read
    ``within`` what that process may read, and are empty otherwise.
    """

    def __init__(
        self, top: Source, texts: Mapping[str, str] | None = None, within: Bounds | None = None
    ) -> None:
        self.top = top
        self._within = within
        self._known = {path: Source(shown(Path(path)), text) for path, text in (texts or {}).items()}
        self._known[_key(top.path)] = top
        self._scans: dict[int, Scan] = {}
        self._kept: list[Source] = []

    def get(self, path: Path) -> Source:
        key = _key(path)
        source = self._known.get(key)
        if source is None:
            try:
                data = read_regular(Path(key), within=self._within)
            except OSError:
                data = b""
            source = self._known[key] = decode(data, shown(path))[0]
        return source

    def scan(self, source: Source) -> Scan:
        found = self._scans.get(id(source))
        if found is None:
            self._kept.append(source)
            found = self._scans[id(source)] = quick_scan(source)
        return found


def shown(path: Path) -> Path:
    """A path for people: without detours, relative to the current folder if it is below that."""
    plain = os.path.normpath(path)
    here = os.getcwd() + os.sep
    return Path(plain.removeprefix(here))


def _key(path: Path) -> str:
    return os.path.abspath(path)


class Provenance:
    """The places of all elements of one expansion, by their number in document order."""

    def __init__(
        self, sources: Sources, files: Sequence[str], calls: Sequence[Call], places: list[int]
    ) -> None:
        self.sources = sources
        self.files = [sources.get(Path(name)) for name in files]
        self.calls = calls
        self.places = places
        self._chains: dict[int, tuple[Step, ...]] = {-1: ()}
        self._written: dict[int, tuple[list[int], list[int]]] = {}
        self._with_tags: dict[int, Source] = {}

    def source(self, number: int) -> Source:
        """The file that an element was written in; one without any tag is not, and the top file is meant."""
        file = self.places[4 * number]
        found = self._with_tags.get(file)
        if found is None:
            source = self.files[file]
            has_tags = source is self.sources.top or bool(self.sources.scan(source).starts)
            found = self._with_tags[file] = source if has_tags else self.sources.top
        return found

    def offset(self, number: int) -> int:
        _, line, column, _ = self.places[4 * number : 4 * number + 4]
        return self.source(number).offset(line, column)

    def offsets_in(self, path: Path) -> set[int]:
        """Where the elements that come from a file begin in it."""
        key = _key(path)
        wanted = {number for number, source in enumerate(self.files) if _key(source.path) == key}
        files = self.places[::4]
        return {self.offset(number) for number, file in enumerate(files) if file in wanted}

    def last_before(self, source: Source, start: int) -> int:
        """The number of the first element written at the last place up to ``start``; -1 if there is none."""
        known = self._written.get(id(source))
        if known is None:
            first: dict[int, int] = {}
            for number in range(len(self.places) // 4):
                if self.source(number) is source:
                    first.setdefault(self.offset(number), number)
            offsets = sorted(first)
            known = self._written[id(source)] = offsets, [first[offset] for offset in offsets]
        offsets, numbers = known
        at = bisect_right(offsets, start) - 1
        return numbers[at] if at >= 0 else -1

    def chain(self, number: int) -> tuple[Step, ...]:
        """The calls and includes that led to element ``number``, the nearest first."""
        return self.steps(self.places[4 * number + 3])

    def steps(self, row: int) -> tuple[Step, ...]:
        if row not in self._chains:
            call = self.calls[row]
            step = Step(self.name_at(call.file, call.line, call.column), _described(call))
            self._chains[row] = (step, *self.steps(call.outer))
        return self._chains[row]

    def name_at(self, file: int, line: int, column: int) -> Span:
        """The name of the tag that starts there."""
        source = self.files[file]
        at = source.offset(line, column)
        match = START.match(source.text, at)
        return source.span(match.start(1), match.end(1)) if match else source.span(at, at)


def _described(call: Call) -> str:
    return f"in macro `{call.name}`, called here" if call.kind == "macro" else "included here"


class OriginSpans(Spans):
    """Like :class:`Spans`, but places are in the xacro files, where the elements were written.

    The place of a value is that of the expression that it came from.
    """

    __slots__ = ("_indices", "provenance")

    def __init__(self, provenance: Provenance, source: Source, scan: Scan) -> None:
        super().__init__(source, scan)
        self.provenance = provenance
        self._indices: dict[int, int] = {}

    def home(self, element: Element) -> Source:
        return self.provenance.source(element.index)

    def span(self, element: Element, start: int, end: int) -> Span:
        number = element.index
        return OriginSpan.of(self.provenance.source(number).span(start, end), self.provenance.chain(number))

    def origins(self, element: Element) -> tuple[Step, ...]:
        return self.provenance.chain(element.index)

    def attribute_value(self, element: Element, name: str) -> Span:
        return OriginSpan.with_value(super().attribute_value(element, name), element.text_of(name))

    def text(self, element: Element) -> Span:
        return OriginSpan.with_value(super().text(element), element.text.strip())

    def found(self, element: Element) -> tuple[Scan, int]:
        number = element.index
        scan = self.provenance.sources.scan(self.provenance.source(number))
        index = self._indices.get(number)
        if index is None:
            index = max(bisect_right(scan.starts, self.provenance.offset(number)) - 1, 0)
            self._indices[number] = index
        return scan, index

    def start_tag(self, element: Element) -> StartTag:
        scan, index = self.found(element)
        return parse_start_tag(self.home(element), scan.starts[index])[0]

    def part(self, span: Span, index: int) -> Span:
        """The ``index``-th word; an expression is one word, whatever comes of it."""
        words = list(_WORD.finditer(span.text))
        if index >= len(words):
            return span
        start = span.start + words[index].start()
        part = span.source.span(start, start + len(words[index][0]))
        values = (getattr(span, "value", None) or "").split()
        value = values[index] if len(values) == len(words) else None
        return OriginSpan.with_value(OriginSpan.of(part, getattr(span, "origins", ())), value)


class ExpandedDocument(Document):
    """The expansion of a xacro file; its places are in the files that were expanded."""

    __slots__ = ("_names",)

    def __init__(self, source: Source, provenance: Provenance) -> None:
        self.provenance = provenance
        self._names: dict[str, tuple[set[str], list[str]]] = {}
        super().__init__(source, None, [])

    @property
    def spans(self) -> OriginSpans:
        if self._spans is None:
            self._spans = OriginSpans(self.provenance, self.source, self.scan)
        assert isinstance(self._spans, OriginSpans)
        return self._spans

    @property
    def is_expanded(self) -> bool:
        return True

    def origins(self, element: Element) -> tuple[Step, ...]:
        return self.spans.origins(element)

    def may_write(self, pattern: str) -> bool:
        return any(re.search(pattern, text) for text in self._texts)

    def may_name(self, pattern: str, name: str) -> bool:
        if pattern not in self._names:
            names = dict.fromkeys(self._unreached_names(pattern))
            self._names[pattern] = (
                {each for each in names if is_literal(each)},
                [each for each in names if not is_literal(each)],
            )
        literal, others = self._names[pattern]
        if name in literal or len(others) > _MOST_NAMES:
            return True
        return any(may_become(written, name) for written in others)

    def _unreached_names(self, pattern: str) -> Iterator[str]:
        """The names, by the group of a pattern, where the expansion wrote nothing and another one may.

        Those that hold expressions in the body of a macro only if a call of it is there, too.
        """
        calls, bodies, names = set[str](), list[tuple[str, str]](), list[str]()
        for source in self._sources:
            reached = self.provenance.offsets_in(source.path)
            macro = ""
            for match in re.finditer(rf"{_CALLED}|{pattern}", _blanked(source.text)):
                if match["macro"] or match["end"]:
                    macro = match["macro"] or ""
                elif match.start() in reached:
                    continue
                elif match["call"]:
                    calls.add(match["call"])
                elif macro and not is_literal(match[match.lastindex or 0]):
                    bodies.append((macro, match[match.lastindex or 0]))
                else:
                    names.append(match[match.lastindex or 0])
        return chain(names, (name for macro, name in bodies if macro in calls))

    @property
    def _sources(self) -> Iterator[Source]:
        """The files that were expanded, and those that they include where the expansion did not get."""
        yield from self.provenance.files
        top = self.provenance.sources.top
        library = library_of(self)
        waiting = [top.path] if library is not None else []
        known = {source.path for source in self.provenance.files} - {top.path}
        while waiting and library is not None and len(known) < _MOST_FILES:
            document = library.document(waiting.pop(), Kind.XACRO, self)
            for read in visible_definitions(document).readings if document is not None else ():
                source = read.document.source
                if source.path not in known:
                    known.add(source.path)
                    yield source
                    names = dict.fromkeys(include.filename for include in read.includes)
                    for name in islice(names, _MOST_FILES):
                        waiting += possible_files(read.document, name, source.path)

    def names_of_others(self, pattern: str, element: Element) -> Set[str]:
        return names_beside(self, self.spans.home(element).path, pattern)

    @property
    def _texts(self) -> Iterator[str]:
        return (_COMMENT.sub("", source.text) for source in self.provenance.files)

    @property
    def top(self) -> Source:
        """The xacro file that was expanded."""
        return self.provenance.sources.top

    def origins_at(self, span: Span) -> tuple[Step, ...]:
        """How a place came to be; for a plain place, how the first element written there did."""
        if isinstance(span, OriginSpan):
            return span.origins
        number = self.provenance.last_before(span.source, span.start)
        return self.provenance.chain(number) if number >= 0 else ()

    def written(self, span: Span) -> Span:
        """The place that one in the expanded text comes from; any other place is returned as it is."""
        if span.source is not self.source or self.root is None:
            return span
        number = max(bisect_right(self.scan.starts, span.start) - 1, 0)
        element = self.elements[number]
        tag = parse_start_tag(self.source, self.scan.starts[number])[0]
        around = (place for place in self.scan.comments if place[0] <= span.start < place[1])
        between = next(around, (span.start, span.end) if span.start >= tag.end else None)
        if between is not None and (found := self._between_tags(span, between, number)) is not None:
            return found
        for attribute in tag.attributes:
            if attribute.value_start <= span.start and span.end <= attribute.value_end:
                return self.spans.attribute_value(element, attribute.name)
            if attribute.name_start <= span.start and span.end <= attribute.name_end:
                return self.spans.attribute_name(element, attribute.name)
        return self.spans.name(element)

    def _between_tags(self, span: Span, around: tuple[int, int], number: int) -> Span | None:
        """A place in a comment or text: it is written after the element before it, or before the one after it."""
        text = self.source.text
        expanded = [text[around[0] : span.start], text[span.start : span.end], text[span.end : around[1]]]
        for pieces in (expanded, [piece.replace("&gt;", ">") for piece in expanded]):
            whole = "".join(pieces)
            for element in self.elements[number : number + 2]:
                written, is_before = self.spans.home(element).text, element is self.elements[number]
                at = self.spans.start_tag(element).end if is_before else element.span.start
                start = written.find(whole, at) if is_before else written.rfind(whole, 0, at)
                if start >= 0:
                    begin = start + len(pieces[0])
                    place = self.spans.span(element, begin, begin + len(pieces[1]))
                    return OriginSpan.with_value(place, pieces[1])
        return None


def _blanked(text: str) -> str:
    """A text without its comments, of the same length."""
    return _COMMENT.sub(lambda comment: " " * len(comment[0]), text)


# The expanded text with comments that say where each element was written.

_RUN = "--"


def annotated(document: ExpandedDocument) -> str:
    """The text, with a comment before every element that is on a line of its own.

    Elements written on consecutive lines of one file in one go share the comment of the
    element around them.
    """
    text = document.source.text
    root = document.root
    if root is None:
        return text
    pieces, at = [], 0
    starts = document.scan.starts
    for start, element in zip(starts, document.elements, strict=True):
        line = text.rfind("\n", 0, start) + 1
        if text[line:start].strip() or not _is_news(element, document):
            continue
        pieces += [text[at:line], text[line:start], f"<!-- {_origin(element, document)} -->\n"]
        at = line
    return "".join([*pieces, text[at:]])


def _is_news(element: Element, document: ExpandedDocument) -> bool:
    """Whether the comment of the element around does not say it all."""
    parent = element.parent
    if parent is None:
        return True
    spans = document.spans
    same = spans.home(element) is spans.home(parent)
    return not same or spans.origins(element) != spans.origins(parent) or "name" in element.attributes


def _origin(element: Element, document: ExpandedDocument) -> str:
    steps = "".join(f"; {step.text}: {_place(step.span)}" for step in document.origins(element))
    text = f"{_place(element.span)}{steps}".replace(", called here", "")
    while _RUN in text:
        text = text.replace(_RUN, "-")
    return text


def _place(span: Span) -> str:
    path = span.source.path
    shown = relative_path(path) if path.is_absolute() and path.is_relative_to(Path.cwd()) else str(path)
    return f"{shown}:{span.begin.line}"
