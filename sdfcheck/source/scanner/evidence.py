"""Evidence for what went wrong where start and end tags do not match."""

from __future__ import annotations

import re
from collections.abc import Iterator

from sdfcheck.source.problems import SyntaxKind
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.scanner.start_tag import BARE_START, tag_of
from sdfcheck.source.scanner.tokens import Token, TokenKind, first_line, name_range

LOOK_AHEAD = 5_000
"""How many tokens one look ahead may read."""
REPAIR_LIMIT = 50
"""How many repairs one text is worth."""

_UNKNOWN = "?"
_BLANK_LINE = re.compile(r"[\r\n]([ \t]+)(?=[\r\n])")
# Names that are frequent in robot descriptions: likelier the right spelling than a wrong one.
_COMMON = frozenset(
    (
        *("sdf", "robot", "world", "model", "link", "joint", "frame", "include", "plugin", "sensor", "light"),
        *("visual", "collision", "geometry", "inertial", "inertia", "material", "pose", "origin", "surface"),
        *("parent", "child", "axis", "limit", "dynamics", "box", "cylinder", "sphere", "mesh", "mass", "uri"),
        *("physics", "gazebo", "transmission", "xacro:macro", "xacro:property", "xacro:if", "xacro:unless"),
    )
)


class Repair(NamedTuple):
    """A defect at ``place`` and what makes it good: ``tokens`` instead of some, from ``number`` on."""

    kind: SyntaxKind
    name: str
    place: tuple[int, int]
    other: tuple[int, int] | None
    number: int
    replaced: int
    tokens: tuple[Token, ...]
    doubtful: tuple[tuple[int, int], ...] = ()
    is_known: bool = False
    """Has what is wrong been said of the tag?"""


