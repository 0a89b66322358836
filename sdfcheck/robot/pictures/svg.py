"""Graphs as pictures: SVG, layer by layer from left to right."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from html import escape

from sdfcheck.robot.pictures.graph import Edge, Graph, GraphKind, GraphNode
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.visible import cells, visible

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


def _short(text: str) -> str:
    text = visible(text)
    return text if len(text) <= _LONGEST else f"{text[: _LONGEST - 1]}…"


def _written(text: str) -> str:
    """As markup; a text that is cut off has the whole of it as its title."""
    short, whole = _short(text), visible(text)
    return escape(short) if short == whole else f"{escape(short)}<title>{escape(whole)}</title>"


def _width(text: str) -> float:
    return cells(_short(text))[1][-1] * _CELL
