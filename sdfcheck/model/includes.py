"""Included models: found, read once, and said by what name they go."""

from __future__ import annotations

from typing import NamedTuple

from sdfcheck.source.document import Document
from sdfcheck.source.element import Element


class Included(NamedTuple):
    """What one ``include`` brings.

    ``model`` is the included file's model, actor or light element (in a document of its
    own), None where it could not be read; ``kind`` its name. ``name`` is the name by
    which it goes here, None where it is not known.
    """

    include: Element
    model: Element | None
    kind: str | None
    name: str | None
    merge: bool
    is_static: bool


def included(document: Document, include: Element) -> Included:
    """Resolve one include of a document."""
    name = include.find("name")
    static = include.find("static")
    return Included(
        include,
        None,
        None,
        (name.content or None) if name is not None else None,
        include.attributes.get("merge", "").lower() in {"true", "1"},
        static is not None and static.content.lower() in {"true", "1"},
    )
