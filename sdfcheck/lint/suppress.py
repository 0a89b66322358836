"""Suppressions written into a file as XML comments.

``<!-- sdfcheck: ignore[XYZ001, name-of-rule] reason -->`` silences the rules for the
next element: for its start tag and, if it holds no elements, for its text and end tag.
A whole subtree takes ``disable[…]`` before and ``enable[…]`` (or ``enable``: all) behind
it. ``ignore-file[…]``, anywhere in the file, holds for all of it; without brackets it
silences every rule. What was reached through a macro or an include can be silenced where
the macro is called or the file is included.
"""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Iterable, Sequence
from pathlib import Path

from sdfcheck.lint.diagnostic import Diagnostic
from sdfcheck.lint.engine import Comment
from sdfcheck.lint.fix import Edit, Fix
from sdfcheck.lint.run import RuleFacts
from sdfcheck.lint.select import UnknownSelector, covered
from sdfcheck.lint.suppress_rules import MalformedSuppression, OwnRule, UnusedSuppression
from sdfcheck.lint.wording import named
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.text import Span
from sdfcheck.source.wrong_usage import suggestion

IGNORE, DISABLE, ENABLE, IGNORE_FILE = "ignore", "disable", "enable", "ignore-file"
VERBS = (IGNORE, DISABLE, ENABLE, IGNORE_FILE)

_DIRECTIVE = r"<!--\s*(sdfcheck\s*(:?)\s*([A-Za-z][\w-]*)\s*(?:(\[)([^\]]*)(\]?))?)"
_ANY_RULE = ""
"""Stands for the code of every rule, where a directive has no brackets."""


class Selector(NamedTuple):
    """One word between the brackets, and the codes that it covers."""

    span: Span
    codes: frozenset[str]


class Directive(NamedTuple):
    """A comment that was understood; ``place`` is the directive without its reason."""

    verb: str
    comment: Comment
    place: Span
    selectors: tuple[Selector, ...]
    complete: bool
    """Whether all words between the brackets were understood."""


class Filtered(NamedTuple):
    """What is left of the diagnostics, how many were silenced, and what is said about useless directives."""

    kept: tuple[Diagnostic, ...]
    suppressed: int
    unused: tuple[Diagnostic, ...]


class Suppressions(NamedTuple):
    """The directives of a file, in order, and what is wrong with those not understood."""

    directives: tuple[Directive, ...]
    malformed: tuple[Diagnostic, ...]

    def filter(self, diagnostics: Iterable[Diagnostic], active: frozenset[str]) -> Filtered:
        """Silence diagnostics; ``active`` are the codes of the rules that ran."""
        ranges = _Ranges(self.directives)
        kept = [diagnostic for diagnostic in diagnostics if not ranges.silence(diagnostic)]
        unused = [
            report
            for number, directive in enumerate(self.directives)
            for report in _unused(directive, {word for at, word in ranges.used if at == number}, active)
        ]
        return Filtered(tuple(kept), ranges.silenced, tuple(unused))


def suppressions(comments: Iterable[Comment], rules: Sequence[RuleFacts]) -> Suppressions:
    """Read the directives among the comments of a file; ``rules`` are all that exist."""
    directives: list[Directive] = []
    malformed: list[Diagnostic] = []
    for comment in comments:
        match = re.match(_DIRECTIVE, comment.span.text)
        if match is None or not (match[2] or match[4]):
            continue  # prose that begins with our name
        complaint = _complaint(comment, match)
        if complaint is not None:
            malformed.append(complaint)
            continue
        words = _words(comment, match)
        selectors = []
        for word in words:
            understood = _understand(word, rules)
            if isinstance(understood, Selector):
                selectors.append(understood)
            else:
                malformed.append(understood)
        if not match[4]:
            selectors = [Selector(_part(comment, match, 3), frozenset((_ANY_RULE,)))]
        if selectors:
            place = _part(comment, match, 1)
            complete = len(selectors) >= len(words)
            directives.append(Directive(match[3], comment, place, tuple(selectors), complete))
    directives.sort(key=lambda directive: (directive.place.source.path, directive.place.start))
    return Suppressions(tuple(directives), tuple(malformed))


def _understand(word: Span, rules: Sequence[RuleFacts]) -> Selector | Diagnostic:
    try:
        return Selector(word, covered(word.text, rules)[1])
    except UnknownSelector as error:
        return _report(MalformedSuppression, word, str(error))


