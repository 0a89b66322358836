"""The report of a rule about a place, and words for several things at once."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from enum import Enum
from typing import TYPE_CHECKING

from sdfcheck.lint.fix import Fix
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.text import Span

if TYPE_CHECKING:
    from sdfcheck.consumers.reaction import Reaction


# The report of a rule about a place.


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


class MissingKind(Enum):
    """The missing fact; the value is its noun."""

    PACKAGE = "package"
    MODEL = "model"
    REMOTE = "address on the network"
    LFS = "Git LFS file"
    SUBMODULE = "submodule"
    IGNORED = "ignored file"
    BUILT = "file of a build"


class Missing(NamedTuple):
    """Something that is not on this computer, and may be on another, with how often it is needed."""

    kind: MissingKind
    name: str
    uses: int = 1


class Moment(NamedTuple):
    """A robot while something happens: where its joints are (rad, m), and the points of its model concerned (m)."""

    positions: tuple[tuple[str, float], ...]
    points: tuple[tuple[float, ...], ...] = ()


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
    """The reaction of each consumer that is concerned, sorted by consumer."""
    missing: Missing | None = None
    """Given where the finding is about this computer, and the file may be sound."""
    cause: Span | None = None
    """The place of what this follows from: where another finding begins there, this one is part of that.

    Of a fault that xacro meets, which need not be found at the same place: where an error is on its line.
    """
    repeats: tuple[Span, ...] = ()
    """Further places of the same mistake, which the message only counts."""
    moment: Moment | None = None
    """Given where the finding is about a robot that moves."""

    @property
    def concerned(self) -> frozenset[str]:
        """The consumers that do not take the file as it is meant."""
        return frozenset(consumer for consumer, reaction in self.affects if not reaction.is_harmless)

    def for_targets(self, targets: Collection[str]) -> Diagnostic:
        """The same for those who ask about some consumers: an error if one of them refuses the file, and only then."""
        if any(consumer in targets and reaction.is_refusal for consumer, reaction in self.affects):
            return self._replace(severity=Severity.ERROR)
        return self._replace(severity=Severity.WARNING) if self.severity is Severity.ERROR else self

    @property
    def without_fix(self) -> Diagnostic:
        """The same for a text that must not be edited: the title of its fix says what to do."""
        return self if self.fix is None else self._replace(fix=None, help=self.help or self.fix.title)

    @property
    def sort_key(self) -> tuple[str, int, int, str, str]:
        return (self.span.source.path.as_posix(), self.span.start, self.span.end, self.code, self.message)


# Words for several things at once.


def listed(words: Iterable[str], joiner: str = "and", *, most: int = 0) -> str:
    """``a, b and c``; of more than ``most`` words so many, and how many are left: ``a, b and 3 more``."""
    shown = list(words)
    if 0 < most < len(shown):
        left = len(shown) - most
        return f"{', '.join(shown[:most])} and {left} more"
    return f" {joiner} ".join(filter(None, (", ".join(shown[:-1]), *shown[-1:])))


def named(words: Iterable[str], joiner: str = "and", *, most: int = 0) -> str:
    """Names in a list: ```a`, `b` and `c```."""
    return listed((f"`{word}`" for word in words), joiner, most=most)


def used(count: int) -> str:
    """`` (used 3 times)``; nothing for once."""
    return f" (used {count} times)" if count > 1 else ""


def counted(number: int, noun: str) -> str:
    """``1 file``, ``2 files``."""
    return f"{number} {noun}" if number == 1 else f"{number} {noun}s"
