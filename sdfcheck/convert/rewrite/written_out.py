"""A document with its includes written out, whose places are those of what is written out."""

from __future__ import annotations

from sdfcheck.convert.migrate.migrate import to_sdf
from sdfcheck.convert.rewrite.include_expansion import Rendered, expanded
from sdfcheck.convert.rewrite.tidy import Branch
from sdfcheck.robot.includes.included import included, includes_of
from sdfcheck.source.document import Document, Element


class WrittenOut(Rendered):
    """The text that a document is with what it includes; made from the branch of its root."""

    def __init__(self, document: Document, root: Branch, expanded: list[Element]) -> None:
        super().__init__(document, root)
        self.expanded = expanded
        """The includes that are written out."""


def written_out(document: Document) -> tuple[Document, list[str]]:
    """The document with all includes replaced by what they bring, and why some of them are not."""
    root, expansion = expanded(document, to_sdf)
    if not expansion.expanded:
        return document, expansion.notes
    return WrittenOut(document, root, expansion.expanded), expansion.notes


def needs_writing_out(document: Document) -> bool:
    """Does a document include URDF, itself or in what it includes?"""
    seen: list[Document] = []
    waiting = [document]
    while waiting:
        at = waiting.pop()
        seen.append(at)
        for include in includes_of(at):
            found = included(at, include)
            if found.model is None or found.document is None:
                continue
            if found.model.name == "robot":
                return True
            if found.document not in seen:
                waiting.append(found.document)
    return False
