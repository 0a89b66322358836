"""The effect of directives, and those without effect.

A diagnostic that was reached through a macro or an include can be silenced where it is, where the
macro is called, or where the file is included; one that names another element in a label also before that.
"""

from __future__ import annotations

import re
from bisect import bisect_right
from collections import defaultdict
from collections.abc import Callable, Iterable, Sequence
from itertools import accumulate, chain
from pathlib import Path

from sdfcheck.lint.diagnostic import Diagnostic
from sdfcheck.lint.fix import Fix, TextEdit
from sdfcheck.lint.suppress.directives import (
    ANY_RULE,
    DISABLE,
    ENABLE,
    IGNORE,
    IGNORE_FILE,
    Directive,
    Selector,
)
from sdfcheck.lint.suppress.rules import UnusedSuppression, report
from sdfcheck.lint.wording import named
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.text import Span


class Filtered(NamedTuple):
    """The diagnostics that are left, how many were silenced, and the notes on useless directives."""

    kept: tuple[Diagnostic, ...]
    suppressed: int
    unused: tuple[Diagnostic, ...]


def suppress(
    diagnostics: Iterable[Diagnostic],
    own: Sequence[Directive],
    active: frozenset[str],
    *,
    foreign: Sequence[Directive] = (),
    outward: Sequence[Span] = (),
    is_idle: Callable[[Directive, str], bool] = lambda directive, code: False,
) -> Filtered:
    """Silence diagnostics of one file by the directives in it and in the ``foreign`` files they come from.

    ``active`` are the codes of the rules that ran. Directives that reach into one of the
    ``outward`` places may be for what only other runs bring out; they are not judged, nor are the codes
    for which ``is_idle`` says that their rule had nothing to look at where the directive holds.
    """
    ranges = _Ranges([*own, *foreign])
    kept = [diagnostic for diagnostic in diagnostics if not ranges.silence(diagnostic)]
    reaching = ranges.reaching(outward)
    unused = [
        reported
        for number, directive in enumerate(own)
        if number not in reaching
        for reported in _unused(directive, ranges.used[number], active, is_idle)
    ]
    return Filtered(tuple(kept), ranges.silenced, tuple(unused))


class _Range(NamedTuple):
    """The reach of one word of one directive; ``end`` is -1 for the end of the file."""

    start: int
    end: int
    directive: int
    word: int


_Key = tuple[Path, str]
"""A file and a code."""


class _Ranges:
    """The silenced places, by file and code: next elements, stretches, whole files."""

    __slots__ = ("_near", "_open", "_whole", "_wide", "silenced", "used")

    def __init__(self, directives: Sequence[Directive]) -> None:
        self._near: dict[_Key, list[_Range]] = {}
        self._wide: dict[_Key, list[_Range]] = {}
        self._whole: dict[_Key, _Range] = {}
        self._open: dict[_Key, _Range] = {}
        self.used: defaultdict[int, set[int]] = defaultdict(set)
        """The words that silenced something, by directive."""
        self.silenced = 0
        for number, directive in enumerate(directives):
            for word, selector in enumerate(directive.selectors):
                for code in selector.codes:
                    self._enter(directive, code, number, word)
        for key, rest in self._open.items():
            self._wide.setdefault(key, []).append(rest)

    def silence(self, diagnostic: Diagnostic) -> bool:
        """Whether a directive covers the diagnostic; the directive then counts as used."""
        for span in (diagnostic.span, *(origin.span for origin in diagnostic.origins)):
            key = (span.source.path, diagnostic.code)
            hit = (
                _covering(self._near.get(key, ()), span.start)
                or _covering(self._wide.get(key, ()), span.start)
                or self._whole.get(key)
                or self._whole.get((span.source.path, ANY_RULE))
            )
            if hit:
                return self._note(hit)
        for label in diagnostic.labels:
            span = label.span
            hit = _covering(self._near.get((span.source.path, diagnostic.code), ()), span.start)
            if hit:
                return self._note(hit)
        return False

    def _note(self, hit: _Range) -> bool:
        self.used[hit.directive].add(hit.word)
        self.silenced += 1
        return True

    def reaching(self, places: Sequence[Span]) -> set[int]:
        """The directives that silence something in one of the places, which are in the order of the text."""
        if not places:
            return set()
        # A place inside of another one adds nothing.
        reach = accumulate((place.end for place in places), max)
        places = [place for place, end in zip(places, reach, strict=True) if place.end == end]
        ends = [place.end for place in places]
        reaching = set()
        for each in chain(*self._near.values(), *self._wide.values(), self._whole.values()):
            # The first place that ends after the stretch begins is the one that it touches, if any.
            at = bisect_right(ends, each.start)
            if at < len(places) and (each.end < 0 or places[at].start < each.end):
                reaching.add(each.directive)
        return reaching

    def _enter(self, directive: Directive, code: str, number: int, word: int) -> None:
        """Note what one directive, met in the order of the text, does to one code."""
        key = (directive.place.source.path, code)
        start = directive.place.start
        if directive.verb == DISABLE:
            self._open.setdefault(key, _Range(start, -1, number, word))
        elif directive.verb == IGNORE_FILE:
            self._whole.setdefault(key, _Range(0, -1, number, word))
        elif directive.verb == IGNORE:
            target = directive.comment.target
            ranges = self._near.setdefault(key, [])
            if target is not None and not (ranges and ranges[-1].start == target.start):
                ranges.append(_Range(target.start, target.end, number, word))
        else:
            ended = [key] if code != ANY_RULE else [other for other in self._open if other[0] == key[0]]
            for other in ended:
                if other in self._open:
                    self._wide.setdefault(other, []).append(self._open.pop(other)._replace(end=start))
                    self.used[number].add(word)


