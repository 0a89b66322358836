"""Directives: comments that speak to sdfcheck, read.

``<!-- sdfcheck: ignore[XYZ001, name-of-rule] reason -->`` silences the rules for the
next element: for its start tag and, if it holds no elements, for its text and end tag.
A whole subtree takes ``disable[…]`` before and ``enable[…]`` (or ``enable``: all) after
it. ``ignore-file[…]``, anywhere in the file, holds for all of it; without brackets it
silences every rule.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

from sdfcheck.formats.suggest import nearest_choice
from sdfcheck.lint.diagnostic import Diagnostic
from sdfcheck.lint.rule import write_instead
from sdfcheck.lint.run import RuleFacts
from sdfcheck.lint.select import UnknownSelector, covered
from sdfcheck.lint.suppress.comments import Comment
from sdfcheck.lint.suppress.rules import MalformedSuppression, report
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.text import Span

IGNORE, DISABLE, ENABLE, IGNORE_FILE = "ignore", "disable", "enable", "ignore-file"
VERBS = (IGNORE, DISABLE, ENABLE, IGNORE_FILE)

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
        near, place = nearest_choice(verb, VERBS), _part(comment, match, 3)
        guess = f", did you mean `{near}`?" if near else ""
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
