"""Lints one file of a run, with what it refers to available, and silences what is to be silenced."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, cast

from sdfcheck.files.library import Library, Projects, SearchPaths
from sdfcheck.lint.config.configuration import Configuration
from sdfcheck.lint.config.settings import Settings
from sdfcheck.lint.diagnostic import Diagnostic, Origin, Severity
from sdfcheck.lint.engine import INTERNAL_ERROR, Dispatch, Xacro, lint_document
from sdfcheck.lint.rulebook.rulebook import RuleBook
from sdfcheck.lint.select import simulated_levels
from sdfcheck.source.document import Document, read
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Span

if TYPE_CHECKING:
    from sdfcheck.files.library import Library
    from sdfcheck.lint.config.settings import ArgumentSet
    from sdfcheck.lint.engine import Xacro
    from sdfcheck.lint.fix import Fix
    from sdfcheck.lint.run import RuleFacts
    from sdfcheck.lint.suppress.suppression import Comment, Directive
    from sdfcheck.source.document import Document
    from sdfcheck.xacro.expansion import Expander, Surroundings


# Reads one file and lints it, a xacro file also as what it expands to.


class FileResult(NamedTuple):
    diagnostics: list[Diagnostic]
    comments: Sequence[Comment] = ()
    """Those that speak to sdfcheck."""
    outward: Sequence[Span] = ()
    """Where comments may be for what other files bring out."""
    document: Document | None = None
    """The document that the comments are in."""


def lint_source(
    data: bytes,
    path: Path,
    kind: Kind | None,
    dispatch: Dispatch,
    library: Library | None = None,
    xacro: Xacro | None = None,
) -> FileResult:
    """Read and lint one file's bytes. Any text gives diagnostics.

    Other files are taken from the library; without one nothing is looked up.
    """
    document = library.known(data, path) if library is not None else None
    is_own = document is None or document.kind is not (kind or document.kind)
    if document is None or is_own:
        document = read(data, path, kind)
    document.library, document.included_by = library, ()
    if library is not None and document.kind is Kind.URDF and not _is_whole(document):
        from sdfcheck.xacro.prepare import is_fragment, is_launched_source

        is_part = is_fragment(document)
        if is_part or is_launched_source(document):
            document, is_own = read(data, path, Kind.XACRO), True
            document.library, xacro = library, None if is_part else xacro
    if library is not None and is_own:
        library.turn_to(document)
    if document.kind is Kind.SRDF:
        from sdfcheck.lint.expanded import lint_semantics

        return result(lint_semantics(document, dispatch, xacro), document)
    if document.kind is Kind.XACRO:
        from sdfcheck.lint.expanded import lint_xacro
        from sdfcheck.xacro.static.definitions import is_robot

        expander, sets, variants = xacro or Xacro(None)
        # A file that includes this one calls its macros, and shows the problems in them.
        is_open = expander is None or not is_robot(document)
        found = lint_xacro(document, dispatch, expander, sets, variants=variants)
        return result(found, document, open=is_open)
    return result(lint_document(document, dispatch), document)


def _is_whole(document: Document) -> bool:
    from sdfcheck.formats.urdf.survey import is_whole

    return is_whole(document)


def result(diagnostics: list[Diagnostic], document: Document, *, open: bool = False) -> FileResult:
    """The diagnostics that the document's comments leave; all of it if it is ``open`` to others."""
    source = document.source
    if "sdfcheck:" not in source.text or document.root is None:
        return FileResult(diagnostics)
    from sdfcheck.lint.suppress.suppression import comments, includes

    whole = [source.span(0, len(source.text))]
    outward = whole if open else includes(source, document.scan)
    return FileResult(diagnostics, comments(source, document.scan), outward, document)


_ROBOTS = frozenset({Kind.SDF, Kind.URDF})
_INCLUDABLE = frozenset({Kind.SDF, Kind.URDF, Kind.MODEL_CONFIG, Kind.BROKEN_XML, Kind.EMPTY})
"""The kinds whose texts findings may show."""


class Selected(NamedTuple):
    """A file that is to be linted, read."""

    path: Path
    data: bytes
    kind: Kind


