"""Rings among frames: what is attached to, or placed relative to, itself by way of others."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, cast

from sdfcheck.robot.graph import Frame, Node, Scope
from sdfcheck.robot.parts.joint import Joint
from sdfcheck.robot.values import reference_value
from sdfcheck.source.document import Value
from sdfcheck.source.record import Record

if TYPE_CHECKING:
    from sdfcheck.robot.graph import Part
    from sdfcheck.robot.parts.files import Include
    from sdfcheck.robot.root import Root


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
