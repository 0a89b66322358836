"""Which end tag belongs to which start tag, also where some are missing, by the evidence of the text.

A parser that knows only "expected this, found that" reports the wrong place first and others after it.
Here the text ahead and the indentation count as evidence, and one mistake makes one problem.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from sdfcheck.source.decode import DEPTH_LIMIT
from sdfcheck.source.problems import (
    ContentAfterRoot,
    LateDeclaration,
    Problem,
    SyntaxDefect,
    SyntaxKind,
    TooDeep,
)
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.scanner.start_tag import BARE_START, tag_of
from sdfcheck.source.scanner.tokens import (
    DEFECT_LIMIT,
    Act,
    Pairs,
    Step,
    Token,
    TokenKind,
    Tokens,
    first_line,
    name_range,
)
from sdfcheck.source.text import Source, Span

# Evidence for what went wrong where start and end tags do not match.


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


def pair(source: Source, text: str, tokens: Tokens) -> Pairs:
    """Join start and end tags. ``text`` is what the tokens were cut from."""
    return _Pairing(source, text, tokens).run()


class _Pairing:
    def __init__(self, source: Source, text: str, tokens: Tokens) -> None:
        self.source = source
        self.text = text
        self.tokens = list(tokens.pieces)
        self.cut = tokens.cut
        self.odd_ends = tokens.odd_ends
        self.faulty = any(isinstance(problem, SyntaxDefect) for problem in tokens.problems)
        self.evidence = Evidence(text, self.tokens)
        self.steps: list[Step] = []
        # With the number of the token that they were found at, to go back after it.
        # The problems that a repair has found stay (-1).
        self.problems: list[tuple[int, Problem]] = []
        self.joined = 0
        """The defects that are part of another one."""
        self.doubtful: list[tuple[int, tuple[int, int]]] = []
        self.number = 0
        """Of the token that is looked at."""
        self.open: list[int] = []
        """Numbers of the tokens that opened what is open."""
        self.root: Span | None = None
        self.too_deep = 0
        self.crossed: list[str] = []
        """Names of elements that an outer end tag has closed; their own may follow."""

    def run(self) -> Pairs:
        end = len(self.text)
        while True:
            while self.number < len(self.tokens):
                token = self.tokens[self.number]
                if self.root is not None and not self.open:
                    if self.is_after_root(token):
                        return self.result(token.start)
                elif not self.take(token):
                    continue
                self.number += 1
            if self.cut or (repair := self.evidence.doubled_start(self.open)) is None:
                self.take_end_of_text(end)
                return self.result(end)
            self.apply(repair)

    def result(self, end: int) -> Pairs:
        problems = [problem for _, problem in self.problems]
        return Pairs(self.steps, problems, [doubt for _, doubt in self.doubtful], end)

    # Each `take…` decides on one token; False if a repair leads back to another one.

    def take(self, token: Token) -> bool:
        kind = token.kind
        if kind is TokenKind.END:
            return self.take_end(token)
        if kind is TokenKind.START or kind is TokenKind.EMPTY:
            self.take_start(token)
        elif not self.open:
            return self.take_before_root(token)
        elif kind is TokenKind.DECLARATION and not self.too_deep:
            self.defect(SyntaxKind.SECOND_DECLARATION, (token.start, token.end))
            self.step(Act.DROP, token)
        else:
            self.step(Act.DROP if self.too_deep else Act.KEEP, token)
        return True

    def take_before_root(self, token: Token) -> bool:
        if token.kind is TokenKind.TEXT or token.kind is TokenKind.SECTION:
            if repair := self.evidence.bare_root(self.number):
                return self.apply(repair)
            self.defect(SyntaxKind.TEXT_OUTSIDE_ROOT, first_line(token, self.text))
        elif token.kind is TokenKind.DECLARATION and token.start > 0:
            first = self.tokens[0]
            if first.kind is TokenKind.DECLARATION and first.start == 0:
                other = self.source.span(first.start, first.end)
                self.defect(SyntaxKind.SECOND_DECLARATION, (token.start, token.end), other)
            elif not self.problems and self.source.text.startswith(self.text[: token.start]):
                # Otherwise something before it was blanked, such as the mark of a merge conflict.
                here = self.source.span(token.start, token.end)
                self.note(LateDeclaration(self.source.span(0, token.start), here))
        return True

    def take_start(self, token: Token) -> None:
        if len(self.open) >= DEPTH_LIMIT:
            if not self.too_deep and not any(isinstance(p, TooDeep) for _, p in self.problems):
                self.note(TooDeep(self.name_span(token), DEPTH_LIMIT))
            self.too_deep += token.kind is TokenKind.START
            self.step(Act.DROP, token)
            return
        if self.root is None:
            self.root = self.name_span(token)
        self.step(Act.OPEN, token)
        if token.kind is TokenKind.START:
            self.open.append(self.number)

    def take_end(self, token: Token) -> bool:
        if self.too_deep or (self.cut and self.number == len(self.tokens) - 1):
            self.too_deep -= self.too_deep > 0
            self.step(Act.DROP, token)
        elif not self.open:
            self.defect(SyntaxKind.EXTRA_END_TAG, (token.start, token.end), detail=token.name)
        elif token.name == self.tokens[self.open[-1]].name:
            self.close(token)
        elif token.name in self.crossed:
            self.crossed.remove(token.name)
            self.step(Act.DROP, token)
        else:
            names = [self.tokens[opened].name for opened in self.open]
            if token.name in names:
                return self.take_outer_end(token, names)
            return self.take_foreign_end(token, names)
        return True

    def take_foreign_end(self, token: Token, names: list[str]) -> bool:
        """An end tag for something that is not open: misspelled, or too many, or its start tag is broken."""
        top, outer = names[-1], names[-2] if len(names) > 1 else None
        following = self.evidence.next_unmatched_end(self.number)
        similar = alike(token.name, top)
        if following == top and not (outer == top and similar):
            if repair := self.evidence.bare_start(self.open[-1], self.number):
                return self.apply(repair)
            self.extra(token)
        elif following == outer or similar:
            self.mismatch(token)
        else:
            self.extra(token)
        return True

    def take_outer_end(self, token: Token, names: list[str]) -> bool:
        """An end tag for something farther out: the inner elements lack theirs, or it is a wrong one."""
        depth = len(names) - 1 - names[::-1].index(token.name)
        expected = names[depth - 1] if depth else None
        following = self.evidence.next_unmatched_end(self.number)
        if following != expected and following == names[-2]:
            self.mismatch(token)
            return True
        while len(self.open) > depth + 1:
            if repair := self.evidence.cause(self.open, depth, self.number):
                return self.apply(repair)
            if following is not None and following != expected and following == names[len(self.open) - 1]:
                self.crossed.append(following)
            self.leave_open(token)
        self.close(token)
        return True

    def take_end_of_text(self, size: int) -> None:
        if self.cut:
            self.doubt(0, size)
        elif self.open:
            innermost = self.tokens[self.open[-1]]
            end = len(self.text.rstrip())
            self.defect(SyntaxKind.TRUNCATED, (end - 1, end), self.name_span(innermost), innermost.name)
            if len(self.open) > 1:
                self.doubt(0, size)
        elif self.root is None and not self.problems and not self.faulty:
            self.defect(SyntaxKind.NO_ELEMENT, (0, 0))
        while self.open:
            self.close_unwritten(size)

    def is_after_root(self, token: Token) -> bool:
        """Is this something that must not be after the root element?"""
        assert self.root is not None
        if token.kind in {TokenKind.COMMENT, TokenKind.OTHER} or token.name in self.crossed:
            return False
        span = self.source.span(token.start, token.end)
        if token.kind in {TokenKind.START, TokenKind.EMPTY}:
            span = self.name_span(token)
        elif token.kind is TokenKind.TEXT:
            span = self.source.span(*first_line(token, self.text))
        self.note(ContentAfterRoot(span, self.root))
        return True

    # Effects on elements

    def step(self, act: Act, token: Token) -> None:
        self.steps.append(Step(act, token, self.number, token.name))

    def close(self, token: Token) -> None:
        self.open.pop()
        self.step(Act.CLOSE, token)

    def close_unwritten(self, at: int) -> Token:
        """The innermost element ends without an end tag; returns its start tag."""
        opened = self.tokens[self.open.pop()]
        self.step(Act.CLOSE, Token(TokenKind.END, at, at, opened.name))
        return opened

    def leave_open(self, token: Token) -> None:
        """The innermost element has no end tag before the one that closes an outer element."""
        last_opened = next(step.number for step in reversed(self.steps) if step.act is Act.OPEN)
        has_children = last_opened != self.open[-1]
        opened = self.close_unwritten(token.start)
        if opened.tag is None:
            place, other = self.evidence.gap(opened, self.number)
            self.unclosed(opened.name, place, self.source.span(*other))
        # The content that it has swallowed is in the wrong place now.
        self.doubt(opened.start, token.start if has_children else opened.end)

    def unclosed(self, name: str, place: tuple[int, int], other: Span) -> None:
        """An end tag is missing at a place; those of the elements around it, too, are the same defect."""
        inner = self.taken_back(SyntaxKind.UNCLOSED_ELEMENT, place)
        self.defect(SyntaxKind.UNCLOSED_ELEMENT, place, other, f"{inner}></{name}" if inner else name)

    def taken_back(self, kind: SyntaxKind, place: tuple[int, int]) -> str:
        """The name in the last defect, which becomes one with another of its kind at its place; else empty."""
        last = self.problems[-1][1] if self.problems and not self.has_enough_problems else None
        if not isinstance(last, SyntaxDefect) or (last.kind, last.span) != (kind, self.source.span(*place)):
            return ""
        self.problems.pop()
        self.joined += 1
        return last.detail

    def mismatch(self, token: Token) -> None:
        """The end tag of the innermost element says another name; which of the two is misspelled?"""
        opened = self.tokens[self.open[-1]]
        start, end = name_range(opened, self.text), name_range(token, self.text)
        if opened.tag is not None or token.start in self.odd_ends:
            pass  # one of the two is broken, and that has been said
        elif self.evidence.is_misspelt_start(opened.name, token.name):
            self.defect(SyntaxKind.MISMATCHED_END_TAG, start, self.source.span(*end), token.name)
            at = next(i for i in range(len(self.steps) - 1, -1, -1) if self.steps[i].token is opened)
            self.steps[at] = self.steps[at]._replace(name=token.name)
        else:
            self.defect(SyntaxKind.MISMATCHED_END_TAG, end, self.source.span(*start), opened.name)
            if len(self.open) > 1:
                self.doubt_lack(self.tokens[self.open[-2]])
        self.doubt(opened.start, opened.end)
        self.doubt(token.start, token.end)
        self.close(token)

    def extra(self, token: Token) -> None:
        """An end tag too many, or one whose start tag got lost: then what it was to enclose is misplaced."""
        here, opened = (token.start, token.end), self.open[-1]
        orphans = None if self.evidence.is_exhausted else self.evidence.orphans(opened, self.number)
        if twin := self.evidence.empty_twin(opened, self.number):
            self.defect(SyntaxKind.EXTRA_END_TAG, here, self.name_span(twin), token.name)
        elif orphans is None:
            self.defect(SyntaxKind.EXTRA_END_TAG, here, self.name_span(self.tokens[opened]), token.name)
        else:
            place = self.evidence.place_before(orphans, self.evidence.indent(token.start))
            inner = self.taken_back(SyntaxKind.MISSING_START_TAG, place)
            name = f"{token.name}><{inner}" if inner else token.name
            self.defect(SyntaxKind.MISSING_START_TAG, place, self.source.span(*here), name)
            self.doubt_lack(self.tokens[opened])
        self.step(Act.DROP, token)
        self.doubt(token.start if orphans is None else self.tokens[orphans].start, token.end)

    def apply(self, repair: Repair) -> bool:
        """Change the tokens as the repair says, and go back to where it begins."""
        self.evidence.note_repair()
        self.number = repair.number
        self.tokens[repair.number : repair.number + repair.replaced] = repair.tokens
        while self.steps and self.steps[-1].number >= repair.number:
            self.steps.pop()
        self.problems = [entry for entry in self.problems if entry[0] < repair.number]
        self.doubtful = [entry for entry in self.doubtful if entry[0] < repair.number]
        self.open.clear()
        self.too_deep = 0
        for step in self.steps:
            if step.act is Act.OPEN and step.token.kind is TokenKind.START:
                self.open.append(step.number)
            elif step.act is Act.CLOSE:
                self.open.pop()
        if not repair.is_known:
            other = self.source.span(*repair.other) if repair.other else None
            defect = SyntaxDefect(self.source.span(*repair.place), repair.kind, other, repair.name)
            self.problems.append((-1, defect))
        self.doubtful += [(-1, doubt) for doubt in repair.doubtful]
        return False

    def name_span(self, token: Token) -> Span:
        return self.source.span(*name_range(token, self.text))

    def note(self, problem: Problem) -> None:
        self.problems.append((self.number, problem))

    @property
    def has_enough_problems(self) -> bool:
        return len(self.problems) + self.joined >= DEFECT_LIMIT

    def doubt(self, start: int, end: int) -> None:
        self.doubtful.append((self.number, (start, end)))

    def doubt_lack(self, parent: Token) -> None:
        """An element that the parent seems to lack may be in it, misspelled or not recognized."""
        self.doubt(parent.start, parent.end)

    def defect(
        self, kind: SyntaxKind, place: tuple[int, int], other: Span | None = None, detail: str = ""
    ) -> None:
        if not self.has_enough_problems:
            self.note(SyntaxDefect(self.source.span(*place), kind, other, detail))
        else:
            self.evidence.budget = 0
