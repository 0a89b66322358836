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


OLDEST = Version(1, 2)
NEWEST = Version(1, 12)
VERSIONS = tuple(Version(1, minor) for minor in range(OLDEST.minor, NEWEST.minor + 1))
_MINORS = frozenset(str(version.minor) for version in VERSIONS)
