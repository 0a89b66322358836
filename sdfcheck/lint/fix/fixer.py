"""Applies the fixes of diagnostics, file by file, until there is nothing left to fix."""

from __future__ import annotations

from bisect import bisect_left, insort
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from itertools import groupby, takewhile
from pathlib import Path

from sdfcheck.consumers.reaction import ON_REQUEST, Consumer
from sdfcheck.lint.config.settings import Settings
from sdfcheck.lint.diagnostic import Diagnostic, Severity, named
from sdfcheck.lint.fix import Fix, TextEdit
from sdfcheck.lint.one_file import Caches, Selected, lint_file
from sdfcheck.lint.rulebook.rulebook import RuleBook
from sdfcheck.lint.run import Run
from sdfcheck.lint.session import Options, find, selected
from sdfcheck.lint.suppress.suppression import comments, touched
from sdfcheck.source.document import Document, read
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind, sniff
from sdfcheck.source.splice import Unwritable, replaced, splice

ROUNDS = 10
"""So many times a file is linted again without fewer fixes to apply before it counts as endless."""
TRIALS = 48
"""So many times a file is linted at most to find out which of its fixes do harm."""
AGAIN = 8
"""So many kinds of fixes are tried again after others were made."""

_GUESSED = frozenset((Kind.MISSPELT_ROOT, Kind.BROKEN_XML))
"""The kinds that a fix may turn into another one."""

Lint = Callable[[Selected], tuple[Sequence[Diagnostic], int]]
"""The diagnostics of a file, and how many were silenced."""


class MadeFix(NamedTuple):
    """A fix that was applied: its title, and the rule that it is of."""

    code: str
    name: str
    title: str


class FixedFile(NamedTuple):
    """A file before and after its fixes; where some of them or all were left out, why."""

    path: Path
    before: bytes
    after: bytes
    fixed: int
    refusal: str = ""
    made: tuple[MadeFix, ...] = ()
    """The fixes that were applied, in the order in which they were."""


class Refused(Exception):
    """Edits do no good; the message says why."""


def fix_files(done: Run, paths: Sequence[Path], options: Options, *, unsafe: bool) -> Iterator[FixedFile]:
    """Fix the files of a run in which something can be fixed; nothing is written."""
    wanted = {
        fix.edits[0].span.source.path
        for diagnostic in done.diagnostics
        if (fix := diagnostic.fix) is not None and fix.edits and _allowed(fix, unsafe)
    } & set(done.files)
    if not wanted:
        return
    found = find(paths, options)
    found = found._replace(files=tuple(f for f in found.files if f.path in wanted), empty=())
    book = RuleBook()
    with Caches(expand=options.expand, arguments=options.arguments) as caches:
        for file in selected(found, options, []):
            settings = options.settings_for(file.path)

            def lint(file: Selected, settings: Settings = settings) -> tuple[Sequence[Diagnostic], int]:
                return lint_file(file, book, settings, caches)

            yield fix_file(file, lint, unsafe=unsafe)


def fix_file(file: Selected, lint: Lint, *, unsafe: bool) -> FixedFile:
    """Apply the fixes of one file: lint, edit, and lint again until it is stable.

    A fix that does harm is left out: one that brings in a problem of the text or an error that was
    not there, or that ends the effect of a comment that silences something.
    """
    trials = _Trials(lint)
    now, left, fewest = _Linted.of(file, lint), ROUNDS, -1
    made: list[MadeFix] = []
    seen = {file.data}
    while fixes := trials.next(now.found, file.path, unsafe=unsafe):
        if 0 <= fewest <= len(fixes):
            left -= 1
        else:
            left, fewest = ROUNDS, len(fixes)
        after, applied = trials.apply(now, together(fixes)[1])
        if not applied and not trials.are_over:
            continue  # those that were in the way of others are left out
        if not applied:
            break
        if after.file.data in seen or not left:
            return FixedFile(file.path, file.data, file.data, 0, "its fixes undo one another")
        seen.add(after.file.data)
        made += _made(now.found, applied)
        now = after
    return FixedFile(file.path, file.data, now.file.data, len(made), trials.refusal, tuple(made))


def harmless(file: Selected, fixes: Sequence[Fix], lint: Lint) -> list[Fix]:
    """Those of some fixes that do no harm; of very many that are in each other's way, not all are tried."""
    trials, kept, left = _Trials(lint), list[Fix](), list(fixes)
    now = _Linted.of(file, lint) if fixes else None
    while now is not None and left and not trials.are_over:
        group = together(left)[1]
        kept += trials.apply(now, group)[1]
        tried = set(group)
        left = [fix for fix in left if fix not in tried]
    return kept


