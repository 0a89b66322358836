"""References: the names of frames that poses, attachments and axes write."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import TYPE_CHECKING, cast

from sdfcheck.formats.sdf.survey import survey
from sdfcheck.formats.version import Version
from sdfcheck.robot.graph import Frame, Node, Scope
from sdfcheck.robot.parts.joint import Joint
from sdfcheck.robot.values import lazy, reference_value
from sdfcheck.source.document import Value
from sdfcheck.source.record import Record

if TYPE_CHECKING:
    from sdfcheck.robot.graph import Part
    from sdfcheck.robot.parts.files import Include
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


# Rings among frames: what is attached to, or placed relative to, itself by way of others.

_Step = tuple[Value | None, Node | None]
"""The reference that leads on from a node (None where it is implied), and where to."""


class Ring(Record):
    """Frames that are attached to, or placed relative to, each other in a ring.

    ``role`` is ``attached_to`` or ``relative_to``. ``members`` are the references that make
    the ring, ``names`` the frames that hold them; both begin with the first of this file.
    """

    role: str
    members: tuple[Value, ...]
    names: tuple[str, ...]


def rings(root: Root) -> tuple[Ring, ...]:
    """The rings that references of this file take part in."""
    starts = [
        node
        for reference in root.frame_references
        if reference.role != "expressed_in" and (node := _node(reference.owner)) is not None
    ]
    # A reported ring of attachments contains a frame: rings of joints alone are left out.
    has_frames = bool(root.includes) or any(each.role == "attached_to" for each in root.frame_references)
    attached = _search("attached_to", starts, _attachment) if has_frames else ()
    return (*attached, *_search("relative_to", starts, _placement))


def _node(part: Part) -> Node | None:
    """The node that a part is, or that an include makes."""
    if part.kind == "include":
        return cast("Include", part).node
    return part if isinstance(part, Node) else None


def _attachment(node: Node) -> _Step:
    """The node that a node moves with."""
    value = None
    if isinstance(node, Frame):
        value = node.attached_to_value
    elif isinstance(node, Joint):
        value = node.child_value
    return (None, None) if value is None else (value, node.look_up(value.text.strip()))


def _placement(node: Node) -> _Step:
    """The node that a node is placed relative to: at the end, the model around it."""
    value = _pose_reference(node)
    if value is not None:
        return value, node.look_up(value.text.strip())
    value, on = _attachment(node)
    if value is not None:
        return value, on
    around = node.merged or node.holder
    return None, around if isinstance(around, Node) and around.kind != "world" else None


def _pose_reference(node: Node) -> Value | None:
    """The reference of the pose of a node that something is around."""
    if not isinstance(node.holder, Scope):
        return None
    value = reference_value(node.pose_element)
    return value if value is not None and value.text.strip() else None


def _search(role: str, starts: list[Node], step: Callable[[Node], _Step]) -> list[Ring]:
    found: list[Ring] = []
    done: set[Node] = set()
    for start in starts:
        path: dict[Node, Value | None] = {}
        at: Node | None = start
        while at is not None and at not in done and at not in path:
            path[at], at = step(at)
        if at is not None and at in path:
            nodes = list(path)
            ring = _ring(role, nodes[nodes.index(at) :], path)
            found += [] if ring is None else [ring]
        done.update(path)
    return found


def _ring(role: str, nodes: list[Node], path: Mapping[Node, Value | None]) -> Ring | None:
    if role == "attached_to" and all(isinstance(node, Joint) for node in nodes):
        return None  # what joints lead to is their own matter
    if role == "relative_to" and all(_pose_reference(node) is None for node in nodes):
        return None  # the ring of attachments
    members = [(value, node.name) for node in nodes if (value := path[node]) is not None]
    document = nodes[0].root.document
    own = [at for at, (value, _) in enumerate(members) if value.element.document is document]
    if not own:
        return None  # it is reported in its own file
    first = min(own, key=lambda at: members[at][0].span.start)
    members = members[first:] + members[:first]
    return Ring(role, tuple(value for value, _ in members), tuple(name for _, name in members))
