"""One suggestion, and snippets."""

from __future__ import annotations

from enum import Enum
from itertools import count

from sdfcheck.formats.schema import Definition
from sdfcheck.source.record import NamedTuple

# The items that are offered.


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


# An element with what it cannot do without.

_DEEPEST = 3


class Snippet:
    """Writes elements with numbered places to fill in."""

    def __init__(self) -> None:
        self._number = count(1)

    def element(self, name: str, element: Definition | None, depth: int = 0) -> str:
        """An element, from its name on; the ``<`` before it is there."""
        if element is None:
            return f"{name}>{self._stop()}</{name}>"
        head = name
        required = [element.attributes[each] for each in element.required_attributes]
        for each in required:
            head += " " + self.attribute(each.name, each.listed or each.usual[:3], each.given_default)
        if any(each.usual for each in required):
            return f"{head}/>"
        if element.type:
            return f"{head}>{self._stop(element.listed, element.given_default)}</{name}>"
        needed = [] if depth >= _DEEPEST else list(element.needed_children)
        body = [f"<{self.element(each, element.children[each], depth + 1)}" for each in needed]
        return self._with_body(name, head, body, depth, is_empty=not element.children and not element.open)

    def attribute(self, name: str, choices: tuple[str, ...] = (), default: str = "") -> str:
        """An attribute with the place of its value."""
        return f'{name}="{self._stop(choices, default)}"'

    def _with_body(self, name: str, head: str, body: list[str], depth: int, *, is_empty: bool) -> str:
        if is_empty:
            return f"{head}/>"
        inner = "\n".join(f"\t{line}" for text in body for line in text.split("\n"))
        if depth and not body:
            return f"{head}>{self._stop()}</{name}>"
        last = f"\n\t{self._stop()}" if not body else ""
        return f"{head}>{last}" + (f"\n{inner}" if inner else "") + f"\n</{name}>"

    def _stop(self, choices: tuple[str, ...] = (), default: str = "") -> str:
        number = next(self._number)
        if choices and len(choices) <= 30 and not any(set(each) & set(",|$}\\") for each in choices):
            return f"${{{number}|{','.join(choices)}|}}"
        return f"${{{number}:{escaped(default)}}}" if default else f"${number}"


def plain(snippet: str) -> str:
    """A snippet without its tab stops: what was offered first is filled in."""
    import re

    text = re.sub(r"\$\{\d+\|([^,|]*)[^}]*\|\}", r"\1", snippet)
    text = re.sub(r"\$\{\d+:((?:[^}\\]|\\.)*)\}", lambda match: re.sub(r"\\(.)", r"\1", match[1]), text)
    return re.sub(r"\$\d+", "", text)
