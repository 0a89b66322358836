"""How to speak of mistakes in places that no expansion reaches."""

from collections.abc import Mapping
from typing import Any

from sdfcheck import Consumer, Severity, warns

_AFFECTS = dict.fromkeys(Consumer, warns("gets no robot description once xacro reaches the place"))


def unless_reached(*, is_dormant: bool, help: str | None = None) -> Mapping[str, Any]:
    """The words for a diagnostic where xacro does not stop, as it does not get there."""
    if not is_dormant:
        return {"help": help}
    advice = "xacro does not reach it with these arguments, and would stop here"
    return {
        "severity": Severity.WARNING,
        "affects": _AFFECTS,
        "help": f"{help}; {advice}" if help else advice,
    }
