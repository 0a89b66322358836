"""Text of other people's files, safe to show on a terminal and counted in its cells."""

from __future__ import annotations

from collections.abc import Sequence

_TAB = 4
_JOINERS = "\u200c\u200d"  # invisible by design: inside emoji, and between Persian letters


def visible(text: str) -> str:
    """The text in one line with everything invisible spelled out, so that none of it acts on a terminal."""
    return text if text.isprintable() else "".join(map(_spelled, text))


def cells(text: str) -> tuple[str, Sequence[int]]:
    """A line as it is shown, tabs expanded, and the cell in which each character begins.

    The last of the cells is where the line ends: there is one more than characters.
    """
    if text.isascii() and text.isprintable():
        return text, range(len(text) + 1)
    shown: list[str] = []
    columns = [0]
    for character in text:
        column = columns[-1]
        piece = " " * (_TAB - column % _TAB) if character == "\t" else _spelled(character)
        shown.append(piece)
        columns.append(column + _width(piece))
    return "".join(shown), columns


def _spelled(character: str) -> str:
    if character.isprintable() or character in _JOINERS:
        return character
    code = ord(character)
    if code < 0x20:
        return chr(0x2400 + code)  # Unicode draws the control characters
    return "\u2421" if code == 0x7F else f"<U+{code:04X}>"


def _width(piece: str) -> int:
    """Cells that a terminal gives to what is shown for one character."""
    if piece.isascii():
        return len(piece)
    from unicodedata import category, east_asian_width

    if piece in _JOINERS or category(piece) in {"Mn", "Me"}:
        return 0
    return 2 if east_asian_width(piece) in {"W", "F"} else 1
