"""The gate to what reading includes brings to light: a document that includes nothing loads none of it."""

from __future__ import annotations

from collections.abc import Iterator

from sdfcheck.source.document import Document


def problems(document: Document) -> Iterator[object]:
    """Problems of the parameters and the placement of includes."""
    if "<include" in document.source.text:
        from sdfcheck.robot.includes import checks

        yield from checks.problems(document)
