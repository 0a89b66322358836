"""Parts of URDF in macros of xacro, where no robot shows them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from sdfcheck.robot.graph import Part
from sdfcheck.robot.parts.files import Pieces
from sdfcheck.robot.parts.gazebo import GazeboBlock
from sdfcheck.robot.parts.joint import Joint
from sdfcheck.robot.parts.link import Link
from sdfcheck.robot.root import root_of
from sdfcheck.source.document import Document, Element
from sdfcheck.xacro.static.macro_survey import TRANSPARENT

_OWNERS: dict[str, type[Link | Joint]] = {
    "axis": Joint,
    "collision": Link,
    "inertial": Link,
    "limit": Joint,
    "visual": Link,
}
"""Class → the class of the holder: a macro without one is taken for it."""


def parts_in_macros(document: Document, elements: Iterable[Element]) -> Iterator[Part]:
    """The parts of links and joints, plugins and files, that elements in macros of a document for xacro make."""
    robot = root_of(document).scopes[0]
    pieces = Pieces(robot, elements)
    if pieces.resources:
        yield pieces
        yield from pieces.resources
    for element in pieces.elements:
        if element.name == "gazebo":
            yield from GazeboBlock(robot, element).plugins
        owner = _OWNERS.get(element.name)
        place = next((each for each in element.around if each.name not in TRANSPARENT), None)
        if owner is None or place is None:
            continue
        holder = robot.registry.get(place)
        if holder is None:
            holder = robot.registry[place] = owner(robot, place)
        yield holder.part(element)
