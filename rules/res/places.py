"""How the rules of this family speak of paths."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path

from sdfcheck import Document, Value

_SHOWN = 3


def place(document: Document, path: str | Path) -> str:
    """A path as seen from the folder of the document, if that is shorter."""
    whole = os.path.normpath(path)
    try:
        short = os.path.relpath(path, os.path.abspath(document.path.parent))
    except ValueError:  # another drive
        return whole
    return min(short, whole, key=len)


def looked_for(value: Value, paths: Sequence[str]) -> str:
    """Where something was looked for, the first few places."""
    document = value.element.document
    places = list(dict.fromkeys(place(document, path) for path in paths))
    left = len(places) - _SHOWN
    more = f" and {left} more {'place' if left == 1 else 'places'}" if left > 0 else ""
    return f"looked for {', '.join(places[:_SHOWN])}{more}"


def needs_no_escape(text: str) -> bool:
    """Can the text stand in XML as it is?"""
    return not set(text) & set("<>&\"'")
