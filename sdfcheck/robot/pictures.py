"""Pictures of a robot: its tree of links and joints, its frames and its poses, as text, DOT and SVG."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterator
from enum import Enum
from html import escape

from sdfcheck.robot.graph import Joint, Model, Scope
from sdfcheck.robot.part import Node
from sdfcheck.robot.root import Root, root_of
from sdfcheck.source.document import Document
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.visible import cells, visible

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
            named = scope.nodes
            # In URDF a joint may have the name of a link.
            namesakes = [(joint.name, joint) for joint in scope.joints if named.get(joint.name) is not joint]
            for own, node in (*named.items(), *namesakes):
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
    from sdfcheck.robot.motion.poses import is_in_urdf

    if is_in_urdf(node):
        base, joint = node.urdf_base
        draft.tie(node, base, "", joint.get("name") or "" if joint is not None else "")
        return
    default = {"joint": "child", "frame": "attached to"}.get(node.kind, "")
    reference = node.base_name
    draft.tie(
        node, node.base, reference, ("relative to" if node.written_base else default) if reference else ""
    )


def _pose_notes(draft: _Draft) -> Callable[[Node], str]:
    """Resolved poses as text: position and roll, pitch, yaw in the frame of the top."""
    from sdfcheck.robot.motion.poses import to_rpy
    from sdfcheck.source.errors import DescriptionError

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


# Graphs as text: a tree for people, the languages of Graphviz and Mermaid for pictures.

Paint = Callable[[str, str], str]
"""Colors a piece of text; the second word says what it is: kind, label or note."""

_SHAPES = {"link": "box", "joint": "diamond", "model": "folder", "world": "folder", UNKNOWN: "octagon"}


def plain(text: str, what: str) -> str:
    """No color."""
    return text


def tree(graph: Graph, paint: Paint = plain) -> str:
    """One line a node, indented below its parent; a node that occurs again is not unfolded again."""
    below = graph.below
    lines: list[str] = []
    seen: set[int] = set()
    for root in graph.tops:
        if root in seen:
            continue
        stack: list[tuple[int, str, str, str]] = [(root, "", "", "")]
        while stack:
            number, label, branch, indent = stack.pop()
            again = number in seen
            seen.add(number)
            lines.append(branch + _line(graph, number, label, paint) + (" (again)" if again else ""))
            if again:
                continue
            edges = below[number]
            for place, edge in reversed(list(enumerate(edges, 1))):
                is_last = place == len(edges)
                step, deeper = ("└─ ", "   ") if is_last else ("├─ ", "│  ")
                stack.append((edge.lower, edge.label, indent + step, indent + deeper))
    return "".join(f"{line}\n" for line in lines)


def dot(graph: Graph) -> str:
    """For Graphviz."""
    lines = [f"digraph {graph.kind.value} {{", "  node [fontname=sans];", "  edge [fontname=sans];"]
    for number, node in enumerate(graph.nodes):
        shape = _SHAPES.get(node.kind, "ellipse")
        lines.append(f"  n{number} [label={_dot_text(_words(node))}, shape={shape}];")
    for edge in graph.edges:
        start, end = _ends(graph, edge)
        label = f" [label={_dot_text([edge.label])}]" if edge.label else ""
        lines.append(f"  n{start} -> n{end}{label};")
    return "\n".join((*lines, "}", ""))


def mermaid(graph: Graph) -> str:
    """For Mermaid, as GitHub and GitLab show it in Markdown."""
    lines = ["flowchart TD"]
    for number, node in enumerate(graph.nodes):
        lines.append(f"  n{number}[{_mermaid_text(_words(node))}]")
    for edge in graph.edges:
        start, end = _ends(graph, edge)
        label = f"|{_mermaid_text([edge.label])}|" if edge.label else ""
        lines.append(f"  n{start} -->{label} n{end}")
    return "\n".join((*lines, ""))


def _ends(graph: Graph, edge: Edge) -> tuple[int, int]:
    """Arrows point to what a frame refers to, and from parent to child along joints."""
    if graph.kind is GraphKind.JOINTS:
        return edge.upper, edge.lower
    return edge.lower, edge.upper


def _line(graph: Graph, number: int, label: str, paint: Paint) -> str:
    node = graph.nodes[number]
    kind, _, name = node.title.partition(" ")
    text = f"{paint(kind, 'kind')} {visible(name)}".rstrip()
    if label:
        label = paint(visible(label), "label")
        text = f"{label} → {text}" if graph.kind is GraphKind.JOINTS else f"{text} ({label})"
    return f"{text}  {paint(visible(node.note), 'note')}" if node.note else text


def _words(node: GraphNode) -> list[str]:
    return [word for word in (node.title, node.note) if word]


def _dot_text(words: list[str]) -> str:
    escaped = (visible(word).replace("\\", "\\\\").replace('"', '\\"') for word in words)
    return '"' + "\\n".join(escaped) + '"'


def _mermaid_text(words: list[str]) -> str:
    escapes = {"#": "#35;", '"': "#quot;", "<": "#lt;", ">": "#gt;", "&": "#amp;", "`": "#96;"}
    escaped = ("".join(escapes.get(letter, letter) for letter in visible(word)) for word in words)
    return '"' + "<br/>".join(escaped) + '"'


# Graphs as pictures: SVG, layer by layer from left to right.

_CELL = 7.25
"""Pixels of a character of the font."""
_HEIGHT = 24
_LINE = 34
"""Pixels from one node to the next below it."""
_GAP = 48
"""Pixels between a node and the label of the next one."""
_EDGE = 12
_LONGEST = 60
"""Characters of a text that are shown; the whole text appears under the pointer."""

_STYLE = """
svg { color-scheme: light dark; --page: #fff; --ink: #1f2328; --faint: #59636e; --box: #f2f5f8; --wrong: #b42318; }
@media (prefers-color-scheme: dark) {
svg { --page: #14171c; --ink: #e6e8eb; --faint: #9aa4af; --box: #232a33; --wrong: #ff8a80; }
}
.page { fill: var(--page); }
text { font: 12px ui-monospace, "DejaVu Sans Mono", Menlo, Consolas, monospace; fill: var(--ink); }
.label { fill: var(--faint); }
.box { fill: var(--box); stroke: var(--faint); }
.joint { rx: 12px; }
.model, .world { stroke-width: 2; }
.unknown { stroke: var(--wrong); stroke-dasharray: 4 3; }
.edge { fill: none; stroke: var(--faint); }
.again { stroke-dasharray: 4 3; }
.tip { fill: var(--faint); }
"""


class _Place(NamedTuple):
    """Where a node is drawn: the left end of its box, its middle, and its width."""

    x: float
    y: float
    width: float


def svg(graph: Graph) -> str:
    """The picture. Names are text; a node that occurs again is drawn once, with a dashed edge."""
    tree, again = _tree(graph)
    places, width, height = _places(graph, tree)
    lines = [
        (
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:.0f}" height="{height:.0f}" '
            f'viewBox="0 0 {width:.0f} {height:.0f}" role="img">'
        ),
        f"<title>{graph.kind.value}</title>",
        f"<style>{_STYLE}</style>",
        (
            '<defs><marker id="tip" viewBox="0 0 8 8" refX="8" refY="4" markerWidth="8" markerHeight="8" '
            'orient="auto-start-reverse"><path class="tip" d="M0 0L8 4L0 8z"/></marker></defs>'
        ),
        f'<rect class="page" width="{width:.0f}" height="{height:.0f}"/>',
    ]
    for edge in tree:
        lines += _edge(graph, edge, places, is_again=False)
    for edge in again:
        lines += _edge(graph, edge, places, is_again=True)
    for node, place in zip(graph.nodes, places, strict=True):
        lines += _node(node, place)
    return "\n".join((*lines, "</svg>", ""))


def _tree(graph: Graph) -> tuple[list[Edge], list[Edge]]:
    """The edges that reach a node first, in the order of drawing, and the others."""
    below = graph.below
    tree: list[Edge] = []
    again: list[Edge] = []
    seen: set[int] = set()
    for root in graph.tops:
        if root in seen:
            continue
        seen.add(root)
        waiting = below[root][::-1]
        while waiting:
            edge = waiting.pop()
            if edge.lower in seen:
                again.append(edge)
                continue
            seen.add(edge.lower)
            tree.append(edge)
            waiting += below[edge.lower][::-1]
    return tree, again


def _places(graph: Graph, tree: list[Edge]) -> tuple[list[_Place], float, float]:
    """The position of each node, and the size of the picture: parents beside the middle of their leaves."""
    children: defaultdict[int, list[int]] = defaultdict(list)
    depth = [0] * len(graph.nodes)
    for edge in tree:  # from the root down
        children[edge.upper].append(edge.lower)
        depth[edge.lower] = depth[edge.upper] + 1
    widths = [
        _width(node.title) + (_width(node.note) + 2 * _CELL if node.note else 0) + 16 for node in graph.nodes
    ]
    xs = _columns(tree, depth, widths)
    ys = [0.0] * len(graph.nodes)
    order = _order(graph, tree, children)
    row = 0
    for number in order:
        if not children[number]:
            ys[number] = row * _LINE + _LINE / 2
            row += 1
    for number in reversed(order):
        if below := children[number]:
            ys[number] = (ys[below[0]] + ys[below[-1]]) / 2
    places = [_Place(xs[depth[at]], ys[at] + _EDGE, widths[at]) for at in range(len(graph.nodes))]
    right = max((place.x + place.width for place in places), default=0) + _EDGE
    return places, right, row * _LINE + 2 * _EDGE


def _order(graph: Graph, tree: list[Edge], children: dict[int, list[int]]) -> list[int]:
    """All nodes, parents before what is below them."""
    carried = {edge.lower for edge in tree}
    waiting = [number for number in range(len(graph.nodes)) if number not in carried][::-1]
    order: list[int] = []
    while waiting:
        number = waiting.pop()
        order.append(number)
        waiting += children[number][::-1]
    return order


def _columns(tree: list[Edge], depth: list[int], widths: list[float]) -> list[float]:
    """Where each layer begins: after the widest node before it, and the widest label."""
    layers = max(depth, default=0) + 1
    node_width, label_width = [0.0] * layers, [0.0] * layers
    for at, layer in enumerate(depth):
        node_width[layer] = max(node_width[layer], widths[at])
    for edge in tree:
        layer = depth[edge.lower]
        label_width[layer] = max(label_width[layer], _width(edge.label))
    xs = [float(_EDGE)]
    for layer in range(1, layers):
        xs.append(xs[-1] + node_width[layer - 1] + _GAP + label_width[layer])
    return xs


def _edge(graph: Graph, edge: Edge, places: list[_Place], *, is_again: bool) -> Iterator[str]:
    upper, lower = places[edge.upper], places[edge.lower]
    start, end = upper.x + upper.width, lower.x
    bend, line = (2 * _GAP, "") if is_again else (_GAP / 2, f"H{end:.1f}")
    stop = end if is_again else start + _GAP
    path = (
        f"M{start:.1f} {upper.y:.1f}C{start + bend:.1f} {upper.y:.1f} "
        f"{stop - bend:.1f} {lower.y:.1f} {stop:.1f} {lower.y:.1f}{line}"
    )
    # Arrows point to what a frame refers to, and from parent to child along joints.
    tip = "marker-end" if graph.kind is GraphKind.JOINTS else "marker-start"
    yield f'<path class="edge{" again" if is_again else ""}" d="{path}" {tip}="url(#tip)"/>'
    if edge.label and not is_again:
        yield (
            f'<text class="label" x="{end - 12:.1f}" y="{lower.y - 4:.1f}" text-anchor="end">'
            f"{_written(edge.label)}</text>"
        )


def _node(node: GraphNode, place: _Place) -> Iterator[str]:
    yield (
        f'<rect class="box {escape(node.kind)}" x="{place.x:.1f}" y="{place.y - _HEIGHT / 2:.1f}" '
        f'width="{place.width:.1f}" height="{_HEIGHT}" rx="4"/>'
    )
    note = f'<tspan class="label" dx="{2 * _CELL}">{_written(node.note)}</tspan>' if node.note else ""
    yield f'<text x="{place.x + 8:.1f}" y="{place.y + 4:.1f}">{_written(node.title)}{note}</text>'


def _shortened(text: str) -> str:
    text = visible(text)
    return text if len(text) <= _LONGEST else f"{text[: _LONGEST - 1]}…"


def _written(text: str) -> str:
    """As markup; a text that is cut off has the whole of it as its title."""
    short, whole = _shortened(text), visible(text)
    return escape(short) if short == whole else f"{escape(short)}<title>{escape(whole)}</title>"


def _width(text: str) -> float:
    return cells(_shortened(text))[1][-1] * _CELL
