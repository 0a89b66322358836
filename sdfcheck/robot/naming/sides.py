"""Names that differ only by the side: ``left_wheel`` and ``right_wheel``, ``FL_hip`` and ``RR_hip``, ``LKnee``."""

from __future__ import annotations

import re
from functools import lru_cache

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
_SIDE = re.compile(rf"(?<![A-Za-z])({'|'.join(_SPELLED)})(?![a-z])")


@lru_cache(maxsize=1000)
def without_sides(name: str) -> str:
    """A name without its words for sides; the same where it has none."""
    return _SIDE.sub("", name)


def mirrored(name: str) -> str:
    """The name on the other side: left for right; the same where it has no such word.

    Single letters count at the beginning, for elsewhere they may count through the alphabet.
    """

    def other(found: re.Match[str]) -> str:
        word = found[0]
        if len(word) == 1 and found.start():
            return word
        return _like(word, _WORDS.get(word.lower(), word))

    return _SIDE.sub(other, name)


def _like(written: str, word: str) -> str:
    """A word in the case of another one."""
    if written.isupper():
        return word.upper()
    return word.capitalize() if written[0].isupper() else word
