"""How libsdformat reads values, with the reason where that is not what is written.

Checked against version 17 of the library: it takes the longest number from the front of
a text and forgets what follows, so that `1,5` is 1 and `1.5kg` is 1.5 in silence.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator
from enum import Enum
from functools import partial

from sdfcheck.formats.choices import Verdict
from sdfcheck.formats.reading import AS_WRITTEN, Cause, Outcome, Reading, malformed, misread
from sdfcheck.formats.schema import RowInVersion
from sdfcheck.formats.table import Range
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.text import pattern

# Numbers as the C++ library takes them from the front of a text.

BLANKS = " \t\n\r\v\f"

_DIGITS = r"(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)"
_HEX = r"0x(?:[0-9a-f]+(?:\.[0-9a-f]*)?|\.[0-9a-f]+)(?:p[+-]?[0-9]+)?"
_STRTOD = pattern(
    rf"(?P<hex>[+-]?{_HEX})|(?P<digits>[+-]?{_DIGITS}(?:e[+-]?[0-9]+)?)|[+-]?(?:inf(?:inity)?|nan)",
    re.IGNORECASE,
)
_STREAM = pattern(rf"(?P<digits>[+-]?{_DIGITS}(?:[eE][+-]?[0-9]*)?)")
_INTEGER = pattern(r"[+-]?[0-9]+")
_WHOLE_HEX = pattern(r"0[xX][0-9a-fA-F]+")
_NOT_ZERO = pattern(r"[+-]?[0.]*[1-9]")
_LONGEST = 40


class Width(Enum):
    """Floating point types: the largest number without overflow, the smallest without underflow."""

    DOUBLE = (1.7976931348623157e308, 2.2250738585072014e-308)
    SINGLE = (3.4028235677973362e38, 1.1754943508222875e-38)


class Number(NamedTuple):
    """A number at the front of a text: its value and where it ends."""

    value: float
    end: int
    is_hexadecimal: bool = False
    too_large: bool = False
    too_small: bool = False
    """Not zero, but too near to zero for its type."""

    @property
    def is_special(self) -> bool:
        """Whether infinity or nan was written."""
        return not math.isfinite(self.value) and not self.too_large

    @property
    def plain(self) -> str:
        """The value as people write it."""
        return "0" if self.too_small else repr(self.value).removesuffix(".0")


def leading_float(text: str, start: int = 0, width: Width = Width.DOUBLE) -> Number | None:
    """The texts that strtod takes: infinity, nan and hexadecimal included. None when there is no number."""
    match = _STRTOD.match(text, start)
    if match is None:
        return None
    if match["digits"]:
        return _number(match, width)
    if match["hex"]:
        return Number(_from_hex(match["hex"]), match.end(), is_hexadecimal=True)
    return Number(float(match[0]), match.end())


def stream_float(text: str, start: int) -> Number | None:
    """The texts that an input stream takes: not infinity, nan, hexadecimal or a bare exponent."""
    match = _STREAM.match(text, start)
    if match is None or match[0][-1] in "eE+-":
        return None
    return _number(match, Width.DOUBLE)


def leading_integer(text: str) -> tuple[int, int] | None:
    """The texts that stoi takes: decimal, or hexadecimal without a sign; the value and where it ends."""
    if match := _WHOLE_HEX.match(text):
        return _to_int(match[0], 16), match.end()
    if match := _INTEGER.match(text):
        return _to_int(match[0], 10), match.end()
    return None


def stream_integer(text: str, start: int) -> Number | None:
    """A decimal whole number of 32 bits, as an input stream takes it."""
    match = _INTEGER.match(text, start)
    if match is None:
        return None
    value = _to_int(match[0], 10)
    return Number(float(value), match.end(), too_large=not -(2**31) <= value < 2**31)


def _to_int(digits: str, base: int) -> int:
    # Python refuses to convert thousands of digits; the first forty are as much out of range.
    return int(digits[:_LONGEST], base)


def _number(match: re.Match[str], width: Width) -> Number:
    value = float(match["digits"])
    largest, smallest = width.value
    too_small = abs(value) < smallest and _NOT_ZERO.match(match["digits"]) is not None
    return Number(value, match.end(), too_large=abs(value) > largest, too_small=too_small)


def _from_hex(text: str) -> float:
    try:
        return float.fromhex(text)
    except OverflowError:
        return math.inf


# Judging the parts of a value: words between spaces that should be numbers.

SHARE = Range(0.0, 1.0)

_WORD = pattern(rf"[^{BLANKS}]+")
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


_SIZES = {"angle": 1, "quaternion": 3, "time": 2, "vector2d": 2, "vector2i": 2, "vector3": 3}
_WHOLE = frozenset(("time", "vector2i"))
_EXPECTED = {
    "bool": "true or false",
    "char": "one character",
    "color": "3 or 4 numbers from 0 to 1",
    "double": "a number",
    "float": "a number",
    "int": "a whole number",
    "pose": "6 numbers",
    "time": "2 whole numbers",
    "unsigned int": "a whole number that is not negative",
    "vector2i": "2 whole numbers",
}
_TURNING_POSES = frozenset(("pose:pose", "inertial:inertial/pose"))


def read(
    kind: str,
    text: str,
    *,
    required: bool = False,
    bounds: Range | None = None,
    infinite: bool = False,
    rotation_format: str = "euler_rpy",
) -> Reading:
    """How a text of a type (as the tables name it) is read.

    ``required``: empty is refused; otherwise it is the default, whatever the type.
    ``infinite``: infinity makes sense here.
    """
    trimmed = text.strip(" \t\n")
    offset = text.find(trimmed)
    expected = "7 numbers" if kind == "pose" and rotation_format == "quat_xyzw" else expected_of(kind)
    if not trimmed:
        empty = Reading(Outcome.EMPTY, 0, len(text), refused=True, expected=expected)
        return empty if required else Reading(Outcome.DEFAULT)
    if kind == "pose":
        reading = read_parts(trimmed, (7,) if rotation_format == "quat_xyzw" else (6,), Width.DOUBLE)
    elif kind == "color":
        reading = read_parts(trimmed, (3, 4), Width.SINGLE)
    elif kind in _SIZES:
        reading = read_stream(trimmed, _SIZES[kind], kind in _WHOLE, bounds)
    elif kind in _SCALARS:
        reading = _SCALARS[kind](trimmed, bounds)
    else:
        return AS_WRITTEN
    if reading.outcome is Outcome.NOT_FINITE and infinite and "nan" not in trimmed.lower():
        return AS_WRITTEN
    if reading.is_fine:
        return reading
    return reading._replace(expected=expected, start=reading.start + offset, end=reading.end + offset)


def expected_of(kind: str) -> str:
    """A type in plain words."""
    if kind in _EXPECTED:
        return _EXPECTED[kind]
    count = _SIZES.get(kind, 0)
    return f"{count} number{'s' * (count > 1)}" if count else "text"


def read_at(definition: RowInVersion, text: str, rotation_format: str = "euler_rpy") -> Reading:
    """How a text is read at its place, with the choices and the range there: what explains ``accepts``."""
    kind, required = definition.type, definition.needs_value
    choices, bounds = definition.choices, definition.range
    if kind is None:
        return AS_WRITTEN
    if definition.place not in _TURNING_POSES:
        rotation_format = "euler_rpy"
    trimmed = text.strip(" \t\n")
    if choices is not None and trimmed:
        verdict = choices.judge(trimmed)
        if verdict is Verdict.LISTED or trimmed == definition.default != "__default__":
            return AS_WRITTEN
        start = text.find(trimmed)
        expected, refused = "one of " + ", ".join(filter(None, choices.listed)), choices.refuses(trimmed)
        end = start + len(trimmed)
        return Reading(Outcome.NOT_A_CHOICE, start, end, refused=refused, expected=expected, verdict=verdict)
    if kind == "string" and bounds is not None:
        # A number after all, to a consumer that takes the default when it finds none.
        return read("double", text, required=required, bounds=bounds)._replace(refused=False)
    infinite = definition.may_be_infinite
    return read(
        kind, text, required=required, bounds=bounds, infinite=infinite, rotation_format=rotation_format
    )


def _read_bool(text: str, bounds: Range | None) -> Reading:
    if text.lower() in {"true", "false", "1", "0"}:
        return AS_WRITTEN
    cause = Cause.EXPRESSION if "${" in text or "$(" in text else Cause.NOT_A_BOOLEAN
    return malformed(0, len(text), cause)


def _read_char(text: str, bounds: Range | None) -> Reading:
    return AS_WRITTEN if len(text) == 1 else misread(0, len(text), Cause.TRAILING, text[0])


def _read_double(text: str, bounds: Range | None, width: Width = Width.DOUBLE) -> Reading:
    if text.lower() in {"true", "false"}:
        return _truth_value(text, bounds)
    number = leading_float(text, 0, width)
    _, end = word_at(text, 0)
    if number is None:
        return no_number(text, 0, end)
    reading = one_number(text, 0, end, number)
    if reading.outcome is not Outcome.MALFORMED:
        outside = in_range(number.value, bounds, 0, end)
        if outside.refused:
            return outside
    if reading.outcome is Outcome.MALFORMED or not text[end:].strip(BLANKS):
        return in_range(number.value, bounds, 0, end) if reading.is_fine else reading
    return (
        misread(_next_word(text, end), len(text), Cause.EXTRA, number.plain) if reading.is_fine else reading
    )


def _read_int(text: str, bounds: Range | None, unsigned: bool = False) -> Reading:
    if text.lower() in {"true", "false"}:
        return _truth_value(text, bounds)
    found = leading_integer(text)
    _, word_end = word_at(text, 0)
    if found is None:
        return no_number(text, 0, word_end, whole=True)
    written, end = found
    low, high = (1 - 2**64, 2**64 - 1) if unsigned else (-(2**31), 2**31 - 1)
    if not low <= written <= high:
        return malformed(0, word_end, Cause.TOO_LARGE)
    value = written % 2**32 if unsigned else written
    if value != written:
        return misread(0, word_end, Cause.NEGATIVE if written < 0 else Cause.TOO_LARGE, str(value))
    outside = in_range(value, bounds, 0, word_end)
    if end < word_end and not outside.refused:
        whole = leading_float(text)
        # `5.0` is cut to 5, which is what is meant, and so is `5.0000000000000003`, which was computed.
        if whole is None or whole.end < word_end or not math.isclose(whole.value, value, rel_tol=1e-9):
            return misread(0, word_end, rest_cause(text[end], whole=True), str(value))
    if text[word_end:].strip(BLANKS) and not outside.refused:
        return misread(_next_word(text, word_end), len(text), Cause.EXTRA, str(value))
    return outside


def _truth_value(text: str, bounds: Range | None) -> Reading:
    value = int(text.lower() == "true")
    outside = in_range(value, bounds, 0, len(text))
    return outside if outside.refused else misread(0, len(text), Cause.TRUTH_VALUE, str(value))


def _next_word(text: str, position: int) -> int:
    return len(text) - len(text[position:].lstrip(BLANKS))


_SCALARS: dict[str, Callable[[str, Range | None], Reading]] = {
    "bool": _read_bool,
    "char": _read_char,
    "double": _read_double,
    "float": partial(_read_double, width=Width.SINGLE),
    "int": _read_int,
    "unsigned int": partial(_read_int, unsigned=True),
}


def floats(text: str) -> tuple[float, ...] | None:
    """All numbers of a text, separated by spaces; None if a part is not a number, or the text is empty."""
    if not text.isascii() or "_" in text:
        return None
    try:
        return tuple(map(float, text.split())) or None
    except ValueError:
        return None


def number(text: str) -> float | None:
    """The one number of a text; None for anything else."""
    found = floats(text)
    return found[0] if found is not None and len(found) == 1 else None
