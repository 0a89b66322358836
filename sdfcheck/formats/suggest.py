"""Near misses among names: the one that a misspelled name was meant to be."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from sdfcheck.source.document import Document

LONGEST = 200
"""A name with more letters is not guessed at."""
_CELLS = 1_000_000
"""The pairs of letters that are compared for the names of one document."""
LOOK = 10
"""The cost of looking at a candidate, in pairs of letters."""


class Effort:
    """The comparisons that are left for one document: one full of unknown names ends somewhere."""

    __slots__ = ("_left",)

    def __init__(self, document: Document | None = None) -> None:
        self._left = _CELLS

    @property
    def is_spent(self) -> bool:
        return self._left <= 0

    def spend(self, cells: int) -> None:
        self._left -= cells


def suggest(name: str, candidates: Iterable[str], effort: Effort | None = None) -> str | None:
    """The candidate that a misspelled name was meant to be, or None when nothing is near.

    The same letters in another case come first. Otherwise one misspelling (a letter missing,
    added, wrong, or two swapped) is forgiven, two in a name of six letters or more, three from
    twelve on; of two equally near the one with the same letters is meant. A name of one or two letters
    is never guessed from. Candidates for which no ``effort`` is left are not compared.
    """
    if len(name) > LONGEST:
        return None
    effort = effort or Effort()
    folded = _fold(name)
    pool = [(_fold(candidate), candidate) for candidate in sorted(candidates) if len(candidate) <= LONGEST]
    effort.spend(LOOK * len(pool))
    for other, candidate in pool:
        if other == folded:
            return candidate
    allowed = 0 if len(folded) < 3 else 1 if len(folded) < 6 else 2 if len(folded) < 12 else 3
    letters = set(folded)
    near: list[tuple[int, bool, str]] = []
    for other, candidate in pool:
        # Each misspelling brings in one letter and takes out one at most.
        if abs(len(other) - len(folded)) > allowed or len(letters ^ set(other)) > 2 * allowed:
            continue
        if effort.is_spent:
            break
        edits = distance(folded, other, allowed, effort)
        # A short name is another one after half of its letters have changed.
        if edits <= allowed and 2 * edits < len(other):
            near.append((edits, sorted(other) != sorted(folded), candidate))
    return min(near)[2] if near else None


def suggest_in(document: Document, name: str, candidates: Iterable[str]) -> str | None:
    """The same for the names of a document; one full of unknown names is not guessed at for ever."""
    effort = document.view(Effort)
    return None if effort.is_spent else suggest(name, candidates, effort)


def distance(one: str, other: str, most: int = LONGEST, effort: Effort | None = None) -> int:
    """Insertions, deletions, replacements and swaps of neighbors between two words; ``most`` + 1 for more.

    The parts that both begin and end with are no matter, and of the table of the rest only the band
    around its diagonal in which the result can lie is filled.
    """
    one, other = _apart(one, other)
    if not one or not other or abs(len(one) - len(other)) > most:
        return min(max(len(one), len(other)), most + 1)
    if effort is not None:
        effort.spend(len(one) * min(len(other), 2 * most + 1))
    width = len(other) + 1
    before: list[int] = []
    last = list(range(width))
    for i, letter in enumerate(one, 1):
        row = [most + 1] * width
        row[0] = i
        first, final = max(1, i - most), min(len(other), i + most)
        for j in range(first, final + 1):
            against = other[j - 1]
            cost = min(last[j] + 1, row[j - 1] + 1, last[j - 1] + (letter != against))
            if i > 1 and j > 1 and letter == other[j - 2] and one[i - 2] == against:
                cost = min(cost, before[j - 2] + 1)
            row[j] = cost
        if min(row) > most:
            return most + 1
        before, last = last, row
    return min(last[-1], most + 1)


def _apart(one: str, other: str) -> tuple[str, str]:
    """Two words without what both begin with and what both end with."""
    shorter = min(len(one), len(other))
    start = next((at for at in range(shorter) if one[at] != other[at]), shorter)
    rest = shorter - start
    end = next((at for at in range(rest) if one[-1 - at] != other[-1 - at]), rest)
    return one[start : len(one) - end], other[start : len(other) - end]


def _fold(name: str) -> str:
    return name.casefold().replace("-", "_").replace("_", "")
