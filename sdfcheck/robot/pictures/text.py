"""Graphs as text: a tree for people, the languages of Graphviz and Mermaid for pictures."""

from __future__ import annotations

from collections.abc import Callable

from sdfcheck.robot.pictures.graph import UNKNOWN, Edge, Graph, GraphKind, GraphNode
from sdfcheck.source.visible import visible

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
