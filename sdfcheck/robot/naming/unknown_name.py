"""Names that reach nothing."""

from __future__ import annotations

from sdfcheck.source.element import Element, Value
from sdfcheck.source.record import NamedTuple

DEFAULT = "__default__"
"""The word of the format for nothing in particular."""


class UnknownName(NamedTuple):
    """A name that a part writes and nothing of its ``kind`` has in ``scope``; ``names`` are those that are there."""

    value: Value
    kind: str
    scope: Element
    names: tuple[str, ...]
