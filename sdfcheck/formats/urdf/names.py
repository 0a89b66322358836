"""Names of URDF that are empty or blank."""

from __future__ import annotations

from collections.abc import Iterator

from sdfcheck.formats.sdf.problems import EmptyName
from sdfcheck.formats.urdf.survey import survey
from sdfcheck.source.document import Document

_NAMED = ("link", "joint", "material")


def problems(document: Document) -> Iterator[EmptyName]:
    """The empty names of the robot, its links, joints and materials."""
    surveyed = survey(document)
    if surveyed.root is None:
        return
    for element in (surveyed.root, *(element for kind in _NAMED for element in surveyed.top(kind))):
        name = element.attribute("name")
        if name is not None and not name.text.strip():
            yield EmptyName(name)
