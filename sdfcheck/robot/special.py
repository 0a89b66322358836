"""Parts of the robot that the names of elements alone do not determine."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import chain
from operator import attrgetter
from typing import TYPE_CHECKING

from sdfcheck.formats.sdf.survey import survey

if TYPE_CHECKING:
    from sdfcheck.robot.part import Part
    from sdfcheck.robot.parts.control import Ros2Control
    from sdfcheck.robot.parts.control_component import ControlComponent
    from sdfcheck.robot.root import Root
    from sdfcheck.source.element import Element

_LISTENERS = frozenset({"sensor", "audio_source"})


def _customs(root: Root) -> list[Element]:
    if root.is_urdf:
        from sdfcheck.formats.urdf.survey import survey as urdf_survey

        return urdf_survey(root.document).customs
    return survey(root.document).customs


def _contacts(root: Root) -> Iterator[Part]:
    """The contacts of sensors and sounds; surfaces have contacts of their own, and are many."""
    given = root.elements.get("contact", ())
    return (
        root.part_of(each) for each in given if each.parent is not None and each.parent.name in _LISTENERS
    )


def _control(root: Root) -> Sequence[Ros2Control]:
    return root.each("Ros2Control") if root.is_urdf and root.elements.get("ros2_control") else ()


def _components(root: Root) -> Iterator[ControlComponent]:
    return (component for block in _control(root) for component in block.components)


SPECIAL: dict[str, Callable[[Root], Iterable[object]]] = {
    "Custom": lambda root: root.made_of(found, "Custom") if (found := _customs(root)) else (),
    "Contact": _contacts,
    "ControlComponent": _components,
    "ControlInterface": lambda root: chain.from_iterable(map(attrgetter("interfaces"), _components(root))),
    "ControlTransmission": lambda root: (each for block in _control(root) for each in block.transmissions),
    "Include": attrgetter("includes"),
    "FrameReference": attrgetter("frame_references"),
    "Resource": attrgetter("resources"),
    "Root": lambda root: (root,),
}
"""Class → its parts, where the names of elements alone do not determine them."""
