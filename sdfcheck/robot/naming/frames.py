"""References: the names of frames that poses, attachments and axes write."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from sdfcheck.formats.sdf.survey import survey
from sdfcheck.formats.version import Version
from sdfcheck.robot.graph import Node, Scope
from sdfcheck.robot.values import lazy
from sdfcheck.source.document import Value

if TYPE_CHECKING:
    from sdfcheck.robot.graph import Part
    from sdfcheck.robot.root import Root
    from sdfcheck.source.document import Element
    from sdfcheck.source.text import Span


_SEVEN = Version(1, 7)


class FrameReference:
    """The name of a frame in SDFormat, as it is written.

    ``role`` is ``relative_to`` (of a pose, also where it was called ``frame``),
    ``attached_to`` (of a frame) or ``expressed_in`` (of an axis).
    """

    __slots__ = ("__dict__", "role", "root", "value")

    def __init__(self, root: Root, role: str, value: Value) -> None:
        self.root = root
        self.role = role
        self.value = value

    def __repr__(self) -> str:
        return f"FrameReference({self.role} {self.name!r})"

    @property
    def name(self) -> str:
        """The name that it writes."""
        return self.value.text.strip()

    @property
    def span(self) -> Span:
        """The place of the name."""
        return self.value.span

    @property
    def owner_element(self) -> Element:
        """The element that it is about: what has the pose, the frame, or the ``xyz`` of the axis."""
        element = self.value.element
        parent = element.parent if element.name == "pose" else None
        return element if parent is None else parent

    @property
    def owner(self) -> Part:
        """The part that it is about."""
        return self.root.part_of(self.owner_element)

    @lazy
    def scope(self) -> Scope | None:
        """The world or model in which the name is looked up; None around what is at the top of the file."""
        return self.root.scope_of(self.owner_element)

    @lazy
    def target(self) -> Node | None:
        """The node that it names; None if the name is unknown."""
        return None if self.scope is None else self.scope.resolve(self.name)

    @property
    def is_extension(self) -> bool:
        """Is it in a ``<gazebo>`` block of a URDF file?"""
        return self.root.is_urdf

    @property
    def is_unresolved(self) -> bool:
        """Does it surely name nothing?"""
        return self.scope is not None and self.scope.lacks(self.name)


def frame_references(root: Root) -> Iterator[FrameReference]:
    """The references to frames in SDFormat, also in ``<gazebo>`` blocks; those that nobody reads are left out."""
    surveyed = survey(root.document)
    for pose in surveyed.index.get("pose", ()):
        for name, text in pose.attributes.items():
            is_read = name == "relative_to" or (name == "frame" and surveyed.version < _SEVEN)
            if is_read and text.strip():
                reference = FrameReference(root, "relative_to", Value(pose, name, text))
                if reference.owner_element.name != "inertial" and not _is_in_state(pose):
                    yield reference
    for kind, role in (("xyz", "expressed_in"), ("frame", "attached_to")):
        for element in surveyed.index.get(kind, ()):
            value = element.attribute(role)
            if value is not None and value.text.strip() and not _is_in_state(element):
                yield FrameReference(root, role, value)


def _is_in_state(element: Element) -> bool:
    """Is it in a ``<state>``, whose frames libsdformat does not read?"""
    return any(around.name == "state" for around in element.around)
