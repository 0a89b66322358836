"""Where somebody is typing, known by the text before the cursor alone: it may be broken anywhere."""

from __future__ import annotations

import re
from enum import Enum

from sdfcheck.source.record import NamedTuple

_MARKUP = re.compile(
    r"<!--[\s\S]*?-->|<!\[CDATA\[[\s\S]*?\]\]>|<\?[\s\S]*?\?>"
    r"|</(?P<end>[^\s<>]*)[^<>]*>"
    r"|<(?P<start>[^\s/<>!?\"']+)(?:[^<>\"'/]|\"[^\"<]*\"|'[^'<]*'|/(?!>))*(?P<empty>/)?>"
)
_ATTRIBUTE = re.compile(r"([^\s=\"'<>/]+)\s*=\s*(?:\"([^\"]*)\"?|'([^']*)'?)")
_OPEN_VALUE = re.compile(r"([^\s=\"'<>/]+)\s*=\s*(?:\"([^\"]*)|'([^']*))\Z")
_NAME_END = re.compile(r"[\w:.\-]*\Z")
_SPACING = 65536


class Where(Enum):
    """The input at the cursor."""

    TAG = "tag"
    END = "end tag"
    ATTRIBUTE = "attribute"
    VALUE = "value"
    TEXT = "text"
    NOWHERE = "nowhere"
    """In a comment, CDATA, or an instruction."""


class Context(NamedTuple):
    """The input at the cursor, and its surroundings.

    ``around`` are the names of the open elements, from the root's; in a tag and in its attributes
    that of the tag itself is ``tag``. ``typed`` is what the completion replaces, which begins at
    ``start``.
    """

    where: Where
    around: tuple[str, ...]
    tag: str
    attribute: str
    given: tuple[tuple[str, str], ...]
    """The attributes of the tag before the cursor."""
    typed: str
    start: int


class Checkpoints:
    """Which elements are open at some places of a text, so that not all of it is read each time."""

    __slots__ = ("_known",)

    def __init__(self) -> None:
        self._known: list[tuple[int, tuple[str, ...]]] = [(0, ())]

    def cut(self, offset: int) -> None:
        """The text has changed from an offset on."""
        while len(self._known) > 1 and self._known[-1][0] > offset:
            self._known.pop()

    def around(self, text: str, offset: int) -> tuple[tuple[str, ...], int]:
        """The open elements at an offset, and where the markup before it ends."""
        number = len(self._known) - 1
        while self._known[number][0] > offset:
            number -= 1
        end, known = self._known[number]
        stack, noted = list(known), end
        for match in _MARKUP.finditer(text, end, offset):
            _take(match, stack)
            end = match.end()
            if end - noted > _SPACING and number == len(self._known) - 1:
                self._known.append((end, tuple(stack)))
                number, noted = number + 1, end
        return tuple(stack), end


def _take(match: re.Match[str], stack: list[str]) -> None:
    if match["start"] is not None and match["empty"] is None:
        stack.append(match["start"])
    elif match["end"] is not None and match["end"] in stack:
        while stack.pop() != match["end"]:
            pass


def context(text: str, offset: int, checkpoints: Checkpoints | None = None) -> Context:
    """The input at an offset."""
    around, end = (checkpoints or Checkpoints()).around(text, offset)
    rest = text[end:offset]
    opening = rest.rfind("<")
    if rest.lstrip().startswith(("<!--", "<![CDATA[", "<?")) or "<!--" in rest:
        return Context(Where.NOWHERE, around, "", "", (), "", offset)
    if opening < 0:
        typed = rest.lstrip()
        return Context(Where.TEXT, around, around[-1] if around else "", "", (), typed, offset - len(typed))
    inside = rest[opening + 1 :]
    if inside.startswith("/"):
        return Context(Where.END, around, "", "", (), inside[1:], offset - len(inside) + 1)
    name = re.match(r"[^\s/<>\"']*", inside)
    assert name
    if name.end() == len(inside):
        return Context(Where.TAG, around, "", "", (), inside, offset - len(inside))
    return _in_tag(inside, name[0], around, offset)


def _in_tag(inside: str, tag: str, around: tuple[str, ...], offset: int) -> Context:
    given = tuple((found[1], found[2] or found[3] or "") for found in _ATTRIBUTE.finditer(inside))
    value = _OPEN_VALUE.search(inside)
    if value is not None and _is_open(inside):
        typed = value[2] if value[2] is not None else value[3]
        return Context(Where.VALUE, around, tag, value[1], given, typed, offset - len(typed))
    typed_name = _NAME_END.search(inside)
    typed = typed_name[0] if typed_name else ""
    return Context(Where.ATTRIBUTE, around, tag, "", given, typed, offset - len(typed))


def _is_open(inside: str) -> bool:
    """Is there a quote without its other half?"""
    mark = ""
    for character in inside:
        if mark:
            mark = "" if character == mark else mark
        elif character in "\"'":
            mark = character
    return bool(mark)
