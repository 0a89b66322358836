"""Each item of a source is in the result, or a loss at its place."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from sdfcheck.convert.ledger import TEXT, Ledger
from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.migrate.migrate import sdf_to_sdf
from sdfcheck.convert.result import Conversion
from sdfcheck.convert.sdf_to_urdf import convert
from sdfcheck.convert.urdf_to_sdf.conversion import urdf_to_sdf
from sdfcheck.convert.urdf_to_sdf.options import FixedJoints, Options
from sdfcheck.files.library import Library, SearchPaths
from sdfcheck.formats.version import Version
from sdfcheck.source.document import Document, Element, read

FIXTURES = Path(__file__).parents[3] / "fixtures" / "robots"
_TAG = re.compile(r"<(?![?!/])([\w:.-]+)((?:\s+[\w:.-]+\s*=\s*(?:\"[^\"]*\"|'[^']*'))*)\s*(/?)>")

URDF = """\
<robot name="r"><material name="red"><color rgba="1 0 0 1"/></material>
<link name="a"><inertial><origin xyz="0 0 0"/><mass value="1"/>
<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>
<visual><origin xyz="0 0 0.1"/><geometry><box size="1 1 1"/></geometry><material name="red"/></visual>
<collision><geometry><mesh filename="a.stl"/></geometry></collision></link>
<link name="b"><inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
<link name="c"/><link name="d"/>
<joint name="j" type="revolute"><parent link="a"/><child link="b"/><origin xyz="1 0 0"/><axis xyz="0 0 1"/>
<limit lower="-1" upper="1" effort="1" velocity="1"/><dynamics damping="0.1"/><mimic joint="k"/></joint>
<joint name="k" type="continuous"><parent link="b"/><child link="c"/><axis xyz="1 0 0"/>
<limit effort="1" velocity="1"/></joint>
<joint name="f" type="fixed"><parent link="c"/><child link="d"/><origin rpy="0 0 1"/></joint>
<gazebo reference="a"><mu1>0.5</mu1><sensor name="s" type="imu"><imu><topic>t</topic></imu></sensor></gazebo>
<gazebo reference="j"><provideFeedback>true</provideFeedback></gazebo>
<gazebo><plugin name="p" filename="f"><x>1</x></plugin></gazebo></robot>
"""
SDF = """\
<sdf version="1.12"><world name="w"><model name="m"><pose>1 0 0 0 0 0</pose>
<frame name="f"><pose>0 0 1 0 0 0</pose></frame>
<link name="a"><inertial><pose>0 0 0.1 0 0 0</pose><mass>1</mass>
<inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia></inertial>
<visual name="v"><pose>0 0 0.1 0 0 0</pose><geometry><box><size>1 1 1</size></box></geometry>
<material><ambient>0 1 0 1</ambient><diffuse>1 0 0 1</diffuse></material></visual>
<collision name="c"><geometry><capsule><radius>1</radius><length>1</length></capsule></geometry>
<surface><friction><ode><mu>1</mu></ode></friction></surface></collision>
<sensor name="s" type="imu"><update_rate>10</update_rate></sensor></link><link name="b"><pose relative_to="j"/></link>
<model name="n"><pose>0 1 0 0 0 0</pose><link name="l"/><frame name="g" attached_to="l"/></model>
<joint name="j" type="revolute"><pose relative_to="a">1 0 0 0 0 0</pose><parent>a</parent><child>b</child>
<axis><xyz>0 0 1</xyz><limit><lower>-1</lower><upper>1</upper></limit><dynamics><damping>1</damping></dynamics>
</axis></joint>
<joint name="u" type="universal"><parent>b</parent><child>n::l</child><axis><xyz>1 0 0</xyz></axis>
<axis2><xyz>0 1 0</xyz></axis2></joint>
</model><light name="sun" type="directional"><direction>0 0 -1</direction></light></world></sdf>
"""


def planted(text: str) -> str:
    """A document with a custom attribute and, where there is room, a custom element in every element."""
    numbers = iter(range(10000))

    def plant(tag: re.Match[str]) -> str:
        name, attributes, end = tag.groups()
        number = next(numbers)
        declared = ' xmlns:hid="https://example.org/hid"' if number == 0 else ""
        inside = f'<hid:e{number:03d} x="1">see <hid:i>the</hid:i> words {number}.</hid:e{number:03d}>'
        start = f'<{name}{declared}{attributes} hid:a{number:03d}="v"'
        return f"{start}>{inside}</{name}>" if end else f"{start}>" + (inside if _has_room(tag) else "")

    return _TAG.sub(plant, text)


def _has_room(tag: re.Match[str]) -> bool:
    """Is there no value, which must come first?"""
    return tag.string[tag.end() : tag.end() + 1] in {"<", "\n"}


def document_of(text: str, suffix: str) -> Document:
    return read(text.encode(), Path(f"source{suffix}"))


def missing(source: str, done: Conversion) -> list[str]:
    """The planted names that are neither in the result nor in a loss."""
    said = done.text + "".join(loss.message for loss in done.losses)
    return [name for name in re.findall(r"hid:[ae]\d+", source) if name not in said]


def cut(done: Conversion) -> Iterator[str]:
    """The elements of the result that have lost words."""
    for name, number in re.findall(r"<(hid:e(\d+)) ", done.text):
        if f"see <hid:i>the</hid:i> words {int(number)}.</{name}>" not in done.text:
            yield name


WAYS: dict[str, tuple[str, str, Callable[[Document], Conversion]]] = {
    "urdf-to-sdf": (URDF, ".urdf", lambda document: urdf_to_sdf(document, Options())),
    "urdf-to-sdf-merged": (
        URDF,
        ".urdf",
        lambda document: urdf_to_sdf(document, Options(fixed_joints=FixedJoints.MERGE)),
    ),
    "urdf-to-1.4": (URDF, ".urdf", lambda document: urdf_to_sdf(document, Options(Version(1, 4)))),
    "sdf-to-urdf": (SDF, ".sdf", convert),
    "to-1.4": (SDF, ".sdf", lambda document: sdf_to_sdf(document, Version(1, 4))),
    "to-1.6": (SDF, ".sdf", lambda document: sdf_to_sdf(document, Version(1, 6))),
    "to-1.8": (SDF, ".sdf", lambda document: sdf_to_sdf(document, Version(1, 8))),
    "to-1.11": (SDF, ".sdf", lambda document: sdf_to_sdf(document, Version(1, 11))),
}


@pytest.mark.parametrize("way", WAYS)
def test_custom_data_everywhere(way: str) -> None:
    text, suffix, convert_it = WAYS[way]
    source = planted(text)
    assert len(set(re.findall(r"hid:[ae]\d+", source))) > 50
    done = convert_it(document_of(source, suffix))
    assert not missing(source, done)
    assert not list(cut(done))


def test_most_of_it_is_carried() -> None:
    for way, least in (("urdf-to-sdf", 60), ("sdf-to-urdf", 40), ("to-1.11", 90)):
        text, suffix, convert_it = WAYS[way]
        source = planted(text)
        done = convert_it(document_of(source, suffix))
        names = set(re.findall(r"hid:[ae]\d+", source))
        carried = sum(name in done.text for name in names)
        assert carried * 100 >= least * len(names), (way, carried, len(names))


def test_it_comes_back() -> None:
    """From SDFormat to URDF and back, and down and up again."""
    source = planted(SDF)
    there = convert(document_of(source, ".sdf"))
    back = urdf_to_sdf(document_of(there.text, ".urdf"), Options())
    said = back.text + "".join(loss.message for loss in (*there.losses, *back.losses))
    assert not [name for name in re.findall(r"hid:[ae]\d+", source) if name not in said]
    down = sdf_to_sdf(document_of(source, ".sdf"), Version(1, 6))
    up = sdf_to_sdf(document_of(down.text, ".sdf"), Version(1, 12))
    said = up.text + "".join(loss.message for loss in (*down.losses, *up.losses))
    assert not [name for name in re.findall(r"hid:[ae]\d+", source) if name not in said]


def test_attributes_without_prefix_are_kept_as_urdfs() -> None:
    done = urdf_to_sdf(
        document_of('<robot name="r"><link name="a" type="laser"/></robot>', ".urdf"), Options()
    )
    assert 'urdf:type="laser"' in done.text
    (loss,) = (loss for loss in done.losses if loss.kind is LossKind.KEPT_AS_EXTENSION)
    assert loss.span.source.text[loss.span.start : loss.span.end] == "type"


def test_stray_text_and_second_elements_are_losses() -> None:
    text = '<robot name="r">stray<link name="a"><inertial><mass value="1"/><mass value="2"/>\
<inertia ixx="1" iyy="1" izz="1"/></inertial></link></robot>'
    messages = [loss.message for loss in urdf_to_sdf(document_of(text, ".urdf"), Options()).losses]
    assert any("the text `stray` in robot `r`" in message for message in messages)
    assert any("there is another one before it" in message for message in messages)


def test_an_element_that_is_not_a_shape_is_not_called_one() -> None:
    text = URDF.replace('<box size="1 1 1"/>', '<box size="1 1 1"/><material name="red"/>')
    messages = [loss.message for loss in urdf_to_sdf(document_of(text, ".urdf"), Options()).losses]
    assert "material `red` in `geometry` is left out: it means nothing there" in messages


@pytest.mark.parametrize(
    ("inside", "lost"),
    [
        (
            '<link name="x"/><joint name="x" type="fixed"><parent>world</parent><child>x</child></joint>',
            "has its name",
        ),
        (
            (
                '<link name="a"><visual name="v"><geometry><box><size>1 1 1</size></box>'
                "<sphere><radius>1</radius></sphere></geometry></visual></link>"
            ),
            "`sphere` in `geometry` is left out: there is another shape before it",
        ),
        (
            '<link name="a"><inertial><mass>1<x/>kg<y/>net</mass></inertial></link>',
            "the text `net` in `mass` is left out: it has no place in URDF",
        ),
    ],
)
def test_a_tag_that_another_one_hides_is_a_loss(inside: str, lost: str) -> None:
    done = convert(document_of(f'<sdf version="1.9"><model name="m">{inside}</model></sdf>', ".sdf"))
    assert any(loss.message.endswith(lost) for loss in done.losses), done.losses


def test_comments_of_merged_joints_are_kept() -> None:
    text = URDF.replace('<joint name="f" type="fixed">', '<joint name="f" type="fixed"><!-- glued -->')
    done = urdf_to_sdf(document_of(text, ".urdf"), Options(fixed_joints=FixedJoints.MERGE))
    assert "<!-- glued -->" in done.text


class TestLedger:
    def of(self, text: str) -> tuple[Ledger, Element]:
        document = document_of(text, ".sdf")
        assert document.root is not None
        words = {"sdf": frozenset({"version"}), "model": frozenset({"name"}), "pose": frozenset({TEXT})}
        return Ledger(words, "URDF"), document.root

    def test_an_item_that_nobody_entered_fails(self) -> None:
        ledger, root = self.of('<sdf version="1.12"><model name="m"/></sdf>')
        ledger.take(root)
        with pytest.raises(AssertionError, match="model `m` in `sdf`"):
            ledger.close(root)

    def test_a_value_without_a_word_is_a_loss(self) -> None:
        ledger, root = self.of('<sdf version="1.12" a="1" b:c="2"><!-- x --><light name="l"/></sdf>')
        ledger.take(root)
        ledger.close(root)
        assert [loss.message for loss in ledger.losses] == [
            "attribute `a` of `sdf` is left out: it has no place in URDF",
            "attribute `b:c` of `sdf` is left out: it has no place in URDF",
            "a comment in `sdf` is left out: `x`",
            "URDF has no light `l` in `sdf`",
        ]

    def test_data_entered_as_copied_must_exist(self) -> None:
        ledger, root = self.of('<sdf version="1.12"><a:b c:d="1"/></sdf>')
        ledger.copy(next(root.children()))
        _, same = self.of('<sdf version="1.12"><model name="m"><a:b c:d="1"/></model></sdf>')
        ledger.prove(same)
        _, other = self.of('<sdf version="1.12"><a:b/></sdf>')
        with pytest.raises(AssertionError, match="`c:d` of `a:b` is not in the result"):
            ledger.prove(other)

    def test_users_get_a_loss(self, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.undo()
        ledger, root = self.of('<sdf version="1.12"><model name="m"/></sdf>')
        ledger.take(root)
        ledger.close(root)
        assert [loss.kind for loss in ledger.losses] == [LossKind.UNACCOUNTED_ITEM]


INCLUDING = """<sdf version="1.9" xmlns:hid="u"><model name="m" hid:a1="1"><link name="base"/>
<include hid:a2="2"><uri>lamp</uri><name>x</name><hid:e1/><!-- one --></include>
<include merge="true" hid:a3="2"><uri>lamp</uri><hid:e2/></include></model></sdf>"""
LAMP = """<sdf version="1.9" xmlns:hid="u" hid:a4="1"><hid:e3/><model name="lamp" hid:a5="1"><hid:e4/>
<link name="l" hid:a6="1"/></model></sdf>"""


@pytest.mark.parametrize("way", ["1.4", "1.6", "1.8", "urdf"])
def test_custom_data_of_what_is_included(way: str, tmp_path: Path) -> None:
    (tmp_path / "lamp").mkdir()
    (tmp_path / "lamp" / "model.sdf").write_text(LAMP)
    (tmp_path / "lamp" / "model.config").write_text("<model><name>lamp</name><sdf>model.sdf</sdf></model>")
    document = read(INCLUDING.encode(), tmp_path / "m.sdf")
    document.library = Library(SearchPaths(models=(tmp_path,)))
    version = Version.parse(way)
    done = convert(document) if version is None else sdf_to_sdf(document, version)
    assert not missing(INCLUDING, done)
    if way != "1.8":  # where the file stays what it is, but for what is merged
        assert not missing(LAMP, done)


def test_equal_attributes_that_come_to_one_place_are_merged() -> None:
    text = (
        '<sdf version="1.9" xmlns:hid="u" hid:a1="1" hid:a2="1"><model name="m" hid:a1="1" hid:a2="2">'
        '<link name="l"/></model></sdf>'
    )
    done = convert(document_of(text, ".sdf"))
    assert [loss.message for loss in done.losses if "hid:" in loss.message] == [
        "attribute `hid:a2` of `sdf` is left out: there is another one"
    ]
