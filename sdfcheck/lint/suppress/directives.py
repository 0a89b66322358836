"""Directives: comments that speak to sdfcheck, and the elements after them."""

from __future__ import annotations

import re
from bisect import bisect_left, bisect_right
from collections.abc import Iterable, Iterator, Sequence
from itertools import islice

from sdfcheck.formats.near_names import nearest
from sdfcheck.lint.diagnostic import Diagnostic
from sdfcheck.lint.rule import write_instead
from sdfcheck.lint.run import RuleFacts
from sdfcheck.lint.select import UnknownSelector, covered
from sdfcheck.lint.suppress.rules import MalformedSuppression, report
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.scanner.scan import Scan
from sdfcheck.source.text import Source, Span

# Comments that may be directives of sdfcheck, and the elements after them.


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


# Directives: comments that speak to sdfcheck, read.
#
# ``<!-- sdfcheck: ignore[XYZ001, name-of-rule] reason -->`` silences the rules for the
# next element: for its start tag and, if it holds no elements, for its text and end tag.
# A whole subtree takes ``disable[…]`` before and ``enable[…]`` (or ``enable``: all) after
# it. ``ignore-file[…]``, anywhere in the file, holds for all of it; without brackets it
# silences every rule.


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
