"""SRDF and its robot: its references and values are checked against the robot that has most of its names."""

from __future__ import annotations

import time
from pathlib import Path

import pytest

import sdfcheck
from sdfcheck.files.library import Library
from sdfcheck.robot.semantics import descriptions_of, semantics_in
from sdfcheck.source.sniff import Kind
from sdfcheck.xacro.language import may_become

LIMIT = '<limit lower="-1" upper="1" effort="5" velocity="2"/>'
ROBOT = (
    '<robot name="arm"{0}><link name="base"/><link name="upper"/>'
    f'<joint name="shoulder" type="revolute"><parent link="base"/><child link="upper"/>{LIMIT}</joint></robot>'
)
ARM = '<group name="arm"><joint name="shoulder"/><chain base_link="base" tip_link="upper"/></group>'


@pytest.fixture
def package(tmp_path: Path) -> Path:
    (tmp_path / "package.xml").write_text("<package><name>p</name></package>")
    (tmp_path / "arm.urdf").write_text(ROBOT.format(""))
    return tmp_path


def found(folder: Path, text: str, name: str = "arm.srdf", robot: str = "arm") -> list[tuple[str, str]]:
    (folder / name).write_text(
        f'<robot name="{robot}" xmlns:xacro="http://ros.org/wiki/xacro">{text}</robot>'
    )
    run = sdfcheck.lint(folder / name, isolated=True, select=["SRD"])
    return [(each.code, each.span.text) for each in run.diagnostics]


def state(value: str, joint: str = "shoulder") -> str:
    return f'{ARM}<group_state name="home" group="arm"><joint name="{joint}" value="{value}"/></group_state>'


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (ARM, []),
        (ARM + '<group name="more"><link name="uper"/></group>', [("SRD001", "uper")]),
        (ARM + '<disable_collisions link1="base" link2="hand"/>', [("SRD001", "hand")]),
        (ARM + '<end_effector name="e" group="hand" parent_link="upper"/>', [("SRD002", "hand")]),
        (ARM + ARM, [("SRD004", "arm")]),
        (state("0.5"), []),
        (state("1.5"), [("SRD006", "1.5")]),
        (state("1,5"), [("SRD005", "1,5")]),
        (state("1 0"), [("SRD005", "1 0")]),
        (state("0", "root_joint"), []),
        (state("${v}"), []),
        (ARM + "<gripper/><chain/>", []),
    ],
)
def test_references_and_values(package: Path, text: str, expected: list[tuple[str, str]]) -> None:
    assert found(package, text) == expected


def test_nothing_is_said_of_a_robot_that_is_not_found(package: Path) -> None:
    assert found(package, ARM + '<passive_joint name="other"/>', robot="leg") == []


def test_a_robot_without_most_of_the_names_is_another_one(package: Path) -> None:
    text = '<group name="g"><link name="base"/><link name="x"/><link name="y"/><link name="z"/></group>'
    assert found(package, text) == []


@pytest.mark.parametrize("name", ["arm.urdf.xacro", "arm.urdf"])
def test_the_robot_and_the_semantics_may_be_xacro(package: Path, name: str) -> None:
    (package / "arm.urdf").unlink()
    xacro = ' xmlns:xacro="http://ros.org/wiki/xacro"><xacro:property name="top" value="1"/'
    (package / name).write_text(ROBOT.format(xacro).replace('upper="1"', 'upper="${top}"'))
    assert found(package, state("1.5")) == [("SRD006", "1.5")]
    macro = (
        '<xacro:macro name="pose" params="at"><group_state name="home" group="arm">'
        '<joint name="shoulder" value="${at}"/></group_state></xacro:macro><xacro:pose at="7"/>'
    )
    assert found(package, ARM + macro, "arm.srdf.xacro") == [("SRD006", "${at}")]
    assert found(package, macro.replace('at="7"', 'att="7"'), "part.srdf.xacro") == []


LAUNCH = """
from launch.substitutions import Command
def generate_launch_description():
    robot = Command(["xacro ", "arm.urdf.xacro", " name:=", "arm"])
    semantics = Command(["xacro ", "arm.srdf.xacro", " name:=", "arm"])
"""
NAMED = (
    '<robot name="$(arg name)" xmlns:xacro="http://ros.org/wiki/xacro"><xacro:arg name="name" default="arm"/>'
)


def test_robot_and_semantics_are_expanded_as_they_are_launched(package: Path) -> None:
    (package / ".git").mkdir()
    (package / "arm.urdf").unlink()
    (package / "arm.urdf.xacro").write_text(ROBOT.format("").replace('<robot name="arm">', NAMED))
    file = package / "arm.srdf.xacro"
    file.write_text(f"{NAMED}{state('1.5')}</robot>")

    def codes() -> list[str]:
        return [each.code for each in sdfcheck.lint(file, isolated=True, select=["SRD"]).diagnostics]

    assert codes() == []
    (package / "arm.launch.py").write_text(LAUNCH)
    assert codes() == ["SRD006"]


