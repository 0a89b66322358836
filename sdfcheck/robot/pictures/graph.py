"""The graphs of a document: what moves with what, what is placed by what, which joint carries which link."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable
from enum import Enum

from sdfcheck.robot.graph import Model, Node, Scope
from sdfcheck.robot.parts.joint import Joint
from sdfcheck.robot.root import Root, root_of
from sdfcheck.source.document import Document
from sdfcheck.source.record import NamedTuple

UNKNOWN = "unknown"


class GraphKind(Enum):
    """Which graph: attachments, poses, or links and joints."""

    FRAMES = "frames"
    POSES = "poses"
    JOINTS = "joints"


class GraphNode(NamedTuple):
    """``kind`` is that of the frame, or ``unknown`` for a reference to nothing; ``note`` its pose."""

    name: str
    kind: str
    note: str = ""

    @property
    def title(self) -> str:
        return self.name if self.name == self.kind else f"{self.kind} {self.name}"


class Edge(NamedTuple):
    """Node numbers: ``upper`` is nearer to the root."""

    upper: int
    lower: int
    label: str = ""


class Graph(NamedTuple):
    """Nodes in document order. In the graph of joints the edges are joints, and lead down."""

    kind: GraphKind
    nodes: tuple[GraphNode, ...]
    edges: tuple[Edge, ...]

    @property
    def below(self) -> defaultdict[int, list[Edge]]:
        """Number of a node → the edges that lead down from it."""
        found: defaultdict[int, list[Edge]] = defaultdict(list)
        for edge in self.edges:
            found[edge.upper].append(edge)
        return found

    @property
    def tops(self) -> tuple[int, ...]:
        """Where to begin to draw: the nodes without one above, then all, as a ring is cut at its first node."""
        carried = {edge.lower for edge in self.edges}
        numbers = range(len(self.nodes))
        return (*(number for number in numbers if number not in carried), *numbers)


def graph(document: Document, kind: GraphKind) -> Graph:
    """A graph of an SDF or URDF document, included models and all."""
    draft = _Draft(root_of(document))
    {GraphKind.FRAMES: _draw_attachments, GraphKind.POSES: _draw_poses, GraphKind.JOINTS: _draw_joints}[kind](
        draft
    )
    return Graph(kind, tuple(draft.nodes), tuple(draft.edges))


class _Draft:
    """A graph in the making."""

    def __init__(self, root: Root) -> None:
        self.nodes: list[GraphNode] = []
        self.edges: list[Edge] = []
        self.names: dict[Node, str] = {}
        """Every node of the robot in document order, and what to call it from the top."""
        self.tops: dict[Node, Scope] = {}
        self._numbers: dict[object, int] = {}
        for top in root.scopes:
            self._name_all(top, top.name if len(root.scopes) > 1 else "")

    def _name_all(self, top: Scope, name: str) -> None:
        """Name a top scope and all that is in it; without recursion."""
        self.names[top], self.tops[top] = name or top.name, top
        waiting = [(top, name)]
        while waiting:
            scope, prefix = waiting.pop()
            nested = []
            for own, node in scope.nodes.items():
                self.names[node] = f"{prefix}::{own}" if prefix else own
                self.tops[node] = top
                if isinstance(node, Model):
                    nested.append((node, self.names[node]))
            waiting += reversed(nested)

    def node(self, node: Node, note: str = "") -> int:
        """The number of a node of the robot."""
        return self._number(node, GraphNode(self.names.get(node, node.name), node.kind, note))

    def unknown(self, name: str, holder: Node) -> int:
        """The number of something that a node refers to and that does not exist."""
        return self._number((holder.scope, name), GraphNode(name, UNKNOWN))

    def _number(self, key: object, node: GraphNode) -> int:
        if key not in self._numbers:
            self._numbers[key] = len(self.nodes)
            self.nodes.append(node)
        return self._numbers[key]

    def tie(self, lower: Node, upper: Node | None, reference: str, label: str) -> None:
        """An edge to what a reference names, or to what it names in vain."""
        number = self.node(lower)
        if upper is not None:
            self.edges.append(Edge(self.node(upper), number, label))
        elif reference:
            self.edges.append(Edge(self.unknown(reference, lower), number, label))


def _draw_attachments(draft: _Draft) -> None:
    from sdfcheck.robot.motion.poses import is_in_urdf

    # The frames of URDF are its links, and the joints lead from one to the next.
    frames = [node for node in draft.names if not (isinstance(node, Joint) and is_in_urdf(node))]
    for node in frames:
        draft.node(node)
    for joint in draft.names:
        if isinstance(joint, Joint) and is_in_urdf(joint) and joint.child is not None:
            draft.tie(joint.child, joint.parent, joint.parent_name, f"joint {joint.name}")
    for node in frames:
        if isinstance(node, Model):
            draft.tie(node, None if node.stands_still else node.attachment, "", "canonical link")
        elif isinstance(node, Joint):
            draft.tie(node, node.attachment, node.child_name, "child")
        elif node.kind == "frame":
            value = getattr(node, "attached_to_value", None)
            reference = value.text.strip() if value is not None else ""
            draft.tie(node, node.attachment, reference, "attached to" if reference else "")


def _draw_poses(draft: _Draft) -> None:
    note = _pose_notes(draft)
    for node in draft.names:
        draft.node(node, note(node))
    for node, top in draft.tops.items():
        if node is not top:
            _tie_to_base(draft, node)


def _tie_to_base(draft: _Draft, node: Node) -> None:
    from sdfcheck.robot.motion.poses import is_in_urdf, urdf_base

    if is_in_urdf(node):
        base, joint = urdf_base(node)
        draft.tie(node, base, "", joint.name if joint is not None else "")
        return
    default = {"joint": "child", "frame": "attached to"}.get(node.kind, "")
    reference = node.base_name
    draft.tie(
        node, node.base, reference, ("relative to" if node.written_base else default) if reference else ""
    )


def _pose_notes(draft: _Draft) -> Callable[[Node], str]:
    """Resolved poses as text: position and roll, pitch, yaw in the frame of the top."""
    from sdfcheck.robot.errors import DescriptionError
    from sdfcheck.robot.motion.rotations import to_rpy

    def note(node: Node) -> str:
        top = draft.tops[node]
        if node is top:
            return ""
        try:
            pose = node.root.poses.reached(top, node)
        except DescriptionError as error:
            return str(error)
        numbers = (*pose[:3, 3], *to_rpy(pose[:3, :3]))
        return " ".join(_short(float(number)) for number in numbers)

    return note


def _short(number: float) -> str:
    """Six digits after the point at most, and never a negative zero."""
    return f"{round(number, 6) + 0.0:.10g}"


def _draw_joints(draft: _Draft) -> None:
    for node in draft.names:
        if node.kind == "link":
            draft.node(node)
    for joint in draft.names:
        if isinstance(joint, Joint):
            kind = (joint.type_value.text.strip() if joint.type_value is not None else "") or "no type"
            upper = _end(draft, joint, joint.parent_name, joint.parent)
            lower = _end(draft, joint, joint.child_name, joint.child)
            if upper is not None and lower is not None:
                draft.edges.append(Edge(upper, lower, f"{draft.names[joint]} ({kind})"))


def _end(draft: _Draft, joint: Joint, name: str, found: Node | None) -> int | None:
    """The node of the link at an end of a joint."""
    if not name:
        return None
    carrier = found.carrier if found is not None else None
    return draft.unknown(name, joint) if carrier is None else draft.node(carrier)
