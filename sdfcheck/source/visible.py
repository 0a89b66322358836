"""Text of other people's files, safe to show on a terminal and in the log of a job, and counted in cells."""

from __future__ import annotations

from collections.abc import Sequence

from sdfcheck.source.text import pattern

_TAB = 4
_JOINERS = "\u200c\u200d"  # invisible by design: inside emoji, and between Persian letters


ESCAPE = pattern(r"\x1b\[[0-9;]*m|\x1b\]8;(?:id=\d+)?;(?:https?://[!-~]*)?\x1b\\")
"""Colors, and the starts and ends of links."""
_ESCAPE = pattern(f"({ESCAPE.pattern})")
_COMMAND = pattern(r"##(?=[a-z]*\[)")
"""What CI systems take for a command anywhere in a line, such as ``##vso[``."""
_COMMAND_MARK = "::"
"""What GitHub takes for a command at the start of a line, spaces before it or not."""

_OTHER_FILE = "::: "
"""Before the name of another file in a report; its third colon keeps it from being a command."""


def visible(text: str) -> str:
    """The text in one line with everything invisible spelled out, so that none of it acts on a terminal."""
    if not text.isprintable():
        text = "".join(map(_spelled, text))
    return _COMMAND.sub(f"#{_code('#')}", text) if "##" in text else text


def harmless(line: str, *, color: bool = False) -> str:
    """A line of text for people as it may leave the program; with ``color`` colors and links pass.

    None of it acts on a terminal, begins another line or a command of a CI system. Names
    that are painted must be visible before, as their own colors would pass, too.
    """
    if color and "\x1b" in line:
        pieces = _ESCAPE.split(line)
        return "".join(piece if at % 2 else visible(piece) for at, piece in enumerate(pieces))
    text = visible(line)
    rest = text.lstrip()
    if not rest.startswith(_COMMAND_MARK) or rest.startswith(_OTHER_FILE):
        return text
    return text[: len(text) - len(rest)] + _code(rest[0]) + rest[1:]


def harmless_document(text: str) -> str:
    """A document as it is shown on a terminal: its lines and tabs stay, all else that acts is spelled out."""
    if text.replace("\n", "").isprintable():
        return text
    lines = (line.removesuffix("\r").split("\t") for line in text.split("\n"))
    return "\n".join("\t".join("".join(map(_spelled, piece)) for piece in line) for line in lines)


def cells(text: str) -> tuple[str, Sequence[int]]:
    """A line as it is shown, tabs expanded, and the cell in which each character begins.

    The last of the cells is where the line ends: there is one more than characters.
    """
    if text.isascii() and text.isprintable() and "##" not in text:
        return text, range(len(text) + 1)
    shown: list[str] = []
    columns = [0]
    commands = {match.end() - 1 for match in _COMMAND.finditer(text)}
    for number, character in enumerate(text):
        column = columns[-1]
        piece = " " * (_TAB - column % _TAB) if character == "\t" else _spelled(character)
        if number in commands:
            piece = _code(character)
        shown.append(piece)
        columns.append(column + _width(piece))
    return "".join(shown), columns


def width_of(text: str) -> int:
    """Cells that a terminal gives to a text; colors and links have none."""
    if "\x1b" in text:
        text = ESCAPE.sub("", text)
    return len(text) if text.isascii() else sum(map(_width, text))


def _spelled(character: str) -> str:
    if character.isprintable() or character in _JOINERS:
        return character
    code = ord(character)
    if code < 0x20:
        return chr(0x2400 + code)  # Unicode draws the control characters
    return "\u2421" if code == 0x7F else _code(character)


def _code(character: str) -> str:
    return f"<U+{ord(character):04X}>"


def _width(piece: str) -> int:
    """Cells that a terminal gives to what is shown for one character."""
    if piece.isascii():
        return len(piece)
    from unicodedata import category, east_asian_width

    if piece in _JOINERS or category(piece) in {"Mn", "Me"}:
        return 0
    return 2 if east_asian_width(piece) in {"W", "F"} else 1
