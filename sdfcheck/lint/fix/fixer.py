"""Applies the fixes of diagnostics, file by file, until there is nothing left to fix."""

from __future__ import annotations

from bisect import bisect_left, insort
from collections.abc import Callable, Iterator, Sequence
from itertools import takewhile
from pathlib import Path

from sdfcheck.lint.config.configuration import Settings
from sdfcheck.lint.diagnostic import Diagnostic
from sdfcheck.lint.fix import Edit, Fix
from sdfcheck.lint.one_file import Caches, Selected, lint_file
from sdfcheck.lint.rulebook.rulebook import RuleBook
from sdfcheck.lint.run import Run
from sdfcheck.lint.session import Options, find, selected
from sdfcheck.source.document import Document, read
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind, sniff
from sdfcheck.source.splice import Unwritable, replaced, splice

ROUNDS = 10
"""So many times a file is linted again without fewer fixes to apply before it counts as endless."""


class MadeFix(NamedTuple):
    """A fix that was applied: its title, and the rule that it is of."""

    code: str
    name: str
    title: str


class FixedFile(NamedTuple):
    """A file before and after its fixes; where it was refused to apply them, why."""

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
    book = RuleBook(options.choice, options.target)
    with Caches(expand=options.expand, arguments=options.arguments) as caches:
        for file in selected(found, options, []):
            settings = options.settings_for(file.path)

            def lint(file: Selected, settings: Settings = settings) -> Sequence[Diagnostic]:
                return lint_file(file, book, settings, caches)[0]

            yield fix_file(file, lint, unsafe=unsafe)


def fix_file(file: Selected, lint: Callable[[Selected], Sequence[Diagnostic]], *, unsafe: bool) -> FixedFile:
    """Apply the fixes of one file: lint, edit, and lint again until it is stable."""
    now, left, fewest = file, ROUNDS, -1
    made: list[MadeFix] = []
    seen = {file.data}
    try:
        while fixes := applicable(found := lint(now), file.path, unsafe=unsafe):
            if 0 <= fewest <= len(fixes):
                left -= 1
            else:
                left, fewest = ROUNDS, len(fixes)
            edits, applied = together(fixes)
            now = now._replace(data=edited(now, edits))
            if now.kind is Kind.MISSPELT_ROOT:
                now = now._replace(kind=sniff(now.data, now.path))
            if now.data in seen or not left:
                raise Refused("its fixes undo one another")
            seen.add(now.data)
            made += _made(found, applied)
    except Refused as refusal:
        return FixedFile(file.path, file.data, file.data, 0, str(refusal))
    return FixedFile(file.path, file.data, now.data, len(made), made=tuple(made))


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


def _made(found: Sequence[Diagnostic], applied: Sequence[Fix]) -> Iterator[MadeFix]:
    """The note on applied fixes; each is for one of the diagnostics."""
    left = list(found)
    for fix in applied:
        at = next(at for at, diagnostic in enumerate(left) if diagnostic.fix == fix)
        diagnostic = left.pop(at)
        yield MadeFix(diagnostic.code, diagnostic.name, fix.title)


def together(fixes: Sequence[Fix]) -> tuple[list[Edit], list[Fix]]:
    """The edits, in order, of those fixes that are apart from the ones before; and these fixes.

    An edit that two fixes share is done once.
    """
    taken: list[tuple[int, int]] = []
    edits: dict[tuple[int, int], Edit] = {}
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


def _range(edit: Edit) -> tuple[int, int]:
    return edit.span.start, edit.span.end


def _is(known: Edit | None, edit: Edit) -> bool:
    return known is not None and known.text == edit.text


def _allowed(fix: Fix, unsafe: bool) -> bool:
    return unsafe or fix.is_safe


def edited(file: Selected, edits: Sequence[Edit]) -> bytes:
    """The bytes after the edits; raises Refused where they are worse than before."""
    pieces = [(*_range(edit), edit.text) for edit in edits]
    try:
        result = splice(file.data, pieces)
    except Unwritable as error:
        raise Refused(str(error)) from None
    before, after = _read(file), _read(file._replace(data=result))
    if after.source.text != replaced(before.source.text, pieces):
        raise Refused("the edits would change how its other characters are read")
    if _is_worse(before, after):
        raise Refused("the edits would break it")
    return result


def _read(file: Selected) -> Document:
    return read(file.data, file.path, None if file.kind is Kind.BROKEN_XML else file.kind)


def _is_worse(before: Document, after: Document) -> bool:
    """Is there more wrong with the text than there was?"""
    if before.root is None or after.root is None:
        return before.root is not None
    is_other = after.root.name != before.root.name and before.kind is not Kind.MISSPELT_ROOT
    return is_other or len(after.problems) > len(before.problems)
