"""Is a result as sound as its source? Errors that the source does not have."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable

from sdfcheck.consumers.reaction import Consumer, Verdict
from sdfcheck.convert.loss import LossKind, loss_at, to_diagnostic
from sdfcheck.lint.diagnostic import Diagnostic, Severity
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element

ELSEWHERE = frozenset({"RES"})
"""Families whose errors are about other files, which a conversion can do without."""
_KEPT = frozenset({"INR", "RES"})
"""Families whose warnings are about what a conversion does not touch."""


def new_errors(
    source: Document, before: Iterable[Diagnostic], result: Document, after: Iterable[Diagnostic]
) -> list[Diagnostic]:
    """The errors for which a result, linted without what is ``ELSEWHERE``, is not written.

    Those that its source does not have are placed at the element of the source that has the name of what
    they are in. Those of the source in ``<gazebo>`` blocks, which only consumers of the result read, are in
    the source as well.
    """
    found = [one for one in after if one.severity is Severity.ERROR]
    if not found:
        return []
    before = tuple(before)
    own = [one for one in before if _is_for_the_result(source, one)]
    had = Counter(one.code for one in before) - Counter(one.code for one in own)
    now = Counter(one.code for one in found)
    fresh = [one for one in found if now[one.code] > had[one.code]]
    repeated = {(one.code, one.message) for one in fresh}
    known = [one for one in own if (one.code, one.message) in repeated]
    said = {(one.code, one.message) for one in known}
    losses = {
        loss_at(_counterpart(source, result, one), LossKind.UNSOUND_RESULT, _text(one), Severity.ERROR)
        for one in fresh
        if (one.code, one.message) not in said
    }
    return [*known, *map(to_diagnostic, sorted(losses, key=lambda loss: (loss.span.start, loss.message)))]


def _is_for_the_result(source: Document, error: Diagnostic) -> bool:
    """Is it in a ``<gazebo>`` block, which no parser of the source's own format reads?"""
    root, spans = source.root, source.spans
    if root is None or error.span.source.path != source.source.path:
        return False
    blocks = (spans.place(block) for block in root.children("gazebo"))
    return any(block.start <= error.span.start < block.close_end for block in blocks)


def means_another_robot(found: Diagnostic) -> bool:
    """Is it a warning about something that Gazebo, who reads results, takes otherwise than it is written?"""
    if found.severity is not Severity.WARNING or found.code[:3] in _KEPT:
        return False
    reaction = dict(found.affects).get(Consumer.GAZEBO.value)
    return reaction is not None and reaction.verdict is Verdict.WARN and "ignores" not in reaction.words


def _text(error: Diagnostic) -> str:
    line = error.span.begin.line
    return f"the result would have an error in line {line} ({error.code}): {error.message}"


def _counterpart(source: Document, result: Document, error: Diagnostic) -> Element:
    """The element of the source that has the name of the nearest element around an error, or its root."""
    assert source.root is not None
    around = None if result.root is None else _named_around(result.root, error.span.start)
    for name, kind in reversed(around or []):
        same = [e for e in source.root.walk() if e.attributes.get("name") == name]
        exact = [element for element in same if element.name == kind]
        if exact or same:
            return (exact or same)[0]
    return source.root


def _named_around(root: Element, place: int) -> list[tuple[str, str]]:
    """Name and kind of the elements around a place, from the outside in."""
    spans, found = root.document.spans, []
    at: Element | None = root
    while at is not None:
        if name := at.attributes.get("name", "").strip():
            found.append((name, at.name))
        inside = (
            child
            for child in at.children()
            if spans.place(child).start <= place < spans.place(child).close_end
        )
        at = next(inside, None)
    return found
