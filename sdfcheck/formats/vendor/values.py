"""How consumers of vendors' own values take a text.

A *lenient* consumer takes the number at the front of a text, drops the rest, and takes 0 where
there is none (Drake in SDF files, through libsdformat). A *strict* one takes only numbers and
refuses the file otherwise, except that letters after a number end it (Drake in URDF files).
"""

from __future__ import annotations

from enum import Enum

from sdfcheck.formats.sdf.values import leading_float, stream_float, words
from sdfcheck.formats.vendor.definitions import REFUSED, Effect, Outcome, Slot
from sdfcheck.source.record import NamedTuple

_COUNTS = {"double": 1, "int": 1, "vector2": 2, "vector3": 3}
_EXPECTED = {
    "bool": "true or false",
    "double": "a number",
    "int": "a whole number",
    "truth": "true or false",
    "vector2": "2 numbers",
    "vector3": "3 numbers",
}
_BOOLEANS = frozenset(("true", "false", "1", "0"))


class TagFault(Enum):
    """Why a value is not read as written."""

    NOT_A_NUMBER = "not a number"
    NOT_WHOLE = "not a whole number"
    NOT_FINITE = "infinity or nan"
    NOT_A_BOOLEAN = "neither true nor false"
    TRAILING = "text after the number"
    TOO_FEW = "too few numbers"
    TOO_MANY = "too many numbers"
    EMPTY = "empty"


class Misreading(NamedTuple):
    """Why a text is not read as written; ``start`` and ``end`` delimit the part at fault."""

    fault: TagFault
    start: int
    end: int
    effect: Effect


def expected_of(slot: Slot) -> str:
    """The type of a value in plain words."""
    return _EXPECTED.get(slot.type, "a file" if slot.type == "file" else "a name")


def misreading(slot: Slot, text: str, lenient: bool, ranged: bool = True) -> Misreading | None:
    """The problem of a text as a value of its type; None if it is read as written.

    ``ranged`` is False where the consumer accepts any replacement, in range or not.
    """
    if slot.type in {"flag", ""}:
        return None
    stripped = text.strip()
    offset = text.find(stripped)
    if not stripped:
        return Misreading(TagFault.EMPTY, 0, len(text), _in_place_of(slot, lenient, ranged))
    if slot.type in {"bool", "truth"}:
        known = stripped in {"true", "false"} if slot.type == "truth" else stripped.lower() in _BOOLEANS
        end = offset + len(stripped)
        return None if known else Misreading(TagFault.NOT_A_BOOLEAN, offset, end, slot.bad)
    if slot.type not in _COUNTS:
        return None
    found = _lenient(slot, stripped, ranged) if lenient else _strict(slot, stripped)
    if found is None:
        return None
    return found._replace(start=found.start + offset, end=found.end + offset)


def as_read(slot: Slot, text: str) -> str:
    """The value that a lenient consumer reads from a text, where a strict one would refuse it."""
    bad = misreading(slot, text, lenient=True, ranged=False)
    return bad.effect.value if bad is not None and bad.effect.outcome is Outcome.READ else text


def numbers(slot: Slot, text: str) -> tuple[float, ...]:
    """The numbers of a text that is read as written."""
    if slot.type not in _COUNTS:
        return ()
    found = map(leading_float, text.split()[: _COUNTS[slot.type]])
    return tuple(number.value for number in found if number is not None)


def out_of_range(slot: Slot, text: str) -> str | None:
    """The bound that a well-formed value breaks, in words."""
    found = numbers(slot, text)
    if slot.nonzero and found and not any(found):
        return "not zero"
    if slot.range is not None and not all(map(slot.range.holds, found)):
        return str(slot.range)
    return None


def _in_place_of(slot: Slot, lenient: bool, ranged: bool) -> Effect:
    """The problem of a text that holds no number: the lenient take zeros, which may be out of range."""
    count = _COUNTS.get(slot.type)
    if count is None or not lenient:
        return slot.bad if slot.type in {"bool", "truth"} else REFUSED
    zeros = " ".join(["0"] * count)
    if ranged and slot.wrong.refused and out_of_range(slot, zeros):
        return slot.wrong
    return Effect(Outcome.READ, zeros)


def _lenient(slot: Slot, text: str, ranged: bool) -> Misreading | None:
    count = _COUNTS[slot.type]
    take = leading_float if count == 1 else stream_float
    position, values = 0, []
    for _ in range(count):
        start = len(text) - len(text[position:].lstrip())
        number = take(text, start)
        if number is None or number.too_large:
            fault = TagFault.TOO_FEW if start == len(text) else TagFault.NOT_A_NUMBER
            start, end = (0, len(text)) if fault is TagFault.TOO_FEW else (start, _word_end(text, start))
            return Misreading(fault, start, end, _in_place_of(slot, True, ranged))
        position = number.end
        values.append(number.plain)
        if slot.type == "int" and not number.value.is_integer():
            whole = Effect(Outcome.READ, str(int(number.value)))
            return Misreading(TagFault.NOT_WHOLE, start, number.end, whole)
    if not text[position:]:
        return None
    effect = Effect(Outcome.READ, " ".join(values))
    rest = len(text) - len(text[position:].lstrip())
    many = rest > position and leading_float(text, rest) is not None
    fault = TagFault.TOO_MANY if many else TagFault.TRAILING
    return Misreading(fault, rest if many else text.rfind(" ", 0, position) + 1, len(text), effect)


def _strict(slot: Slot, text: str) -> Misreading | None:
    count = _COUNTS[slot.type]
    parts = list(words(text))
    cut: Misreading | None = None
    for start, end in parts:
        number = stream_float(text, start)
        if number is None or number.too_large:
            special = leading_float(text, start)
            fault = TagFault.NOT_FINITE if special and special.is_special else TagFault.NOT_A_NUMBER
            return Misreading(fault, start, end, REFUSED)
        if number.end < end:
            # A single number ends at the first letter; in a list that is an error.
            effect = Effect(Outcome.READ, number.plain) if count == 1 else REFUSED
            cut = cut or Misreading(TagFault.TRAILING, start, end, effect)
        elif slot.type == "int" and not number.value.is_integer():
            return Misreading(TagFault.NOT_WHOLE, start, end, REFUSED)
    if len(parts) < count:
        return Misreading(TagFault.TOO_FEW, 0, len(text), REFUSED)
    if len(parts) > count:
        return Misreading(TagFault.TOO_MANY, parts[count][0], len(text), REFUSED)
    return cut


def _word_end(text: str, start: int) -> int:
    return next((end for first, end in words(text) if first <= start < end), len(text))
