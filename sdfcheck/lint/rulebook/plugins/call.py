"""Calls to rules of plugins, which may do anything: what they return is checked, what they print set aside."""

from __future__ import annotations

import io
import sys
from collections.abc import Iterable, Iterator
from contextlib import contextmanager, redirect_stdout
from functools import wraps
from types import NoneType
from typing import TYPE_CHECKING, Any

from sdfcheck.lint.diagnostic import Diagnostic, Severity
from sdfcheck.lint.fix import Fix, TextEdit
from sdfcheck.lint.rulebook.plugins.place import Misbehavior, place_of_check
from sdfcheck.source.text import Span

if TYPE_CHECKING:
    from sdfcheck.lint.rule import Rule


# Prints of rules go to stderr: stdout carries the report.


class Aside(io.TextIOBase):
    """A stream to stderr that says once whose prints these are."""

    def __init__(self, whose: str) -> None:
        self._whose = whose
        self._is_named = False

    def write(self, text: str) -> int:
        """Write to stderr."""
        if not self._is_named and text:
            self._is_named = True
            sys.stderr.write(f"warning: {self._whose} prints; this is not part of the report:\n")
        return sys.stderr.write(text)

    def flush(self) -> None:
        """Nothing is held back."""
        sys.stderr.flush()


@contextmanager
def aside(name: str) -> Iterator[None]:
    """While this lasts, what is printed is the plugin's."""
    with redirect_stdout(Aside(f"plugin {name}")):
        yield


_END = object()
_LONG = 60
"""More of a strange value does not help on one line."""


def guard(rule: Rule) -> None:
    """Hold a rule to what rules promise.

    Its ``check`` then raises Misbehavior for a result that is not a diagnostic of the rule; prints
    of ``check`` and ``applies`` go to stderr.
    """
    place = place_of_check(type(rule))
    prints = Aside(f"rule {rule.code} {rule.name} ({place})")
    applies, check = rule.applies, rule.check

    @wraps(applies)
    def guarded_applies(subject: Any) -> bool:
        with redirect_stdout(prints):
            return applies(subject)

    @wraps(check)
    def guarded_check(subject: Any) -> Iterator[Diagnostic]:
        with redirect_stdout(prints):
            items = _iterated(check(subject), place)
        while True:
            with redirect_stdout(prints):
                item: Any = next(items, _END)
            if item is _END:
                return
            if wrong := next(_wrong(item, rule), None):
                raise Misbehavior(place, wrong)
            yield item

    vars(rule).update(applies=guarded_applies, check=guarded_check)


def _iterated(returned: Any, place: str) -> Iterator[Any]:
    """The diagnostics that a rule yields."""
    if isinstance(returned, Diagnostic):
        raise Misbehavior(place, "`check` returned a Diagnostic: yield it")
    if isinstance(returned, str) or not isinstance(returned, Iterable):
        raise Misbehavior(place, f"`check` should yield diagnostics, and returned {_shortened(returned)}")
    return iter(returned)


def _wrong(item: Any, rule: Rule) -> Iterator[str]:
    """The fault of something that a rule has yielded."""
    if not isinstance(item, Diagnostic):
        yield f"`check` yielded {_shortened(item)}, not a Diagnostic: use self.diagnostic(…)"
        return
    fields = item._asdict()
    if (item.code, item.name) != (rule.code, rule.name):
        yield f"`check` yielded a diagnostic of {item.code} {item.name}, not of its own"
    for field, kind, expected in _FIELDS:
        if not isinstance(fields[field], kind):
            yield f"`check` yielded a diagnostic with {_shortened(fields[field])} as {field}: it should be {expected}"
    if not all(isinstance(text, str) for _, text in item.labels):
        yield "`check` yielded a diagnostic with a label that is not a text"
    if item.fix is not None and not all(_is_edit(edit) for edit in item.fix.edits):
        yield "`check` yielded a diagnostic with a fix whose edits are not Edits of a span and a text"


_FIELDS: tuple[tuple[str, type | tuple[type, ...], str], ...] = (
    ("message", str, "a text"),
    ("severity", Severity, "a Severity"),
    ("span", Span, "an element, a value or a Span"),
    ("labels", tuple, "pairs of a place and a text"),
    ("help", (str, NoneType), "a text"),
    ("fix", (Fix, NoneType), "a Fix, as sdfcheck.replace and sdfcheck.edit make it"),
)


def _is_edit(edit: Any) -> bool:
    fields = tuple(edit) if isinstance(edit, TextEdit) else (None, None)
    return isinstance(fields[0], Span) and isinstance(fields[1], str)


def _shortened(value: object) -> str:
    text = repr(value)
    return text if len(text) < _LONG else f"{text[:_LONG]}…"
