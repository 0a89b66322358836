"""The scan of a long text that is broken in one place.

Text that is well formed far before and after the place is found by one search and hidden from the
tolerant steps. A strict parser has the last word: where it does not read the result, or where something
is wrong elsewhere, the whole text is scanned.
"""

from __future__ import annotations

import sys
from bisect import bisect_left

from sdfcheck.source.problems import Problem
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.scanner.full_scan import assemble
from sdfcheck.source.scanner.prepare import prepare
from sdfcheck.source.scanner.quick_scan import MARKUP
from sdfcheck.source.scanner.scan import Scan
from sdfcheck.source.scanner.tokenizer import tokenize
from sdfcheck.source.text import Source, Span

WINDOW = 16_384
"""So many characters before and after the place are never hidden."""
_WORTHWHILE = 256
"""Shorter text is not hidden."""


class _Stretch(NamedTuple):
    """Whole elements, one after the other: where they are in the text, and among the places of a scan."""

    start: int
    end: int
    places: Scan


def local_scan(source: Source, fault: int) -> Scan | None:
    """The scan of a text in which a strict parser found a fault; None where the whole text has to be looked at.

    The caller has to make sure that a strict parser reads ``wellformed``, and finds as many elements as the scan.
    """
    text, prepared = source.text, prepare(source)
    first, last = fault - WINDOW, fault + WINDOW
    if prepared.problems or "<!DOCTYPE" in text:
        return None
    hidden = [*_before(text, first), *_after(text, last)]
    if not hidden:
        return None
    masked = _masked(text, hidden)
    tokens = tokenize(source, masked)
    starts = {stretch.start for stretch in hidden}
    pieces = [token for token in tokens.pieces if token.start not in starts]
    if len(pieces) != len(tokens.pieces) - len(hidden):
        return None
    tokens = tokens._replace(pieces=pieces)
    found, end = assemble(source, prepared._replace(text=masked), tokens, text)
    is_near = all(first <= place <= last for problem in found.problems for place in _places(problem))
    if end < len(text) or not found.problems or not is_near:
        return None
    return _completed(found, hidden)


def _before(text: str, end: int) -> list[_Stretch]:
    """The whole elements before an offset."""
    places, lone_starts, lone_ends, sound_end = _read(text, 0, end)
    tags = [(places.starts[index], places.ends[index]) for index in lone_starts]
    return [] if lone_ends else _between(tags, places, tags[0][0] if tags else 0, sound_end)


def _after(text: str, start: int) -> list[_Stretch]:
    """The whole elements after an offset, from the first tag on a line of its own."""
    begin = text.find("\n", start)
    begin = text.find("<", begin) if begin >= 0 else -1
    if begin < 0:
        return []
    places, lone_starts, lone_ends, _ = _read(text, begin, len(text))
    return [] if lone_starts or not lone_ends else _between(lone_ends, places, begin, lone_ends[-1][0])


def _read(text: str, start: int, end: int) -> tuple[Scan, list[int], list[tuple[int, int]], int]:
    """The places of elements, which start and end tags have no other half, and where the last markup ends."""
    places = Scan()
    starts, ends, closes, close_ends = places.starts, places.ends, places.closes, places.close_ends
    unclosed: list[int] = []
    lone_ends: list[tuple[int, int]] = []
    after = start
    for match in MARKUP.finditer(text, start, max(end, start)):
        at, after = match.span()
        kind = match.lastindex
        if kind == 1:
            if unclosed:
                index = unclosed.pop()
                closes[index], close_ends[index] = at, after
            else:
                lone_ends.append((at, after))
        elif text[at + 1] not in "!?":
            if kind is None:
                unclosed.append(len(starts))
            starts.append(at)
            ends.append(after)
            closes.append(after)
            close_ends.append(after)
        elif text.startswith("<!--", at):
            places.comments.append((at, after))
    return places, unclosed, lone_ends, after


def _between(tags: list[tuple[int, int]], places: Scan, start: int, end: int) -> list[_Stretch]:
    """The text between unpaired tags, where it is long."""
    found = []
    for at, after in (*tags, (end, end)):
        if at - start > _WORTHWHILE:
            found.append(_Stretch(start, at, places))
        start = after
    return found


def _masked(text: str, hidden: list[_Stretch]) -> str:
    """The text with instructions of the same length in place of what is hidden."""
    pieces: list[str] = []
    copied = 0
    for start, end, _ in hidden:
        pieces += (text[copied:start], "<?hidden", " " * (end - start - 10), "?>")
        copied = end
    return "".join((*pieces, text[copied:]))


def _places(problem: Problem) -> list[int]:
    """Where the places of a problem begin."""
    values = (getattr(problem, field) for field in problem._fields)
    return [value.start for value in values if isinstance(value, Span)]


def _completed(found: Scan, hidden: list[_Stretch]) -> Scan:
    """A scan with the places of what was hidden."""
    result = Scan()
    result.problems, result.doubtful, result.wellformed = found.problems, found.doubtful, found.wellformed
    result.comments = found.comments
    taken = 0
    for start, end, places in (*hidden, _Stretch(sys.maxsize, 0, Scan())):
        until = bisect_left(found.starts, start)
        shift = len(result.starts) - taken
        result.odd |= {index + shift: tag for index, tag in found.odd.items() if taken <= index < until}
        first, last = bisect_left(places.starts, start), bisect_left(places.starts, end)
        for name in ("starts", "ends", "closes", "close_ends"):
            getattr(result, name).extend(getattr(found, name)[taken:until])
            getattr(result, name).extend(getattr(places, name)[first:last])
        result.comments += [comment for comment in places.comments if start <= comment[0] < end]
        taken = until
    result.comments = sorted(result.comments)
    return result