class Caches:
    """The libraries and expanders of a run: one for all files that have the same search paths.

    ``projects`` are those that other parts of the run know already, by search paths.
    """

    __slots__ = ("_arguments", "_expand", "_expanders", "_is_alone", "_libraries", "_named", "_projects")

    def __init__(
        self,
        *,
        expand: bool = True,
        arguments: ArgumentSet = (),
        named: tuple[Path, ...] = (),
        is_alone: bool = False,
        projects: dict[SearchPaths, Projects] | None = None,
    ) -> None:
        self._projects = {} if projects is None else projects
        self._named = named
        self._is_alone = is_alone
        self._expand = expand
        self._arguments = arguments
        self._libraries: dict[SearchPaths, Library] = {}
        self._expanders: dict[tuple[SearchPaths, tuple[str, ...]], Expander] = {}

    def __enter__(self) -> Caches:
        return self

    def __exit__(self, *raised: object) -> None:
        self.close()

    def close(self) -> None:
        """End what expands xacro."""
        for expander in self._expanders.values():
            expander.close()

    def xacro(self, settings: Settings, path: Path) -> Xacro:
        """How to expand a file: by whom (None: not at all) and with which sets of arguments."""
        if not self._expand:
            return Xacro(None, ())
        key = settings.search, settings.env
        if key not in self._expanders:
            self._expanders[key] = self._expander(self._surroundings(settings))
            self._expanders[key].start()

        sets: Sequence[ArgumentSet] = settings.arguments_for(path)
        if self._arguments:  # they have the last word in each set
            merged = ({**dict(given), **dict(self._arguments)} for given in sets or ((),))
            sets = list(dict.fromkeys(tuple(given.items()) for given in merged))
        return Xacro(self._expanders[key], tuple(map(dict, sets)))

    def _expander(self, surroundings: Surroundings) -> Expander:
        from sdfcheck.xacro.expansion import Expander

        return Expander(surroundings)

    def _surroundings(self, settings: Settings) -> Surroundings:
        from sdfcheck.xacro.expansion import Surroundings

        return Surroundings(dict(settings.packages), settings.package_paths, settings.env)

    def library(self, settings: Settings) -> Library:
        search = settings.search._replace(named=self._named, is_alone=self._is_alone)
        if search not in self._libraries:
            projects = self._projects.setdefault(search, Projects())
            self._libraries[search] = Library(search, settings.size_limit, projects)
        return self._libraries[search]

    @property
    def refused(self) -> list[tuple[Path, Path]]:
        """The files that were not read as they lie outside, each with a document that refers to it."""
        return sorted(pair for library in self._libraries.values() for pair in library.refused.items())

    def included(self, files: Sequence[Path]) -> Iterator[Document]:
        """The documents that only includes lead to, each once; ``files`` are the run's own."""
        own: set[str] = set()
        for library in self._libraries.values():
            for document in library.unseen():
                if not own:
                    own.update(map(library.disk.real, files))
                key = library.disk.real(document.path)
                if key not in own and document.included_by and document.kind in _INCLUDABLE:
                    own.add(key)
                    yield document


def lint_file(
    file: Selected, book: RuleBook, settings: Settings, caches: Caches, *, variants: bool = True
) -> tuple[Sequence[Diagnostic], int]:
    """The diagnostics of one file, and how many were silenced; of xacro with its ``variants``."""
    # The parser knows what broken XML was meant to be.
    kind = None if file.kind is Kind.BROKEN_XML else file.kind
    # The process of the expansion gets ready while the rest is loaded here.
    is_expanded = kind in {Kind.XACRO, Kind.SRDF} or (
        kind is Kind.URDF and (b"$(" in file.data or b"${" in file.data)
    )
    xacro = caches.xacro(settings, file.path)._replace(variants=variants) if is_expanded else None
    dispatch, library = book.dispatch(settings, file.path), caches.library(settings)
    result = lint_source(file.data, file.path, kind, dispatch, library, xacro)
    return _silence(result, book, settings, file.path)


def lint_included(
    document: Document, book: RuleBook, configuration: Configuration
) -> tuple[Sequence[Diagnostic], int]:
    """The errors of a file that only an include leads to, and the includes in it that lead nowhere, with the way there.

    It is somebody else's file: its warnings are theirs, and it is not fixed.
    """
    path = document.path
    settings = configuration.settings_for(path)
    if settings.excludes(path):
        return (), 0
    steps = tuple(Origin(uri.span, "included here") for uri in reversed(document.included_by))
    found = [
        diagnostic.without_fix._replace(origins=(*diagnostic.origins, *steps))
        for diagnostic in lint_document(document, book.dispatch(settings, path))
    ]
    kept, silenced = _silence(result(found, document), book, settings, path)
    return [each for each in kept if each.severity is Severity.ERROR or _is_lost(each)], silenced


