"""Near misses among names."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from sdfcheck.source.document import Document


class Effort:
    """The comparisons of names that are left for one document: one full of unknown names ends somewhere."""

    __slots__ = ("_left",)

    def __init__(self, document: Document) -> None:
        self._left = 50_000

    @property
    def is_spent(self) -> bool:
        return self._left <= 0

    def spend(self, comparisons: int) -> None:
        self._left -= comparisons


def suggest(name: str, candidates: Iterable[str]) -> str | None:
    """The candidate that a misspelled name was meant to be, or None when nothing is near.

    The same letters in another case come first. Otherwise one misspelling (a letter missing,
    added, wrong, or two swapped) is forgiven, two in a name of six letters or more, three from
    twelve on; of two equally near the one with the same letters is meant. A name of one or two letters
    is never guessed from.
    """
    folded = _fold(name)
    pool = sorted(candidates)
    for candidate in pool:
        if _fold(candidate) == folded:
            return candidate
    allowed = 0 if len(folded) < 3 else 1 if len(folded) < 6 else 2 if len(folded) < 12 else 3
    letters = set(folded)
    near: list[tuple[int, bool, str]] = []
    for candidate in pool:
        other = _fold(candidate)
        # Each misspelling brings in one letter and takes out one at most.
        if abs(len(other) - len(folded)) > allowed or len(letters ^ set(other)) > 2 * allowed:
            continue
        edits = distance(folded, other)
        # A short name is another one after half of its letters have changed.
        if edits <= allowed and 2 * edits < len(other):
            near.append((edits, sorted(other) != sorted(folded), candidate))
    return min(near)[2] if near else None


def suggest_in(document: Document, name: str, candidates: Iterable[str]) -> str | None:
    """The same for the names of a document; one full of unknown names is not guessed at for ever."""
    effort = document.view(Effort)
    if effort.is_spent:
        return None
    pool = list(candidates)
    effort.spend(len(pool))
    return suggest(name, pool)


def distance(one: str, other: str) -> int:
    """Insertions, deletions, replacements and swaps of neighbors between two words."""
    before: list[int] = []
    last = list(range(len(other) + 1))
    for i, letter in enumerate(one, 1):
        row = [i]
        for j, against in enumerate(other, 1):
            cost = min(last[j] + 1, row[j - 1] + 1, last[j - 1] + (letter != against))
            if i > 1 and j > 1 and letter == other[j - 2] and one[i - 2] == against:
                cost = min(cost, before[j - 2] + 1)
            row.append(cost)
        before, last = last, row
    return last[-1]


def _fold(name: str) -> str:
    return name.casefold().replace("-", "_").replace("_", "")