def applicable(diagnostics: Sequence[Diagnostic], path: Path, *, unsafe: bool) -> list[Fix]:
    """The fixes that may be applied to a file and change it, by their first edit."""
    fixes = [
        diagnostic.fix
        for diagnostic in diagnostics
        if diagnostic.fix is not None
        and _allowed(diagnostic.fix, unsafe)
        and all(edit.span.source.path == path for edit in diagnostic.fix.edits)
        and any(edit.text != edit.span.text for edit in diagnostic.fix.edits)
    ]
    return sorted(fixes, key=lambda fix: min(_range(edit) for edit in fix.edits))


class _Linted(NamedTuple):
    """A text, and what was found in it."""

    file: Selected
    document: Document
    found: Sequence[Diagnostic]
    silenced: int

    @classmethod
    def of(cls, file: Selected, lint: Lint) -> _Linted:
        return cls(file, _read(file), *lint(file))


class _Trials:
    """Applies fixes on trial, and keeps those that do no harm."""

    def __init__(self, lint: Lint) -> None:
        self._lint = lint
        self._left = TRIALS
        self._refused: set[tuple[str, ...]] = set()
        self._reasons: dict[tuple[str, ...], str] = {}
        self._may_try_again = False
        """Whether fixes were applied since some were refused: these may do no harm any more."""
        self._has_tried_again = False
        """Whether they were: once, those of the same words together."""

    @property
    def refusal(self) -> str:
        """Why the first of the fixes that are left out is; empty for none."""
        return next((reason for fix, reason in self._reasons.items() if fix in self._refused), "")

    def next(self, found: Sequence[Diagnostic], path: Path, *, unsafe: bool) -> list[Fix]:
        """The fixes to try: those of errors that stop every consumer come first, the others are judged by a robot."""
        stopping = _stopping(found)
        for each in (stopping, found) if stopping else (found,):
            fixes = applicable(each, path, unsafe=unsafe)
            if left := [fix for fix in fixes if _words(fix) not in self._refused]:
                return left
        if not self._may_try_again or self._has_tried_again or self.are_over:
            return []
        self._refused.clear()
        self._has_tried_again = True
        return self.next(found, path, unsafe=unsafe)

    @property
    def are_over(self) -> bool:
        return self._left <= 0

    def apply(self, before: _Linted, fixes: Sequence[Fix]) -> tuple[_Linted, list[Fix]]:
        """The text after those fixes that do no harm, together, and these; they are apart from each other."""
        now, kept = before, list[Fix]()
        groups = [list(fixes)]
        if self._has_tried_again:
            groups = [list(alike) for _, alike in groupby(sorted(fixes, key=_words), _words)]
            for group in groups[:-AGAIN]:
                self._refused.add(_words(group[0]))
            groups = groups[-AGAIN:]
        while groups:
            group = groups.pop()
            try:
                now, kept = self._after(before, [*kept, *group]), [*kept, *group]
            except Refused as refusal:
                half = 0 if self._has_tried_again else len(group) // 2
                if half and not self.are_over:
                    groups += [group[half:], group[:half]]
                else:
                    for words in map(_words, group):
                        self._refused.add(words)
                        self._reasons.setdefault(words, str(refusal))
        self._may_try_again = bool(self._refused) and (self._may_try_again or bool(kept))
        return now, kept

    def _after(self, before: _Linted, fixes: Sequence[Fix]) -> _Linted:
        """The text after the fixes; raises Refused where that is worse."""
        file, data, document = before.file, *_edited(before.file, before.document, together(fixes)[0])
        self._left -= 1
        kind = sniff(data, file.path) if file.kind in _GUESSED else file.kind
        file = file._replace(data=data, kind=kind)
        after = _Linted(file, document if kind is before.file.kind else _read(file), *self._lint(file))
        if _lost_directives(before, after, fixes):
            raise Refused("the edits would take away a comment for sdfcheck")
        if brought := _brought(before, after):
            raise Refused(f"the edits would bring in {named(brought)}")
        return after


def _words(fix: Fix) -> tuple[str, ...]:
    """The texts that a fix replaces and writes, wherever it is."""
    return (fix.title, *(word for edit in fix.edits for word in (edit.span.text, edit.text)))


def _lost_directives(before: _Linted, after: _Linted, fixes: Sequence[Fix]) -> Counter[str]:
    """The comments for sdfcheck that are there no more, but for those that the fixes are about."""
    old, new = (comments(each.document.source, each.document.scan) for each in (before, after))
    meant = {each.span.start for fix in fixes for edit in fix.edits for each in touched(old, edit.span)}
    kept = Counter(comment.span.text for comment in old if comment.span.start not in meant)
    return kept - Counter(comment.span.text for comment in new)


