"""The texts that are open in the editor and the files on disk, as one set of documents."""

from __future__ import annotations

import os
import re
from bisect import bisect_left
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from itertools import chain
from pathlib import Path
from typing import Any, TypeVar

from sdfcheck.files.discover import discover
from sdfcheck.files.library import Disk, Library, SearchPaths
from sdfcheck.files.packages import Packages
from sdfcheck.files.regular import SIZE_LIMIT, read_regular
from sdfcheck.lint.config.configuration import Configuration
from sdfcheck.lint.config.settings import UNSET, Settings
from sdfcheck.lint.one_file import Caches
from sdfcheck.lint.rulebook.rulebook import RuleBook
from sdfcheck.lint.run import RuleFacts
from sdfcheck.lint.select import check_targets, covered
from sdfcheck.lsp.context import Checkpoints
from sdfcheck.lsp.worker import Worker
from sdfcheck.lsp.xacro_names import Own
from sdfcheck.source.decode import DEPTH_LIMIT
from sdfcheck.source.document import Aside, Document, Element, fill
from sdfcheck.source.errors import WrongUsage
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.scanner.scan import ElementPlace, QuickScan, Scan
from sdfcheck.source.sniff import HEAD, Kind, Treatment, sniff, treatment
from sdfcheck.source.text import Source
from sdfcheck.xacro.expansion import Expander, Expansion, Surroundings
from sdfcheck.xacro.static.definitions import Reading, is_robot

# The tree of a long text after an edit: the smallest element around the edit is read, all others stay as they
# are.


T = TypeVar("T")
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
            later = before[after:]
            return [
                *before[:first],
                *map(start.__add__, inside),
                *(map(shift.__add__, later) if shift else later),
            ]

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


MOST_EXPANSIONS = 48
MOST_EXPANDED = 2_000_000
"""So many expansions are remembered, with so many characters in all, but two in any case."""


class Choices(NamedTuple):
    """The client's settings, over the configuration files."""

    configuration: Path | None = None
    given: Settings = UNSET
    trust: bool = False
    expand: bool = True
    lenses: bool = True
    sweep: bool = True
    """Are files linted that nobody has opened?"""
    faults: tuple[str, ...] = ()
    """The faults of some of them, each as a sentence; these are left out."""


class Buffer:
    """A text that is open in the editor; its document is made when it is asked for."""

    __slots__ = ("_document", "_stale", "checkpoints", "last", "path", "source", "uri", "version")

    def __init__(self, uri: str, path: Path, text: str, version: int | None) -> None:
        self.uri = uri
        self.path = path
        self.source = Source(path, text)
        self.version = version
        self.checkpoints = Checkpoints()
        self._document: Document | None = None
        self.last: Document | None = None
        """The document of an earlier text that was well-formed, as far as no other document depends on it."""
        self._stale: list[Document] = []

    def write(self, source: Source, version: int | None, kept: int = 0) -> None:
        """Take a new text, which begins with ``kept`` characters of the old one."""
        old = self._document
        if old is not None and old.is_wellformed and len(old.source.text) >= LONG:
            old, self.last = self.last, old
        self._stale += filter(None, [old])
        self._document = None
        self.source, self.version = source, version
        self.checkpoints.cut(kept)

    @property
    def made(self) -> Document | None:
        """The document, if it was asked for."""
        return self._document

    def forget(self) -> None:
        """Make the document anew when it is asked for next."""
        self._stale += filter(None, [self._document, self.last])
        self._document = self.last = None

    def tidy(self, kept: int = 0) -> None:
        """Drop old documents, which takes a while; so many are kept for later."""
        while len(self._stale) > kept:
            self._stale.pop(0).release()

    @property
    def data(self) -> bytes:
        return self.source.text.encode("utf-8", "surrogatepass")

    @property
    def kind(self) -> Kind:
        """The kind of a text."""
        head = self.source.text[:HEAD].encode("utf-8", "surrogatepass")
        return sniff(head, self.path)

    @property
    def document(self) -> Document:
        """The text as it is read; not to be looked at by two threads."""
        found = self.soon
        if found is None:
            self.tidy(kept=1)
            kind = self.kind
            self._document = found = Document(self.source, None if kind is Kind.BROKEN_XML else kind, [])
        return found

    @property
    def soon(self) -> Document | None:
        """The same, as far as it is known or takes but a moment to be read."""
        if self._document is None and (last := self.last) is not None:
            self._document = reparsed(last, self.source, self.kind)
            if self._document is not None:
                self._stale.append(last)
                self.last = None
        return self._document

    @property
    def is_linted(self) -> bool:
        """Is it something that has diagnostics?"""
        return treatment(self.kind, self.path, named=True) is Treatment.LINT


