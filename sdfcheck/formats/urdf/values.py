"""How urdfdom reads a value, with the reason where that is not what is written.

It is stricter than libsdformat: a number has to be all of its text, so `1.5kg`, `1,5`,
`0x10`, `inf` and `1 ` with a space after it are refused, and in a vector only spaces separate
the numbers, no tabs or line breaks. Checked against version 3.0.1.
"""

from __future__ import annotations

import re
from math import isfinite

from sdfcheck.formats.reading import AS_WRITTEN, Cause, Outcome, Reading, malformed
from sdfcheck.formats.sdf.numbers import BLANKS, stream_float
from sdfcheck.formats.sdf.parts import no_number
from sdfcheck.formats.sdf.table import Range
from sdfcheck.formats.urdf.table import UrdfAttribute, is_expression

_SIZES = {"vector3": 3, "color": 4, "quaternion": 4}
_EXPECTED = {"double": "a number", "int": "a whole number", "unsigned int": "a whole number"}
_PIECE = re.compile(r"[^ ]+")
_OTHER_BLANK = re.compile(r"[\t\n\r\v\f]+")


def read(attribute: UrdfAttribute, text: str) -> Reading:
    """How the text of an attribute is read, as it is in the file, tabs and line breaks included."""
    kind = attribute.type
    if attribute.choices:
        if text in attribute.choices:
            return AS_WRITTEN
        expected = "one of " + ", ".join(attribute.choices)
        return Reading(Outcome.NOT_A_CHOICE, 0, len(text), refused=True, expected=expected)
    if kind not in _SIZES and kind not in _EXPECTED:
        return AS_WRITTEN
    expected = _EXPECTED.get(kind) or f"{_SIZES[kind]} numbers"
    if not text.strip():
        return Reading(Outcome.EMPTY, 0, len(text), refused=True, expected=expected)
    if kind in _SIZES:
        reading = _read_parts(text, _SIZES[kind], attribute.range)
    else:
        reading = _read_number(text, 0, len(text), attribute.range)
    return reading if reading.is_fine else reading._replace(expected=expected)


def _read_parts(text: str, count: int, bounds: Range | None) -> Reading:
    pieces = [match.span() for match in _PIECE.finditer(text)]
    for start, end in pieces:
        # Spaces of other kinds pass before a number, not after one and not alone.
        if blank := _OTHER_BLANK.search(text, end - len(text[start:end].lstrip()), end):
            return malformed(*blank.span(), Cause.BLANK)
        if text[start:end].isspace():
            return malformed(start, end, Cause.BLANK)
    worst = AS_WRITTEN
    for start, end in pieces:
        if worst.is_fine:
            worst = _read_number(text, start, end, bounds)
    if worst.outcome is Outcome.MALFORMED:
        return worst
    if len(pieces) != count:
        start, end = pieces[count if len(pieces) > count else 0][0], pieces[-1][1]
        return Reading(Outcome.WRONG_COUNT, start, end, refused=True, wanted=(count,), got=len(pieces))
    return worst


def _read_number(text: str, start: int, end: int, bounds: Range | None) -> Reading:
    """A number from ``start`` to ``end``, with nothing after it; spaces before it are ignored."""
    while text[start] in BLANKS:
        start += 1
    number = stream_float(text, start)
    if number is None:
        return no_number(text, start, end)
    if number.end != end:
        rest = text[number.end : end]
        if not rest.strip(BLANKS):
            return malformed(number.end, end, Cause.BLANK)
        if rest[0] in BLANKS:
            return malformed(start, end, Cause.EXTRA)
        return no_number(text, start, end)._replace(cause=_cause(rest))
    if number.too_large or not isfinite(number.value):
        return malformed(start, end, Cause.TOO_LARGE)
    if bounds is not None and not bounds.holds(number.value):
        return Reading(Outcome.OUT_OF_RANGE, start, end, range=bounds, refused=bounds.refused)
    return AS_WRITTEN


def _cause(rest: str) -> Cause:
    if is_expression(rest):
        return Cause.EXPRESSION
    return {",": Cause.COMMA, "x": Cause.HEXADECIMAL, "X": Cause.HEXADECIMAL}.get(rest[0], Cause.TRAILING)
