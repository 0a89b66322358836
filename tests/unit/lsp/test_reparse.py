"""After an edit a long text has the tree and the places that it would have if it were read anew."""

from __future__ import annotations

import gc
import random
import re
from itertools import chain
from pathlib import Path

import pytest

from sdfcheck.lsp.findings import Findings
from sdfcheck.lsp.hover import hover
from sdfcheck.lsp.workspace import Workspace, reparsed, same_ends
from sdfcheck.source.document import Aside, Document
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Source

MODEL = """\
    <model name="m{0}">
      <!-- of {0} -->
      <pose>{0} 0 0 0 0 0</pose>
      <static>true</static><?hint {0}?>
      <link name="l"><visual name="v"><geometry><box><size>1 1 1</size></box></geometry></visual></link>
      <v:tag xmlns:v="http://v" v:a="1 &lt; {0}"><![CDATA[<a> {0}]]></v:tag>
      text
    </model>
"""
WORLD = (
    f'<sdf version="1.9">\n  <world name="w">\n{"".join(map(MODEL.format, range(200)))}  </world>\n</sdf>\n'
)
PIECES = (
    *"<>/ \"'a1\n&",
    "<x/>",
    "</x>",
    "<x>",
    "<!--",
    "-->",
    "<!-- c -->",
    "<v:t a='1'/>",
    "é",
    "]]>",
    "<?hint?>",
)


def shape(document: Document) -> list[object]:
    """All that a tree and its scan say."""
    nodes = [
        *document.prolog,
        *chain.from_iterable(each.nodes for each in document.elements),
        *document.epilog,
    ]
    scan = document.scan
    return [
        [
            (each.name, each.attributes, each.text, each.tail, each.index, each.parent and each.parent.index)
            for each in document.elements
        ],
        [(each.name, each.text, each.tail, each.index, each.parent and each.parent.index) for each in nodes],
        {element.index: prefixes for element, prefixes in document.declared.items()},
        {*document.names} - {"hint"},  # an instruction
        [scan.starts, scan.ends, scan.closes, scan.close_ends, scan.comments],
        all(each.document is document for each in document.elements),
        document.root is document.elements[0],
        [isinstance(each, Aside) for each in nodes],
    ]


@pytest.mark.parametrize("seed", range(3))
def test_the_tree_is_that_of_the_new_text(seed: int) -> None:
    chance, reused = random.Random(seed), 0
    source = Source(Path("w.sdf"), WORLD)
    document = Document(source, Kind.SDF, [])
    for _ in range(60):
        start = chance.randrange(len(source.text))
        end = start + chance.choice((0, 0, 0, 1, 1, 5, 40))
        edited = source.edited(start, end, chance.choice(("", *PIECES)))
        fresh = Document(Source(source.path, edited.text), Kind.SDF, [])
        found = reparsed(document, edited, Kind.SDF)
        if found is None:
            continue
        reused += 1
        assert shape(found) == shape(fresh)
        source, document = edited, found
    assert reused > 5


def looked(path: Path, text: str, findings: Findings | None = None) -> list[tuple[object, ...]]:
    """The findings in a text that was never open, or those that are known of an open one."""
    if findings is None:
        findings = Findings(Workspace())
        findings.lint(findings.workspace.open(path.as_uri(), path, text, 1))
    return [
        (each.code, each.message, each.span.start, each.span.end, [label.span.start for label in each.labels])
        for each in findings.at(path)
    ]


@pytest.mark.parametrize("seed", range(2))
def test_the_findings_are_those_of_the_new_text(seed: int, tmp_path: Path) -> None:
    chance, path, glances, right = random.Random(seed), tmp_path / "w.sdf", 0, 0
    findings = Findings(Workspace())
    buffer = findings.workspace.open(path.as_uri(), path, WORLD, 1)
    findings.lint(buffer)
    for number in range(8):
        text = buffer.source.text
        start = chance.choice([each.start() for each in re.finditer(r"[0-9]|name|link|<pose>", text)])
        edited = buffer.source.edited(
            start, start + chance.choice((0, 1)), chance.choice(("", "x", " 2 ", '"', "<"))
        )
        findings.workspace.write(buffer, edited, number)
        is_seen = findings.glance(buffer)
        seen = looked(path, edited.text, findings)
        findings.lint(buffer)
        known = looked(path, edited.text, findings)
        assert known == looked(path, edited.text)
        glances += is_seen
        right += is_seen and seen == known
        if buffer.made is None or not buffer.made.is_wellformed:
            findings.workspace.write(buffer, Source(path, text), number)
            assert findings.glance(buffer)
            findings.lint(buffer)
    assert right >= glances - 1 > 3


