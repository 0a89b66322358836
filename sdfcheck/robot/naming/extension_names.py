"""Names in the ``<gazebo>`` blocks of a URDF robot: they are siblings of those in what the block is about."""

from __future__ import annotations

from typing import TYPE_CHECKING

from sdfcheck.formats.sdf.survey import survey
from sdfcheck.robot.naming.name import Name, Namesakes
from sdfcheck.robot.parts.joint import UNCONVERTED
from sdfcheck.source.element import Element, Value

if TYPE_CHECKING:
    from collections.abc import Iterable

    from sdfcheck.robot.root import Root

_MERGED = frozenset({"plugin", "visual", "collision"})
"""In a block these share names freely: a shape there is what is added to those of the link."""


def extension_names(root: Root) -> dict[Element, list[Name]]:
    """Element → the names that the blocks add to it; an element in a block, or what the block is about."""
    found: dict[Element, list[Name]] = {}
    for parent, children in survey(root.document).named.items():
        at, free = parent, frozenset({"plugin"})
        if parent.name == "gazebo":
            at, free = _subject(root, parent), _MERGED
        found.setdefault(at, []).extend(
            Name(kind, text.strip(), Value(element, "name", text), at, is_extension=True)
            for kind, text, element in children
            if text.strip() and kind not in free and ":" not in kind
        )
    return found


def extended_namesakes(root: Root, given: Iterable[Name]) -> list[Namesakes]:
    """The names in blocks that siblings have already; ``given`` are those of the robot's links and joints."""
    found: list[Namesakes] = []
    for parent, names in extension_names(root).items():
        taken: dict[str, Name] = {}
        if parent is root.element:
            for name in given:
                if name.makes_frame and not _is_dropped(name):
                    taken.setdefault(name.name, name)
        for name in names:
            first = taken.setdefault(name.name, name)
            if first is not name:
                found.append(Namesakes(first, name))
    return found


def _is_dropped(name: Name) -> bool:
    """Is it of a joint that libsdformat has no place for? Then the name is free."""
    return name.kind == "joint" and name.value.element.get("type") in UNCONVERTED


def _subject(root: Root, block: Element) -> Element:
    """The link, joint or robot that a block is about."""
    from sdfcheck.robot.parts.gazebo import GazeboBlock

    part = root.part_of(block)
    subject = part.subject if isinstance(part, GazeboBlock) else None
    return block if subject is None else subject.element
