"""The words in which the reading of a value is reported."""

from __future__ import annotations

from enum import Enum

from sdfcheck.formats.choices import Verdict
from sdfcheck.formats.table import Range
from sdfcheck.source.record import NamedTuple


class Outcome(Enum):
    """The outcomes of reading a text."""

    AS_WRITTEN = "as written"
    DEFAULT = "default"
    """Empty: the default is taken."""
    EMPTY = "empty"
    """Empty, and refused, because a value is required."""
    MALFORMED = "malformed"
    """Not of the type: refused."""
    MISREAD = "misread"
    """Accepted, and read as something else: see ``read_as``."""
    WRONG_COUNT = "wrong count"
    """Too few or too many numbers: see ``wanted`` and ``got``. Too many are accepted by some types."""
    OUT_OF_RANGE = "out of range"
    """Outside ``range``."""
    NOT_FINITE = "not finite"
    """Accepted as infinity or nan, where neither makes sense."""
    NOT_A_CHOICE = "not a choice"
    """Not simply one of those listed for the place: see ``verdict``."""


class Cause(Enum):
    """Why a text is malformed or misread."""

    NOT_A_NUMBER = "not a number"
    NOT_A_BOOLEAN = "neither true nor false"
    EXPRESSION = "an expression that nothing has expanded"
    COMMA = "a comma"
    TRAILING = "text after the number"
    EXTRA = "more than one number"
    GLUED = "no space between numbers"
    HEXADECIMAL = "a hexadecimal number"
    TRUTH_VALUE = "true or false for a number"
    FRACTION = "a fraction for a whole number"
    EXPONENT = "an exponent for a whole number"
    NEGATIVE = "a negative number for an unsigned one"
    TOO_LARGE = "too large for its type"
    TOO_SMALL = "too near to zero for its type"
    NOT_FINITE = "infinity or nan"
    BLANK = "a space other than the spaces between numbers"


class Reading(NamedTuple):
    """How a text is read; ``start`` and ``end`` delimit the part of it that is at fault."""

    outcome: Outcome
    start: int = 0
    end: int = 0
    cause: Cause | None = None
    read_as: str = ""
    """The value that a misread part is read as."""
    refused: bool = False
    """libsdformat reports an error, mostly reading no further."""
    expected: str = ""
    """The type in plain words: "a number", "3 numbers", or the choices."""
    wanted: tuple[int, ...] = ()
    got: int = 0
    range: Range | None = None
    verdict: Verdict | None = None

    @property
    def is_fine(self) -> bool:
        return self.outcome is Outcome.AS_WRITTEN or self.outcome is Outcome.DEFAULT


AS_WRITTEN = Reading(Outcome.AS_WRITTEN)


def misread(start: int, end: int, cause: Cause, read_as: str) -> Reading:
    return Reading(Outcome.MISREAD, start, end, cause, read_as)


def malformed(start: int, end: int, cause: Cause) -> Reading:
    return Reading(Outcome.MALFORMED, start, end, cause, refused=True)
