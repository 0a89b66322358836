"""Where the cursor is in a text, what is likely there, and the items that completion offers."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Collection, Iterable, Iterator, Mapping
from enum import Enum
from itertools import count

from sdfcheck.formats import near_names as usual
from sdfcheck.formats.schema import Definition
from sdfcheck.source.record import NamedTuple

# Where somebody is typing, known by the text before the cursor alone: it may be broken anywhere.


MARKUP = re.compile(
    r"<!--[\s\S]*?-->|<!\[CDATA\[[\s\S]*?\]\]>|<\?[\s\S]*?\?>"
    r"|</(?P<end>[^\s<>]*)[^<>]*>"
    r"|<(?P<start>[^\s/<>!?\"']+)(?:[^<>\"'/]|\"[^\"<]*\"|'[^'<]*'|/(?!>))*(?P<empty>/)?>"
)
_ATTRIBUTE = re.compile(r"([^\s=\"'<>/]+)\s*=\s*(?:\"([^\"]*)\"?|'([^']*)'?)")
_OPEN_VALUE = re.compile(r"([^\s=\"'<>/]+)\s*=\s*(?:\"([^\"]*)|'([^']*))\Z")
_REST = re.compile(r"[^<>]*")
_AT_CURSOR = re.compile(r"\A[\w:.\-]*\s*=\s*(?:\"[^\"]*\"?|'[^']*'?)")
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
    """The other attributes of the tag, before the cursor and after it."""
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
        for match in MARKUP.finditer(text, end, offset):
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
    after = _REST.match(text, offset)
    return _in_tag(inside, name[0], after[0] if after else "", around, offset)


def _in_tag(inside: str, tag: str, rest: str, around: tuple[str, ...], offset: int) -> Context:
    value, mark = _OPEN_VALUE.search(inside), _open_quote(inside)
    given = _given(inside) + _given(rest.partition(mark)[2] if mark else _AT_CURSOR.sub("", rest))
    if value is not None and mark:
        typed = value[2] if value[2] is not None else value[3]
        return Context(Where.VALUE, around, tag, value[1], given, typed, offset - len(typed))
    typed_name = _NAME_END.search(inside)
    typed = typed_name[0] if typed_name else ""
    return Context(Where.ATTRIBUTE, around, tag, "", given, typed, offset - len(typed))


def _given(text: str) -> tuple[tuple[str, str], ...]:
    return tuple((found[1], found[2] or found[3] or "") for found in _ATTRIBUTE.finditer(text))


def _open_quote(inside: str) -> str:
    """The quote without its other half; empty if there is none."""
    mark = ""
    for character in inside:
        if mark:
            mark = "" if character == mark else mark
        elif character in "\"'":
            mark = character
    return mark


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


def without_stops(snippet: str) -> str:
    """A snippet without its tab stops: what was offered first is filled in."""
    import re

    text = re.sub(r"\$\{\d+\|([^,|]*)[^}]*\|\}", r"\1", snippet)
    text = re.sub(r"\$\{\d+:((?:[^}\\]|\\.)*)\}", lambda match: re.sub(r"\\(.)", r"\1", match[1]), text)
    return re.sub(r"\$\d+", "", text)


# Likely continuations at a place: by what the text itself has in such places, and by public files.


AROUND = 40_000
"""So many characters before and after the cursor are looked at."""

_TAG = re.compile(
    r"<!--.*?-->|<!\[CDATA\[.*?\]\]>|</(?P<end>[\w:.-]+)\s*>"
    r"|<(?P<start>[\w:.-]+)(?P<inside>(?:\s+[^<>\"'=\s]+\s*=\s*(?:\"[^\"<]*\"|'[^'<]*'))*)\s*(?P<empty>/)?>(?P<text>[^<]*)",
    re.DOTALL,
)


_WHOLE_ATTRIBUTE = re.compile(r"([^\s\"'=]+)\s*=\s*(?:\"([^\"]*)\"|'([^']*)')")


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
_HABIT = 20
"""So many elements in an element say as much about what comes next there as public files do."""
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
        own = without_conditions(where.around)
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
        for found in _WHOLE_ATTRIBUTE.finditer(tag["inside"] or ""):
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
        trust = 1 / (1 + pairs.total() / _HABIT)  # the more the text itself has, the less others say
        present = set() if self.is_choice else {*self.before, *self.after}
        doubled = {name for first, name in known if first == name}
        found = {}
        for name in names:
            score = following.get(name, 0.0) + here.get(name, 0.0) / 2
            score += leading.get(name, 0.0) / 2 if after else 0.0
            score += trust * (next_there.get(name, 0.0) + there.get(name, 0.0) / 2)
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


def without_conditions(around: Iterable[str]) -> tuple[str, ...]:
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