@pytest.mark.parametrize(("default", "expected"), [("true", []), ("false", [("SRD001", "hand")])])
def test_the_robot_is_expanded_with_the_arguments_of_the_semantics(
    package: Path, default: str, expected: list[tuple[str, str]]
) -> None:
    (package / "arm.urdf").unlink()
    hand = '<xacro:if value="$(arg hand)"><link name="${side}hand"/></xacro:if></robot>'
    xacro = (
        ' xmlns:xacro="http://ros.org/wiki/xacro"><xacro:arg name="hand" default="false"/>'
        '<xacro:property name="side" value=""/'
    )
    (package / "arm.urdf.xacro").write_text(ROBOT.format(xacro).replace("</robot>", hand))
    text = f'<xacro:arg name="hand" default="{default}"/>{ARM}<group name="g"><link name="hand"/></group>'
    assert found(package, text, "arm.srdf.xacro") == expected


def test_another_robot_of_the_name_is_no_stranger_while_one_cannot_be_expanded(package: Path) -> None:
    leg = '<group name="leg"><joint name="knee"/></group>'
    assert found(package, leg) == [("SRD007", "robot")]
    xacro = ' xmlns:xacro="http://ros.org/wiki/xacro"><xacro:include filename="$(find nowhere)/leg.xacro"/'
    (package / "leg.urdf.xacro").write_text(ROBOT.format(xacro))
    assert found(package, leg) == []


def test_descriptions_of_the_robot_come_by_nearness(package: Path) -> None:
    folder = package / "deep"
    folder.mkdir()
    for place in (folder, package):
        (place / "arm.srdf").write_text(f'<robot name="arm">{ARM}</robot>')
        (place / "arm.urdf").write_text(ROBOT.format(""))
    for place, order in ((folder, [folder, package]), (package, [package, folder])):
        document = Library().document(place / "arm.srdf", Kind.SRDF)
        assert document is not None
        (semantics,) = semantics_in(document)
        folders = [each.path.parent for each in descriptions_of(semantics)]
        assert folders[:2] == order


@pytest.mark.parametrize(
    "given",
    ["xacro_args: side:=left hand:=true", "xacro_args:\n      side:=left\n      hand:=true\n  srdf: x"],
)
def test_the_robot_is_expanded_with_the_arguments_of_the_assistant(package: Path, given: str) -> None:
    (package / "q").mkdir()
    (package / "q" / "package.xml").write_text("<package><name>q</name></package>")
    (package / ".git").mkdir()
    made = ROBOT.format("").replace("shoulder", "$(arg side)_shoulder")
    made = made.replace("<robot ", '<robot xmlns:xacro="http://ros.org/wiki/xacro" ').replace(
        "</robot>", '<xacro:if value="$(arg hand)"><link name="hand"/></xacro:if></robot>'
    )
    (package / "arm.urdf").unlink()
    (package / "q" / "arm.urdf.xacro").write_text(made)
    wrong = ARM.replace("shoulder", "left_shoulder") + '<group name="g"><link name="hnd"/></group>'
    assert found(package, wrong) == []
    settings = f"a:\n  urdf:\n    package: q\n    relative_path: arm.urdf.xacro\n    {given}\n"
    (package / ".setup_assistant").write_text(settings)
    assert found(package, wrong) == [("SRD001", "hnd")]
    other = f"{settings}\n  SRDF:\n    relative_path: config/{{}}.srdf\n"
    (package / ".setup_assistant").write_text(other.format("arm"))
    assert found(package, wrong) == [("SRD001", "hnd")]
    (package / ".setup_assistant").write_text(other.format("leg"))
    assert found(package, wrong) == [("SRD001", "hnd")]
    (package / "config").mkdir()
    (package / "config" / "leg.srdf").touch()
    assert found(package, wrong) == []