def _stopping(found: Sequence[Diagnostic]) -> list[Diagnostic]:
    """The errors for which no consumer gets a robot."""
    every = {consumer.value for consumer in Consumer} - ON_REQUEST
    return [
        each
        for each in found
        if each.severity is Severity.ERROR
        and every <= {consumer for consumer, reaction in each.affects if reaction.is_refusal}
    ]


def _brought(before: _Linted, after: _Linted) -> list[str]:
    """The rules of which there are more errors than before; of all diagnostics, where fewer are silenced."""
    if stopping := _stopping(before.found):  # all of it can be judged only when it is a robot
        more = Counter(each.name for each in _stopping(after.found))
        return sorted(more - Counter(each.name for each in stopping))
    errors_only = after.silenced >= before.silenced
    counts = [
        Counter(each.name for each in found if not errors_only or each.severity is Severity.ERROR)
        for found in (before.found, after.found)
    ]
    return sorted(counts[1] - counts[0])


def _made(found: Sequence[Diagnostic], applied: Sequence[Fix]) -> Iterator[MadeFix]:
    """The note on applied fixes; each is for one of the diagnostics."""
    left: dict[Fix, list[Diagnostic]] = {}
    for diagnostic in reversed(found):
        if diagnostic.fix is not None:
            left.setdefault(diagnostic.fix, []).append(diagnostic)
    for fix in applied:
        diagnostic = left[fix].pop()
        yield MadeFix(diagnostic.code, diagnostic.name, fix.title)


def together(fixes: Sequence[Fix]) -> tuple[list[TextEdit], list[Fix]]:
    """The edits, in order, of those fixes that are apart from the ones before; and these fixes.

    An edit that two fixes share is done once.
    """
    taken: list[tuple[int, int]] = []
    edits: dict[tuple[int, int], TextEdit] = {}
    applied: list[Fix] = []
    for fix in fixes:
        new = [edit for edit in fix.edits if not _is(edits.get(_range(edit)), edit)]
        places = [_range(edit) for edit in new]
        fitting = list(takewhile(lambda place: _take(taken, place), places))
        if len(fitting) < len(places):
            for place in fitting:
                taken.remove(place)
            continue
        edits.update(zip(places, new, strict=True))
        applied.append(fix)
    return [edits[place] for place in taken], applied


def _take(taken: list[tuple[int, int]], place: tuple[int, int]) -> bool:
    """Put a range among the others if it touches none; at one offset there is one edit."""
    at = bisect_left(taken, place)
    following = taken[at] if at < len(taken) else None
    before = taken[at - 1] if at else None
    if following is not None and (following[0] < place[1] or following[0] == place[0]):
        return False
    if before is not None and (before[1] > place[0] or before[0] == place[0]):
        return False
    insort(taken, place)
    return True


def _range(edit: TextEdit) -> tuple[int, int]:
    return edit.span.start, edit.span.end


def _is(known: TextEdit | None, edit: TextEdit) -> bool:
    return known is not None and known.text == edit.text


def _allowed(fix: Fix, unsafe: bool) -> bool:
    return unsafe or fix.is_safe


def edited(file: Selected, edits: Sequence[TextEdit]) -> bytes:
    """The bytes after the edits; raises Refused where they are worse than before."""
    return _edited(file, _read(file), edits)[0]


def _edited(file: Selected, before: Document, edits: Sequence[TextEdit]) -> tuple[bytes, Document]:
    """The bytes of a document after the edits, and what they read as; raises Refused where they are worse."""
    pieces = [(*_range(edit), edit.text) for edit in edits]
    try:
        result = splice(file.data, pieces)
    except Unwritable as error:
        raise Refused(str(error)) from None
    after = _read(file._replace(data=result))
    if after.source.text != replaced(before.source.text, pieces):
        raise Refused("the edits would change how its other characters are read")
    if _is_worse(before, after):
        raise Refused("the edits would break it")
    return result, after


def _read(file: Selected) -> Document:
    return read(file.data, file.path, None if file.kind is Kind.BROKEN_XML else file.kind)


def _is_worse(before: Document, after: Document) -> bool:
    """Is there something wrong with the text that was not?"""
    if before.root is None or after.root is None:
        return before.root is not None
    is_other = after.root.name != before.root.name and before.kind is not Kind.MISSPELT_ROOT
    known, found = (Counter(type(problem) for problem in each.problems) for each in (before, after))
    return is_other or bool(found - known)
