"""Where the tables of vendors' tags are; what reads them is loaded when a document uses a prefix."""

from __future__ import annotations

from pathlib import Path

BUILT_IN = (Path(__file__).parents[1] / "data" / "drake.txt",)
SUFFIX = ".vendor.txt"
"""How the name of a table in a pack ends."""


def prefix_of(path: Path) -> str:
    """The prefix that a table is about: its file's name up to the first dot."""
    return path.name.partition(".")[0]
