"""How to speak of text that simulators take and strict XML parsers, such as that of xacro, refuse."""

import re
from collections.abc import Mapping
from typing import Any

from sdfcheck import Consumer, Severity, Span, refuses

_COMMENT = re.compile(r"<!--.*?-->", re.DOTALL)
_AFFECTS = dict.fromkeys(Consumer, refuses("gets no robot description"))


def is_xacro(span: Span) -> bool:
    source = span.source
    if source.path.suffix == ".xacro" or not source.contains("<xacro:"):
        return source.path.suffix == ".xacro"
    return "<xacro:" in _COMMENT.sub("", source.text)


def unless_xacro(span: Span, message: str, **own: Any) -> Mapping[str, Any]:
    """The message, with what is ``own`` to a diagnostic; for xacro files that of an error."""
    if not is_xacro(span):
        return {"message": message, **own}
    return {"message": f"{message}: xacro refuses the file", "severity": Severity.ERROR, "affects": _AFFECTS}
