"""How to speak of text that simulators take and strict XML parsers, such as that of xacro, refuse."""

from collections.abc import Mapping
from typing import Any

from sdfcheck import Consumer, Severity, Span, refuses

_AFFECTS = dict.fromkeys(Consumer, refuses("gets no robot description"))


def is_xacro(span: Span) -> bool:
    return span.source.path.suffix == ".xacro" or span.source.contains("<xacro:")


def unless_xacro(span: Span, message: str, **own: Any) -> Mapping[str, Any]:
    """The message, with what is ``own`` to a diagnostic; for xacro files that of an error."""
    if not is_xacro(span):
        return {"message": message, **own}
    return {"message": f"{message}: xacro refuses the file", "severity": Severity.ERROR, "affects": _AFFECTS}
