"""What refers to parts of a URDF robot by name: extensions."""

from __future__ import annotations

from collections.abc import Iterator

from sdfcheck.formats.suggest import suggest_in
from sdfcheck.formats.urdf.survey import UrdfSurvey, survey
from sdfcheck.formats.urdf.table import is_expression
from sdfcheck.robot.robot_problems import UnreferencedExtension
from sdfcheck.robot.urdf_tree import tree
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element


def problems(document: Document) -> Iterator[object]:
    """Everything wrong with references in a URDF document, in no particular order."""
    surveyed = survey(document)
    if surveyed.root is None:
        return
    robot = tree(document)
    # A name that joints give to a link, too, is reported with them.
    known = {*robot.links, *robot.joint_named, *robot.unknown_ends}
    for block in surveyed.top("gazebo"):
        yield from _extension(known, surveyed, block)


def _extension(known: set[str], surveyed: UrdfSurvey, block: Element) -> Iterator[object]:
    value = block.attribute("reference")
    if value is not None and value.text and value.text not in known and not is_expression(value.text):
        yield UnreferencedExtension(
            value, suggest_in(surveyed.document, value.text, known), _kind(surveyed, value.text)
        )


def _kind(surveyed: UrdfSurvey, name: str) -> str | None:
    """What else in the robot has that name."""
    for kind in ("visual", "collision", "material", "robot"):
        if any(element.attributes.get("name") == name for element in surveyed.index.get(kind, ())):
            return kind
    return None
