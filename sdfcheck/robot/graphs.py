"""The graphs of a document: what moves with what, what is placed by what, which joint carries which link."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from enum import Enum

from sdfcheck.robot.carriers import attachment, carrier, child_of, look_up, own_model, stands_still
from sdfcheck.robot.scopes import WORLD_FRAME, Frame, Scope, scopes
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element
from sdfcheck.source.record import NamedTuple

UNKNOWN = "unknown"


class GraphKind(Enum):
    """Which graph: attachments, poses, or links and joints."""

    FRAMES = "frames"
    POSES = "poses"
    JOINTS = "joints"


class Node(NamedTuple):
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
    nodes: tuple[Node, ...]
    edges: tuple[Edge, ...]


def graph(document: Document, kind: GraphKind) -> Graph:
    """A graph of an SDF or URDF document, included models and all."""
    draft = _Draft()
    roots = root_scopes(document)
    for root in roots:
        draft.name_all(root, root.name if len(roots) > 1 else "")
    if kind is GraphKind.JOINTS:
        _draw_joints(draft)
    elif kind is GraphKind.FRAMES:
        _draw_attachments(draft)
    else:
        _draw_poses(draft, roots)
    return Graph(kind, tuple(draft.nodes), tuple(draft.edges))


def root_scopes(document: Document) -> list[Scope]:
    """The worlds and models at the top of an SDF document, or the robot of a URDF one."""
    root = document.root
    if root is None or root.name != "robot":
        return scopes(document).roots
    scope = Scope("model", root.attributes.get("name", ""), root, None)
    for kind in ("link", "joint"):
        for child in root.children(kind):
            if name := child.attributes.get("name", ""):
                scope.frames.setdefault(name, Frame(kind, name, child, scope))
    return [scope]


class _Draft:
    """A graph in the making."""

    def __init__(self) -> None:
        self.nodes: list[Node] = []
        self.edges: list[Edge] = []
        self.names: dict[Frame, str] = {}
        """Every frame, and what to call it from the top."""
        self._numbers: dict[object, int] = {}

    def name_all(self, scope: Scope, name: str) -> None:
        """Name a scope's own frame and all that is in it; nested scopes without recursion."""
        waiting = [(scope, name)]
        while waiting:
            at, prefix = waiting.pop()
            self.names[at.own] = prefix or at.name
            nested = []
            for own, frame in at.frames.items():
                self.names[frame] = f"{prefix}::{own}" if prefix else own
                if frame.kind == "model" and frame.inner is not None:
                    nested.append((frame.inner, self.names[frame]))
            waiting += reversed(nested)

    def node(self, frame: Frame, note: str = "") -> int:
        """The number of a frame; a model's frame is one from inside and outside."""
        key = frame.inner.own if frame.kind == "model" and frame.inner is not None else frame
        if key not in self._numbers:
            self._numbers[key] = len(self.nodes)
            self.nodes.append(Node(self.names.get(frame, frame.name), frame.kind, note))
        return self._numbers[key]

    def unknown(self, name: str, holder: Frame) -> int:
        """The number of something that a frame refers to and that does not exist."""
        return self._other((holder.scope, name), Node(name, UNKNOWN))

    def world(self, scope: Scope) -> int:
        """The number of the world, also of one around a model that stands alone."""
        while scope.parent is not None:
            scope = scope.parent
        return self.node(scope.own) if scope.kind == "world" else self._other("world", Node("world", "world"))

    def _other(self, key: object, node: Node) -> int:
        if key not in self._numbers:
            self._numbers[key] = len(self.nodes)
            self.nodes.append(node)
        return self._numbers[key]

    def tie(self, lower: Frame, upper: Frame | None, reference: str, label: str) -> None:
        """An edge to what a reference names, or to what it names in vain."""
        number = self.node(lower)
        if upper is not None:
            self.edges.append(Edge(self.node(upper), number, label))
        elif reference:
            self.edges.append(Edge(self.unknown(reference, lower), number, label))

    def distinct(self) -> Iterator[Frame]:
        """All frames in document order, a nested model's once."""
        for frame in list(self.names):
            if not (frame is frame.scope.own and frame.scope.parent is not None):
                yield frame


