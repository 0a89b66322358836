"""A difference between two robots."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum


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