def _complaint(comment: Comment, match: re.Match[str]) -> Diagnostic | None:
    """What keeps a directive from being understood at all."""
    verb = match[3]
    if verb not in VERBS:
        near = suggestion(verb, VERBS)
        return _report(MalformedSuppression, _part(comment, match, 3), f"unknown directive `{verb}`{near}")
    if not match[2]:
        return _report(MalformedSuppression, _part(comment, match, 1), "`:` is missing behind `sdfcheck`")
    if match[4] and not match[6]:
        return _report(MalformedSuppression, _part(comment, match, 4), "`[` is never closed")
    if (match[4] and not match[5].strip()) or (not match[4] and verb in (IGNORE, DISABLE)):
        place = _part(comment, match, 3)
        return _report(MalformedSuppression, place, f"`{verb}` names no rule", help=f"write `{verb}[rule]`")
    return None


def _words(comment: Comment, match: re.Match[str]) -> list[Span]:
    """The words between the brackets."""
    if not match[4]:
        return []
    start = comment.span.start + match.start(5)
    return [
        comment.span.source.span(start + word.start(), start + word.end())
        for word in re.finditer(r"[^,\s](?:[^,]*[^,\s])?", match[5])
    ]


def _part(comment: Comment, match: re.Match[str], group: int) -> Span:
    start = comment.span.start
    end = len(match[0][: match.end(group)].rstrip())
    return comment.span.source.span(start + match.start(group), start + end)


class _Range(NamedTuple):
    """What one word of one directive silences; ``end`` is -1 for the end of the file."""

    start: int
    end: int
    directive: int
    word: int


_Key = tuple[Path, str]
"""A file and a code."""


class _Ranges:
    """What is silenced, by file and code: next elements, stretches, whole files."""

    __slots__ = ("_near", "_open", "_whole", "_wide", "silenced", "used")

    def __init__(self, directives: Sequence[Directive]) -> None:
        self._near: dict[_Key, list[_Range]] = {}
        self._wide: dict[_Key, list[_Range]] = {}
        self._whole: dict[_Key, _Range] = {}
        self._open: dict[_Key, _Range] = {}
        self.used: set[tuple[int, int]] = set()
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
                or self._whole.get((span.source.path, _ANY_RULE))
            )
            if hit:
                self.used.add((hit.directive, hit.word))
                self.silenced += 1
                return True
        return False

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
            ended = [key] if code != _ANY_RULE else [other for other in self._open if other[0] == key[0]]
            for other in ended:
                if other in self._open:
                    self._wide.setdefault(other, []).append(self._open.pop(other)._replace(end=start))
                    self.used.add((number, word))


def _covering(ranges: Sequence[_Range], offset: int) -> _Range | None:
    """The one of the ranges (sorted, apart from each other) that holds ``offset``."""
    place = bisect_right(ranges, offset, key=lambda entry: entry.start) - 1
    if place < 0 or 0 <= ranges[place].end <= offset:
        return None
    return ranges[place]


def _unused(directive: Directive, used: set[int], active: frozenset[str]) -> list[Diagnostic]:
    """What to say of the words of a directive that silenced nothing, as far as that can be judged."""
    words = [
        selector
        for index, selector in enumerate(directive.selectors)
        if index not in used and selector.codes - {_ANY_RULE} <= active
    ]
    if not words:
        return []
    if len(words) == len(directive.selectors) and directive.complete:
        fix = Fix("remove the comment", (Edit(_line_or_comment(directive.comment.span), ""),))
        return [_report(UnusedSuppression, directive.place, _reason(directive, words), fix=fix)]
    return [
        _report(
            UnusedSuppression,
            word.span,
            _reason(directive, [word]),
            fix=Fix(f"remove `{word.span.text}`", (Edit(_with_comma(directive, word.span), ""),)),
        )
        for word in words
    ]


def _reason(directive: Directive, words: Sequence[Selector]) -> str:
    names = named(word.span.text for word in words)
    bare = words[0].codes == {_ANY_RULE}
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
    behind = re.compile(r"[ \t]*(?:\r\n?|\n)").match(text, span.end)
    if behind and (start == 0 or text[start - 1] in "\r\n"):
        return span.source.span(start, behind.end())
    return span


def _with_comma(directive: Directive, word: Span) -> Span:
    """A word with the comma and blanks that part it from its neighbour."""
    text = word.source.text
    end = directive.place.end
    behind = re.compile(r"\s*,\s*").match(text, word.end, end)
    if behind:
        return word.source.span(word.start, behind.end())
    before = text[directive.place.start : word.start].rstrip(" \t\r\n,")
    return word.source.span(directive.place.start + len(before), word.end)


def _report(
    rule: OwnRule, span: Span, message: str, *, fix: Fix | None = None, help: str | None = None
) -> Diagnostic:
    return Diagnostic(rule.code, rule.name, rule.severity, message, span, fix=fix, help=help)
