"""Lines that fit a terminal: long ones go on below, at a space."""

from __future__ import annotations

import re
from collections.abc import Iterator

from sdfcheck.source.visible import ESCAPE, width_of

_STEP = 2
_LEAST = 20
"""Narrower than this no text is made."""
_RESET = "\x1b[0m"


def fitted(text: str, width: int | None) -> str:
    """A report with the lines that are too long for so many cells folded; None: as it is."""
    if width is None:
        return text
    return "\n".join(part for line in text.split("\n") for part in folded(line, width))


def folded(line: str, width: int, indent: int | None = None) -> Iterator[str]:
    """The parts of a line, those after the first indented a little more than it; colors go on.

    A text without spaces, such as a path, stays whole: a terminal wraps it, and it can be copied.
    """
    if len(line) <= width and line.isascii() and "\x1b" not in line:
        yield line
        return
    if indent is None:
        indent = len(line) - len(line.lstrip(" ")) + _STEP
    indent = min(indent, max(width - _LEAST, 0))
    shown, column, ink = "", 0, ""
    for word in re.findall(r" +|[^ ]+", line):
        cells = width_of(word)
        if word.isspace() or not shown.strip() or column + cells <= width:
            shown += word
            column += cells
        else:
            yield shown.rstrip(" ") + (_RESET if ink else "")
            shown, column = " " * indent + ink + word, indent + cells
        for code in ESCAPE.findall(word):
            if code.startswith("\x1b["):
                ink = "" if code == _RESET else code
    yield shown.rstrip(" ")
