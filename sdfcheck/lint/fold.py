"""Diagnostics of expanded documents: put in their places, and each defect said once."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from itertools import islice
from typing import TYPE_CHECKING

from sdfcheck.consumers.reaction import Manner
from sdfcheck.files.library import Disk
from sdfcheck.lint.diagnostic import Diagnostic, Label, Origin, Severity
from sdfcheck.lint.fix import Fix
from sdfcheck.source.text import Source, Span

if TYPE_CHECKING:
    from sdfcheck.source.document import Document
    from sdfcheck.xacro.origins import ExpandedDocument
    from sdfcheck.xacro.static.reasons import Giver


def settle(diagnostics: Iterable[Diagnostic], document: ExpandedDocument, file: Document) -> list[Diagnostic]:
    """Move what points into the expanded text to where that was written in a xacro file, and add how it got there.

    A fix stays if it edits the linted file alone, and no expression in it.
    """
    settled = []
    for diagnostic in diagnostics:
        span = document.written(diagnostic.span)
        origins = tuple(Origin(*step) for step in document.origins_at(span))
        labels = tuple(_label(document.written(label.span), label.text, span) for label in diagnostic.labels)
        fix = diagnostic.fix
        kept = diagnostic if fix is None or _holds(fix, document.top) else diagnostic.without_fix
        moved = kept._replace(
            span=span,
            labels=tuple(label for label in labels if label.span != span),
            origins=diagnostic.origins or origins,
            repeats=tuple(map(document.written, diagnostic.repeats)),
        )
        settled.append(moved)
    return [*_at_values(_once_a_way(settled), file)]


def _once_a_way(diagnostics: Iterable[Diagnostic]) -> list[Diagnostic]:
    """Of diagnostics about lines that two calls or includes bring alike, the first, which says how many there are."""
    groups: dict[object, list[Diagnostic]] = {}
    for each in diagnostics:
        is_way = len(each.labels) == 1 and each.labels[0].text.endswith(_WAY)
        key = (each.code, each.labels, each.origins) if is_way else id(each)
        groups.setdefault(key, []).append(each)
    return [_of_a_way(*group) for group in groups.values()]


def _of_a_way(first: Diagnostic, *more: Diagnostic) -> Diagnostic:
    """The first of some alike; what to do where one file is included twice."""
    if (
        len(first.labels) == 1
        and first.labels[0].text.endswith(_WAY)
        and first.labels[0].span.text == _INCLUDE
    ):
        first = first._replace(help=_TWICE)
    if not more:
        return first
    return first.without_fix._replace(message=f"{first.message}, and {len(more)} more like this")


_WAY = ", from here"
_INCLUDE = "xacro:include"
_TWICE = "include the file once: what it defines is there again with each `xacro:include`"


def _label(place: Span, text: str, span: Span) -> Label:
    """A label; where it is the place of the diagnostic itself, reached in another way, the step that differs."""
    if Span(*place) == Span(*span):
        own, other = reversed(getattr(span, "origins", ())), reversed(getattr(place, "origins", ()))
        for here, there in zip(own, other, strict=False):
            if here.span != there.span:
                return Label(Span(*there.span), text + _WAY)
    return Label(place, text)


def _at_values(diagnostics: Iterable[Diagnostic], file: Document) -> Iterator[Diagnostic]:
    """The diagnostics with the values of expressions that they are about.

    A text that is meant for a number has one, where it is written; none if it is reported by expressions already.
    """
    seen = set()
    at_fault: set[Span] | None = None
    for each in diagnostics:
        value: str | None = getattr(each.span, "value", None)
        if value is None:
            yield each
            continue
        from sdfcheck.xacro.static.reasons import MOST, all_givers, misnumbered, values_at_fault

        if at_fault is None:
            at_fault = {*values_at_fault(file.problems)}
        found = all_givers(each.span, getattr(each.span, "origins", ()), file)
        given = misnumbered(found)
        if not at_fault.isdisjoint(giver.span for giver in found):
            continue
        if given is None or given.text.strip() not in value:
            yield _with_values(each, value, found[:MOST])
        elif (each.code, given.span) not in seen:
            seen.add((each.code, given.span))
            yield _moved(each, value, given.span)


def _moved(diagnostic: Diagnostic, value: str, place: Span) -> Diagnostic:
    """The diagnostic about a value, at the place that gives it."""
    span = diagnostic.span
    message = diagnostic.message.replace(span.text, value)
    labels = (Label(span, "read here"), *(each for each in diagnostic.labels if each.span != place))
    return diagnostic._replace(span=place, message=f"{message} (`{span.text}`)", labels=labels, origins=())


def _with_values(diagnostic: Diagnostic, value: str, found: Sequence[Giver]) -> Diagnostic:
    """The diagnostic with the value of the expression that it is about, and where that value comes from."""
    span = diagnostic.span
    message, code = diagnostic.message.replace(span.text, value), f"`{span.text}`"
    if found:
        name, text, place = found[0]
        at = f"line {place.begin.line}"
        if place.source.path != span.source.path:
            at = f"{place.source.path.name}:{place.begin.line}"
        given = f"`{text}`" if "$" in text else text or '""'
        code += f", set at {at}" if name == span.text else f", with `{name}` = {given} set at {at}"
    known = {label.span for label in diagnostic.labels}
    labels = [Label(each.span, f"`{each.name}` is set here") for each in found if each.span not in known]
    return diagnostic._replace(message=f"{message} ({code})", labels=(*diagnostic.labels, *labels))


def _holds(fix: Fix, top: Source) -> bool:
    return all(edit.span.source is top and "$" not in edit.span.text for edit in fix.edits)


def fold(diagnostics: Iterable[Diagnostic]) -> list[Diagnostic]:
    """One diagnostic for each rule, place and severity, with the number of expansions that it shows up in.

    The first represents all. Its fix stays if all have the same. Two diagnostics of one expansion
    at one place are two mistakes.
    """
    groups: dict[object, list[Diagnostic]] = {}
    heard: Counter[object] = Counter()
    for diagnostic in sorted(dict.fromkeys(diagnostics), key=_order):
        what = (diagnostic.code, diagnostic.severity, Span(*diagnostic.span))
        heard[what, diagnostic.origins] += 1
        groups.setdefault((what, heard[what, diagnostic.origins]), []).append(diagnostic)
    return sorted((_one(group) for group in groups.values()), key=lambda diagnostic: diagnostic.sort_key)


def _order(diagnostic: Diagnostic) -> tuple[tuple[tuple[str, int], ...], tuple[str, int, int, str, str]]:
    """By the calls and includes, from the outside in, then by place."""
    way = tuple((o.span.source.path.as_posix(), o.span.start) for o in reversed(diagnostic.origins))
    return way, diagnostic.sort_key


def _one(group: list[Diagnostic]) -> Diagnostic:
    first, *others = group
    if not others:
        return first
    same_fix = all(_written(other.fix) == _written(first.fix) for other in others)
    message = f"{first.message} (in {len(group)} expansions)"
    return (first if same_fix else first.without_fix)._replace(message=message)


def _written(fix: Fix | None) -> object:
    """A fix by what it writes, wherever macro calls and includes led to its places."""
    return fix and (*fix[:1], *fix[2:], *(edit._replace(span=Span(*edit.span)) for edit in fix.edits))


def with_consequences(found: Iterable[Diagnostic]) -> list[Diagnostic]:
    """The findings of one document, each with those that follow from it taken up by it.

    A finding follows from the first one that begins in its ``cause``, an error rather than a warning, or from what
    that one follows from. Where nothing begins there, it is a mistake of its own.
    """
    chosen = sorted(found, key=lambda each: (each.cause is None, each.severity.rank, each.sort_key))
    at = {(span.source, span.start): each for each in chosen for span in (*each.repeats, each.span)}
    starts = sorted(start for _, start in at)

    def before(each: Diagnostic) -> Diagnostic:
        if (cause := each.cause) is None:
            return each
        near = starts[bisect_left(starts, cause.start) : bisect_right(starts, cause.end)]
        first = next((at[cause.source, start] for start in near if (cause.source, start) in at), each)
        # Another expansion of the same place may be about another name.
        return each if first.code == each.code and cause == each.span else first

    consequences: dict[int, list[Diagnostic]] = {}
    firsts = []
    for each in chosen:
        first = each
        for _ in range(_MOST_STEPS):
            first = before(first)
        if first is each or before(first) is not first:
            firsts.append(each)
        else:
            consequences.setdefault(id(first), []).append(each)
    return [_with(each._replace(cause=None), consequences.get(id(each), ())) for each in firsts]


def _with(diagnostic: Diagnostic, consequences: Sequence[Diagnostic]) -> Diagnostic:
    """The diagnostic, as severe as what follows from it, with what consumers do for that.

    Its fix writes the same where they are about the same name.
    """
    if not consequences:
        return diagnostic
    worst = dict(diagnostic.affects)
    for each in consequences:
        for consumer, reaction in each.affects:
            known = worst.setdefault(consumer, reaction)
            worst[consumer] = max(known, reaction, key=lambda one: _MANNERS.index(one.manner))
    span = diagnostic.span
    alike = [each for each in consequences if each.span != span and each.span.text == span.text]
    new = (Label(each.span, "named here, too") for each in alike)
    labels = (*diagnostic.labels, *islice(new, max(0, _MOST_LABELS - len(diagnostic.labels))))
    fix = diagnostic.fix
    if fix is not None and alike:
        others = (edit for each in alike if each.fix is not None for edit in each.fix.edits)
        same = (edit for edit in others if edit.text == fix.edits[0].text)
        fix = fix._replace(edits=tuple(dict.fromkeys((*fix.edits, *same))))
    return diagnostic._replace(
        severity=max(diagnostic, *consequences, key=lambda each: each.severity.rank).severity,
        affects=tuple(sorted(worst.items())),
        labels=labels,
        fix=fix,
        repeats=(
            *diagnostic.repeats,
            *(place for each in consequences for place in (each.span, *each.repeats)),
        ),
    )


_MANNERS = tuple(Manner)
_MOST_STEPS = 4
"""So many findings may follow one from the other."""
_MOST_LABELS = 4


def without_repeats(diagnostics: Sequence[Diagnostic]) -> list[Diagnostic]:
    """The diagnostics of a run, each defect once, also where it is in a file that others include.

    A defect that several files reach is reported with its highest severity, and what is wrong in another file where
    that is included first. A consequence is left out where an error is reported on the line of its ``cause``.
    """
    foreign = [diagnostic for diagnostic in diagnostics if diagnostic.origins or diagnostic.cause]
    if not foreign:
        return list(diagnostics)
    disk = Disk()

    def line(span: Span) -> tuple[str, int]:
        return disk.real(span.source.path), span.begin.line

    def place(diagnostic: Diagnostic) -> tuple[str, str, int, int]:
        span, cause = diagnostic.span, diagnostic.cause
        if cause is not None and cause.source.path != span.source.path:
            span = cause
        return diagnostic.code, disk.real(span.source.path), span.start, span.end

    own = [each for each in diagnostics if not each.origins]
    places = set(map(place, foreign)).intersection(map(place, own))
    causes = {line(each.cause) for each in foreign if each.cause}
    if causes:
        causes &= {line(each.span) for each in own if each.severity is Severity.ERROR and not each.cause}
    worst: dict[tuple[object, ...], Diagnostic] = {}
    turns: Counter[tuple[object, ...]] = Counter()
    for each in diagnostics:
        if (each.origins and place(each) in places) or (each.cause and line(each.cause) in causes):
            continue
        top = each.origins[-1].span if each.origins else each.span
        by = (place(each), disk.real(top.source.path))
        turns[by] += 1
        known = worst.setdefault((place(each), turns[by]), each)
        if each.severity.rank > known.severity.rank:
            worst[place(each), turns[by]] = each
    return [*worst.values()]
