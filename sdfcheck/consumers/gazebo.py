"""What keeps libsdformat from reading the `<gazebo>` blocks of a robot."""

from __future__ import annotations

from collections.abc import Iterator

from sdfcheck.formats.sdf.problems import MissingAttribute
from sdfcheck.formats.urdf.survey import survey
from sdfcheck.robot.parts.gazebo_blocks import extension_parts
from sdfcheck.source.document import Document


def problems(document: Document) -> Iterator[MissingAttribute]:
    """The plugins without a file, for which it refuses the robot."""
    for block in survey(document).top("gazebo"):
        for element in extension_parts(block):
            if element.name == "plugin" and not element.attributes.get("filename"):
                yield MissingAttribute(element, "filename", empty="filename" in element.attributes)