def _kind(path: Path) -> Kind | None:
    """The content of a file of ROS: robots, their semantics and macros have the same root."""
    if path.suffix not in {".urdf", ".xacro", ".srdf"}:
        return None
    try:
        kind = sniff(read_regular(path)[:HEAD], path)
    except OSError:
        return None
    return kind if kind in {Kind.URDF, Kind.XACRO, Kind.SRDF} else None


Buffers = dict[str, Buffer]
"""Real path → what is open."""


class LiveLibrary(Library):
    """A library in which open texts take the place of files."""

    __slots__ = ("_buffers", "_looked_into", "dropped")

    def __init__(self, buffers: Buffers, search: SearchPaths, limit: int) -> None:
        super().__init__(search, limit)
        self._buffers = buffers
        self._looked_into: set[str] = set()
        self.dropped: list[Document] = []
        """Documents that nobody asks for any more."""

    def read(self, path: Path, of: Document, limit: int = SIZE_LIMIT) -> bytes:
        key = self.disk.real(path)
        self._looked_into.add(key)
        buffer = self._buffers.get(key)
        return super().read(path, of, limit) if buffer is None else buffer.data

    @property
    def open_texts(self) -> tuple[str, ...]:
        sources = (buffer.source for buffer in self._buffers.values())
        return tuple(source.text for source in sources if source.contains("xacro:"))

    def holds(self, path: Path) -> bool:
        return super().holds(path) or self.disk.real(path) in self._looked_into

    def forget(self) -> None:
        self._drop(self.documents())
        super().forget()
        self._looked_into.clear()

    def look_again(self) -> None:
        """Look for the files of projects again: some may be new."""
        self._projects.forget()

    def forget_robots(self, path: Path) -> None:
        """The text of a xacro file has changed: read robots anew, and that file; macros of others stay known."""
        changed = self.disk.real(path)
        kept = {
            key: (document, self._hashes[key])
            for key, document in self._documents.items()
            if document is not None and key != changed and key not in self._buffers and _is_library(document)
        }
        disk, views = self.disk, dict(self._projects.views)
        self._drop(
            document for key, document in self._documents.items() if document is not None and key not in kept
        )
        super().forget()
        self.disk = disk
        self._projects.views.update(views)
        for key, (document, size) in kept.items():
            document.forget_views((Reading, Own))
            self._documents[key], self._hashes[key] = document, size

    def _drop(self, documents: Iterable[Document]) -> None:
        """Take documents apart later, but for those of open texts."""
        own = {id(buffer.made) for buffer in self._buffers.values()}
        self.dropped += [document for document in documents if id(document) not in own]

    def known(self, data: bytes, path: Path) -> Document | None:
        buffer = self._buffers.get(self.disk.real(path))
        if buffer is None:
            return super().known(data, path)
        return buffer.document if buffer.data == data else None

    def _read(self, path: Path, key: str, kind: Kind | None, of: Document | None) -> Document | None:
        buffer = self._buffers.get(key)
        if buffer is None:
            return super()._read(path, key, kind, of)
        document = buffer.document
        if kind is not None and document.kind is not kind:
            document = Document(buffer.source, kind, [])
        self._hashes[key] = hash(buffer.data)
        document.library = self
        return document


def _is_library(document: Document) -> bool:
    """Is a file for others to include?"""
    return document.kind is Kind.XACRO and not is_robot(document)


Meanwhile = Callable[[Callable[[], Mapping[str, Any]]], Mapping[str, Any]]
"""Waits for the result of what has nothing to do with documents."""


