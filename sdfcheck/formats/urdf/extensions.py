"""The gate to what is SDFormat in a URDF file: a robot without ``<gazebo>`` blocks loads none of it."""

from __future__ import annotations

from sdfcheck.source.document import Document


def problems(document: Document) -> list[object]:
    """The problems of the SDFormat in the ``<gazebo>`` blocks of a robot."""
    if "<gazebo" not in document.source.text:
        return []
    from sdfcheck.formats.sdf import structure, survey

    return [*survey.problems(document), *structure.structure_problems(document)]