class Evidence:
    """Looks for evidence in a list of tokens, which others may change meanwhile."""

    def __init__(self, text: str, tokens: list[Token]) -> None:
        self.text = text
        self.tokens = tokens
        self.budget = 100_000 + 8 * len(tokens)
        """How many tokens all questions together may still read."""
        self.repairs_left = REPAIR_LIMIT

    def note_repair(self) -> None:
        """Count a repair that was applied: the pairing then goes back, which takes time, too."""
        self.repairs_left -= 1
        self.budget -= len(self.tokens)

    @property
    def is_exhausted(self) -> bool:
        """Has so much been asked already that a text like this is worth no more questions?"""
        return self.repairs_left <= 0 or self.budget <= 0

    def next_unmatched_end(self, number: int) -> str | None:
        """The name in the next end tag after token ``number`` that ends what is open; None: no such."""
        depth = 0
        if self.is_exhausted:
            return _UNKNOWN
        for index in range(number + 1, min(number + 1 + LOOK_AHEAD, len(self.tokens))):
            self.budget -= 1
            token = self.tokens[index]
            if token.kind is TokenKind.START:
                depth += 1
            elif token.kind is TokenKind.END:
                if depth == 0:
                    return token.name
                depth -= 1
        at_end = number + 1 + LOOK_AHEAD >= len(self.tokens)
        return None if at_end and depth == 0 else _UNKNOWN

    def cause(self, opened: list[int], depth: int, number: int) -> Repair | None:
        """Why the innermost of the ``opened`` elements has no end tag before token ``number``.

        ``opened[depth]`` is the element that this token closes.
        """
        if self.is_exhausted:
            return None
        repair = self.doubled_start(opened[depth + 1 :])
        if repair is None:
            repair = self.damaged_end(opened[-1], number) or self.missing_end(opened, number)
        return repair

    def doubled_start(self, opened: list[int]) -> Repair | None:
        """``<pose>0 0 0<pose>``: the second one is an end tag without its slash; or almost."""
        if len(opened) < 2 or self.is_exhausted:
            return None
        token, outer = self.tokens[opened[-1]], self.tokens[opened[-2]]
        if self.text[token.start : token.end] != f"<{token.name}>":
            return None
        if token.name == outer.name or (alike(token.name, outer.name) and self.uses(token.name) == 1):
            return self._as_end_tag(opened[-1], outer)
        return None

    def damaged_end(self, opened: int, number: int) -> Repair | None:
        """``<pose>0 0 0/pose>`` or ``<pose>0 0 0<pose/>``."""
        name = self.tokens[opened].name
        for index, token in self.children(opened, number):
            at = self.text.find(f"/{name}>", token.start, token.end) if token.kind is TokenKind.TEXT else -1
            if at >= 0:
                end = at + len(name) + 2
                return self._split(index, Token(TokenKind.END, at, end, name))
            tag = self.text[token.start : token.end] if token.kind is TokenKind.EMPTY else ""
            if tag.replace(" ", "") == f"<{name}/>":
                return self._as_end_tag(index, self.tokens[opened])
        return None

    def missing_end(self, opened: list[int], number: int) -> Repair | None:
        """By indentation: the next sibling has been swallowed, or a nested element has taken the end tag."""
        element = self.tokens[opened[-1]]
        indent = self.indent(element.start)
        outer = self.indent(self.tokens[opened[-2]].start)
        if indent is None or outer is None or outer >= indent:
            return None
        nested: Token | None = None
        for index, token in self.children(opened[-1], number):
            own = self.indent(token.start)
            if token.kind is TokenKind.END:
                if nested is not None and nested.name == element.name and own == indent:
                    return self._end_before(index, nested)
            elif token.kind in {TokenKind.START, TokenKind.EMPTY}:
                if own is not None and own <= indent:
                    return self._end_before(index, element)
                nested = token if own is not None and own > indent else None
        return None

    def bare_start(self, opened: int, number: int) -> Repair | None:
        """``pose>0 0 0</pose>``: the end tag ``number`` is sound, and its start tag lacks the ``<``."""
        if self.is_exhausted:
            return None
        found: tuple[int, re.Match[str]] | None = None
        for index, token in self.children(opened, number):
            if token.kind is TokenKind.TEXT:
                for match in BARE_START.finditer(self.text, token.start, token.end):
                    if match[1] == self.tokens[number].name and not match[3]:
                        found = index, match
        if found is None:
            return None
        index, match = found
        return self._split(index, Token(TokenKind.START, *match.span(), match[1], tag_of(match)))

    def bare_root(self, number: int) -> Repair | None:
        """``sdf version="1.12">`` before everything else: the root's start tag lacks the ``<``."""
        token = self.tokens[number]
        match = BARE_START.search(self.text, token.start, token.end)
        last = next((t for t in reversed(self.tokens) if t.kind is TokenKind.END), None)
        if match is None or match[3] or last is None or last.name != match[1]:
            return None
        return self._split(number, Token(TokenKind.START, *match.span(), match[1], tag_of(match)))

    def is_misspelt_start(self, start: str, end: str) -> bool:
        """Of two names that differ by a misspelling: is only the end tag's common, or used elsewhere?"""
        if self.is_exhausted or not alike(start, end):
            return False
        if (start in _COMMON) != (end in _COMMON):
            return end in _COMMON
        return self.uses(start) == 1 and self.uses(end) > 0

    def uses(self, name: str) -> int:
        """How many start tags there are of that name."""
        self.budget -= len(self.tokens)
        return sum(token.name == name and token.kind is not TokenKind.END for token in self.tokens)

    def empty_twin(self, opened: int, number: int) -> Token | None:
        """``<pose/>0 0 0</pose>``: the element that the end tag ``number`` was to end is closed already."""
        name = self.tokens[number].name
        twins = (t for _, t in self.children(opened, number) if t.kind is TokenKind.EMPTY and t.name == name)
        return max(twins, key=lambda token: token.start, default=None)

    def orphans(self, opened: int, number: int) -> int | None:
        """The first token of what the end tag ``number`` was to enclose, whose start tag got lost.

        That is a text, or what is indented deeper; None: nothing is before the end tag.
        """
        indent = self.indent(self.tokens[number].start)
        if indent is None:
            return number - 1 if self.tokens[number - 1].kind is TokenKind.TEXT else None
        outer = self.indent(self.tokens[opened].start)
        if outer is not None and outer >= indent:
            return None
        first: int | None = None
        for index, token in self.children(opened, number):
            own = self.indent(token.start)
            if own is not None and own <= indent:
                first = None
            elif own is not None and first is None and token.kind is not TokenKind.END:
                first = index
        return first

    def place_before(self, number: int, indent: int | None) -> tuple[int, int]:
        """The line of spaces that a tag of this indentation has left before a token; else the token."""
        before, after = self.tokens[number - 1], self.tokens[number]
        for line in _BLANK_LINE.finditer(self.text, before.end, after.start):
            if indent and len(line[1].expandtabs()) == indent:
                return line.span(1)
        return first_line(after, self.text) if after.kind is TokenKind.TEXT else (after.start, after.end)

    def children(self, opened: int, number: int) -> Iterator[tuple[int, Token]]:
        """The tokens directly inside an element, up to token ``number``; of elements both tags."""
        depth = 0
        for index in range(opened + 1, number):
            self.budget -= 1
            if self.budget <= 0:
                return
            token = self.tokens[index]
            depth -= token.kind is TokenKind.END
            if depth <= 0:
                depth = 0
                yield index, token
            depth += token.kind is TokenKind.START

    def indent(self, at: int) -> int | None:
        """The column at which a line begins at ``at``; None if something is before it."""
        far = max(at - 200, 0)
        line = max(self.text.rfind("\n", far, at), self.text.rfind("\r", far, at)) + 1
        before = self.text[line:at] if line or far == 0 else "?"
        return len(before.expandtabs()) if not before.strip(" \t") else None

    def _as_end_tag(self, index: int, opened: Token) -> Repair:
        token = self.tokens[index]
        end = Token(TokenKind.END, token.start, token.end, opened.name)
        place, other = (token.start, token.end), name_range(opened, self.text)
        return Repair(SyntaxKind.MISSING_SLASH, opened.name, place, other, index, 1, (end,))

    def _split(self, index: int, tag: Token) -> Repair:
        """Part of a text turns out to be a tag without its ``<``."""
        token = self.tokens[index]
        around = (
            Token(TokenKind.TEXT, token.start, tag.start),
            tag,
            Token(TokenKind.TEXT, tag.end, token.end),
        )
        parts = tuple(t for t in around if t is tag or self.text[t.start : t.end].strip())
        place = (tag.start, tag.end)
        name = ("/" if tag.kind is TokenKind.END else "") + tag.name
        return Repair(SyntaxKind.MISSING_ANGLE, name, place, None, index, 1, parts, (place,))

    def _end_before(self, index: int, element: Token) -> Repair:
        token = self.tokens[index]
        end = Token(TokenKind.END, token.start, token.start, element.name)
        place, other = self.gap(element, index)
        is_known = element.tag is not None
        return Repair(SyntaxKind.UNCLOSED_ELEMENT, element.name, place, other, index, 0, (end,), (), is_known)

    def gap(self, element: Token, number: int) -> tuple[tuple[int, int], tuple[int, int]]:
        """Where an end tag is missing before token ``number``, and the other place to look at.

        That is the last line of a text, the line of spaces that the tag has left, or else the token; the
        start tag is the other one. Where an element is empty, its start tag may lack a slash, and the
        token is the other place.
        """
        before, after = self.tokens[number - 1], self.tokens[number]
        name = name_range(element, self.text)
        if before is element:
            return name, (after.start, after.end)
        if before.kind is TokenKind.TEXT:
            content = self.text[before.start : before.end].rstrip()
            end = before.start + len(content)
            start = max(content.rfind("\n"), content.rfind("\r")) + 1
            return (end - len(content[start:].lstrip()), end), name
        return self.place_before(number, self.indent(element.start)), name


def alike(one: str, other: str) -> bool:
    """Two names that differ by a misspelling: case, one letter more, less or other, two swapped."""
    one, other = one.lower(), other.lower()
    if abs(len(one) - len(other)) > 1 or not one or not other:
        return False
    if one == other or sorted(one) == sorted(other):
        return True
    pairs = enumerate(zip(one, other, strict=False))
    start = next((i for i, (a, b) in pairs if a != b), min(len(one), len(other)))
    rest, other_rest = one[start:], other[start:]
    return rest[1:] == other_rest[1:] or rest[1:] == other_rest or rest == other_rest[1:]
