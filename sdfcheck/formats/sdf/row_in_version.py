"""The common part of elements and attributes: a row of the table, as one version has it."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cache
from math import inf
from typing import TYPE_CHECKING, Any

from sdfcheck.formats.sdf.table import Row, at
from sdfcheck.formats.sdf.version import Version

if TYPE_CHECKING:
    from sdfcheck.formats.sdf.choices import Choices
    from sdfcheck.formats.sdf.table import Range

Accepts = Callable[[str], object]

# Digits are counted so that a number stays inside its type without being converted.
_NUMBER = r"[+-]?(?:\d{1,60}\.?\d{0,60}|\.\d{1,60})(?:[eE][+-]?\d\d?)?"
_SINGLE = r"[+-]?(?:\d{1,8}\.?\d{0,8}|\.\d{1,8})(?:[eE][+-]?[0-2]?\d)?"
_SHARE = r"(?:0?\.\d{1,20}|[01](?:\.0*)?)"
_WHOLE = r"[+-]?\d{1,9}"

_LONGEST = 60
_TINY = 1e-300

_TRUTH = frozenset(("true", "false", "1", "0", "True", "False"))
# Each part, and how many of them.
_PATTERNS = {
    "color": (_SHARE, "3,4"),
    "float": (_SINGLE, "1"),
    "pose": (_NUMBER, "6"),
    "time": (_WHOLE, "2"),
    "vector2d": (_NUMBER, "2"),
    "vector3": (_NUMBER, "3"),
}


class RowInVersion:
    """An element or attribute; ``choices``, ``range``, ``may_be_infinite`` and ``accepts`` at their first use."""

    __slots__ = ("accepts", "choices", "may_be_infinite", "name", "place", "range", "row", "version")
    version: Version
    row: Row
    name: str
    place: str
    """Its path over all versions, such as ``joint:joint/axis/limit/lower`` or ``joint:joint/@type``."""
    range: Range | None
    """Bounds that hold by meaning or by the table; libsdformat does not check those of attributes."""
    choices: Choices | None
    may_be_infinite: bool
    accepts: Accepts
    """True for text that is surely read as written and nothing can be said against.

    For a pose: with rotation_format euler_rpy, the default.
    """

    if TYPE_CHECKING:
        type: str | None
        default: str | None

        @property
        def needs_value(self) -> bool: ...
    else:

        def __getattr__(self, name: str) -> Any:
            if name == "choices":
                self.choices = self._read_choices()
            elif name == "range":
                self.range = self._read_range()
            elif name == "may_be_infinite":
                self.may_be_infinite = "inf" in self.row.default or self.row.extra("infinite") != ""
            elif name == "accepts":
                self.accepts = _acceptance(self)
            else:
                raise AttributeError(name)
            return object.__getattribute__(self, name)

    def _read_choices(self) -> Choices | None:
        if not self.row.extra("choices"):
            return None
        from sdfcheck.formats.sdf.choices import Choices

        return Choices.of(self.row, self.version)

    def _read_range(self) -> Range | None:
        if not self.row.extras:
            return None
        from sdfcheck.formats.sdf.table import Range

        return Range.of(self.row, self.version.minor)


def _acceptance(definition: RowInVersion) -> Accepts:
    """The check for one place. An empty text is accepted for texts only, where it is the default."""
    kind, bounds = definition.type, definition.range
    if kind is None:
        return _nothing
    if listed := at(definition.row.extra("choices"), definition.version.minor):
        return _choices(definition, listed)
    if kind == "bool":
        return _TRUTH.__contains__
    if kind in {"int", "unsigned int"}:
        return _bounded(_digits, bounds) if bounds else _digits
    if kind == "string" and bounds is None:
        return str.strip if definition.needs_value else _anything
    matches: Accepts
    if kind in {"double", "string"}:
        matches = _number_or_infinity if definition.may_be_infinite else _number
    else:
        matches = _parts(*_PATTERNS[kind])
    return matches if bounds is None else _bounded(matches, bounds)


def _anything(text: str) -> bool:
    return True


def _number(text: str) -> bool:
    # Stripping leaves nothing when all characters are of the given ones.
    if text.strip("0123456789.+-eE \t\n") or len(text) > _LONGEST:
        return False
    try:
        value = abs(float(text))
    except ValueError:
        return False
    return _TINY < value < inf or (value == 0 and "e" not in text and "E" not in text)


def _number_or_infinity(text: str) -> bool:
    return _number(text) or text in {"inf", "-inf", "+inf"}


def _digits(text: str) -> bool:
    return len(text) < 10 and text.isascii() and text.isdigit()


def _nothing(text: str) -> bool:
    return not text or text.isspace()


def _choices(definition: RowInVersion, listed: str) -> Accepts:
    accepted = set(listed.split(","))
    if library := definition.row.extra("library"):
        accepted.intersection_update(library.split(","))
    if definition.default != "__default__":
        accepted.add(definition.default or "")
    accepted.discard("") if definition.needs_value else accepted.add("")
    return frozenset(accepted).__contains__


@cache
def _parts(part: str, count: str) -> Accepts:
    return re.compile(rf"\s*(?:(?:{part})(?:\s+|\Z)){{{count}}}", re.ASCII).fullmatch


def _bounded(matches: Accepts, bounds: Range) -> Accepts:
    holds = bounds.holds

    def accepts(text: str) -> bool:
        return bool(matches(text)) and all(holds(float(part)) for part in text.split())

    return accepts
