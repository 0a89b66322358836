"""Names that may be meant."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable

from sdfcheck.formats.near_names import nearest
from sdfcheck.formats.suggest import Effort
from sdfcheck.source.document import Document
from sdfcheck.source.scanner.evidence import alike

_DIGIT = re.compile(r"\d")


def guess(document: Document, name: str, known: Collection[str], *, surely: bool) -> str | None:
    """The name that was meant: the one it misspells or, unless it has to be ``surely`` so, the most similar.

    A document full of unknown names is not guessed at for ever.
    """
    effort = document.view(Effort)
    if effort.is_spent:
        return None
    effort.spend(len(known))
    return misspelling_of(name, known) or (None if surely else nearest(name, known))


def misspelling_of(name: str, candidates: Iterable[str]) -> str | None:
    """The candidate of which a name is a misspelling for certain: each of its words is at most a misspelling away.

    Where not all definitions are known, a name may well be one of them that is merely like others.
    """
    words = _words(name)
    for candidate in sorted(candidates):
        others = _words(candidate)
        pairs = zip(words, others, strict=False)
        if len(words) == len(others) and all(a == b or (len(a) > 2 and _alike(a, b)) for a, b in pairs):
            return candidate
        if len(words) != len(others) and len(name) > 3 and _alike(name, candidate):
            return candidate
    return None


def _alike(one: str, other: str) -> bool:
    """Is one word a misspelling of the other? Those with digits are models or numbers, as in `d435` and `d415`."""
    return not _DIGIT.search(one + other) and alike(one, other)


def _words(name: str) -> list[str]:
    return re.split(r"[_.\-]", name.lower())
