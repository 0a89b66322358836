"""Numbers as the C++ library takes them from the front of a text."""

from __future__ import annotations

import math
import re
from enum import Enum

from sdfcheck.source.record import NamedTuple

BLANKS = " \t\n\r\v\f"

_DIGITS = r"(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)"
_HEX = r"0x(?:[0-9a-f]+(?:\.[0-9a-f]*)?|\.[0-9a-f]+)(?:p[+-]?[0-9]+)?"
_STRTOD = re.compile(
    rf"(?P<hex>[+-]?{_HEX})|(?P<digits>[+-]?{_DIGITS}(?:e[+-]?[0-9]+)?)|[+-]?(?:inf(?:inity)?|nan)",
    re.IGNORECASE,
)
_STREAM = re.compile(rf"(?P<digits>[+-]?{_DIGITS}(?:[eE][+-]?[0-9]*)?)")
_WHOLE = re.compile(r"[+-]?[0-9]+")
_WHOLE_HEX = re.compile(r"0[xX][0-9a-fA-F]+")
_NOT_ZERO = re.compile(r"[+-]?[0.]*[1-9]")
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
    if match := _WHOLE.match(text):
        return _to_int(match[0], 10), match.end()
    return None


def stream_integer(text: str, start: int) -> Number | None:
    """A decimal whole number of 32 bits, as an input stream takes it."""
    match = _WHOLE.match(text, start)
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