class LiveCaches(Caches):
    """Libraries and expanders that know the open texts."""

    __slots__ = ("_aside", "_buffers")

    def __init__(self, buffers: Buffers, aside: Meanwhile, *, expand: bool, named: tuple[Path, ...]) -> None:
        super().__init__(expand=expand, named=named)
        self._buffers = buffers
        self._aside = aside

    def library(self, settings: Settings) -> LiveLibrary:
        search = settings.search._replace(named=self._named)
        if search not in self._libraries:
            self._libraries[search] = LiveLibrary(self._buffers, search, settings.size_limit)
        found = self._libraries[search]
        assert isinstance(found, LiveLibrary)
        return found

    @property
    def libraries(self) -> tuple[Library, ...]:
        """Those that were asked for."""
        return tuple(self._libraries.values())

    def forget(self) -> None:
        """Files have changed: expand anew, and read documents anew, when that is asked for next."""
        for library in self.libraries:
            library.forget()
        for expander in self._expanders.values():
            assert isinstance(expander, LiveExpander)
            expander.forget()

    def forget_robots(self, path: Path) -> None:
        """The text of a xacro file has changed; expanders notice that themselves."""
        for library in self.libraries:
            assert isinstance(library, LiveLibrary)
            library.forget_robots(path)

    def tidy(self) -> None:
        """Take apart what was dropped: it refers to itself, and would stay in memory."""
        for library in self.libraries:
            assert isinstance(library, LiveLibrary)
            for document in library.dropped:
                document.release()
            library.dropped.clear()
        for expander in self._expanders.values():
            assert isinstance(expander, LiveExpander)
            expander.tidy()

    def _expander(self, surroundings: Surroundings) -> Expander:
        return LiveExpander(surroundings, self._aside)

    def _surroundings(self, settings: Settings) -> Surroundings:
        return super()._surroundings(settings)._replace(texts=_Texts(self._buffers))


class _Known(NamedTuple):
    """An expansion, and the open texts that it came from."""

    text: str
    texts: Mapping[str, str]
    expansion: Expansion


_Request = tuple[str, tuple[tuple[str, str], ...], bool]
"""Path, arguments, whether it may be partial."""


class LiveExpander(Expander):
    """Remembers its last expansions, which diagnostics and names both ask for."""

    def __init__(self, surroundings: Surroundings, aside: Meanwhile) -> None:
        super().__init__(surroundings)
        self._aside = aside
        self._known: dict[_Request, _Known] = {}
        self._dropped: list[Expansion] = []

    def forget(self) -> None:
        """Expand anew when that is asked for next."""
        self._dropped += [known.expansion for known in self._known.values()]
        self._known.clear()

    def tidy(self) -> None:
        """Take apart the documents of expansions that nobody asks for any more."""
        for expansion in self._dropped:
            if expansion.document is not None:
                expansion.document.release()
        self._dropped.clear()

    def known(
        self, document: Document, arguments: Mapping[str, str] | None = None, *, is_partial: bool = False
    ) -> Expansion | None:
        """The expansion of a document, if it was made before, and of the texts that are open now."""
        request = self._request(document, arguments, is_partial)
        known = self._known.get(request)
        if known is None:
            return None
        texts = self.surroundings.texts
        if known.text == document.source.text and all(
            texts.get(path) == text for path, text in known.texts.items()
        ):
            self._known[request] = self._known.pop(request)
            return known.expansion
        self._dropped.append(self._known.pop(request).expansion)
        return None

    def lately(self, document: Document, arguments: Mapping[str, str]) -> Expansion | None:
        """The last expansion of a document, also of an earlier text; None where it was not expanded."""
        for is_partial in (False, True):
            known = self._known.get(self._request(document, arguments, is_partial))
            if known is not None and known.expansion.document is not None:
                return known.expansion
        return None

    def tried(self, document: Document, arguments: Mapping[str, str], texts: Mapping[str, str]) -> Expansion:
        """The expansion that a document would have with other texts in the files at some absolute paths."""
        around = self.surroundings
        path = os.path.abspath(document.path)
        text = texts.get(path, document.source.text)
        self.surroundings = around._replace(texts={**around.texts, **texts})
        try:
            changed = Document(Source(document.path, text), document.kind, [])
            changed.library = document.library
            return super()._expand(changed, arguments, is_partial=False)
        finally:
            self.surroundings = around

    def _request(self, document: Document, arguments: Mapping[str, str] | None, is_partial: bool) -> _Request:
        return os.path.abspath(document.path), tuple(sorted((arguments or {}).items())), is_partial

    def _ask(self, packages: Packages, **wanted: Any) -> Mapping[str, Any]:
        return self._aside(lambda: super(LiveExpander, self)._ask(packages, **wanted))

    def _expand(
        self, document: Document, arguments: Mapping[str, str] | None, *, is_partial: bool
    ) -> Expansion:
        known = self.known(document, arguments, is_partial=is_partial)
        if known is not None:
            return known
        texts = dict(self.surroundings.texts)
        made = super()._expand(document, arguments, is_partial=is_partial)
        own = {path: texts[path] for path in map(os.path.abspath, made.files) if path in texts}
        request = self._request(document, arguments, is_partial)
        self._known[request] = _Known(document.source.text, own, made)
        self._limit()
        return made

    def _limit(self) -> None:
        """Forget what was asked for longest ago."""
        sizes = [len(known.expansion.text or "") for known in self._known.values()]
        total = sum(sizes)
        for size in sizes[:-2]:
            if total <= MOST_EXPANDED and len(self._known) <= MOST_EXPANSIONS:
                return
            total -= size
            self._dropped.append(self._known.pop(next(iter(self._known))).expansion)