def _draw_attachments(draft: _Draft) -> None:
    for frame in draft.distinct():
        draft.node(frame)
    for frame in draft.distinct():
        if frame.kind == "model":
            stands = frame.inner is not None and stands_still(frame.inner)
            draft.tie(frame, None if stands else attachment(frame), "", "canonical link")
        elif frame.kind == "joint":
            draft.tie(frame, attachment(frame), child_of(frame), "child")
        elif frame.kind == "frame":
            reference = frame.element.attributes.get("attached_to", "").strip()
            draft.tie(frame, attachment(frame), reference, "attached to" if reference else "")


def _draw_poses(draft: _Draft, roots: list[Scope]) -> None:
    from sdfcheck.robot.poses import base_of, is_urdf, pose_element, reference_of, urdf_base

    note = _pose_notes()
    root_of = {frame: root for root in roots for frame in _below(root)}
    for frame in draft.distinct():
        draft.node(frame, note(frame, root_of.get(frame)))
    for frame in draft.distinct():
        if frame is frame.scope.own:
            continue
        if is_urdf(frame):
            base, joint = urdf_base(frame)
            draft.tie(frame, base, "", joint.attributes.get("name", "") if joint is not None else "")
        elif reference := base_of(frame):
            default = {"joint": "child", "frame": "attached to"}.get(frame.kind, "")
            label = "relative to" if reference_of(pose_element(frame)) else default
            draft.tie(frame, look_up(frame, reference), reference, label)
        else:
            draft.tie(frame, own_model(frame), "", "")


def _below(root: Scope) -> Iterator[Frame]:
    waiting = [root]
    while waiting:
        scope = waiting.pop()
        yield from scope.frames.values()
        waiting += scope.inner


def _pose_notes() -> Callable[[Frame, Scope | None], str]:
    """Resolved poses as text: position and roll, pitch, yaw in the frame of the root."""
    from sdfcheck.robot.poses import PoseError, Poses
    from sdfcheck.robot.rotations import to_rpy

    poses = Poses()

    def note(frame: Frame, root: Scope | None) -> str:
        if root is None:
            return ""
        try:
            pose = poses.reached(root, frame)
        except PoseError as error:
            return str(error)
        numbers = (*pose[:3, 3], *to_rpy(pose[:3, :3]))
        return " ".join(_short(float(number)) for number in numbers)

    return note


def _short(number: float) -> str:
    """Six digits after the point at most, and never a negative zero."""
    return f"{round(number, 6) + 0.0:.10g}"


def _draw_joints(draft: _Draft) -> None:
    frames = list(draft.distinct())
    for frame in frames:
        if frame.kind == "link":
            draft.node(frame)
    for joint in frames:
        if joint.kind == "joint":
            kind = joint.element.attributes.get("type", "").strip() or "no type"
            upper, lower = (_end(draft, joint, role) for role in ("parent", "child"))
            if upper is not None and lower is not None:
                draft.edges.append(Edge(upper, lower, f"{draft.names[joint]} ({kind})"))


def _end(draft: _Draft, joint: Frame, role: str) -> int | None:
    """The node of the link at an end of a joint."""
    name = child_of(joint) if role == "child" else _parent_of(joint.element)
    if not name:
        return None
    found = look_up(joint, name)
    if found is None and name == WORLD_FRAME:
        return draft.world(joint.scope)
    link = carrier(found) if found is not None else None
    if link is None:
        return draft.unknown(name, joint)
    return draft.node(link)


def _parent_of(joint: Element) -> str:
    parent = joint.find("parent")
    if parent is None:
        return ""
    return parent.content or parent.attributes.get("link", "").strip()
