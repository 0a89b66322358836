"""Closed lists of values."""

from __future__ import annotations

from enum import Enum

from sdfcheck.formats.table import Row, at
from sdfcheck.formats.version import NEWEST, OLDEST, Version
from sdfcheck.source.record import NamedTuple


class Enforcement(Enum):
    """The reaction of libsdformat to a value outside the list."""

    FATAL = "fatal"
    """The document is not read."""
    ERROR = "error"
    """Reported on load."""
    NO = "no"


class Verdict(Enum):
    """How a text relates to a list of choices."""

    LISTED = "listed"
    """In the list of the version, and accepted."""
    REFUSED = "refused"
    """In the list of the version, but libsdformat refuses it."""
    UNLISTED = "unlisted"
    """Accepted by libsdformat, in no version's list."""
    TOO_NEW = "too new"
    """In the list of a later version only."""
    REMOVED = "removed"
    """In the list of an earlier version only."""
    WRONG_CASE = "wrong case"
    """A listed value in another case, where case matters."""
    UNKNOWN = "unknown"


class Choices(NamedTuple):
    """The values listed for one place."""

    version: Version
    listed: tuple[str, ...]
    """By the description of the version."""
    library: tuple[str, ...]
    """Accepted by libsdformat whatever the version; empty where it checks nothing."""
    enforced: Enforcement
    ignores_case: bool
    aliases: dict[str, str]
    """Spelling → the one that it means."""
    history: tuple[tuple[Version, tuple[str, ...]], ...]
    """The lists over all versions, each from its first version on."""

    @classmethod
    def of(cls, row: Row, version: Version) -> Choices | None:
        """The choices of a place in a version; None where the values are free."""
        field = row.extra("choices")
        now = at(field, version.minor)
        if not now:
            return None
        aliases = (pair.partition(">") for pair in row.extra("aliases").split(",") if pair)
        return cls(
            version=version,
            listed=tuple(now.split(",")),
            library=tuple(row.extra("library").split(",")) if row.extra("library") else (),
            enforced=Enforcement(row.extra("enforced") or "no"),
            ignores_case=row.extra("case") == "insensitive",
            aliases={old: new for old, _, new in aliases},
            history=_history(field),
        )

    def judge(self, text: str) -> Verdict:
        """How a trimmed text relates to the list."""
        wanted = text.lower() if self.ignores_case else text
        listed = {value.lower() for value in self.listed} if self.ignores_case else set(self.listed)
        if wanted in listed:
            return Verdict.LISTED if not self.library or wanted in self.library else Verdict.REFUSED
        since = self.since(wanted)
        if since is not None:
            return Verdict.TOO_NEW if since > self.version else Verdict.REMOVED
        if wanted in self.library:
            return Verdict.UNLISTED
        if text.lower() in {value.lower() for value in (*self.listed, *self.library)}:
            return Verdict.WRONG_CASE
        return Verdict.UNKNOWN

    def refuses(self, text: str) -> bool:
        """Whether libsdformat does not take a trimmed text."""
        wanted = text.lower() if self.ignores_case else text
        return bool(self.library) and self.enforced is not Enforcement.NO and wanted not in self.library

    def since(self, text: str) -> Version | None:
        """The first version that lists a value."""
        return next((first for first, values in self.history if text in values), None)


def _history(field: str) -> tuple[tuple[Version, tuple[str, ...]], ...]:
    first, *later = field.split("|")
    lists = [(OLDEST, tuple(first.split(",")) if first else ())]
    for change in later:
        minor, _, values = change.partition(":")
        lists.append((Version(NEWEST.major, int(minor)), tuple(values.split(","))))
    return tuple(lists)