class _Texts(Mapping[str, str]):
    """Absolute path → text, of what is open now and xacro may read."""

    def __init__(self, buffers: Buffers) -> None:
        self._buffers = buffers

    def _open(self) -> dict[str, str]:
        return {
            os.path.abspath(buffer.path): buffer.source.text
            for buffer in self._buffers.values()
            if buffer.kind in {Kind.XACRO, Kind.URDF}
        }

    def __getitem__(self, path: str) -> str:
        return self._open()[path]

    def __iter__(self) -> Iterator[str]:
        return iter(self._open())

    def __len__(self) -> int:
        return len(self._open())


def _fault(setting: str, word: str, rules: tuple[RuleFacts, ...]) -> str:
    """The fault of a word of a setting; empty: it has none."""
    try:
        if setting == "target":
            check_targets([word])
        elif rules:
            covered(word, rules)
    except WrongUsage as error:
        return str(error)
    return ""


class Outdated(Exception):
    """The text that is looked at has changed meanwhile."""


class Workspace:
    """The open texts with their settings, rules and libraries; everything here belongs to one thread.

    Between the portions of its work a ``worker`` gives answers.
    """

    def __init__(self, worker: Worker | None = None) -> None:
        self._worker = worker
        self._looked_at: Path | None = None
        self.folders: tuple[Path, ...] = ()
        self.buffers: Buffers = {}
        self._disk = Disk()
        self.generation = 0
        """How often documents were forgotten: what was worked out before has no worth after."""
        self.fault = ""
        """The fault of the configuration, as a sentence for people."""
        self.choose(Choices())

    def surround(self, folders: tuple[Path, ...]) -> None:
        """Take other folders of the editor; the files in them may refer to one another."""
        self.folders = folders
        self.refresh()

    def choose(self, choices: Choices) -> None:
        """Take other settings of the client; whatever was known is worked out anew."""
        self.choices = choices
        self.configuration = self._configuration()
        self.fault, given = self._without_faults(choices)
        self.configuration = self.configuration.with_given(given)
        self.book = RuleBook(self.pause)
        self.caches = LiveCaches(self.buffers, self.aside, expand=choices.expand, named=self.folders)
        self.forget()

    def _without_faults(self, choices: Choices) -> tuple[str, Settings]:
        """The faults of the settings, and those that are right."""
        faults, given = [*filter(None, [self.fault]), *choices.faults], choices.given
        rules = self._known_rules() if given.select or given.extend_select or given.ignore else ()
        right: dict[str, tuple[str, ...]] = {}
        for name in ("select", "extend_select", "ignore", "target"):
            words = getattr(given, name) or ()
            found = {word: _fault(name, word, rules) for word in words}
            setting = re.sub(r"_(.)", lambda match: match[1].upper(), name)
            faults += (f"setting `{setting}`: {fault}" for fault in found.values() if fault)
            right[name] = tuple(word for word in words if not found[word])
        return "; ".join(faults), given._replace(
            select=right["select"] or None,
            extend_select=right["extend_select"],
            ignore=right["ignore"],
            target=right["target"] or None,
        )

    def _known_rules(self) -> tuple[RuleFacts, ...]:
        """The rules that settings can name; none where the configuration keeps them from being known."""
        folder = self.folders[0] if self.folders else Path.cwd()
        try:
            return RuleBook().rules(self.settings_for(folder / "any.sdf"))
        except WrongUsage:
            return ()

    def refresh(self) -> None:
        """Find configuration files, packages and documents again."""
        self.caches.close()
        self.choose(self.choices)

    def forget(self) -> None:
        """Read all documents again when they are asked for."""
        self.generation += 1
        self._disk = Disk()
        self.caches.forget()
        for buffer in self.buffers.values():
            buffer.forget()

    def close(self) -> None:
        """End what expands xacro."""
        self.caches.close()

    @contextmanager
    def looking_at(self, path: Path) -> Iterator[None]:
        """A time in which the text of a file must stay as it is."""
        outer, self._looked_at = self._looked_at, path
        try:
            yield
        except Outdated:
            self.caches.tidy()
            for buffer in self.buffers.values():
                buffer.tidy()
            raise
        finally:
            self._looked_at = outer

    def pause(self) -> None:
        """Let answers have their turn.

        Raises:
            Outdated: what is looked at has changed in theirs.
        """
        if self._worker is not None and self._worker.is_waited_for:
            before = self._state
            self._worker.give_way()
            if self._state != before:
                raise Outdated

    def aside(self, call: Callable[[], T]) -> T:
        """The result of what has nothing to do with documents; answers have their turn meanwhile."""
        return call() if self._worker is None else self._worker.aside(call, self.pause)

    @property
    def _state(self) -> tuple[int, Source | None]:
        """The state that all knowledge of the file that is looked at depends on."""
        buffer = None if self._looked_at is None else self.buffers.get(self.key(self._looked_at))
        return self.generation, None if buffer is None else buffer.source

    # Texts

    def key(self, path: Path) -> str:
        """By what a file is known, whatever links lead to it."""
        return self._disk.real(path)

    def open(self, uri: str, path: Path, text: str, version: int | None) -> Buffer:
        """Take a text that the editor shows."""
        self._turn(path)
        buffer = self.buffers[self.key(path)] = Buffer(uri, path, text, version)
        return buffer

    def write(self, buffer: Buffer, source: Source, version: int | None, kept: int = 0) -> None:
        """Take a new text of what is open, which begins with ``kept`` characters of the old one."""
        self._turn(buffer.path)
        buffer.write(source, version, kept)

    def drop(self, path: Path) -> None:
        """A text that the editor closes is again the content of its file."""
        if self.buffers.pop(self.key(path), None) is not None:
            self._turn(path)

    def is_referred_to(self, path: Path) -> bool:
        """Did another document ask for this one?"""
        return any(library.holds(path) for library in self.caches.libraries)

    def _turn(self, path: Path) -> None:
        """Documents that depend on a file must be read again."""
        if not self.is_referred_to(path):
            return
        buffer = self.buffers.get(self.key(path))
        if buffer is None or buffer.kind is not Kind.XACRO:
            self.forget()
            return
        self.generation += 1
        self.caches.forget_robots(path)
        for each in self.buffers.values():
            each.forget()

    # Documents

    def look_again(self, buffer: Buffer) -> None:
        """Look for the files around a xacro file again, of which some may be new to a client that does not watch."""
        if buffer.kind in {Kind.XACRO, Kind.SRDF, Kind.URDF} and buffer.made is not None:
            self.library(buffer.path).look_again()
            buffer.made.forget_views((Reading, Own))

    def settings_for(self, path: Path) -> Settings:
        """The settings of a file; the defaults where the configuration is faulty."""
        try:
            return self.configuration.settings_for(path)
        except WrongUsage as error:
            self.fault = str(error)
            return Settings()

    def library(self, path: Path) -> LiveLibrary:
        """The library that the file at a path looks others up in."""
        return self.caches.library(self.settings_for(path))

    def facts(self, path: Path) -> dict[str, RuleFacts]:
        """The available rules for a file, by their codes."""
        try:
            return {facts.code: facts for facts in self.book.rules(self.settings_for(path))}
        except WrongUsage as error:
            self.fault = str(error)
            return {}

    def document(self, path: Path) -> Document | None:
        """The text that is open at a path, or the content of the file; None where it cannot be read."""
        library = self.library(path)
        buffer = self.buffers.get(self.key(path))
        if buffer is None:
            return library.document(path, _kind(path))
        document = buffer.document
        document.library = library
        return document

    def listed(self, places: Iterable[Path]) -> list[Path]:
        """The descriptions in some folders, and single files."""
        there = [place for place in places if os.path.exists(place)]
        found = discover(there, exclude=lambda each: self.settings_for(each).excludes(each))
        return [file.path for file in found.files]

    def _configuration(self) -> Configuration:
        """The configuration that is set, or else that of the files; none where it is faulty."""
        self.fault = ""
        try:
            return Configuration(self.choices.configuration, trusted=self.choices.trust)
        except WrongUsage as error:
            self.fault = f"setting `configuration`: {error}"
            return Configuration(trusted=self.choices.trust)
