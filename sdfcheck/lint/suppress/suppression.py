"""Directives: comments that speak to sdfcheck, and the elements after them.

``<!-- sdfcheck: ignore[XYZ001, name-of-rule] reason -->`` silences the rules for the
next element: for its start tag and, if it holds no elements, for its text and end tag.
A whole subtree takes ``disable[…]`` before and ``enable[…]`` (or ``enable``: all) after
it. ``ignore-file[…]``, anywhere in the file, holds for all of it; without brackets it
silences every rule.
"""

from __future__ import annotations

import re
from bisect import bisect_left, bisect_right
from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import accumulate, chain, islice
from pathlib import Path

from sdfcheck.formats.near_names import nearest
from sdfcheck.lint.diagnostic import Diagnostic, named
from sdfcheck.lint.fix import Fix, TextEdit
from sdfcheck.lint.rule import write_instead
from sdfcheck.lint.run import RuleFacts
from sdfcheck.lint.select import UnknownSelector, covered
from sdfcheck.lint.suppress.rules import MalformedSuppression, UnusedSuppression, report
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.scanner.scan import Scan
from sdfcheck.source.text import Source, Span

MARK = "sdfcheck:"


class Comment(NamedTuple):
    """A comment, and what it covers of the element after it: see :func:`reach`."""

    span: Span
    target: Span | None


def comments(source: Source, scan: Scan) -> list[Comment]:
    """The comments of a text that hold a word for sdfcheck."""
    text = source.text
    found = []
    for start, end in scan.comments:
        if MARK not in text[start:end]:
            continue
        number = bisect_left(scan.starts, end)
        target = source.span(*reach(source, scan, number)) if number < len(scan.starts) else None
        found.append(Comment(source.span(start, end), target))
    return found


def touched(comments: Sequence[Comment], span: Span) -> Iterator[Comment]:
    """Those of the comments of one text, in its order, of which a change of a place changes something."""
    for comment in islice(comments, bisect_right(comments, span.start, key=lambda each: each.span.end), None):
        if comment.span.start >= span.end:
            break
        yield comment


def reach(source: Source, scan: Scan, number: int) -> tuple[int, int]:
    """The reach of a comment before an element: its start tag, and all of a leaf or an include."""
    place = scan.place(number)
    is_leaf = number + 1 == len(scan.starts) or scan.starts[number + 1] >= place.close_end
    is_whole = is_leaf or is_include(source, place.start)
    return place.start, place.close_end if is_whole else place.end


def is_include(source: Source, start: int) -> bool:
    """Is the element that starts there one that brings in another file?"""
    return source.text.startswith("<include", start)


def includes(source: Source, scan: Scan) -> list[Span]:
    """The elements that bring in other files."""
    return [
        source.span(start, scan.close_ends[number])
        for number, start in enumerate(scan.starts)
        if is_include(source, start)
    ]


IGNORE, DISABLE, ENABLE, IGNORE_FILE = "ignore", "disable", "enable", "ignore-file"
VERBS = (IGNORE, DISABLE, ENABLE, IGNORE_FILE)

_MEANT = {
    **dict.fromkeys(
        ("ignore-next-line", "disable-next-line", "ignore-line", "ignore-next", "noqa", "nolint"), IGNORE
    ),
    **dict.fromkeys(("off", "disable-rule", "disable-rules"), DISABLE),
    **dict.fromkeys(("on", "enable-rule", "enable-rules"), ENABLE),
    **dict.fromkeys(("skip-file", "disable-file", "ignore-all", "disable-all"), IGNORE_FILE),
}
"""Words that other linters have → the directive that does the same here."""

_DIRECTIVE = r"<!--\s*(sdfcheck(?:\s*(:))?\s*([A-Za-z][\w-]*)\s*(?:(\[)([^\]]*)(\]?))?)"
ANY_RULE = ""
"""Means the code of every rule, where a directive has no brackets."""


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


class Directives(NamedTuple):
    """The directives of some comments, in order, and what is wrong with those not understood."""

    known: tuple[Directive, ...]
    malformed: tuple[Diagnostic, ...]


def directives(comments: Iterable[Comment], rules: Sequence[RuleFacts]) -> Directives:
    """Read the directives among comments; ``rules`` are all that exist."""
    known: list[Directive] = []
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
            selectors = [Selector(_part(comment, match, 3), frozenset((ANY_RULE,)))]
        if selectors:
            place = _part(comment, match, 1)
            complete = len(selectors) >= len(words)
            known.append(Directive(match[3], comment, place, tuple(selectors), complete))
    known.sort(key=lambda directive: (directive.place.source.path, directive.place.start))
    return Directives(tuple(known), tuple(malformed))


def _understand(word: Span, rules: Sequence[RuleFacts]) -> Selector | Diagnostic:
    try:
        return Selector(word, covered(word.text, rules)[1])
    except UnknownSelector as error:
        return report(MalformedSuppression, word, str(error), fix=write_instead(error.near, word))


def _complaint(comment: Comment, match: re.Match[str]) -> Diagnostic | None:
    """The fault that keeps a directive from being understood at all."""
    verb = match[3]
    if verb not in VERBS:
        near, place = _MEANT.get(verb.lower()) or nearest(verb, VERBS), _part(comment, match, 3)
        guess = f"; did you mean `{near}`?" if near else ""
        message = f"unknown directive `{verb}`{guess}"
        return report(MalformedSuppression, place, message, fix=write_instead(near, place))
    if not match[2]:
        return report(MalformedSuppression, _part(comment, match, 1), "`:` is missing after `sdfcheck`")
    if match[4] and not match[6]:
        return report(MalformedSuppression, _part(comment, match, 4), "`[` is never closed")
    if (match[4] and not match[5].strip()) or (not match[4] and verb in (IGNORE, DISABLE)):
        place = _part(comment, match, 3)
        return report(MalformedSuppression, place, f"`{verb}` names no rule", help=f"write `{verb}[rule]`")
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


# The effect of directives, and those without effect.
#
# A diagnostic that was reached through a macro or an include can be silenced where it is, where the
# macro is called, or where the file is included; one that names another element in a label also before that.


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
