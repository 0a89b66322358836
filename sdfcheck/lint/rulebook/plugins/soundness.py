"""Faults that keep a rule from running at all: attributes that are missing or malformed."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from importlib import import_module
from typing import Any

from sdfcheck.lint.diagnostic import Severity
from sdfcheck.lint.example import Bad, Good
from sdfcheck.lint.rule import Rule
from sdfcheck.source.element import Element
from sdfcheck.source.record import NamedTuple

_CODE = r"[A-Z][A-Z0-9]*[A-Z][0-9]{3,}|[A-Z][0-9]{3,}"
_NAME = r"[a-z][a-z0-9]*(-[a-z0-9]+)*"
_DIALECTS = ("sdf", "urdf", "xacro", "model-config")


class Flaw(NamedTuple):
    """The fault of an attribute of a rule."""

    attribute: str
    text: str


def flaws(rule: type[Rule]) -> Iterator[Flaw]:
    """The faults of a rule, one for each attribute at most."""
    for attribute, examine in _EXAMINED.items():
        value = vars(rule).get(attribute) if attribute == "code" else getattr(rule, attribute, None)
        text = examine(value) if value is not None else _MISSING.get(attribute)
        if text:
            yield Flaw(attribute, text)
    if not (rule.__doc__ or "").strip():
        yield Flaw("", "has no docstring, which is its manual")
    if rule.check is Rule.check:
        yield Flaw("", "has no `check`")
    if text := _looks_nowhere(rule):
        yield Flaw("", text)


_SUBJECTS = ("looks_at", "selects", "explains")
"""The attributes that say what a rule looks at."""


def _looks_nowhere(rule: type[Rule]) -> str | None:
    """The fault of the three attributes that list the targets of a rule, taken together."""
    if not any(getattr(rule, attribute) for attribute in _SUBJECTS):
        return f"looks at nothing: give it {' or '.join(f'`{name}`' for name in _SUBJECTS)}"
    if Element in rule.looks_at and not rule.selects:
        return "looks at elements, and has no `selects` that says at which"
    return None


def _spelled(attribute: str, form: str, what: str) -> Callable[[Any], str | None]:
    def examine(value: Any) -> str | None:
        is_sound = isinstance(value, str) and re.fullmatch(form, value)
        return None if is_sound else f"`{attribute}` should be {what}, not {value!r}"

    return examine


def _tuple_of(attribute: str, kind: type, what: str, *, needed: bool = False) -> Callable[[Any], str | None]:
    """Demands a tuple of instances of a type."""

    def examine(value: Any) -> str | None:
        # A single example is a named tuple, so that a forgotten comma leaves a tuple of its fields.
        if type(value) in (tuple, list) and all(isinstance(item, kind) for item in value):
            return f"has no `{attribute}` example" if needed and not value else None
        comma = ": a comma is missing after it" if isinstance(value, kind) else ""
        return f"`{attribute}` should be a tuple of {what}{comma}"

    return examine


def _examples(attribute: str, kind: type) -> Callable[[Any], str | None]:
    listed = _tuple_of(attribute, kind, f"{kind.__name__}(…)", needed=True)

    def examine(value: Any) -> str | None:
        if text := listed(value):
            return text
        strange = next((example for example in value if not isinstance(example.text, str)), None)
        return (
            None if strange is None else f"`{attribute}` has an example that is not a text: {strange.text!r}"
        )

    return examine


def _selects(value: object) -> str | None:
    form = "selectors, such as `sdf:joint/axis`"
    return _tuple_of("selects", str, form)(value) or next(filter(None, map(_selector, value)), None)  # type: ignore[call-overload]


def _selector(selector: str) -> str | None:
    """The fault of a selector: an unknown dialect, or a place that the format does not have."""
    dialect, colon, path = selector.partition(":")
    if not colon or dialect not in _DIALECTS:
        return f"`selects` has `{selector}`, which should begin with one of {', '.join(f'`{d}:`' for d in _DIALECTS)}"
    if not path or not all(path.split("/")) or "@" in path:
        return f"`selects` has `{selector}`, which should name an element after the colon, such as `{dialect}:joint`"
    if dialect in ("xacro", "model-config"):
        return None
    from sdfcheck.formats.describe.description import UnknownPlace
    from sdfcheck.formats.describe.place import describe

    try:
        describe(selector)
    except UnknownPlace as error:
        return f"`selects` has `{selector}`, which is nowhere: {error}"
    return None


def _looks_at(value: object) -> str | None:
    if text := _tuple_of("looks_at", type, "classes, such as Joint")(value):
        return text
    from sdfcheck.lint.subjects import OF_TEXT, OF_VENDORS
    from sdfcheck.robot.kinds import ELEMENTS
    from sdfcheck.robot.special import SPECIAL

    known = (*ELEMENTS, *SPECIAL, *OF_TEXT, *OF_VENDORS, Element.__name__)
    strange = [kind.__name__ for kind in value if kind.__name__ not in known]  # type: ignore[attr-defined]
    return f"`looks_at` has `{strange[0]}`, which is not a part of a robot" if strange else None


def _explains(value: object) -> str | None:
    if text := _tuple_of("explains", type, "kinds of problem, such as `problems.UnknownElement`")(value):
        return text
    problems = import_module("sdfcheck.problems")

    strange = [kind for kind in value if getattr(problems, kind.__name__, None) is not kind]  # type: ignore[attr-defined]
    return f"`explains` has `{strange[0].__name__}`, which is not a kind of problem" if strange else None


def _affects(value: object) -> str | None:
    from sdfcheck.consumers.reaction import by_dialect

    try:
        by_dialect(value)  # type: ignore[arg-type]
    except Exception:
        return f"`affects` should say what consumers do, such as {{Consumer.DRAKE: REFUSES}}, not {value!r}"
    return None


def _instance(attribute: str, kind: type, what: str) -> Callable[[Any], str | None]:
    def examine(value: Any) -> str | None:
        return None if isinstance(value, kind) else f"`{attribute}` should be {what}, not {value!r}"

    return examine


_EXAMINED: dict[str, Callable[[Any], str | None]] = {
    "code": _spelled("code", _CODE, "capitals and three digits, such as `ABC001`"),
    "name": _spelled("name", _NAME, "lower-case words joined by hyphens, such as `zero-effort`"),
    "severity": _instance("severity", Severity, "a Severity, such as Severity.WARNING"),
    "looks_at": _looks_at,
    "selects": _selects,
    "needs": _tuple_of("needs", str, "texts, such as `<mesh`"),
    "explains": _explains,
    "affects": _affects,
    "default": _instance("default", bool, "True or False"),
    "preview": _instance("preview", bool, "True or False"),
    "scaffold": _instance("scaffold", str, "a text with {} where the examples go"),
    "bad": _examples("bad", Bad),
    "good": _examples("good", Good),
}
_MISSING = {
    "code": "has no `code` of its own, such as `ABC001`",
    "name": "has no `name`, such as `zero-effort`",
    "severity": "has no `severity`, such as Severity.WARNING",
    "bad": "has no `bad` example",
    "good": "has no `good` example",
}