@pytest.mark.parametrize(
    ("added", "expected"),
    [
        ("", [("SRD001", "hnd")]),
        ('<link name="hand"/>', [("SRD001", "hnd")]),
        ('<link name="hnd"/>', []),
        ('<xacro:include filename="$(find cameras)/hands.xacro"/><xacro:hand name="hnd"/>', []),
    ],
)
def test_the_package_of_the_file_adds_to_the_robot_of_the_assistant(
    package: Path, added: str, expected: list[tuple[str, str]]
) -> None:
    (package / ".git").mkdir()
    configured = package / "moveit"
    for name in ("moveit", "q"):
        (package / name).mkdir()
        (package / name / "package.xml").write_text(f"<package><name>{name}</name></package>")
    (package / "arm.urdf").rename(package / "q" / "arm.urdf")
    (configured / ".setup_assistant").write_text("urdf:\n  package: q\n  relative_path: arm.urdf\n")
    (configured / "arm.urdf.xacro").write_text(
        '<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">'
        f'<xacro:include filename="$(find q)/arm.urdf"/>{added}</robot>'
    )
    wrong = ARM + '<group name="g"><link name="hnd"/></group>'
    assert [each for each in found(configured, wrong) if each[0].startswith("SRD")] == expected


def test_the_robot_of_the_assistant_has_another_name(package: Path) -> None:
    (package / ".git").mkdir()
    configured = package / "moveit"
    for name in ("moveit", "q"):
        (package / name).mkdir()
        (package / name / "package.xml").write_text(f"<package><name>{name}</name></package>")
    (package / "arm.urdf").rename(package / "q" / "arm.urdf")
    assert found(configured, ARM, robot="my_arm") == []
    (configured / ".setup_assistant").write_text("urdf:\n  package: q\n  relative_path: arm.urdf\n")
    assert found(configured, ARM, robot="my_arm") == [("SRD007", "my_arm")]
    assert found(configured, ARM.replace("shoulder", "hip"), robot="my_arm") == []


def test_another_robot_of_the_name_is_not_taken_while_that_of_the_assistant_is_not_here(
    package: Path,
) -> None:
    (package / "package.xml").write_text("<package><name>q</name></package>")
    (package / ".git").mkdir()
    wrong = ARM + '<group name="more"><link name="uper"/></group>'
    (package / ".setup_assistant").write_text("urdf:\n  package: q\n  relative_path: made/arm_2.urdf\n")
    assert found(package, ARM) == []
    assert found(package, wrong) == []
    (package / ".setup_assistant").write_text("urdf:\n  package: nowhere\n  relative_path: arm_2.urdf\n")
    assert found(package, wrong) == []
    (package / ".setup_assistant").write_text("urdf:\n  package: q\n  relative_path: made/arm.urdf\n")
    assert found(package, wrong) == [("SRD001", "uper")]


def test_a_robot_of_another_name_is_found_by_the_name_of_its_file(package: Path) -> None:
    (package / "other.urdf").write_text(ROBOT.format("").replace('"arm"', '"leg"'))
    virtual = '<virtual_joint name="float" type="floating" parent_frame="map" child_link="base"/>'
    outside = state("1.5") + virtual
    assert found(package, outside, robot="my_arm") == [("SRD006", "1.5")]
    assert found(package, outside, name="hand.srdf", robot="my_arm") == []
    assert found(package, outside + '<passive_joint name="knee"/>', robot="my_arm") == []


_TWICE = "".join(
    f'<group name="g{n}"><group name="g{n + 1}"/><group name="g{n + 1}"/></group>' for n in range(30)
)
_CHAIN = "".join(f'<group name="g{n}"><group name="g{n + 1}"/></group>' for n in range(10_000))
_END = '<end_effector name="e" group="g0" parent_group="g0" parent_link="upper"/>'


@pytest.mark.parametrize(
    ("text", "name", "expected"),
    [
        (_TWICE + '<group name="g30"><link name="upper"/></group>' + _END, "arm", ["SRD009"]),
        (_CHAIN + '<group name="g10000"><link name="upper"/></group>' + _END, "arm", []),
        (ARM, "${a}".join("a" * 40), []),
    ],
    ids=["twice", "too many", "name"],
)
def test_groups_and_names_do_not_take_long(package: Path, text: str, name: str, expected: list[str]) -> None:
    (package / "other.urdf").write_text(ROBOT.format("").replace('name="arm"', f'name="{"a" * 100}b"'))
    (package / ".setup_assistant").write_text("urdf:\n" * 3 + "\n" * 100_000)
    begin = time.process_time()
    assert [code for code, _ in found(package, text, robot=name)] == expected
    assert time.process_time() - begin < 5


@pytest.mark.parametrize(
    ("written", "name", "may_be"),
    [
        ("arm", "arm", True),
        ("arm", "arms", False),
        ("${a}", "arm", False),
        ("${a}_arm", "left_arm", True),
        ("${a}_arm", "_arm", False),
        ("arm_${a}", "arm_left", True),
        ("arm_${a}", "arm_", False),
        ("${a}_arm_${b}", "left_arm_2", True),
        ("${a}_arm_${b}", "_arm_2", False),
        ("${a}_arm_${b}", "left_arm_", False),
        ("the_${a}x${b}_arm", "the_xxx_arm", True),
        ("the_${a}x${b}_arm", "the_xx_arm", False),
        ("${a}_a", "_a_a", True),
    ],
)
def test_a_name_with_expressions_may_be_another(written: str, name: str, *, may_be: bool) -> None:
    assert may_become(written, name) is may_be


