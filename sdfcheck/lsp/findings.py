"""The diagnostics of what is open, by the files in which they are."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from itertools import chain
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar

from sdfcheck.formats.sdf.survey import Noted, Survey, noted_in, notes
from sdfcheck.lint.config.settings import Settings
from sdfcheck.lint.diagnostic import Diagnostic, Origin
from sdfcheck.lint.engine import Dispatch, explain, lint_document
from sdfcheck.lint.fold import without_repeats
from sdfcheck.lint.one_file import Selected, lint_file, lint_included
from sdfcheck.lsp.names import roots_of
from sdfcheck.lsp.workspace import LONG, Buffer, Workspace, around, same_ends
from sdfcheck.source.document import Document, Element
from sdfcheck.source.errors import WrongUsage
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import HEAD, Kind, sniff
from sdfcheck.source.text import Source, Span
from sdfcheck.xacro.static.definitions import is_robot

if TYPE_CHECKING:
    from collections.abc import Mapping

    from sdfcheck.source.document import Value
    from sdfcheck.source.scanner.scan import ElementPlace


# The first look at a world after an edit: at the model that has changed; what is known of the rest stays.


T = TypeVar("T")


class Look(NamedTuple):
    """A look at all of a long world: its text, its tree, what is known of its elements, and what was found."""

    source: Source
    root: Element
    noted: Noted
    found: tuple[Diagnostic, ...]


def look(buffer: Buffer, found: tuple[Diagnostic, ...], last: Look | None) -> Look | None:
    """The state of a text for later glances; of a broken one its ``last`` tree. None where there are none."""
    document = buffer.made
    if document is None or document.kind is not Kind.SDF or len(document.source.text) < LONG:
        return None
    if document.is_wellformed and document.root is not None:
        return Look(document.source, document.root, notes(document), found)
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
    tags = set() if document else {each.code for each in found}
    before = (each for each in last.found if each.code not in tags)
    kept = _kept(before, last.source, source, start, end)
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


def _kept(
    found: Iterable[Diagnostic], before: Source, source: Source, start: int, end: int
) -> list[Diagnostic]:
    """The diagnostics of a text before it changed in a range, where they are now; those in the range are gone."""
    shift = len(source.text) - len(before.text)

    def moved(span: Span) -> Span | None:
        if span.source is not before:
            return span
        if start < span.end and span.start < end - shift:
            return None
        by = shift if span.start >= end - shift else 0
        return source.span(span.start + by, span.end + by)

    return [each for one in found if (each := _moved(one, moved)) is not None]


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
        self._scan, self.elements, self.is_wellformed = whole.scan, whole.elements, True
        self.names, self.declared = whole.names, whole.declared
        if surveyed is not None:
            self._views[Survey] = surveyed
            if Survey not in whole._views:
                whole._views[noted_in] = surveyed.noted  # parts ask their own document


def _part(whole: Document, units: list[Element], last: Look) -> Document:
    """A document as one that has only some parts in its world, but the names of all."""
    world, root = units[0].around
    outer = Element(root.name, root.attributes, None, whole, root.index)
    inner = Element(world.name, world.attributes, outer, whole, world.index)
    outer.nodes, inner.nodes = [inner], [*units]
    surveyed = Survey(_Part(whole, outer))
    surveyed.noted = _noted(last.noted, surveyed.noted, units)
    named = surveyed.noted.named
    beside = (each for each in named.get(world, ()) if each[2].document is whole and each[2] not in units)
    named[world] = sorted([*beside, *named.pop(inner, ())], key=lambda each: each[2].index)
    surveyed.index.pop(root.name, None)
    surveyed.index.pop(world.name, None)
    return _Part(whole, root, surveyed)


def _noted(before: Noted, own: Noted, units: list[Element]) -> Noted:
    """The notes about the elements of a world: of some parts their ``own``, of the others those from before."""
    seen = set(chain.from_iterable(unit.walk() for unit in units))

    def joined(known: Mapping[Element, T], new: Mapping[Element, T]) -> dict[Element, T]:
        return {**{each: note for each, note in known.items() if each not in seen}, **new}

    return Noted(
        joined(before.named, own.named),
        joined(before.displaced, own.displaced),
        joined(before.replaced, own.replaced),
        {**{key: span for key, span in before.misspelled.items() if key[0] not in seen}, **own.misspelled},
    )


class _Foreign(NamedTuple):
    """The diagnostics of a file that is included, without the way there."""

    document: Document
    diagnostics: tuple[Diagnostic, ...]
    is_of: int
    """The generation of documents that it was found in."""


class _Robot(NamedTuple):
    """The findings in a robot in xacro with its usual arguments, and those that others bring out."""

    source: Source
    usual: tuple[Diagnostic, ...]
    others: tuple[Diagnostic, ...]


class Findings:
    """The known problems, for each root that was linted and each file that one of them includes."""

    def __init__(self, workspace: Workspace) -> None:
        self.workspace = workspace
        self._by_root: dict[str, tuple[Diagnostic, ...]] = {}
        self._looked: dict[str, tuple[Source, int]] = {}
        """Open file → the text that was looked at last, and the generation of documents."""
        self._roots_for: dict[str, set[str]] = {}
        """Open file of macros → the robots on disk that were linted for it."""
        self._foreign: dict[str, _Foreign] = {}
        self._looks: dict[str, tuple[Look | None, int]] = {}
        """Open file → what a glance at it needs, and the generation of documents."""
        self._glanced: dict[str, tuple[Source, int]] = {}
        self._robots: dict[str, _Robot] = {}

    def glance(self, buffer: Buffer) -> bool:
        """Look at an open text as far as that takes no time: at what has changed in a world, if that alone can be
        looked at; at a robot in xacro with the arguments that it has. The rest is for :meth:`lint`.
        """
        key, state = self._state(buffer)
        if self._looked.get(key) == state:
            return False
        if self._glanced.get(key) != state:
            found = self._usual(buffer) if buffer.kind is Kind.XACRO else self._changed(buffer)
            if found is None:
                return False
            self._by_root[key], self._glanced[key] = tuple(found), state
        return True

    def _changed(self, buffer: Buffer) -> list[Diagnostic] | None:
        """The findings in a world of which one part has changed; None where all of it is to be looked at."""
        last = self._last(buffer)
        if last is None:
            return None
        dispatch = self.workspace.book.dispatch(self.workspace.settings_for(buffer.path), buffer.path)
        return glance(buffer, last, dispatch)

    def _usual(self, buffer: Buffer) -> list[Diagnostic] | None:
        """The findings in a robot with its usual arguments, and those with others that were known; None without any."""
        from sdfcheck.lint.expanded import other_values

        document, key = self.workspace.document(buffer.path), self.workspace.key(buffer.path)
        if document is None or not is_robot(document) or not any(True for _ in other_values(document)):
            return None
        self._lint(buffer.path, buffer.data, buffer, variants=False)
        source, usual = buffer.source, self._by_root[key]
        before, _, others = self._robots.get(key, _Robot(source, (), ()))
        start, rest = same_ends(before.text, source.text)
        kept = _kept(others, before, source, start, len(source.text) - rest)
        self._robots[key] = _Robot(source, usual, tuple(kept))
        self.workspace.caches.tidy()
        return [*usual, *kept]

    def _state(self, buffer: Buffer) -> tuple[str, tuple[Source, int]]:
        return self.workspace.key(buffer.path), (buffer.source, self.workspace.generation)

    def near(self, buffer: Buffer, offset: int) -> Document | None:
        """An open text as far as it tells about a place; None where all of it is to be asked, or was."""
        last = self._last(buffer)
        found = None if last is None or last.source is buffer.source else near(buffer, last, offset)
        if found is not None:
            found.library = self.workspace.library(buffer.path)
        return found

    def _last(self, buffer: Buffer) -> Look | None:
        """The last look at a text, if the files around it are still the same."""
        last, is_of = self._looks.get(self.workspace.key(buffer.path), (None, -1))
        return last if is_of == self.workspace.generation else None

    def lint(self, buffer: Buffer) -> None:
        """Look at an open text, and at what it includes for the first time; at the same text once."""
        key, state = self._state(buffer)
        if self._looked.get(key) != state:
            if self._last(buffer) is not None and buffer.made is not None:
                buffer.made.forget_views(())  # what is known may be of a part
            self._lint(buffer.path, buffer.data, buffer)
            self._looked[key], robot = state, self._robots.get(key)
            if robot is not None and robot.source is buffer.source:
                others = (each for each in self._by_root[key] if each not in robot.usual)
                self._robots[key] = robot._replace(others=tuple(others))
            known = look(buffer, self._by_root[key], self._last(buffer))
            self._looks[key] = known, self.workspace.generation
            self.workspace.caches.tidy()

    def lint_from_disk(self, path: Path) -> None:
        """Look at a file that is not open, for what it shows about those that are."""
        from sdfcheck.files.regular import read_regular

        try:
            around = self.workspace.library(path).around(path)
            self._lint(path, read_regular(path, within=around), None)
        except OSError:
            self.forget(path)

    def includers(self, buffer: Buffer) -> list[Path]:
        """The robots that are not open and use a file of macros; those that did so before are forgotten."""
        if buffer.kind is not Kind.XACRO:
            return []
        key = self.workspace.key(buffer.path)
        before = self._roots_for.pop(key, set())
        document = self.workspace.document(buffer.path)
        robots = [] if document is None else roots_of(document)
        open_texts = self.workspace.buffers
        roots = [each.path for each in robots if self.workspace.key(each.path) not in open_texts]
        self._roots_for[key] = set(map(self.workspace.key, roots))
        for gone in before - self._roots_for[key]:
            self._by_root.pop(gone, None)
        return roots

    def forget(self, path: Path) -> None:
        """Drop the findings of a root."""
        key = self.workspace.key(path)
        self._by_root.pop(key, None)
        self._looked.pop(key, None)
        self._looks.pop(key, None)
        self._glanced.pop(key, None)
        self._robots.pop(key, None)
        for root in self._roots_for.pop(key, set()):
            self._by_root.pop(root, None)

    def _lint(self, path: Path, data: bytes, buffer: Buffer | None, *, variants: bool = True) -> None:
        workspace, key = self.workspace, self.workspace.key(path)
        if buffer is not None and not buffer.is_linted:
            self._by_root[key] = ()
            return
        settings = workspace.settings_for(path)
        if settings.excludes(path):
            self._by_root[key] = ()
            return
        self._loosen(key)
        with workspace.looking_at(path):
            self._by_root[key] = self._found_in(path, data, buffer, settings, variants=variants)
            self._lint_included(path)

    def _found_in(
        self, path: Path, data: bytes, buffer: Buffer | None, settings: Settings, *, variants: bool
    ) -> tuple[Diagnostic, ...]:
        workspace = self.workspace
        kind = buffer.kind if buffer is not None else sniff(data[:HEAD], path)
        try:
            file = Selected(path, data, kind)
            found, _ = lint_file(file, workspace.book, settings, workspace.caches, variants=variants)
        except WrongUsage as error:  # a selector that names no rule
            workspace.fault = str(error)
            return ()
        return tuple(found)

    def _lint_included(self, path: Path) -> None:
        workspace = self.workspace
        own = [path, *(buffer.path for buffer in workspace.buffers.values())]
        for document in workspace.caches.included(own):
            try:
                found, _ = lint_included(document, workspace.book, workspace.configuration)
            except WrongUsage as error:
                workspace.fault = str(error)
                continue
            steps = len(document.included_by)
            bare = (each._replace(origins=each.origins[: len(each.origins) - steps]) for each in found)
            self._foreign[workspace.key(document.path)] = _Foreign(
                document, tuple(bare), workspace.generation
            )

    def _loosen(self, key: str) -> None:
        """Let included files note anew where a root, whose text has changed, includes them."""
        for library in self.workspace.caches.libraries:
            for document in library.documents():
                by = document.included_by
                if by and self.workspace.key(by[0].element.document.path) == key:
                    document.included_by = ()

    # Findings to show

    def all(self) -> dict[str, list[Diagnostic]]:
        """Real path → what was found there, sorted, from whichever root; each once."""
        by_path: dict[str, list[Diagnostic]] = {}
        keys: dict[Source, str] = {}
        seen: set[tuple[object, ...]] = set()
        for diagnostic in sorted(without_repeats(self._found()), key=lambda each: each.sort_key):
            source = diagnostic.span.source
            if source not in keys:
                keys[source] = self.workspace.key(source.path)
            key = keys[source]
            same = key, diagnostic.code, diagnostic.message, diagnostic.span.start, diagnostic.span.end
            if same not in seen and self._is_current(source, key):
                seen.add(same)
                by_path.setdefault(key, []).append(diagnostic)
        return by_path

    def _found(self) -> list[Diagnostic]:
        found = [diagnostic for diagnostics in self._by_root.values() for diagnostic in diagnostics]
        for foreign in self._foreign.values():
            if foreign.is_of == self.workspace.generation:
                found += _with_way(foreign)
        return found

    def _is_current(self, source: Source, key: str) -> bool:
        """Are places still right? They are not in a text that has changed since it was looked at."""
        buffer = self.workspace.buffers.get(key)
        return buffer is None or source is buffer.source or source.text == buffer.source.text

    def at(self, path: Path) -> list[Diagnostic]:
        """The findings in one file."""
        return self.all().get(self.workspace.key(path), [])


def _with_way(foreign: _Foreign) -> Sequence[Diagnostic]:
    by: tuple[Value, ...] = foreign.document.included_by
    if not by:
        return ()
    steps = tuple(Origin(uri.span, "included here") for uri in reversed(by))
    return [each._replace(origins=(*each.origins, *steps)) for each in foreign.diagnostics]
