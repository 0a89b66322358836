"""Actions for diagnostics: fixes, one or all, and comments that silence them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from sdfcheck.lint.diagnostic import Diagnostic
from sdfcheck.lint.fix import TextEdit
from sdfcheck.lint.fix.fixer import Lint, fix_file, harmless
from sdfcheck.lint.one_file import Selected, lint_file
from sdfcheck.lint.suppress.add_ignores import ignoring
from sdfcheck.lsp.workspace import Buffer, Workspace
from sdfcheck.source.decode import decode
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.text import Source, Span

_LINES = 20_000
"""Of longer texts all that lies between the first and the last difference is replaced."""


class Offer(NamedTuple):
    """Something that can be done about a diagnostic; ``is_fix`` is False for silencing it."""

    title: str
    diagnostic: Diagnostic
    edits: tuple[TextEdit, ...]
    is_fix: bool
    is_safe: bool


def offers(workspace: Workspace, buffer: Buffer, found: Sequence[Diagnostic], at: Span) -> list[Offer]:
    """The actions for the diagnostics that touch a range: fixes first, safe ones before others."""
    touched = [each for each in found if each.span.start <= at.end and at.start <= each.span.end]
    fixes = _harmless(workspace, buffer, [fix for each in touched for fix in _fixes(each)])
    silences = [silence for each in touched for silence in _silences(workspace, buffer, each)]
    return [*sorted(fixes, key=lambda offer: not offer.is_safe), *silences]


def _harmless(workspace: Workspace, buffer: Buffer, fixes: Sequence[Offer]) -> list[Offer]:
    file, lint = _trial(workspace, buffer)
    given = [(offer, offer.diagnostic.fix) for offer in fixes]
    kept = set(harmless(file, [fix for _, fix in given if fix is not None], lint))
    return [offer for offer, fix in given if fix in kept]


def _trial(workspace: Workspace, buffer: Buffer) -> tuple[Selected, Lint]:
    """An open text as a file, and how to lint what becomes of it."""
    settings = workspace.settings_for(buffer.path)

    def lint(file: Selected) -> tuple[Sequence[Diagnostic], int]:
        return lint_file(file, workspace.book, settings, workspace.caches)

    return Selected(buffer.path, buffer.data, buffer.kind), lint


def _fixes(diagnostic: Diagnostic) -> Iterator[Offer]:
    fix = diagnostic.fix
    if fix is not None and fix.edits:
        title = fix.title if fix.is_safe else f"{fix.title} (unsafe)"
        title = title[:1].upper() + title[1:]
        yield Offer(title, diagnostic, fix.edits, True, fix.is_safe)


def _silences(workspace: Workspace, buffer: Buffer, diagnostic: Diagnostic) -> Iterator[Offer]:
    rules = tuple(workspace.facts(buffer.path).values())
    document = buffer.document
    if diagnostic.span.source.text != document.source.text:
        return
    edits = ignoring(document, diagnostic, rules)
    if edits:
        is_near = edits[0].span.start > document.scan.starts[0]
        where = "here" if is_near else "in this file"
        yield Offer(f"Ignore {diagnostic.name} {where}", diagnostic, tuple(edits), False, True)


def fix_all(workspace: Workspace, buffer: Buffer) -> list[TextEdit]:
    """The edits that all safe fixes of an open text come to; none where they would do no good."""
    file, lint = _trial(workspace, buffer)
    fixed_file = fix_file(file, lint, unsafe=False)
    if not fixed_file.fixed:
        return []
    return differences(buffer.source, decode(fixed_file.after, buffer.path)[0].text)


def differences(source: Source, after: str) -> list[TextEdit]:
    """The edits that turn a text into another, line by line."""
    from difflib import SequenceMatcher

    before = source.text
    if before == after:
        return []
    old, new = before.splitlines(keepends=True), after.splitlines(keepends=True)
    same = next(
        (n for n, pair in enumerate(zip(old, new, strict=False)) if pair[0] != pair[1]),
        min(len(old), len(new)),
    )
    rest = min(len(old), len(new)) - same
    tail = next((n for n in range(rest) if old[-1 - n] != new[-1 - n]), rest)
    start = sum(map(len, old[:same]))
    middle, other = old[same : len(old) - tail], new[same : len(new) - tail]
    if len(middle) > _LINES:
        return [TextEdit(source.span(start, start + sum(map(len, middle))), "".join(other))]
    edits = []
    places = [start]
    for line in middle:
        places.append(places[-1] + len(line))
    for kind, first, last, begin, end in SequenceMatcher(None, middle, other, autojunk=False).get_opcodes():
        if kind != "equal":
            edits.append(TextEdit(source.span(places[first], places[last]), "".join(other[begin:end])))
    return edits
