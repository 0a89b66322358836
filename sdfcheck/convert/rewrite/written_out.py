"""A document with its includes written out, whose places are those of what is written out."""

from __future__ import annotations

from sdfcheck.convert.migrate.migrate import to_sdf
from sdfcheck.convert.rewrite.include_expansion import expanded
from sdfcheck.convert.rewrite.tidy_tree import Branch, render
from sdfcheck.formats.sdf.survey import PARAMETERS
from sdfcheck.robot.includes.included import included, includes_of
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element
from sdfcheck.source.spans import Spans
from sdfcheck.source.text import Source, Span


class WrittenOut(Document):
    """The text that a document is with what it includes; made from the branch of its root."""

    def __init__(self, document: Document, root: Branch, expanded: list[Element]) -> None:
        super().__init__(Source(document.path, render(root, document)), document.kind, [])
        self.library = document.library
        self.included_by = document.included_by
        self.expanded = expanded
        """The includes that are written out."""
        self._sources = _sources(root, document.root)

    @property
    def spans(self) -> Spans:
        if self._spans is None:
            self._spans = _Borrowed(self, self._sources)
        return self._spans

    @property
    def is_expanded(self) -> bool:
        return True


class _Borrowed(Spans):
    """Every place in an element is the name of the element that it was read from."""

    def __init__(self, document: WrittenOut, sources: list[Element]) -> None:
        super().__init__(document.source, document.scan)
        self._of = dict(zip(document.elements, sources, strict=True))

    def span(self, element: Element, start: int, end: int) -> Span:
        return self._of[element].span


def _sources(root: Branch, fallback: Element | None) -> list[Element]:
    """For each element what it was read from, or what around it was."""
    found: list[Element] = []
    waiting = [(root, fallback)]
    while waiting:
        branch, around = waiting.pop()
        source = branch.origin if branch.origin is not None else around
        assert source is not None
        found.append(source)
        waiting += [(child, source) for child in reversed(list(branch.children))]
    return found


def written_out(document: Document) -> tuple[Document, list[str]]:
    """The document with all includes replaced by what they bring, and why some of them are not."""
    root, expansion = expanded(document, to_sdf)
    if not expansion.expanded:
        return document, expansion.notes
    return WrittenOut(document, root, expansion.expanded), expansion.notes


def needs_writing_out(document: Document) -> bool:
    """Does a document include URDF, or change what it includes, itself or in what it includes?"""
    seen: list[Document] = []
    waiting = [document]
    while waiting:
        at = waiting.pop()
        seen.append(at)
        for include in includes_of(at):
            found = included(at, include)
            if found.model is None or found.document is None:
                continue
            if found.model.name == "robot" or include.has(PARAMETERS):
                return True
            if found.document not in seen:
                waiting.append(found.document)
    return False
