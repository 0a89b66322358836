"""The results of comparing two robots."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from enum import Enum
from types import MappingProxyType

from sdfcheck.convert.contents.entry import Divergence
from sdfcheck.source.record import Record

# A difference between two robots.


class ChangeKind(Enum):
    ADDED = "added"
    REMOVED = "removed"
    RENAMED = "renamed"
    CHANGED = "changed"


@dataclass(frozen=True, slots=True)
class Change:
    """One difference: of a ``part`` (model, link, joint, frame), and where it is changed, in ``what``."""

    kind: ChangeKind
    part: str
    name: str
    what: str = ""
    before: str = ""
    after: str = ""
    """Of what was renamed: the old and the new name."""


# The results of comparing two robots.


class Difference(Record):
    """One thing in which source and result are not equal."""

    what: str
    name: str
    text: str


class Verification(Record):
    """The compared quantities, and the largest differences (m, rad, relative for the mass)."""

    links: int
    configurations: int
    position: float
    angle: float
    inertia: float
    differences: tuple[Difference, ...]
    counts: Mapping[str, int] = MappingProxyType({})
    """Other compared quantities: joints, shapes, sensors, plugins and so on."""
    custom: tuple[Divergence, ...] = ()
    """Custom data that is not in the result as it was: a loss, but the same robot."""

    @property
    def is_equal(self) -> bool:
        return not self.differences

    def __str__(self) -> str:
        counts = {"link": self.links, **self.counts, "configuration": self.configurations}
        said = [f"{n} {word}{'s' * (n != 1)}" for word, n in counts.items() if n or word == "link"]
        return f"{', '.join(said)}, max pose error {max(self.position, self.angle):.0e} m"
