"""How libsdformat reads a value, with the reason where that is not what is written.

Checked against version 17 of the library: it takes the longest number from the front of
a text and forgets what follows, so that `1,5` is 1 and `1.5kg` is 1.5 in silence.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from sdfcheck.formats.choices import Verdict
from sdfcheck.formats.reading import AS_WRITTEN, Cause, Outcome, Reading, malformed, misread
from sdfcheck.formats.schema import RowInVersion
from sdfcheck.formats.sdf.numbers import BLANKS, Width, leading_float, leading_integer
from sdfcheck.formats.sdf.parts import (
    in_range,
    no_number,
    one_number,
    read_parts,
    read_stream,
    rest_cause,
    word_at,
)
from sdfcheck.formats.table import Range

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
        return _truth_value(text)
    number = leading_float(text, 0, width)
    _, end = word_at(text, 0)
    if number is None:
        return no_number(text, 0, end)
    reading = one_number(text, 0, end, number)
    if reading.outcome is Outcome.MALFORMED or not text[end:].strip(BLANKS):
        return in_range(number.value, bounds, 0, end) if reading.is_fine else reading
    return (
        misread(_next_word(text, end), len(text), Cause.EXTRA, number.plain) if reading.is_fine else reading
    )


def _read_int(text: str, bounds: Range | None, unsigned: bool = False) -> Reading:
    if text.lower() in {"true", "false"}:
        return _truth_value(text)
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
    if end < word_end:
        whole = leading_float(text)
        # `5.0` is cut to 5, which is what is meant.
        if whole is None or whole.end < word_end or whole.value != value:
            return misread(0, word_end, rest_cause(text[end], whole=True), str(value))
    if text[word_end:].strip(BLANKS):
        return misread(_next_word(text, word_end), len(text), Cause.EXTRA, str(value))
    return in_range(value, bounds, 0, word_end)


def _truth_value(text: str) -> Reading:
    return misread(0, len(text), Cause.TRUTH_VALUE, "1" if text.lower() == "true" else "0")


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
