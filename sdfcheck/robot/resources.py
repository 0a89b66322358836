"""What a document takes from elsewhere: the gate to the analyses of includes and files.

A document that takes nothing from elsewhere loads none of them.
"""

from __future__ import annotations

from collections.abc import Iterator

from sdfcheck.formats.sdf.survey import survey
from sdfcheck.source.document import Document

_NAMING_FILES = (
    "mesh", "heightmap", "image", "script", "audio_source", "skin", "animation", "projector", "texture",
    "sky", "particle_emitter", "pbr", "shader",
)  # fmt: skip

_FILE_TAGS = ("<uri", "<filename", "<texture", "_map>", "<diffuse", "<normal")
"""By these a text may name a file inside of ``<gazebo>``."""


def problems(document: Document) -> Iterator[object]:
    """What is wrong with the includes, files and collision references of an SDF document."""
    index = survey(document).index
    if "<include" in document.source.text:
        from sdfcheck.robot import include_checks

        yield from include_checks.problems(document)
    if any(name in index for name in _NAMING_FILES):
        from sdfcheck.robot import file_checks

        yield from file_checks.problems(document)
    if "contact" in index or "gripper" in index or "state" in index:
        from sdfcheck.robot import collision_references

        yield from collision_references.problems(document)


def urdf_problems(document: Document) -> Iterator[object]:
    """What is wrong with the files that a URDF document names, in ``<gazebo>`` blocks too."""
    from sdfcheck.formats.urdf import survey as urdf_survey

    index = urdf_survey.survey(document).index
    text = document.source.text
    if (
        "mesh" in index
        or "texture" in index
        or ("gazebo" in index and any(tag in text for tag in _FILE_TAGS))
    ):
        from sdfcheck.robot import file_checks

        yield from file_checks.urdf_problems(document)
