"""Small things that a conversion keeps, or says that it does not."""

from __future__ import annotations

from pathlib import Path

import pytest
from lxml import etree

from sdfcheck.cli.main import main
from sdfcheck.convert.call import convert
from sdfcheck.convert.ledger import Ledger
from sdfcheck.convert.sdf_to_urdf.extensions import _list
from sdfcheck.convert.urdf_to_sdf.conversion import urdf_to_sdf
from sdfcheck.convert.urdf_to_sdf.options import FixedJoints, Options
from sdfcheck.source.document import read
from tests.unit.robot.files import write

BODY = '<inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'
URDF = (
    f'<robot name="r"><link name="a">{BODY}</link><link name="b">{BODY}</link><joint name="j" type="{{}}">'
    '<origin xyz="0 0 1"/><parent link="a"/><child link="b"/><axis xyz="0 0 1"/>'
    '<limit lower="0" upper="1" effort="1" velocity="1"/>{}</joint>{}</robot>'
)
NESTED = (
    '<sdf version="1.9"><!-- top --><world name="w"><!-- around --><model name="m"><link name="a"/>'
    '<model name="n"><static>{}</static><link name="b">{}</link></model>'
    '<joint name="j" type="fixed"><parent>a</parent><child>n::b</child></joint></model></world></sdf>'
)


def messages(text: str, to: str) -> str:
    return "\n".join(f"{loss.kind.code} {loss.message}" for loss in convert(text, to).losses)


def test_comments_around_a_model_are_kept() -> None:
    text = convert(NESTED.format("false", ""), "urdf").text
    assert text.index("<!-- top -->") < text.index("<!-- around -->") < text.index("<link")


@pytest.mark.parametrize("value", ["true", "1", "TRUE"])
def test_a_static_model_in_one_that_moves_moves(value: str) -> None:
    said = messages(NESTED.format(value, ""), "urdf")
    assert "model `n` is static, and what it is part of is not: it moves with it" in said


@pytest.mark.parametrize("value", ["true", "false"])
def test_whether_a_nested_model_is_static_is_accounted_for(value: str) -> None:
    said = messages(NESTED.format(value, ""), "urdf")
    assert "CNV030" not in said
    assert ("static" in said) == (value == "true")


def test_names_in_plugins_of_nested_links_follow() -> None:
    plugin = '<plugin name="p" filename="f"><link_name>b</link_name></plugin>'
    text = convert(NESTED.format("false", plugin), "urdf").text
    assert "<link_name>n__b</link_name>" in text


@pytest.mark.parametrize(
    ("written", "kept"), [("false", "false"), ("0", "false"), ("true", "true"), ("1", "true")]
)
def test_flags_of_joints(written: str, kept: str) -> None:
    block = f'<gazebo reference="j"><provideFeedback>{written}</provideFeedback></gazebo>'
    text = convert(URDF.format("revolute", "", block), "sdf").text
    assert f"<provide_feedback>{kept}</provide_feedback>" in text


@pytest.mark.parametrize(("name", "count"), [("j", 0), ("k", 1)])
def test_a_frame_takes_the_place_of_a_floating_joint(name: str, count: int) -> None:
    block = f'<gazebo><frame name="{name}" attached_to="a"/></gazebo>'
    assert convert(URDF.format("floating", "", block), "sdf").text.count("<frame") == count


def merged(inside: str, block: str) -> str:
    document = read(URDF.format("fixed", inside, block).encode(), Path("r.urdf"))
    return urdf_to_sdf(document, Options(fixed_joints=FixedJoints.MERGE)).text


@pytest.mark.parametrize(
    ("pose", "moved"),
    [("", "0 0 1 0 0 0"), ("<pose/>", "0 0 1 0 0 0"), ("<pose>1 0 0 0 0 0</pose>", "1 0 1 0 0 0")],
)
def test_a_sensor_of_a_merged_link_stays_in_place(pose: str, moved: str) -> None:
    text = merged("", f'<gazebo reference="b"><sensor name="s" type="imu">{pose}</sensor></gazebo>')
    assert text.count("<link") == 1
    assert f"<pose>{moved}</pose>" in text[text.index("<sensor") :]


def test_the_custom_data_of_a_merged_joint_is_that_of_its_frame() -> None:
    text = merged('<x:bolt xmlns:x="urn:x"/>', "").replace("\n", "")
    frame = text[text.index('<frame name="j"') :].partition("</frame>")[0]
    assert "<x:bolt" in frame
    joint = 'name="j" x:nr="7" xmlns:x="urn:x"'
    document = read(URDF.replace('name="j"', joint).format("fixed", "", "").encode(), Path("r.urdf"))
    done = urdf_to_sdf(document, Options(fixed_joints=FixedJoints.MERGE))
    assert '<frame name="j" attached_to="a" x:nr="7">' in done.text


