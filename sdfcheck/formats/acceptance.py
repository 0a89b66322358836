"""Fast checks of values: true for text that is surely read as written, and nothing said of the rest."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cache
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from sdfcheck.formats.choices import Range
    from sdfcheck.formats.schema import AttributeDefinition, Definition

Accepts = Callable[[str], object]

# The counts keep numbers inside the range of their type without converting them.
_NUMBER = r"[+-]?(?:[0-9]{1,40}(?:\.[0-9]{0,40})?|\.[0-9]{1,40})(?:[eE][+-]?[0-9]{1,2})?"
_SINGLE = r"[+-]?(?:[0-9]{1,8}(?:\.[0-9]{0,8})?|\.[0-9]{1,8})(?:[eE][+-]?[0-2]?[0-9])?"
_SHARE = r"(?:0?\.[0-9]{1,20}|0|1|[01]\.0{0,20})"
_WHOLE = r"[+-]?[0-9]{1,9}"
_GAP = r"[ \t\n\r]+"
_BLANK = r"[ \t\n\r]*"


def _several(count: int, part: str) -> str:
    return part + f"(?:{_GAP}{part}){{{count - 1}}}"


_PATTERNS = {
    "bool": r"(?:[Tt]rue|TRUE|[Ff]alse|FALSE|1|0)",
    "color": f"{_several(3, _SHARE)}(?:{_GAP}{_SHARE})?",
    "double": _NUMBER,
    "float": _SINGLE,
    "int": _WHOLE,
    "pose": _several(6, _NUMBER),
    "time": _several(2, _WHOLE),
    "unsigned int": r"\+?[0-9]{1,9}",
    "vector2d": _several(2, _NUMBER),
    "vector3": _several(3, _NUMBER),
}


def acceptance(definition: Definition | AttributeDefinition, needs_value: bool) -> Accepts:
    """The check for one place."""
    if definition.type is None:
        return _whole_text("", False)
    choices, bounds = definition.choices, definition.range
    if choices is not None:
        accepted = choices.accepted
        if not needs_value:
            accepted |= {"", definition.default or ""} - {"__default__"}
        return accepted.__contains__
    if definition.type == "string" and bounds is None:
        return str.strip if needs_value else _anything
    pattern = _PATTERNS["double" if definition.type == "string" else definition.type]
    matches = _whole_text(pattern, not needs_value)
    if bounds is None:
        return matches
    return _bounded(matches, bounds)


def _anything(text: str) -> bool:
    return True


@cache
def _whole_text(pattern: str, optional: bool) -> Accepts:
    body = f"(?:{pattern}{_BLANK})?" if optional else pattern + _BLANK
    return re.compile(_BLANK + body).fullmatch


def _bounded(matches: Accepts, bounds: Range) -> Accepts:
    holds = bounds.holds

    def accepts(text: str) -> bool:
        return bool(matches(text)) and all(holds(float(part)) for part in text.split())

    return accepts
