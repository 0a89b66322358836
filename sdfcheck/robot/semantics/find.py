"""The semantics in a document; nothing in other documents than SRDF."""

from __future__ import annotations

from typing import TYPE_CHECKING

from sdfcheck.source.document import Document
from sdfcheck.source.sniff import Kind

if TYPE_CHECKING:
    from sdfcheck.robot.semantics.semantics import Semantics


def semantics_in(document: Document) -> tuple[Semantics, ...]:
    """The parts of an SRDF document that are about a robot."""
    if document.kind is not Kind.SRDF or document.root is None:
        return ()
    from sdfcheck.robot.semantics.semantics import Semantics

    return (document.view(Semantics),)
