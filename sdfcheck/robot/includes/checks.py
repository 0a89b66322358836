"""By-products of reading includes: what is wrong with their parameters and placement.

Source: libsdformat 17's parser.cc, checked against what it reports. Problems of an included file
itself are reported there, where they are fixed.
"""

from __future__ import annotations

from collections.abc import Iterator

from sdfcheck.formats.sdf.problems import MissingElement
from sdfcheck.formats.sdf.survey import PARAMETERS
from sdfcheck.robot.includes.included import Included, included, includes_of
from sdfcheck.source.document import Document


def problems(document: Document) -> list[object]:
    """The problems of the includes of an SDF document by itself, in no particular order."""
    found: list[object] = []
    for include in includes_of(document):
        brought = included(document, include)
        found += _placement(brought)
        if include.has(PARAMETERS):
            from sdfcheck.robot.includes.parameters import parameters

            found += parameters(brought).problems
    return found


def _placement(found: Included) -> Iterator[object]:
    placement = found.include.find("placement_frame")
    if placement is None or not placement.content:
        return
    if not found.include.has("pose"):
        yield MissingElement(found.include, "pose", None, refused=True)
