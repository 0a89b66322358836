"""Which end tag belongs to which start tag, also where some are missing, misspelled or too many.

A parser that knows only "expected this, found that" reports the wrong place first and others after it.
Here the text ahead and the indentation count as evidence, and one mistake makes one problem.
"""

from __future__ import annotations

from sdfcheck.source.limits import DEPTH_LIMIT
from sdfcheck.source.problems import (
    ContentAfterRoot,
    LateDeclaration,
    Problem,
    SyntaxDefect,
    SyntaxKind,
    TooDeep,
)
from sdfcheck.source.scanner.evidence import Evidence, Repair, alike
from sdfcheck.source.scanner.steps import Act, Pairs, Step
from sdfcheck.source.scanner.tokens import DEFECT_LIMIT, Token, TokenKind, Tokens, first_line, name_range
from sdfcheck.source.text import Source, Span


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
            elif not self.problems:
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
            self.defect(SyntaxKind.UNCLOSED_ELEMENT, place, self.source.span(*other), opened.name)
        # The content that it has swallowed is in the wrong place now.
        self.doubt(opened.start, token.start if has_children else opened.end)

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
            self.defect(SyntaxKind.MISSING_START_TAG, place, self.source.span(*here), token.name)
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

    def doubt(self, start: int, end: int) -> None:
        self.doubtful.append((self.number, (start, end)))

    def doubt_lack(self, parent: Token) -> None:
        """An element that the parent seems to lack may be in it, misspelled or not recognized."""
        self.doubt(parent.start, parent.end)

    def defect(
        self, kind: SyntaxKind, place: tuple[int, int], other: Span | None = None, detail: str = ""
    ) -> None:
        if len(self.problems) < DEFECT_LIMIT:
            self.note(SyntaxDefect(self.source.span(*place), kind, other, detail))
        else:
            self.evidence.budget = 0
