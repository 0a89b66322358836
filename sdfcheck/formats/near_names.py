"""Near misses among names: the one that was probably meant by one that does not exist."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Mapping
from functools import cache, lru_cache
from pathlib import Path
from typing import TYPE_CHECKING

from sdfcheck.source.text import pattern

if TYPE_CHECKING:
    from sdfcheck.source.document import Document


# Near misses among names: the one that a misspelled name was meant to be.


LONGEST = 200
"""A name with more letters is not guessed at."""
_CELLS = 1_000_000
"""The pairs of letters that are compared for the names of one document."""
_FULL = 8
"""From so many letters on the first one may be wrong beside another."""
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


_UNIT = pattern(r"_(?:kg|m|rad|s|sec|hz|n|nm)$", re.IGNORECASE)
"""The units of the formats, which no name says."""


def without_unit(name: str, candidates: Collection[str]) -> str | None:
    """The candidate that a name is with a unit behind it, such as ``mass_kg``."""
    bare = _UNIT.sub("", name)
    return bare if bare != name and bare in candidates else None


def with_another_word(name: str, candidates: Iterable[str]) -> str | None:
    """The only candidate with one more word before those of a name: ``dynamic_bias_correlation_time``."""
    longer = [
        each for each in candidates if each.endswith(f"_{name}") and each.count("_") == name.count("_") + 1
    ]
    return longer[0] if "_" in name and len(longer) == 1 else None


def suggest(name: str, candidates: Iterable[str], effort: Effort | None = None) -> str | None:
    """The candidate that a misspelled name was meant to be, or None when nothing is near.

    The same letters in another case come first, and with a 1 after them: the first of several.
    Otherwise one misspelling (a letter missing, added, wrong, or two swapped) is forgiven, two in a name of
    six letters or more, three from twelve on; of two equally near the one with the same letters is meant. A
    name of one or two letters is never guessed from. Candidates for which no ``effort`` is left are not
    compared.
    """
    if len(name) > LONGEST:
        return None
    effort = effort or Effort()
    folded = _fold(name)
    pool = [(_fold(candidate), candidate) for candidate in sorted(candidates) if len(candidate) <= LONGEST]
    effort.spend(LOOK * len(pool))
    for other, candidate in pool:
        if folded in {other, f"{other}1"}:
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
        # A short name is another one after half of its letters have changed, or the first and one more.
        is_other = 2 * edits >= len(other) or (edits > 1 and len(other) < _FULL and folded[0] != other[0])
        if edits <= allowed and not is_other:
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


@lru_cache(maxsize=4096)
def _fold(name: str) -> str:
    return name.casefold().replace("-", "_").replace("_", "")


# The name that was probably meant by one that does not exist: of links, packages, commands, options, rules.


_DIGIT = pattern(r"\d")
_WORD = pattern(r"[^\W\d_]+|\d+")
_LONG = 4
"""Letters of a word of which others are taken for misspellings: `arm` and `arc` are two names."""
_TRIES = 3


def nearest(name: str, candidates: Iterable[str], document: Document | None = None) -> str | None:
    """The candidate that a misspelled name was meant to be, or None.

    The parts in which the two differ must be misspellings of each other: ``panda_description`` is not near
    ``gen_description``, ``left_wheel`` not near ``right_wheel``, ``d415`` not near ``d435``. Given its
    ``document``, the guesses at the names of one document come to an end.
    """
    if document is not None and document.view(Effort).is_spent:
        return None
    pool = list(dict.fromkeys(candidates))
    for _ in range(_TRIES):
        near = suggest(name, pool) if document is None else suggest_in(document, name, pool)
        if near is None or _is_misspelling(name, near):
            return near
        pool.remove(near)
    return None


_MOST_WORDS = 20


def without_a_word(name: str, candidates: Collection[str]) -> str | None:
    """The candidate that a name of three words and more is without one of them; words end at underscores."""
    words = name.split("_")
    shorter = ("_".join(words[:place] + words[place + 1 :]) for place in range(len(words)))
    return (
        next((each for each in shorter if each in candidates), None) if 2 < len(words) < _MOST_WORDS else None
    )


def did_you_mean(name: str, candidates: Iterable[str]) -> str:
    """``; did you mean `x`?`` for the nearest candidate, or nothing."""
    near = nearest(name, candidates)
    return f"; did you mean `{near}`?" if near else ""


def question(name: str, meant: str) -> str:
    """The question whether a name was meant; of one with the same letters that it differs in case."""
    is_same = name != meant and name.casefold() == meant.casefold()
    return f"`{meant}` differs in case only" if is_same else f"did you mean `{meant}`?"


def _is_misspelling(name: str, other: str) -> bool:
    own, others = _WORD.findall(name.casefold()), _WORD.findall(other.casefold())
    if "".join(own) == "".join(others):
        return True
    count = len(others)
    while own and others and own[0] == others[0]:
        del own[0], others[0]
    while own and others and own[-1] == others[-1]:
        del own[-1], others[-1]
    has_context = len(others) < count
    if len(own) != len(others):
        own, others = ["".join(own)], ["".join(others)]
    return all(_is_near(*pair, has_context) for pair in zip(own, others, strict=True))


def _is_near(word: str, other: str, has_context: bool) -> bool:
    """Numbers are near when they are equal, short words when one has a letter more and the words around agree."""
    if word.isdigit() or other.isdigit():
        return word.isdecimal() and other.isdecimal() and int(word) == int(other)
    if word == other:
        return True
    if len(other) < _LONG:
        is_letter_more = abs(len(word) - len(other)) == 1 and distance(word, other) == 1
        return has_context and len(other) > 2 and is_letter_more
    return suggest(word, (other,)) is not None


def guess(document: Document, name: str, known: Collection[str], *, surely: bool) -> str | None:
    """The name that was meant: the one it misspells or, unless it has to be ``surely`` so, the most similar.

    A document full of unknown names is not guessed at for ever.
    """
    effort = document.view(Effort)
    if effort.is_spent or len(name) > LONGEST:
        return None
    effort.spend(2 * LOOK * len(known))
    return misspelling_of(name, known) or (None if surely else nearest(name, known, document))


def misspelling_of(name: str, candidates: Iterable[str]) -> str | None:
    """The candidate of which a name is a misspelling for certain: each of its words is at most a misspelling away.

    Where not all definitions are known, a name may well be one of them that is merely like others.
    """
    words = _parts(name)
    for candidate in sorted(candidates):
        others = _parts(candidate)
        pairs = zip(words, others, strict=False)
        if len(words) == len(others) and all(
            a == b or (len(a) > 2 and _is_one_misspelling(a, b)) for a, b in pairs
        ):
            return candidate
        if (
            len(words) != len(others)
            and len(name) > 3
            and _is_one_misspelling(name.lower(), candidate.lower())
        ):
            return candidate
    return None


def _is_one_misspelling(one: str, other: str) -> bool:
    """Is one word a misspelling of the other? Those with digits are models or numbers, as in `d435` and `d415`."""
    if not one or not other or _DIGIT.search(one + other):
        return False
    return distance(one, other, 1) < 2 or sorted(one) == sorted(other)


def _parts(name: str) -> list[str]:
    return re.split(r"[_.\-]", name.lower())


# How usual elements, attributes and words are, as counted in public files: what to suggest first.

FILE = Path(__file__).parent / "data" / "usual.txt"

_NOTHING: Mapping[str, float] = {}


def children(dialect: str, parent: str, before: str | None = None) -> Mapping[str, float]:
    """The share of each element among those in a parent, or among those right after another one (empty: the first)."""
    return _table().get(f"{dialect} < {parent}" + ("" if before is None else f" {before}"), _NOTHING)


def attributes(dialect: str, element: str) -> Mapping[str, float]:
    """The share of each attribute of an element."""
    return _table().get(f"{dialect} @ {element}", _NOTHING)


def words(dialect: str, place: str) -> Mapping[str, float]:
    """The share of each word in an element, or in ``element@attribute``, where few words are usual."""
    return _table().get(f"{dialect} = {place}", _NOTHING)


@cache
def _table() -> dict[str, dict[str, float]]:
    found: dict[str, dict[str, float]] = {}
    for line in FILE.read_text("utf-8").splitlines():
        key, tab, rest = line.partition("\t")
        if tab:
            row = rest.split(" ")
            found[key] = {name: int(share) / 1000 for name, share in zip(row[::2], row[1::2], strict=True)}
    return found
