"""By-products of reading includes: what is wrong with their parameters and placement.

A document that includes nothing loads nothing for it. Source: libsdformat 17's parser.cc, checked against
what it reports. Problems of an included file itself are reported there, where they are fixed.
"""

from __future__ import annotations

from collections.abc import Iterator

from sdfcheck.formats.problems import MissingElement
from sdfcheck.source.document import Document, Element


def problems(document: Document) -> Iterator[object]:
    """The problems of the includes of an SDF document by itself, in no particular order."""
    if "<include" not in document.source.text:
        return
    from sdfcheck.robot.includes.included import included, includes_of

    for include in includes_of(document):
        brought = included(document, include)
        if _is_placed_in_vain(include):
            yield MissingElement(include, "pose", None, refused=True)
        yield from brought.faults


def _is_placed_in_vain(include: Element) -> bool:
    placement = include.find("placement_frame")
    return placement is not None and bool(placement.content) and not include.has("pose")
