"""Fixes: what they consist of."""

from __future__ import annotations

from enum import Enum

from sdfcheck.source.record import NamedTuple
from sdfcheck.source.text import Span


class Applicability(Enum):
    """Safe: the same robot in every simulator. Unsafe: a person should look."""

    SAFE = "safe"
    UNSAFE = "unsafe"


class TextEdit(NamedTuple):
    """Replace the characters of ``span`` by ``text``; an empty span inserts."""

    span: Span
    text: str


class Fix(NamedTuple):
    """A fix: its title in the imperative, its edits (all in one source), and whether it is safe."""

    title: str
    edits: tuple[TextEdit, ...]
    applicability: Applicability = Applicability.SAFE

    @property
    def is_safe(self) -> bool:
        return self.applicability is Applicability.SAFE
