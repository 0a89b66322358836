"""Which tables of vendors' tags are known; what reads them is loaded when a document uses a prefix."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from sdfcheck.files.library import Library

if TYPE_CHECKING:
    from sdfcheck.source.document import Document

BUILT_IN: Mapping[str, Path] = {"drake": Path(__file__).parents[1] / "data" / "drake.txt"}
"""Prefix → table."""
SUFFIX = ".vendor.txt"
"""How the name of a table in a pack ends."""


def prefix_of(path: Path) -> str:
    """The prefix that a table is about: its file's name up to the first dot."""
    return path.name.partition(".")[0]


def known_tables(library: object | None) -> Mapping[str, Path]:
    """Prefix → table, of those that the documents of a library are read with."""
    if not isinstance(library, Library) or not library.search.tables:
        return BUILT_IN
    return {**{prefix_of(table): table for table in library.search.tables}, **BUILT_IN}


def used_tables(document: Document) -> list[Path]:
    """The tables of the vendors whose prefix a document seems to use."""
    contains = document.source.contains
    return [table for prefix, table in known_tables(document.library).items() if contains(f"{prefix}:")]
