"""Names: one that a file gives, those that the format itself gives, and those that differ only by the side."""

from __future__ import annotations

import re
from collections.abc import Container
from functools import lru_cache

from sdfcheck.source.document import Element, Value
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.text import pattern

# The names that the format itself gives, and the kinds of part that have a frame.

MODEL_FRAME = "__model__"
WORLD_FRAME = "world"
NODES = frozenset({"link", "joint", "frame", "model"})


# One name that a file gives, and one that reaches nothing.

DEFAULT = "__default__"
"""The word of the format for nothing in particular."""


class UnknownName(NamedTuple):
    """A name that a part writes and nothing of its ``kind`` has in ``scope``; ``names`` are those that are there."""

    value: Value
    kind: str
    scope: Element
    names: tuple[str, ...]


class Name(NamedTuple):
    """The name of a part: ``kind`` is the kind that it counts as, ``parent`` the part that it is in.

    For an include that gives no name of its own ``value`` is the uri that brings it, and
    so for the parts of a model that it merges (``is_merged``).
    """

    kind: str
    name: str
    value: Value
    parent: Element
    is_merged: bool = False
    is_extension: bool = False
    """Is it in a ``<gazebo>`` block of a URDF file?"""

    @property
    def makes_frame(self) -> bool:
        """Is it the name of a frame?"""
        return self.kind in NODES

    @property
    def is_compared(self) -> bool:
        """Does libsdformat compare it with the names that it reserves?"""
        from sdfcheck.formats.history import reserved_name_holders

        return self.kind in reserved_name_holders()


class Namesakes(NamedTuple):
    """Two siblings that share a name."""

    first: Name
    later: Name


# Names that differ only by the side: ``left_wheel`` and ``right_wheel``, ``FL_hip`` and ``RR_hip``, ``LKnee``.

_MIRRORED = {
    "left": "right",
    "l": "r",
    "fl": "fr",
    "rl": "rr",
    "lf": "rf",
    "lh": "rh",
    "hl": "hr",
    "bl": "br",
}
_WORDS = {**_MIRRORED, **{right: left for left, right in _MIRRORED.items()}}
_ALONG = ("front", "rear", "back", "hind")
_SPELLED = sorted(
    {form(word) for word in (*_WORDS, *_ALONG) for form in (str.lower, str.upper, str.capitalize)},
    key=lambda word: (-len(word), word),
)
_SIDE = pattern(rf"(?<![A-Za-z])({'|'.join(_SPELLED)})(?![a-z])")


@lru_cache(maxsize=1000)
def without_sides(name: str) -> str:
    """A name without its words for sides; the same where it has none."""
    return _SIDE.sub("", name)


def mirrored(name: str) -> str:
    """The name on the other side: left for right; the same where it has no such word, or words for both sides.

    The left finger of the right hand is that of a copy, or of a mirror image. Single letters count at the
    beginning and right after another such word, for elsewhere they may count through the alphabet.
    """
    sides, after = set[bool](), 0

    def other(found: re.Match[str]) -> str:
        nonlocal after
        word = found[0]
        meant = _WORDS.get(word.lower())
        if meant is None or (len(word) == 1 and found.start() != after):
            return word
        after = found.end() + 1
        sides.add(word.lower() in _MIRRORED)
        return _like(word, meant)

    there = _SIDE.sub(other, name)
    return there if len(sides) == 1 else name


def counts_on(name: str, there: str, names: Container[str]) -> bool:
    """Is the side that two names differ by one of several letters: are there little, ring and *middle* fingers?"""
    differs = [at for at, (one, other) in enumerate(zip(name, there, strict=False)) if one != other]
    if len(differs) != 1:
        return False
    at = differs[0]
    return name[:at] + _like(name[at], "m") + name[at + 1 :] in names


def other_letter(name: str, names: Container[str]) -> str:
    """The name with ``r`` for ``l`` at its end, or the other way; the same where the letters of others count on."""
    stem, letter = name[:-1], name[-1:]
    if letter.lower() not in {"l", "r"} or stem[-1:].isalpha():
        return name
    if any(stem + _like(letter, near) in names for near in "kmqs"):
        return name
    return stem + _like(letter, _WORDS[letter.lower()])


def _like(written: str, word: str) -> str:
    """A word in the case of another one."""
    if written.isupper():
        return word.upper()
    return word.capitalize() if written[0].isupper() else word
