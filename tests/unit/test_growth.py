"""Twice as much of anything takes twice as much work: lines of code are counted, and what C does for one of them."""

from __future__ import annotations

import gc
from pathlib import Path

import pytest

from benchmarks.growth import DIMENSIONS, SERIES, DidNotRun, Dimension, Series, exponent, seconds_of, work
from sdfcheck.lint.call import lint
from sdfcheck.source.document import Element
from sdfcheck.source.text import Source

SIZE = 30
LARGER = dict.fromkeys(
    ("joints without links", "frames attached to nothing", "materials that are nowhere"), 400
)
"""Up to some effort, unknown names are compared with all names that are there."""
STEEP = 1.15
"""Linear work adds 2 times as much from 2n to 4n as from n to 2n, quadratic work 4 times."""
SLACK = 1000
"""Work that is done once, such as looking into caches, may differ a little."""


MEASURED = 2.6
"""The same for robots with meshes, of which some quick work is done for all pairs of links."""
TREES = (
    "chain of revolute joints",
    "chain of fixed joints",
    "links on one link",
    "mimicking joints",
    "frames attached in a chain",
    "models nested in each other",
)
"""In these a walk from each part to the root shows only in larger documents."""
SIZES = {**dict.fromkeys(DIMENSIONS, SIZE), **LARGER, **dict.fromkeys(TREES, 100)}


@pytest.mark.parametrize(("name", "size"), SIZES.items())
def test_work_grows_with_the_size(name: str, size: int) -> None:
    dimension = DIMENSIONS.get(name) or SERIES[name].dimension
    work(dimension, SIZE)
    once, twice, four_times = (work(dimension, size * factor) for factor in (1, 2, 4))
    assert four_times - twice <= 2 * STEEP * (twice - once) + SLACK


MESH = '<visual><geometry><mesh filename="a.obj"/></geometry></visual>'
LINK = f"""<link name="l@">{MESH}</link><joint name="j#" type="revolute"><parent link="l#"/><child link="l@"/>
<origin xyz="# 0 0"/><axis xyz="0 1 0"/><limit lower="-1" upper="1" effort="1" velocity="1"/></joint>"""


@pytest.mark.parametrize("step", [0.1, 3])
def test_work_on_a_chain_of_meshes_grows_with_its_length(
    step: float, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Its links touch, or each is apart from all others."""
    (tmp_path / "a.obj").write_text("v 0 0 0\nv 0.1 0 0\nv 0 0.01 0.01\nf 1 2 3\n")
    monkeypatch.chdir(tmp_path)

    def chain(n: int) -> str:
        links = (
            LINK.replace("@", str(at + 1)).replace('"# 0', f'"{step} 0').replace("#", str(at))
            for at in range(n)
        )
        return f'<robot name="r"><link name="l0">{MESH}</link>{"".join(links)}</robot>'

    dimension = Dimension("a.urdf", chain)
    work(dimension, SIZE)
    once, twice, four_times = (work(dimension, 60 * factor) for factor in (1, 2, 4))
    assert four_times - twice <= MEASURED * (twice - once)


class Searched(str):
    """A text that notes when something is looked for in all of it."""

    __slots__ = ("searches",)

    def __init__(self, text: str) -> None:
        self.searches: list[object] = []

    def __contains__(self, words: object) -> bool:
        self.searches.append(words)
        return str(words) in str(self)


@pytest.mark.parametrize("name", DIMENSIONS)
def test_the_whole_text_is_searched_as_often_in_long_texts(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    texts: list[Searched] = []
    begin = Source.__init__

    def note(source: Source, path: Path, text: str) -> None:
        texts.append(Searched(text))
        begin(source, path, texts[-1])

    monkeypatch.setattr(Source, "__init__", note)
    dimension = DIMENSIONS[name]

    def searches(n: int) -> int:
        texts.clear()
        lint(dimension.text(n), name=dimension.file, isolated=True, target=dimension.target)
        return sum(len(text.searches) for text in texts)

    searches(10)
    assert searches(120) <= searches(40) + 5


@pytest.mark.parametrize("name", DIMENSIONS)
def test_children_are_looked_through_as_often(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    looked = 0
    find = Element.find

    def note(element: Element, name: str) -> Element | None:
        nonlocal looked
        found = find(element, name)
        looked += len(element.nodes) if found is None else element.nodes.index(found)
        return found

    monkeypatch.setattr(Element, "find", note)
    dimension = DIMENSIONS[name]

    def children(n: int) -> int:
        nonlocal looked
        looked = 0
        lint(dimension.text(n), name=dimension.file, isolated=True, target=dimension.target)
        return looked

    children(10)
    assert children(120) <= 3.5 * children(40) + 20


def test_there_are_many_dimensions() -> None:
    assert len(DIMENSIONS) >= 40


STEEP_TIME = 1.5
"""Well above the noise of small documents, and well below 2, the exponent of a search through everything."""


@pytest.mark.parametrize(
    ("name", "command"),
    [
        ("collisions of a link", "convert urdf-to-sdf"),
        ("collisions of a link", "diff"),
        ("chain of fixed joints", "convert urdf-to-sdf --fixed-joints merge"),
        ("frames attached in a chain", "convert sdf-to-urdf"),
        ("ros2_control blocks", "lint"),
    ],
)
def test_processor_time_of_commands_grows_with_the_size(name: str, command: str) -> None:
    series = SERIES[name]
    gc.disable()  # as the program as good as does
    try:
        seconds_of(command, series, 5)
        floor = min(seconds_of(command, series, 5) for _ in range(2))
        powers = []
        for _ in range(3):
            small, large = (max(seconds_of(command, series, n) - floor, 0.02) for n in (400, 1600))
            powers.append(exponent(small, large, 4))
            if powers[-1] < STEEP_TIME:
                break
    finally:
        gc.enable()
    assert min(powers) < STEEP_TIME, powers


def test_a_command_that_does_not_run_is_not_measured() -> None:
    broken = Series(Dimension("a.urdf", lambda n: "<robot" * n), ("print",))
    with pytest.raises(DidNotRun, match="exit code 2"):
        seconds_of("print", broken, 5)
