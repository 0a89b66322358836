"""Tables and long lines for people, as wide as the terminal."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import Literal

from sdfcheck.report.colors import Ink, painter
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.visible import ESCAPE, visible, width_of

# Lines that fit a terminal: long ones go on below, at a space.

_STEP = 2
_NARROWEST = 20
"""Narrower than this no text is made."""
_RESET = "\x1b[0m"


def fitted(text: str, width: int | None) -> str:
    """A report with the lines that are too long for so many cells wrapped; None: as it is."""
    if width is None:
        return text
    return "\n".join(part for line in text.split("\n") for part in wrapped(line, width))


def wrapped(line: str, width: int, indent: int | None = None) -> Iterator[str]:
    """The parts of a line, those after the first indented a little more than it; colors go on.

    A text without spaces, such as a path, stays whole: a terminal wraps it, and it can be copied.
    """
    if len(line) <= width and line.isascii() and "\x1b" not in line:
        yield line
        return
    if indent is None:
        indent = len(line) - len(line.lstrip(" ")) + _STEP
    indent = min(indent, max(width - _NARROWEST, 0))
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


# Tables for people: columns that fit a terminal, or that are as wide as they need to be elsewhere.

_ENDLESS = 10_000
_GAP = 2
_LEAST = 12
"""Narrower than this no column gets."""


class Column(NamedTuple):
    """``gives_way``: cut with ``…`` where the terminal is too narrow; other columns are never cut."""

    heading: str
    is_number: bool = False
    gives_way: bool = False


class Cell(NamedTuple):
    """The text in a row and a column, its color, and its link on a terminal that knows links."""

    text: str
    ink: Ink | None = None
    address: str | None = None


def table(
    columns: Sequence[Column], rows: Sequence[Sequence[Cell]], *, width: int | None, color: bool
) -> list[str]:
    """The lines of a table; on a terminal of so many cells with headings, and cut to fit."""
    from io import StringIO

    from rich.console import Console
    from rich.style import Style
    from rich.table import Table
    from rich.text import Text

    paint = painter(color)

    def text(cell: Cell) -> Text:
        shown = visible(cell.text)
        made = Text.from_ansi(paint(shown, cell.ink) if cell.ink is not None else shown)
        if cell.address:
            made.stylize(Style(link=cell.address))
        return made

    drawn = Table(box=None, show_header=width is not None, pad_edge=False, padding=(0, _GAP, 0, 0))
    for column, cells in zip(columns, _widths(columns, rows, width), strict=True):
        heading = text(Cell(column.heading, Ink.STRONG))
        side: Literal["left", "right"] = "right" if column.is_number else "left"
        drawn.add_column(heading, justify=side, no_wrap=True, overflow="ellipsis", width=cells)
    for row in rows:
        drawn.add_row(*map(text, row))
    console = Console(
        file=StringIO(),
        width=width or _ENDLESS,
        force_terminal=color,
        color_system="standard" if color else None,
        highlight=False,
        legacy_windows=False,
    )
    with console.capture() as capture:
        console.print(drawn)
    return [line.rstrip() for line in capture.get().splitlines()]


def _widths(columns: Sequence[Column], rows: Sequence[Sequence[Cell]], width: int | None) -> list[int]:
    """Cells for each column; what is too wide for the terminal is taken from those that give way."""
    from rich.cells import cell_len

    widths = [
        max(
            [
                cell_len(column.heading) if width is not None else 0,
                *(cell_len(visible(row[at].text)) for row in rows),
            ]
        )
        for at, column in enumerate(columns)
    ]
    if width is None:
        return widths
    excess = sum(widths) + _GAP * (len(columns) - 1) - width
    for at, column in reversed(list(enumerate(columns))):
        if column.gives_way and excess > 0:
            taken = min(excess, widths[at] - min(_LEAST, widths[at]))
            widths[at] -= taken
            excess -= taken
    return widths
