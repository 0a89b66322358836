"""Judging the parts of a value: words between spaces that should be numbers."""

from __future__ import annotations

import re
from collections.abc import Iterator

from sdfcheck.formats.reading import AS_WRITTEN, Cause, Outcome, Reading, malformed, misread
from sdfcheck.formats.sdf.numbers import BLANKS, Number, Width, leading_float, stream_float, stream_integer
from sdfcheck.formats.table import Range

SHARE = Range(0.0, 1.0)

_WORD = re.compile(rf"[^{BLANKS}]+")
_REST = {",": Cause.COMMA, "x": Cause.HEXADECIMAL, "X": Cause.HEXADECIMAL}
_WHOLE_REST = {**_REST, ".": Cause.FRACTION, "e": Cause.EXPONENT, "E": Cause.EXPONENT}


def words(text: str) -> Iterator[tuple[int, int]]:
    """Start and end of every part between spaces."""
    return (match.span() for match in _WORD.finditer(text))


def word_at(text: str, position: int) -> tuple[int, int]:
    """The part around a position that is not blank."""
    start = max(text.rfind(blank, 0, position) for blank in BLANKS) + 1
    match = _WORD.match(text, start)
    return match.span() if match else (position, len(text))


def no_number(text: str, start: int, end: int, whole: bool = False) -> Reading:
    """A part that no number begins, or in which one does not end where it should."""
    if "${" in text or "$(" in text:
        return malformed(0, len(text), Cause.EXPRESSION)
    number = leading_float(text, start)
    cause = Cause.NOT_A_NUMBER
    if number is not None and number.end < end:
        cause = rest_cause(text[number.end], whole=False)
    elif number is not None:
        cause = Cause.NOT_FINITE if number.is_special else Cause.HEXADECIMAL
        if whole and not number.is_special and not number.is_hexadecimal:
            cause = Cause.FRACTION
    return malformed(start, end, Cause.NOT_A_NUMBER if cause is Cause.TRAILING else cause)


def rest_cause(first: str, whole: bool) -> Cause:
    """The fault, by the first character after the number."""
    return (_WHOLE_REST if whole else _REST).get(first, Cause.TRAILING)


def one_number(text: str, start: int, end: int, number: Number) -> Reading:
    """A part that begins with a number, out of which strtod would take it."""
    if number.too_large or number.too_small:
        return malformed(start, end, Cause.TOO_LARGE if number.too_large else Cause.TOO_SMALL)
    if number.end < end:
        return misread(start, end, rest_cause(text[number.end], whole=False), number.plain)
    if number.is_hexadecimal:
        return misread(start, end, Cause.HEXADECIMAL, number.plain)
    if number.is_special:
        return Reading(Outcome.NOT_FINITE, start, end, Cause.NOT_FINITE)
    return AS_WRITTEN


def in_range(value: float, bounds: Range | None, start: int, end: int) -> Reading:
    if bounds is None or bounds.holds(value):
        return AS_WRITTEN
    return Reading(Outcome.OUT_OF_RANGE, start, end, refused=bounds.refused, range=bounds)


def read_stream(text: str, count: int, whole: bool, bounds: Range | None) -> Reading:
    """Numbers taken one after the other, with or without spaces between; what is left over is ignored."""
    position, worst = 0, AS_WRITTEN
    for index in range(count):
        blank = len(text) - len(text[position:].lstrip(BLANKS))
        if blank == len(text):
            return Reading(Outcome.WRONG_COUNT, 0, len(text), refused=True, wanted=(count,), got=index)
        number = stream_integer(text, blank) if whole else stream_float(text, blank)
        start, end = word_at(text, blank)
        if number is None:
            return no_number(text, start, end, whole)
        if number.too_large:
            return malformed(start, end, Cause.TOO_LARGE)
        if worst.is_fine:
            worst = _stream_part(text, (start, end), number, whole, last=index == count - 1)
        if worst.is_fine:
            worst = in_range(number.value, bounds, start, end)
        position = number.end
    extra = [part for part in words(text) if part[0] >= position]
    if extra and worst.is_fine:
        return Reading(Outcome.WRONG_COUNT, extra[0][0], len(text), wanted=(count,), got=count + len(extra))
    return worst


def _stream_part(text: str, part: tuple[int, int], number: Number, whole: bool, last: bool) -> Reading:
    start, end = part
    if number.end < end:
        cause = rest_cause(text[number.end], whole) if last else Cause.GLUED
        return misread(start, end, cause, number.plain)
    return misread(start, end, Cause.TOO_SMALL, "0") if number.too_small else AS_WRITTEN


def read_parts(text: str, wanted: tuple[int, ...], width: Width) -> Reading:
    """The parts of a pose (double) or a color (single): each is taken from the front of its word."""
    worst = AS_WRITTEN
    parts = list(words(text))
    for start, end in parts:
        number = leading_float(text, start, width)
        if number is None:
            return no_number(text, start, end)
        reading = one_number(text, start, end, number)
        if reading.outcome is Outcome.MALFORMED:
            return reading
        if number.is_special:
            if width is Width.DOUBLE or number.value == number.value:
                return malformed(start, end, Cause.NOT_FINITE)
            reading = misread(start, end, Cause.NOT_FINITE, "0")
        if reading.is_fine and width is Width.SINGLE:
            reading = in_range(number.value, SHARE, start, end)
        if worst.is_fine:
            worst = reading
    if len(parts) in wanted:
        return worst
    if worst.cause is Cause.COMMA:
        return malformed(worst.start, worst.end, Cause.COMMA)
    start = parts[wanted[-1]][0] if len(parts) > wanted[-1] else 0
    return Reading(Outcome.WRONG_COUNT, start, len(text), refused=True, wanted=wanted, got=len(parts))
