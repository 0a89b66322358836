"""Files of 1.2 that begin with ``gazebo``, as the root was called before 1.3."""

from __future__ import annotations

import re

from sdfcheck.convert.migrate.node import Node
from sdfcheck.source.document import Document
from sdfcheck.source.text import Source

_OLD, _NEW = "gazebo", "sdf"
_SURPLUS = len(_OLD) - len(_NEW)


def with_newer_root(document: Document) -> Document:
    """The document as if its root were called ``sdf``; every place stays where it is in the file."""
    root = document.root
    if root is None or root.name != _OLD or document.version != "1.2":
        return document
    place, text = document.spans.place(root), document.source.text
    start, end = place.start + 1, place.close + 2
    changed = f"{text[:start]}{_NEW:{len(_OLD)}}{text[start + len(_OLD) :]}"
    if text.startswith(_OLD, end):
        changed = f"{changed[:end]}{_NEW:{len(_OLD)}}{changed[end + len(_OLD) :]}"
    newer = Document(Source(document.source.path, changed), document.kind, [])
    newer.library = document.library
    newer.included_by = document.included_by
    return newer


def tidy_root(root: Node) -> None:
    """Take out the spaces that kept the places."""
    blanks = " " * _SURPLUS
    root.opening = re.sub(rf"^<{_NEW}{blanks}(?=[\s>/])", f"<{_NEW}", root.opening)
    root.closing = root.closing.replace(f"</{_NEW}{blanks}>", f"</{_NEW}>")