HAND = (
    '<robot xmlns:xacro="http://ros.org/wiki/xacro"><xacro:macro name="hand" params="side"><link name="${side}_hand"/>'
    '<joint name="${side}_wrist" type="fixed"><parent link="upper"/><child link="${side}_hand"/></joint>'
    '</xacro:macro><xacro:macro name="foot" params="side"><link name="${side}_foot"/></xacro:macro></robot>'
)


def test_names_that_another_argument_brings_are_not_unknown(package: Path) -> None:
    (package / "arm.urdf").unlink()
    (package / "hand.xacro").write_text(HAND)
    optional = (
        ' xmlns:xacro="http://ros.org/wiki/xacro"><xacro:arg name="hand" default="false"/>'
        '<xacro:if value="$(arg hand)"><xacro:include filename="hand.xacro"/><xacro:hand side="left"/></xacro:if'
    )
    (package / "arm.urdf.xacro").write_text(ROBOT.format(optional))
    group = '<group name="g"><link name="left_hand"/><link name="left_foot"/><link name="left_fand"/></group>'
    assert found(package, ARM + ARM.replace("arm", "b") + group) == [
        ("SRD001", "left_foot"),  # nothing calls its macro
        ("SRD001", "left_fand"),
    ]


@pytest.mark.parametrize("root", ['name="$(arg name)"', 'name="arm"'])
def test_a_robot_of_the_package_that_cannot_be_expanded_is_likely_the_one(package: Path, root: str) -> None:
    (package / "other").mkdir()
    (package / "arm.urdf").rename(package / "other/arm.urdf")
    own = package / "own"
    own.mkdir()
    (own / "package.xml").write_text("<package><name>own</name></package>")
    text = ARM + '<group name="more"><link name="uper"/></group>'
    assert found(own, text) == [("SRD001", "uper")]
    robot = f'<robot {root} xmlns:xacro="http://ros.org/wiki/xacro"><xacro:include filename="$(find lost)/a.xacro"/>'
    (own / "arm.urdf.xacro").write_text(f"{robot}</robot>")
    assert found(own, text) == []


def test_a_robot_whose_name_an_argument_gives(package: Path) -> None:
    named = ' xmlns:xacro="http://ros.org/wiki/xacro"><xacro:arg name="name" default="arm"/'
    text = ROBOT.format(named).replace('name="arm"', 'name="$(arg name)"')
    (package / "arm.urdf").unlink()
    (package / "robot.urdf.xacro").write_text(text.replace('<robot name="$(arg name)"', '<robot name="${n}"'))
    assert found(package, ARM + '<group name="more"><link name="uper"/></group>') == []
    (package / "robot.urdf.xacro").write_text(
        text.replace("<link", '<xacro:property name="n" value="1"/><link', 1).replace(
            '<robot name="$(arg name)"', "<robot name=\"${'a' + 'rm'}\""
        )
    )
    assert found(package, ARM + '<group name="more"><link name="uper"/></group>') == [("SRD001", "uper")]


def test_names_of_files_that_another_argument_includes(package: Path) -> None:
    (package / "arm.urdf").unlink()
    (package / "tools").mkdir()
    (package / "tools/pen_macro.xacro").write_text(
        HAND.replace("_hand", "_pen").replace('name="hand"', 'name="pen"')
    )
    optional = (
        ' xmlns:xacro="http://ros.org/wiki/xacro"><xacro:arg name="tool" default=""/>'
        '<xacro:arg name="off" default="1"/><xacro:unless value="$(arg off)">'
        '<xacro:include filename="tools/$(arg tool)_macro.xacro"/><xacro:pen side="left"/></xacro:unless'
    )
    (package / "arm.urdf.xacro").write_text(ROBOT.format(optional))
    group = '<group name="g"><link name="left_pen"/><link name="left_fen"/></group>'
    assert found(package, ARM + ARM.replace("arm", "b") + group) == [("SRD001", "left_fen")]


def test_a_file_with_the_name_of_a_robot_beside_its_own(package: Path) -> None:
    (package / "leg.urdf").write_text(
        ROBOT.format("").replace('name="arm"', 'name="leg"').replace("upper", "thigh")
    )
    text = ARM.replace("upper", "thigh") + '<group name="more"><link name="thigh"/><link name="thy"/></group>'
    assert found(package, text, name="leg.srdf") == [("SRD001", "thy")]
