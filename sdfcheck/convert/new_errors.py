"""Is a result as sound as its source? Errors that the source does not have, and texts that are read by guessing."""

from __future__ import annotations

from bisect import bisect_right
from collections import Counter
from collections.abc import Callable, Iterable
from operator import attrgetter

from sdfcheck.consumers.reaction import READS, Consumer, Reaction, Verdict
from sdfcheck.convert.loss import LossKind, loss_at, to_diagnostic
from sdfcheck.convert.vendor_spelling import uses
from sdfcheck.formats.namespaces import declarations
from sdfcheck.lint.diagnostic import Diagnostic, Severity
from sdfcheck.lint.targets import OWN_CONSUMER
from sdfcheck.source.document import Document, Element
from sdfcheck.source.errors import WrongUsage
from sdfcheck.source.problems import (
    ContentAfterRoot,
    RepeatedAttribute,
    SyntaxDefect,
    SyntaxKind,
    TooDeep,
    UnknownEntity,
)
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Span

# Texts that are read as XML by guessing.

_BEYOND_REPAIR = (ContentAfterRoot, RepeatedAttribute, SyntaxDefect, TooDeep)


def break_of(document: Document) -> Span | None:
    """The first place where some of a text would be lost if it were written anew; None if there is none."""
    return _first(document, _BEYOND_REPAIR)


def refuse_broken(document: Document) -> None:
    """Raise WrongUsage where the text is broken: consumers refuse it, or read another robot."""
    if (span := break_of(document)) is not None:
        line, column = span.begin
        place = f"{document.path}:{line}:{column}"
        raise WrongUsage(f"{place}: the text is broken here; `sdfcheck lint` says how")


def guess_in(document: Document) -> Span | None:
    """The first place where others may read another text; None if the whole of it can be compared."""
    return _first(document, (*_BEYOND_REPAIR, UnknownEntity))


def _first(document: Document, kinds: tuple[type, ...]) -> Span | None:
    found = (problem for problem in document.problems if isinstance(problem, kinds))
    # The version of XML that a declaration names does not change the text.
    spans = [p.span for p in found if getattr(p, "kind", None) is not SyntaxKind.ODD_VERSION]
    # A prefix that one element declares twice has no meaning that could be written.
    spans += [each.span for each in declarations(document) if each.first is not None]
    return min(spans, key=lambda span: span.start, default=None)


def new_errors(
    source: Document, before: Iterable[Diagnostic], result: Document, after: Iterable[Diagnostic]
) -> list[Diagnostic]:
    """The errors for which a result, linted without what is ``ELSEWHERE``, is not written.

    Those that its source does not have are placed at the element of the source that has the name of what
    they are in. Those of the source in ``<gazebo>`` blocks, which only consumers of the result read, are those
    for which these refuse it.
    """
    found = [one for one in after if one.severity is Severity.ERROR]
    if not found:
        return []
    before = tuple(before)
    blocks = _Blocks(source)
    own = [one for one in before if blocks.hold(one)]
    had = Counter(one.code for one in before) - Counter(one.code for one in own)
    now = Counter(one.code for one in found)
    fresh = [one for one in found if now[one.code] > had[one.code] and not _came_back(source, one)]
    repeated = {(one.code, one.message) for one in fresh}
    known = [one for one in own if (one.code, one.message) in repeated]
    said = {(one.code, one.message) for one in known}
    counterparts = _Counterparts(source, result)
    losses = {
        loss_at(counterparts.of(one), LossKind.UNSOUND_RESULT, _text(one), Severity.ERROR)
        for one in fresh
        if (one.code, one.message) not in said
    }
    stopping = [one for _, one in refused(known, judges(result))]
    return [*stopping, *map(to_diagnostic, sorted(losses, key=lambda loss: (loss.span.start, loss.message)))]


def refused(
    found: Iterable[Diagnostic],
    consumers: Iterable[Consumer],
    reacts: Callable[[Reaction], bool] = attrgetter("is_refusal"),
) -> list[tuple[Consumer, Diagnostic]]:
    """The findings for which consumers refuse a file, or react otherwise."""
    wanted = {consumer.value: consumer for consumer in consumers}
    return [
        (wanted[name], one)
        for one in found
        for name, reaction in one.affects
        if name in wanted and reacts(reaction)
    ]


