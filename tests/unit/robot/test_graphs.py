"""Graphs and how they are written down."""

from __future__ import annotations

from itertools import combinations
from pathlib import Path
from xml.etree import ElementTree

import pytest

from sdfcheck.files.library import Library
from sdfcheck.robot.pictures import Graph, GraphKind, dot, graph, mermaid, svg, tree
from sdfcheck.source.document import read

MODEL = """<model name="m"><link name="a"/><frame name="f" attached_to="a"><pose>0 0 1 0 0 -0</pose></frame>
  <frame name="lost" attached_to="nowhere"/>
  <model name="n"><link name="b"><pose relative_to="__model__">1 0 0 0 0 0.5</pose></link></model>
  <model name="stand"><static>true</static><link name="s"/></model>
  <joint name="j" type="revolute"><parent>world</parent><child>a</child></joint>
  <joint name="k" type="ball"><parent>f</parent><child>n</child></joint></model>"""

TREES = {
    GraphKind.FRAMES: """\
link a
├─ model m (canonical link)
├─ frame f (attached to)
└─ joint j (child)
model stand
link n::b
└─ model n (canonical link)
   └─ joint k (child)
link stand::s
unknown nowhere
└─ frame lost (attached to)
""",
    GraphKind.POSES: """\
model m
├─ link a  0 0 0 0 0 0
│  ├─ frame f (attached to)  0 0 1 0 0 0
│  └─ joint j (child)  0 0 0 0 0 0
├─ model n  0 0 0 0 0 0
│  ├─ joint k (child)  0 0 0 0 0 0
│  └─ link n::b (relative to)  1 0 0 0 0 0.5
└─ model stand  0 0 0 0 0 0
   └─ link stand::s  0 0 0 0 0 0
unknown nowhere
└─ frame lost (attached to)  there is no frame 'nowhere' in m
""",
    GraphKind.JOINTS: """\
link stand::s
world
└─ j (revolute) → link a
   └─ k (ball) → link n::b
""",
}


def draw(text: str, kind: GraphKind) -> Graph:
    whole = text if text.startswith("<robot") else f'<sdf version="1.12">{text}</sdf>'
    return graph(read(whole.encode(), Path("example")), kind)


@pytest.mark.parametrize("kind", GraphKind)
def test_trees(kind: GraphKind) -> None:
    assert tree(draw(MODEL, kind)) == TREES[kind]


def test_rings_are_cut_once() -> None:
    frames = '<frame name="p" attached_to="q"/><frame name="q" attached_to="p"/>'
    text = f'<model name="m"><link name="a"/>{frames}</model>'
    assert tree(draw(text, GraphKind.FRAMES)).splitlines()[2:] == [
        "frame p",
        "└─ frame q (attached to)",
        "   └─ frame p (attached to) (again)",
    ]


def test_urdf() -> None:
    text = (
        '<robot name="r"><link name="a"/><link name="b"/><joint name="j" type="fixed"><origin xyz="0 0 1"/>'
        '<parent link="a"/><child link="b"/></joint></robot>'
    )
    assert tree(draw(text, GraphKind.JOINTS)) == "link a\n└─ j (fixed) → link b\n"
    assert "   └─ link b (j)  0 0 1 0 0 0\n" in tree(draw(text, GraphKind.POSES))


def test_several_roots_are_distinguished() -> None:
    text = '<world name="v"><model name="m"><link name="l"/></model></world><world name="w"/>'
    assert tree(draw(text, GraphKind.JOINTS)) == "link v::m::l\n"


def test_included_models(tmp_path: Path) -> None:
    (tmp_path / "arm.sdf").write_text('<sdf version="1.12"><model name="arm"><link name="l"/></model></sdf>')
    file = tmp_path / "world.sdf"
    file.write_text('<sdf version="1.12"><world name="w"><include><uri>arm.sdf</uri></include></world></sdf>')
    document = Library().document(file)
    assert document is not None
    assert tree(graph(document, GraphKind.POSES)) == (
        "world w\n└─ model arm  0 0 0 0 0 0\n   └─ link arm::l  0 0 0 0 0 0\n"
    )


ODD = """<model name="m"><link name='a"&lt;b\\'/><link name="c"/>
  <joint name="j" type="fixed"><parent>c</parent><child>a"&lt;b\\</child></joint></model>"""


def test_graphviz() -> None:
    assert dot(draw(ODD, GraphKind.JOINTS)).splitlines()[3:] == [
        '  n0 [label="link a\\"<b\\\\", shape=box];',
        '  n1 [label="link c", shape=box];',
        '  n1 -> n0 [label="j (fixed)"];',
        "}",
    ]


