"""Terminals for tests: a stream that says it is one, and what its screen shows."""

from __future__ import annotations

import io
import re
from typing import Any

import pytest


class Terminal(io.StringIO):
    encoding = "utf-8"

    def isatty(self) -> bool:
        return True


def screen(text: str, width: int, height: int) -> list[str]:
    """The rows of a screen after a text."""
    return [row.rstrip() for row in _shown(text, width, height).display]


def cells(row: str, width: int) -> list[str]:
    """The character in each cell of a row; the second cell of a wide character holds nothing."""
    first = _shown(row, width, 2).buffer[0]
    return [first[column].data for column in range(width)]


def _shown(text: str, width: int, height: int) -> Any:
    pyte = pytest.importorskip("pyte", reason="the terminal emulator is in the extra `dev`")
    shown = pyte.Screen(width, height)
    stream = pyte.Stream(shown)
    # After a joiner pyte forgets the rest of what it is fed at once.
    for piece in re.split("(\u200d)", text.replace("\r\n", "\n").replace("\n", "\r\n")):
        stream.feed(piece)
    return shown