@pytest.mark.parametrize(
    ("inside", "times"),
    [
        ("<safety_controller k_velocity='1'><!-- why --></safety_controller>", 1),
        ("<calibration rising='0'><!-- why --></calibration>", 1),
        ('<x:bolt xmlns:x="urn:x"><!-- why --></x:bolt>', 1),
    ],
)
def test_a_comment_in_a_part_of_a_joint_is_kept_once(inside: str, times: int) -> None:
    text = convert(URDF.format("revolute", inside, ""), "sdf").text
    assert text.count("<!-- why -->") == times


def test_a_list_of_names_is_cut_after_three() -> None:
    three = {name: f"{name}1" for name in "abc"}
    assert _list(three) == "`a` → `a1`, `b` → `b1`, `c` → `c1`"
    assert _list({**three, "d": "d1"}).endswith("`c` → `c1` …")


def test_a_custom_attribute_that_is_not_in_the_result_is_reported() -> None:
    source = read(b'<robot name="r" xmlns:x="urn:x" x:a="1"/>', Path("r.urdf")).root
    result = read(b'<sdf version="1.9" xmlns:x="urn:x"><model name="r"/></sdf>', Path("r.sdf")).root
    assert source is not None
    assert result is not None
    ledger = Ledger(None, "SDFormat")
    ledger.copy_attribute(source, "x:a")
    with pytest.raises(AssertionError, match="`x:a` of robot `r` is not in the result"):
        ledger.prove(result)


def test_a_part_beside_an_included_model_is_not_a_loss(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    other = (
        '<sdf version="1.9" xmlns:x="urn:x"><x:own>1</x:own><model name="o"><link name="l"/></model>'
        '<light name="s" type="point"/></sdf>'
    )
    main_text = (
        '<sdf version="1.9"><model name="m"><link name="a"/><include><uri>other.sdf</uri></include>'
        '<joint name="j" type="fixed"><parent>a</parent><child>o::l</child></joint></model></sdf>'
    )
    write(tmp_path, {"other.sdf": other, "main.sdf": main_text})
    main(["convert", "sdf-to-urdf", "--isolated", "--losses", "all", str(tmp_path / "main.sdf")])
    said = capsys.readouterr().err
    assert "`x:own` in `sdf` of the included file is left out" in said
    assert "`light` in `sdf` of the included file" not in said


def test_the_frame_of_a_merged_include(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    other = '<sdf version="1.9"><model name="o"><link name="l"/></model></sdf>'
    include = '<include merge="true"><uri>other.sdf</uri><pose>1 0 0 0 0 0</pose></include>'
    model = f'<sdf version="1.12"><model name="m"><link name="a"/>{include}</model></sdf>'
    write(tmp_path, {"other.sdf": other, "model.sdf": model})
    assert main(["print", "--isolated", "--expand-includes", str(tmp_path / "model.sdf")]) == 0
    assert '<pose relative_to="__model__">1 0 0 0 0 0</pose>' in capsys.readouterr().out


TWICE_IN_URDF = (
    f'<robot name="r" xmlns:x="urn:1"><link name="a" x:one="">{BODY}<x:two xmlns:x="urn:2" x:two=""><x:two/>'
    '</x:two><visual xmlns:x="urn:3" x:three=""><geometry><box size="1 1 1"/></geometry><x:three/></visual>'
    '</link><gazebo xmlns:y="urn:4"><y:four/></gazebo></robot>'
)
TWICE_IN_SDF = (
    '<sdf version="1.9" xmlns:x="urn:1"><model name="m" x:one=""><link name="a"><x:two xmlns:x="urn:2" '
    'x:two=""><x:two/></x:two><visual name="v" xmlns:x="urn:3" x:three="" xmlns:y="urn:4" y:four=""><geometry>'
    "<box><size>1 1 1</size></box></geometry><x:three/></visual></link></model></sdf>"
)


@pytest.mark.parametrize(("to", "text"), [("sdf", TWICE_IN_URDF), ("urdf", TWICE_IN_SDF)])
def test_a_prefix_that_is_declared_twice_means_what_it_meant(to: str, text: str) -> None:
    def names(text: str) -> list[str]:
        elements = etree.fromstring(text.encode()).iter("{*}*")
        return sorted(name for each in elements for name in (each.tag, *each.attrib) if name[0] == "{")

    assert names(convert(text, to).text) == names(text)