def test_mermaid() -> None:
    assert mermaid(draw(ODD, GraphKind.JOINTS)).splitlines() == [
        "flowchart TD",
        '  n0["link a#quot;#lt;b\\"]',
        '  n1["link c"]',
        '  n1 -->|"j (fixed)"| n0',
    ]


def test_arrows_point_to_what_a_frame_refers_to() -> None:
    text = '<model name="m"><link name="a"/><frame name="f" attached_to="a"/></model>'
    assert '  n2 -->|"attached to"| n1' in mermaid(draw(text, GraphKind.FRAMES)).splitlines()


def test_long_chains() -> None:
    frames = "".join(f'<frame name="f{n}" attached_to="f{n + 1}"/>' for n in range(1500))
    text = f'<model name="m"><link name="l"/>{frames}<frame name="f1500" attached_to="l"/></model>'
    assert len(tree(draw(text, GraphKind.FRAMES)).splitlines()) == 1503


def test_nothing() -> None:
    assert tree(draw("", GraphKind.JOINTS)) == ""


SVG = "{http://www.w3.org/2000/svg}"


def boxes(picture: str) -> dict[str, tuple[float, float, float, float]]:
    """Title of a node → left, top, right and bottom of its box, as the picture has them."""
    root = ElementTree.fromstring(picture)
    texts = [each for each in root.iter(f"{SVG}text") if each.get("class") is None]
    rects = [each for each in root.iter(f"{SVG}rect") if each.get("class") != "page"]
    found = {}
    for text, rect in zip(texts, rects, strict=True):
        x, y, width, height = (float(rect.get(key, "")) for key in ("x", "y", "width", "height"))
        found[text.text or ""] = (x, y, x + width, y + height)
    return found


@pytest.mark.parametrize("kind", GraphKind)
def test_boxes_of_a_picture_do_not_overlap(kind: GraphKind) -> None:
    graph = draw(MODEL, kind)
    picture = svg(graph)
    places = boxes(picture)
    assert set(places) == {node.title for node in graph.nodes}
    page = ElementTree.fromstring(picture)
    for left, top, right, bottom in places.values():
        assert 0 < left < right < float(page.get("width", ""))
        assert 0 < top < bottom < float(page.get("height", ""))
    for one, other in combinations(places.values(), 2):
        assert one[2] < other[0] or other[2] < one[0] or one[3] < other[1] or other[3] < one[1]
    for edge in graph.edges:
        assert places[graph.nodes[edge.upper].title][2] < places[graph.nodes[edge.lower].title][0]


def test_arrows_of_a_picture_point_as_in_the_other_formats() -> None:
    for kind, mark, other in (
        (GraphKind.JOINTS, 'marker-end="', 'marker-start="'),
        (GraphKind.FRAMES, 'marker-start="', 'marker-end="'),
    ):
        graph = draw(MODEL, kind)
        assert svg(graph).count(mark) == len(graph.edges) > 1
        assert other not in svg(graph)


def test_marks_of_mermaid_in_names_are_written_as_entities() -> None:
    (_, node) = mermaid(
        draw("<model name='m'><link name='#&lt;&gt;&amp;`'/></model>", GraphKind.JOINTS)
    ).splitlines()
    assert node == '  n0["link #35;#lt;#gt;#amp;#96;"]'


def test_a_ring_is_drawn_once_with_a_dashed_edge() -> None:
    frames = '<frame name="p" attached_to="q"/><frame name="q" attached_to="p"/>'
    picture = svg(draw(f'<model name="m"><link name="a"/>{frames}</model>', GraphKind.FRAMES))
    assert sorted(boxes(picture)) == ["frame p", "frame q", "link a", "model m"]
    assert picture.count('class="edge again"') == 1


def test_names_in_a_picture_are_text() -> None:
    name = "&lt;/text>&lt;script>alert(1)&lt;/script>&#x9b;" + "x" * 100
    picture = svg(draw(f'<model name="m"><link name="{name}"/></model>', GraphKind.JOINTS))
    assert "<script" not in picture
    (text,) = (each for each in ElementTree.fromstring(picture).iter(f"{SVG}text"))
    assert (text.text or "").endswith("…")
    assert text[0].text == "link </text><script>alert(1)</script><U+009B>" + "x" * 100


def test_a_long_chain_is_drawn() -> None:
    links = "".join(f'<link name="l{at}"/>' for at in range(3000))
    joint = '<joint name="j{0}" type="fixed"><parent link="l{0}"/><child link="l{1}"/></joint>'
    joints = "".join(joint.format(at, at + 1) for at in range(2999))
    assert len(boxes(svg(draw(f'<robot name="r">{links}{joints}</robot>', GraphKind.JOINTS)))) == 3000


def test_an_empty_graph_is_a_picture() -> None:
    assert boxes(svg(Graph(GraphKind.JOINTS, (), ()))) == {}
