"""The steps for the pieces of a text."""

from __future__ import annotations

from enum import Enum

from sdfcheck.source.problems import Problem
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.scanner.tokens import Token


class Act(Enum):
    """The outcome of a token."""

    OPEN = "opens an element"
    CLOSE = "closes the innermost element"
    KEEP = "belongs to the innermost element"
    DROP = "is not part of the tree"


class Step(NamedTuple):
    """A token and what becomes of it; ``name`` is that of the element, misspelled or not."""

    act: Act
    token: Token
    number: int
    name: str = ""


class Pairs(NamedTuple):
    """The steps from the root's start tag to its end, and what is wrong; after ``end`` nothing was read."""

    steps: list[Step]
    problems: list[Problem]
    doubtful: list[tuple[int, int]]
    end: int
