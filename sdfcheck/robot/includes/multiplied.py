"""Includes that multiply: files of files of files, each some times, make more models than anybody can look at."""

from __future__ import annotations

from sdfcheck.robot.graph import DEEPEST, MOST_MODELS
from sdfcheck.robot.includes.included import included, includes_of
from sdfcheck.source.document import Document
from sdfcheck.source.errors import WrongUsage
from sdfcheck.source.record import NamedTuple


class TooManyModels(WrongUsage):
    """A file brings more than can be looked into; what is known of it would not be the whole."""


class _Size(NamedTuple):
    """How many models the includes of a file bring in, and how long their longest chain is."""

    models: int
    depth: int


def refuse_too_many(document: Document) -> None:
    """Make sure that all of what a document includes can be looked into.

    Raises TooManyModels.
    """
    if document.root is None or document.root.name != "sdf":
        return
    size = _size(document, {}, ())
    if size.depth > DEEPEST:
        raise TooManyModels(f"{document.path}: includes lead through more than {DEEPEST} files")
    if size.models > MOST_MODELS:
        raise TooManyModels(f"{document.path}: its includes bring in more than {MOST_MODELS} models")


def _size(document: Document, known: dict[Document, _Size], chain: tuple[Document, ...]) -> _Size:
    """The size of each file is worked out once, however often it is included."""
    if document in known:
        return known[document]
    if document in chain:
        raise TooManyModels(f"{chain[0].path}: includes lead from {document.path} back to it")
    if len(chain) > DEEPEST:
        return _Size(0, DEEPEST + 1)
    models, depth = 0, 0
    for include in includes_of(document):
        found = included(document, include)
        if found.document is None or found.model is None or found.kind != "model":
            continue
        inner = _size(found.document, known, (*chain, document))
        models += 1 + inner.models
        depth = max(depth, 1 + inner.depth)
    size = known[document] = _Size(models, depth)
    return size