def test_a_glance_finds_a_name_of_another_model(tmp_path: Path) -> None:
    path, findings = tmp_path / "w.sdf", Findings(Workspace())
    buffer = findings.workspace.open(path.as_uri(), path, WORLD, 1)
    findings.lint(buffer)
    before = looked(path, "", findings)
    for model, is_known in (("m9", True), ("m999", False)):
        text = WORLD.replace("<pose>7 ", f'<pose relative_to="{model}">7 ')
        findings.workspace.write(buffer, Source(path, text), 2)
        assert findings.glance(buffer)
        found = looked(path, text, findings)
        assert [each[0] for each in found if each[0] == "FRM001"] == ([] if is_known else ["FRM001"])
        assert len(found) == len(before) + (not is_known)
        place = text.index('"m7"') + 1
        document = findings.near(buffer, place)
        assert document is not None
        shown = hover(document, place)
        assert shown is not None
        assert "m7" in shown.text


ROBOT = (
    '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:arg name="imu" default="false"/>'
    '<link name="base"/><xacro:if value="$(arg imu)"><joint name="j" type="fixed"><parent link="base"/>'
    '<child link="imu"/></joint></xacro:if><material name="m"/></robot>'
)


def test_typing_in_a_robot_with_arguments_leaves_no_rest(tmp_path: Path) -> None:
    path, findings = tmp_path / "r.urdf.xacro", Findings(Workspace())
    buffer = findings.workspace.open(path.as_uri(), path, ROBOT, 1)
    counts = []
    for number in range(18):
        findings.workspace.write(buffer, Source(path, ROBOT + " " * (number % 4)), number)
        assert findings.glance(buffer)
        buffer.tidy()
        if number % 6 == 5:
            gc.collect()
            counts.append(len(gc.get_objects()))
    findings.workspace.close()
    assert counts[-1] - counts[0] < 50, counts


def test_other_arguments_of_a_robot_are_looked_at_when_its_text_rests(tmp_path: Path) -> None:
    path = tmp_path / "r.urdf.xacro"
    text = ROBOT
    findings = Findings(Workspace())
    buffer = findings.workspace.open(path.as_uri(), path, text, 1)
    assert findings.glance(buffer)
    assert not [found for found in looked(path, "", findings) if "imu:=true" in str(found[1])]
    for number, (old, new) in enumerate((("<mat", " <mat"), ("<xacro:if", " <xacro:if"))):
        text = text.replace(old, new)
        findings.workspace.write(buffer, Source(path, text), number)
        assert findings.glance(buffer)
        soon = looked(path, "", findings)
        assert findings.glance(buffer)
        findings.lint(buffer)
        assert looked(path, "", findings) == looked(path, text)
        assert (soon == looked(path, text)) == bool(number)  # what is known already stays where it is
        assert not findings.glance(buffer)
    findings.workspace.close()


@pytest.mark.parametrize(
    ("old", "new", "ends"),
    [
        ("", "", (0, 0)),
        ("abc", "abc", (3, 0)),
        ("aa", "aaa", (2, 0)),
        ("abcd", "abXcd", (2, 2)),
        ("x", "y", (0, 0)),
    ],
)
def test_common_ends_of_two_texts(old: str, new: str, ends: tuple[int, int]) -> None:
    assert same_ends(old, new) == ends == same_ends(new, old)


def test_edits_of_a_long_text_leave_no_rest(tmp_path: Path) -> None:
    path, findings = tmp_path / "w.sdf", Findings(Workspace())
    buffer = findings.workspace.open(path.as_uri(), path, WORLD, 1)
    findings.lint(buffer)
    counts = []
    for number in range(18):
        text = WORLD.replace("<pose>7 ", ("<pose>8 ", "<pose>x ", "<pose ")[number % 3])
        findings.workspace.write(buffer, Source(path, text), number)
        findings.glance(buffer)
        findings.lint(buffer)
        buffer.tidy()
        if number % 6 == 5:
            gc.collect()
            counts.append(len(gc.get_objects()))
    assert counts[-1] - counts[0] < 50, counts
