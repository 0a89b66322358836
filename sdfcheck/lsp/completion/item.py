"""The items that are offered."""

from __future__ import annotations

from enum import Enum

from sdfcheck.source.record import NamedTuple


class Sort(Enum):
    """The kinds of things that are offered."""

    ELEMENT = "element"
    ATTRIBUTE = "attribute"
    CHOICE = "choice"
    NAME = "name"
    FILE = "file"
    FOLDER = "folder"
    MACRO = "macro"
    PROPERTY = "property"
    WORD = "word"


class Item(NamedTuple):
    """Something to insert; ``snippet`` has tab stops, ``text`` is the same without.

    ``question`` is what to ask :mod:`sdfcheck.formats.describe` for more.
    """

    label: str
    sort: Sort
    text: str
    snippet: str = ""
    detail: str = ""
    rank: int = 5
    is_deprecated: bool = False
    note: str = ""
    is_repeatable: bool = False
    """May an element be there more than once?"""


def escaped(text: str) -> str:
    """A text with the characters escaped that have a meaning in snippets."""
    return text.replace("\\", "\\\\").replace("$", "\\$").replace("}", "\\}")