def _is_lost(diagnostic: Diagnostic) -> bool:
    """Is something not found here without which Gazebo refuses the document?"""
    if diagnostic.missing is None:
        return False
    from sdfcheck.consumers.reaction import UNFOUND, Consumer

    return dict(diagnostic.affects).get(Consumer.GAZEBO.value) == UNFOUND


def _silence(
    result: FileResult, book: RuleBook, settings: Settings, path: Path
) -> tuple[Sequence[Diagnostic], int]:
    """The diagnostics that the comments in a file, or where they come from, leave; how many not."""
    foreign = _foreign(result.diagnostics, path)
    if not result.comments and not foreign:
        return result.diagnostics, 0
    from sdfcheck.lint.suppress.suppression import directives, suppress

    active, rules = book.active(settings, path), book.rules(settings)
    own = directives(result.comments, rules)
    # A rule that failed may have had something to silence.
    failed = any(each.code == INTERNAL_ERROR.code for each in result.diagnostics)
    filtered = suppress(
        result.diagnostics,
        own.known,
        frozenset() if failed else active.codes,
        foreign=directives(foreign, rules).known,
        outward=result.outward,
        is_idle=_idle(result.document, rules),
    )
    reported = [
        report._replace(severity=active.severities.get(report.code, report.severity))
        for report in (*own.malformed, *filtered.unused)
        if report.code in active.codes
    ]
    kept = _without_fixes_of(result.comments, filtered.kept)
    return [*kept, *reported], filtered.suppressed


def silence_simulated(
    found: Sequence[Diagnostic], rules: Sequence[RuleFacts], settings: Settings, path: Path
) -> tuple[Sequence[Diagnostic], int]:
    """The findings of a simulation that settings and comments leave; how many the comments silence.

    No comment is called unused, for it may silence a finding of another simulator.
    """
    from sdfcheck.lint.suppress.suppression import directives, suppress

    levels = simulated_levels(settings, path)
    wanted = []
    for each in found:
        level = levels.get(each.code, each.severity)
        if level is not None:
            wanted.append(each._replace(severity=level))
    comments = _foreign(wanted, None)
    filtered = suppress(wanted, (), frozenset(), foreign=directives(comments, rules).known)
    return filtered.kept, filtered.suppressed


def _without_fixes_of(comments: Sequence[Comment], found: Sequence[Diagnostic]) -> Sequence[Diagnostic]:
    """The diagnostics; no fix of theirs changes a comment for sdfcheck."""
    from sdfcheck.lint.suppress.suppression import touched

    def is_free(fix: Fix) -> bool:
        own = (edit.span for edit in fix.edits if comments and edit.span.source is comments[0].span.source)
        return not any(True for span in own for _ in touched(comments, span))

    return [each if each.fix is None or is_free(each.fix) else each.without_fix for each in found]


def _idle(document: Document | None, rules: Sequence[RuleFacts]) -> Callable[[Directive, str], bool]:
    """Whether a rule has nothing to look at in the element that a comment is for, nor around it.

    Such a comment is for what is still to be written there, or for another version of the file.
    """
    from sdfcheck.lint.rule import Target, span_of
    from sdfcheck.lint.subjects import Subjects
    from sdfcheck.lint.suppress.suppression import IGNORE

    def is_idle(directive: Directive, code: str) -> bool:
        target = directive.comment.target
        facts = next(facts for facts in rules if facts.code == code)
        if document is None or document.kind not in _ROBOTS or target is None or directive.verb != IGNORE:
            return False
        if facts.explains or not (facts.looks_at or facts.selects) or "Root" in facts.looks_at:
            return False
        scan = document.scan
        end = scan.close_ends[bisect_left(scan.starts, target.start)]
        subjects = Subjects(facts.looks_at, facts.selects, ()).of(document)
        starts = (span_of(cast("Target", subject)).start for subject in subjects)
        # In the element, or around it.
        return not any(
            start < end and scan.close_ends[bisect_right(scan.starts, start) - 1] > target.start
            for start in starts
        )

    return is_idle


def _foreign(diagnostics: Sequence[Diagnostic], path: Path | None) -> list[Comment]:
    """The comments for sdfcheck in the files, other than the own one, that diagnostics point at or come through."""
    sources = {
        span.source
        for diagnostic in diagnostics
        for span in (diagnostic.span, *(origin.span for origin in diagnostic.origins))
        if span.source.path != path and span.source.contains("sdfcheck:")
    }
    if not sources:
        return []
    from sdfcheck.lint.suppress.suppression import comments
    from sdfcheck.source.scanner.full_scan import scan

    return [comment for source in sources for comment in comments(source, scan(source))]
