"""The places of a text's elements and comments.

The tree keeps what a text says, a scan keeps the places. Both number elements in document order,
which is how they find each other.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from sdfcheck.source.record import NamedTuple

if TYPE_CHECKING:
    from sdfcheck.source.problems import Problem
    from sdfcheck.source.scanner.start_tag import StartTag


class ElementPlace(NamedTuple):
    """Offsets of an element's tags: start tag ``start:end``, end tag ``close:close_end``.

    An element without an end tag (``<a/>``, or never closed) has ``close == close_end``.
    """

    start: int
    end: int
    close: int
    close_end: int


class Scan:
    """The places of one text's elements (in document order) and comments, and its defects."""

    __slots__ = (
        "close_ends",
        "closes",
        "comments",
        "doubtful",
        "ends",
        "odd",
        "problems",
        "starts",
        "wellformed",
    )

    def __init__(self) -> None:
        self.starts: list[int] = []
        self.ends: list[int] = []
        self.closes: list[int] = []
        self.close_ends: list[int] = []
        self.comments: list[tuple[int, int]] = []
        self.problems: list[Problem] = []
        self.doubtful: list[tuple[int, int]] = []
        """Ranges that were read by a guess: what else is wrong there follows from the guess."""
        self.odd: dict[int, StartTag] = {}
        """Start tags that are not well formed, by their place in the order."""
        self.wellformed = ""
        """The text written anew; empty for one that needs it not."""

    def place(self, index: int) -> ElementPlace:
        return ElementPlace(self.starts[index], self.ends[index], self.closes[index], self.close_ends[index])

    def inside(self, index: int, tag: StartTag) -> tuple[int, int]:
        """From after an element's start tag to where, at the latest, its first text ends."""
        return self.ends[index], self.closes[index]