def _covering(ranges: Sequence[_Range], offset: int) -> _Range | None:
    """The one of the ranges (sorted, apart from each other) that holds ``offset``."""
    place = bisect_right(ranges, offset, key=lambda entry: entry.start) - 1
    if place < 0 or 0 <= ranges[place].end <= offset:
        return None
    return ranges[place]


def _unused(
    directive: Directive, used: set[int], active: frozenset[str], is_idle: Callable[[Directive, str], bool]
) -> list[Diagnostic]:
    """The notes on the words of a directive that silenced nothing, as far as that can be judged."""
    words = [
        selector
        for index, selector in enumerate(directive.selectors)
        if index not in used
        and selector.codes - {ANY_RULE} <= active
        and not (selector.codes - {ANY_RULE} and all(is_idle(directive, code) for code in selector.codes))
    ]
    if not words:
        return []
    if len(words) == len(directive.selectors) and directive.complete:
        fix = Fix("remove the comment", (TextEdit(_line_or_comment(directive.comment.span), ""),))
        return [report(UnusedSuppression, directive.place, _reason(directive, words), fix=fix)]
    return [
        report(
            UnusedSuppression,
            word.span,
            _reason(directive, [word]),
            fix=Fix(f"remove `{word.span.text}`", (TextEdit(_with_comma(directive, word.span), ""),)),
        )
        for word in words
    ]


def _reason(directive: Directive, words: Sequence[Selector]) -> str:
    names = named(word.span.text for word in words)
    bare = words[0].codes == {ANY_RULE}
    if directive.verb == ENABLE:
        return "nothing is disabled here" if bare else f"{names} is not disabled here"
    if bare:
        return "unused suppression: this file has nothing to silence"
    if directive.verb == IGNORE and directive.comment.target is None:
        return f"unused suppression of {names}: no element follows"
    return f"unused suppression of {names}"


def _line_or_comment(span: Span) -> Span:
    """The comment with its whole line, if it is alone there."""
    text = span.source.text
    start = span.start
    while start > 0 and text[start - 1] in " \t":
        start -= 1
    rest = re.compile(r"[ \t]*(?:\r\n?|\n)").match(text, span.end)
    if rest and (start == 0 or text[start - 1] in "\r\n"):
        return span.source.span(start, rest.end())
    return span


def _with_comma(directive: Directive, word: Span) -> Span:
    """A word with the comma and spaces that part it from its neighbor."""
    text = word.source.text
    end = directive.place.end
    rest = re.compile(r"\s*,\s*").match(text, word.end, end)
    if rest:
        return word.source.span(word.start, rest.end())
    before = text[directive.place.start : word.start].rstrip(" \t\r\n,")
    return word.source.span(directive.place.start + len(before), word.end)
