"""The versions of SDFormat that consumers know."""

from __future__ import annotations

from sdfcheck.source.record import NamedTuple


class Version(NamedTuple):
    """A version of SDFormat; 1.10 comes after 1.9."""

    major: int
    minor: int

    def __str__(self) -> str:
        return f"{self.major}.{self.minor}"

    @classmethod
    def parse(cls, text: str) -> Version | None:
        """The version with exactly this text, as libsdformat compares it: `1.6.0` and `1.06` are unknown."""
        major, _, minor = text.partition(".")
        if major == "1" and minor in _MINORS:
            return cls(1, int(minor))
        return None


_MINORS = frozenset(("2", "3", "4", "5", "6", "7", "8", "9", "10", "11", "12"))

OLDEST = Version(1, 2)
NEWEST = Version(1, 12)
