"""Colors of the text formats: a handful of ANSI codes."""

from __future__ import annotations

from collections.abc import Callable
from enum import Enum

from sdfcheck.lint.diagnostic import Severity


class Ink(Enum):
    """The color of a piece of text; the value is the terminal's code."""

    ERROR = "1;31"
    WARNING = "1;33"
    INFO = "1;36"
    STRONG = "1"
    GUTTER = "1;34"
    LABEL = "34"
    FAINT = "2"


Paint = Callable[[str, Ink], str]
INK_OF = {Severity.ERROR: Ink.ERROR, Severity.WARNING: Ink.WARNING, Severity.INFO: Ink.INFO}


def linked(text: str, address: str | None) -> str:
    """A text that leads to an address on terminals that know links; the text alone without one."""
    return f"\x1b]8;;{address}\x1b\\{text}\x1b]8;;\x1b\\" if address else text


def painter(color: bool) -> Paint:
    """Paints, or leaves everything as it is."""
    return _paint if color else _leave


def _paint(text: str, ink: Ink) -> str:
    return f"\x1b[{ink.value}m{text}\x1b[0m" if text else text


def _leave(text: str, ink: Ink) -> str:
    return text