def judges(result: Document) -> tuple[Consumer, ...]:
    """The consumers whose verdict on a result counts."""
    readers = (consumer for consumer, kinds in READS.items() if result.kind.value in kinds)
    return tuple(consumer for consumer in readers if consumer in OWN_CONSUMER.values())


def has_refusals(result: Document, found: Iterable[Diagnostic]) -> bool:
    """Does a consumer of a result refuse it, or drop a part of it?"""
    return bool(refused(found, judges(result), lambda reaction: reaction.is_refusal or reaction.is_loss))


def new_refusals(
    source: Document, before: Iterable[Diagnostic], result: Document, after: Iterable[Diagnostic]
) -> tuple[list[Diagnostic], tuple[Consumer, Diagnostic] | None]:
    """The verdict of the consumers of a result.

    The errors for which they refuse the result, or drop a part of it, though they read the source, which does
    not have them; or a finding for which they refuse the result, as the source has it, too.
    """
    consumers = judges(result)
    before, after = tuple(before), tuple(after)
    known = {consumer for consumer, _ in refused(before, consumers)}
    had = {one.code for one in before if one.severity is Severity.ERROR}
    assert source.root is not None
    all_before = {one.code for one in before}
    found = refused(after, consumers)
    # Parts that only Drake reads are reported where they are written.
    dropped = [
        one
        for _, one in refused(after, consumers, attrgetter("is_loss"))
        if one.code not in all_before and not uses(source.root, "drake")
    ]
    if not found and not dropped:
        return [], None
    counterparts = _Counterparts(source, result)
    fresh = [one for consumer, one in found if consumer not in known and one.code not in had]
    losses = {
        loss_at(counterparts.of(one), LossKind.UNSOUND_RESULT, _text(one), Severity.ERROR)
        for one in (*fresh, *dropped)
    }
    ordered = sorted(losses, key=lambda loss: (loss.span.start, loss.message))
    return [to_diagnostic(loss) for loss in ordered], found[0] if found and not losses else None


def _came_back(source: Document, error: Diagnostic) -> bool:
    """Is it about something that the source keeps from URDF under a prefix, where it had the same error?"""
    name = error.span.text
    return source.kind is Kind.SDF and name.isidentifier() and source.source.contains(f"urdf:{name}")


class _Blocks:
    """The ``<gazebo>`` blocks of a source, which no parser of its own format reads."""

    def __init__(self, source: Document) -> None:
        self._source = source.source
        found = [] if source.root is None else source.root.children("gazebo")
        places = [source.spans.place(block) for block in found]
        self._starts = [place.start for place in places]
        self._ends = [place.close_end for place in places]

    def hold(self, error: Diagnostic) -> bool:
        """Is an error in one of them?"""
        at = bisect_right(self._starts, error.span.start) - 1
        return at >= 0 and error.span.source.path == self._source.path and error.span.start < self._ends[at]


def means_another_robot(found: Diagnostic) -> bool:
    """Is it a warning about something that Gazebo, who reads results, takes otherwise than it is written?"""
    if found.severity is not Severity.WARNING or found.code.startswith("RES"):
        return False  # a conversion does not touch where files are
    reaction = dict(found.affects).get(Consumer.GAZEBO.value)
    return reaction is not None and reaction.verdict is Verdict.WARN and not reaction.is_disregard


def _text(error: Diagnostic) -> str:
    line = error.span.begin.line
    return f"the result would have an error in line {line} ({error.code}): {error.message}"


class _Counterparts:
    """Elements of the source for those of the result, by name."""

    def __init__(self, source: Document, result: Document) -> None:
        assert source.root is not None
        self._root, self._named = source.root, dict[tuple[str, str], Element]()
        for element in source.root.walk():
            if (name := element.attributes.get("name")) is not None:
                self._named.setdefault((name, element.name), element)
                self._named.setdefault((name, ""), element)
        self._spans = result.spans
        self._elements = [] if result.root is None else list(result.root.walk())
        self._starts = [result.spans.place(element).start for element in self._elements]

    def of(self, error: Diagnostic) -> Element:
        """The element of the source that has the name of the nearest one around an error, or its root."""
        number = bisect_right(self._starts, error.span.start) - 1
        at = self._elements[number] if number >= 0 else None
        while at is not None:
            name = at.attributes.get("name", "").strip()
            found = self._named.get((name, at.name)) or self._named.get((name, ""))
            if name and found is not None and error.span.start < self._spans.place(at).close_end:
                return found
            at = at.parent
        return self._root
