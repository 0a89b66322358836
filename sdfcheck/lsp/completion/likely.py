"""Likely continuations at a place: by what the text itself has in such places, and by public files."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Collection, Iterable, Iterator, Mapping

from sdfcheck.formats import near_names as usual
from sdfcheck.lsp.completion.context import Context, Where

AROUND = 40_000
"""So many characters before and after the cursor are looked at."""

_TAG = re.compile(
    r"<!--.*?-->|<!\[CDATA\[.*?\]\]>|</(?P<end>[\w:.-]+)\s*>"
    r"|<(?P<start>[\w:.-]+)(?P<inside>(?:\s+[^<>\"'=\s]+\s*=\s*(?:\"[^\"<]*\"|'[^'<]*'))*)\s*(?P<empty>/)?>(?P<text>[^<]*)",
    re.DOTALL,
)
_ATTRIBUTE = re.compile(r"([^\s\"'=]+)\s*=\s*(?:\"([^\"]*)\"|'([^']*)')")
_WORD = re.compile(r"[a-z]+|[0-9]+")
_EMPTY = frozenset({"link", "joint", "base", "name", "prefix", "xacro"})
_FLAGS = (
    "static",
    "gravity",
    "self_collide",
    "visualize",
    "always_on",
    "cast_shadows",
    "kinematic",
    "enable_wind",
)
_TRANSPARENT = frozenset({"xacro:if", "xacro:unless"})


class Usage:
    """The habits of the text around a place: which element follows which, and the values of each place."""

    def __init__(self, text: str, where: Context, offset: int, *, is_choice: bool = False) -> None:
        self.is_choice = is_choice
        """Are the elements beside the place perhaps not there when it is?"""
        self.children: dict[str, Counter[tuple[str, str]]] = {}
        """Element → how often one child (empty: none) is followed by another."""
        self.attributes: dict[str, Counter[str]] = {}
        self.values: dict[str, list[tuple[int, str]]] = {}
        """``element@attribute``, or an element → where each value begins, and the value."""
        opening = offset if where.where is Where.TEXT else text.rfind("<", 0, offset)
        start = text.find("<", opening - AROUND) if opening > AROUND else 0
        own = plain(where.around)
        self.parent = own[-1] if own else ""
        self.before = self._count(text, start, opening, "")[-1]
        end = offset if where.where in {Where.TAG, Where.TEXT} else text.find(">", offset)
        self.after = self._count(text, max(end, offset), offset + AROUND, self.parent)[0]

    def _count(self, text: str, start: int, end: int, around: str) -> tuple[list[str], list[str]]:
        """Count what a range holds; the elements that are with its beginning in one element, and with its end."""
        levels: list[list[str]] = [[]]
        stack = [around]
        first: list[str] | None = None
        for tag in _TAG.finditer(text, start, end):
            name = tag["start"]
            if name is not None:
                self._tag(tag)
            if name is not None and name not in _TRANSPARENT:
                before = levels[-1][-1] if levels[-1] else ""
                self.children.setdefault(stack[-1], Counter())[before, name] += 1
                levels[-1].append(name)
                if tag["empty"] is None:
                    levels.append([])
                    stack.append(name)
            elif tag["end"] is not None and tag["end"] not in _TRANSPARENT:
                first = first if first is not None else levels[0]
                levels, stack = (levels[:-1], stack[:-1]) if len(levels) > 1 else ([[]], [""])
        return first if first is not None else levels[0], levels[-1]

    def _tag(self, tag: re.Match[str]) -> None:
        name = tag["start"]
        for found in _ATTRIBUTE.finditer(tag["inside"] or ""):
            value = found[2] if found[2] is not None else found[3]
            self.attributes.setdefault(name, Counter())[found[1]] += 1
            at = tag.start("inside") + found.start(2 if found[2] is not None else 3)
            self.values.setdefault(f"{name}@{found[1]}", []).append((at, value))
        words = (tag["text"] or "").strip()
        if words and tag["empty"] is None:
            self.values.setdefault(name, []).append((tag.start("text"), words))

    # Scores

    def elements(
        self, names: Iterable[str], dialect: str, repeatable: Collection[str], typed: str
    ) -> dict[str, float]:
        """How likely each element is at the place, from 0 to about 4, among those that begin as typed; less where it
        is there already.
        """
        before = self.before[-1] if self.before else ""
        after = self.after[0] if self.after else ""
        known = self.children.get(self.parent, Counter())
        known = Counter({pair: number for pair, number in known.items() if pair[1].startswith(typed)})
        following = _shares({name: n for (first, name), n in known.items() if first == before})
        pairs = self.children.get(self.parent, Counter())
        leading = _shares(
            {first: n for (first, name), n in pairs.items() if name == after and first.startswith(typed)}
        )
        here = _shares(_summed(known))
        there, next_there = (_typed(each, typed) for each in self._usual(dialect, before))
        present = set() if self.is_choice else {*self.before, *self.after}
        doubled = {name for first, name in known if first == name}
        found = {}
        for name in names:
            score = following.get(name, 0.0) + here.get(name, 0.0) / 2
            score += leading.get(name, 0.0) / 2 if after else 0.0
            score += next_there.get(name, 0.0) + there.get(name, 0.0) / 2
            if name in present and name not in repeatable and name not in doubled:
                score -= 4
            found[name] = score
        return found

    def _usual(self, dialect: str, before: str) -> Iterator[Mapping[str, float]]:
        """The usual shares of elements at the place; in a macro those of a robot, but for definitions."""
        is_macro = self.parent == "xacro:macro"
        for last in (None, before):
            shares = usual.children(dialect, "robot" if is_macro else self.parent, last)
            yield {name: n for name, n in shares.items() if not (is_macro and name.startswith("xacro:"))}

    def seen_elements(self) -> list[str]:
        """The elements that the text has in the same element elsewhere."""
        return sorted({name for _, name in self.children.get(self.parent, Counter())})

    def seen_attributes(self, tag: str) -> list[str]:
        """The attributes that the text has in the same element elsewhere."""
        return sorted(self.attributes.get(tag, ()))

    def seen_values(self, place: str) -> list[str]:
        """The values that the text has in the same place elsewhere."""
        return [value for _, value in self.values.get(place, ()) if value and "$" not in value]

    @property
    def has_digits(self) -> bool:
        """Does the text write 1 and 0 for true and false?"""
        found = (value for place in _FLAGS for _, value in self.values.get(place, ()))
        return any(value in {"1", "0"} for value in found)

    def attribute_scores(self, tag: str, names: Iterable[str], dialect: str) -> dict[str, float]:
        """How likely each attribute of an element is."""
        here, there = _shares(self.attributes.get(tag, {})), usual.attributes(dialect, tag)
        return {name: here.get(name, 0.0) + there.get(name, 0.0) / 2 for name in names}

    def word_scores(self, place: str, names: Iterable[str], dialect: str) -> dict[str, float]:
        """How likely each word of a closed list is."""
        here = _shares(Counter(value for _, value in self.values.get(place, ())))
        there = usual.words(dialect, place)
        return {name: here.get(name, 0.0) + there.get(name, 0.0) for name in names}

    def neighbors(self, place: str, offset: int) -> tuple[list[str], list[str]]:
        """The values of the same place before the cursor, the nearest first, and those after it."""
        values = self.values.get(place, ())
        return [text for at, text in values if at < offset][::-1], [
            text for at, text in values if at > offset
        ]


def words_in(name: str) -> set[str]:
    """The words that a name is made of, without those that most names have."""
    return set(_WORD.findall(name.lower())) - _EMPTY


def plain(around: Iterable[str]) -> tuple[str, ...]:
    """The names of elements without those of xacro that only decide whether their content counts."""
    return tuple(name for name in around if name not in _TRANSPARENT)


def _summed(pairs: Mapping[tuple[str, str], int]) -> Counter[str]:
    found: Counter[str] = Counter()
    for (_, name), number in pairs.items():
        found[name] += number
    return found


def _typed(shares: Mapping[str, float], typed: str) -> Mapping[str, float]:
    """The shares among the names that begin as typed."""
    found = {name: share for name, share in shares.items() if name.startswith(typed)}
    total = sum(found.values())
    return {name: share / total for name, share in found.items()} if total else {}


def _shares(counts: Mapping[str, int]) -> dict[str, float]:
    total = sum(counts.values())
    return {name: number / total for name, number in counts.items()} if total else {}
