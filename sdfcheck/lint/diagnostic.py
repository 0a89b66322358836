"""What a rule has to say about a place."""

from __future__ import annotations

from enum import Enum
from typing import TYPE_CHECKING

from sdfcheck.lint.fix.fix import Fix
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.text import Span

if TYPE_CHECKING:
    from sdfcheck.consumers.reaction import Reaction


class Severity(Enum):
    """How much a diagnostic matters.

    ERROR: some consumer rejects the file, crashes or silently builds another robot.
    WARNING: accepted, but very likely not meant, or forbidden by the specification.
    INFO: worth knowing.
    """

    INFO = "info"
    WARNING = "warning"
    ERROR = "error"

    @property
    def rank(self) -> int:
        return _RANKS[self]

    def __ge__(self, other: object) -> bool:
        if not isinstance(other, Severity):
            return NotImplemented
        return self.rank >= other.rank


_RANKS = {Severity.INFO: 0, Severity.WARNING: 1, Severity.ERROR: 2}


class Label(NamedTuple):
    """Another place that takes part, and what it has to do with the defect."""

    span: Span
    text: str


class Origin(NamedTuple):
    """One step of how a place was reached: "included from", "in macro `leg`, called from"."""

    span: Span
    text: str


class Diagnostic(NamedTuple):
    """One defect, at the smallest place that a person would edit.

    ``origins`` lead from the nearest step outwards (macro call, include) to the file
    that was linted; empty when the span lies in that file.
    """

    code: str
    name: str
    severity: Severity
    message: str
    span: Span
    labels: tuple[Label, ...] = ()
    fix: Fix | None = None
    help: str | None = None
    origins: tuple[Origin, ...] = ()
    affects: tuple[tuple[str, Reaction], ...] = ()
    """What each reader that is concerned does, sorted by reader."""

    @property
    def concerned(self) -> frozenset[str]:
        """The readers that do not take the file as it is meant."""
        return frozenset(reader for reader, reaction in self.affects if not reaction.is_harmless)

    @property
    def sort_key(self) -> tuple[str, int, int, str, str]:
        return (self.span.source.path.as_posix(), self.span.start, self.span.end, self.code, self.message)
