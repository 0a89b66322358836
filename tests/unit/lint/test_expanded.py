"""A xacro file is linted as it is written and as what it expands to."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

import sdfcheck
from sdfcheck.files.library import Library
from sdfcheck.lint.diagnostic import Diagnostic, Severity
from sdfcheck.lint.engine import Dispatch
from sdfcheck.lint.expanded import lint_xacro
from sdfcheck.lint.rulebook.packs import load_index
from sdfcheck.lint.select import ActiveRules
from sdfcheck.source.document import read
from sdfcheck.source.sniff import Kind
from sdfcheck.xacro.expansion import Expander
from sdfcheck.xacro.static.analysis import problems
from sdfcheck.xacro.static.definitions import is_robot

HEAD = '<sdf version="1.12" xmlns:xacro="http://www.ros.org/wiki/xacro">'
LEG = (
    '<xacro:macro name="leg" params="side mass">\n'
    '<link name="${side}"><inertial><mass>${mass}</mass></inertial></link>'
)


@pytest.fixture(scope="module")
def expander() -> Iterator[Expander]:
    with Expander() as one:
        yield one


def lint(expander: Expander | None, path: Path, text: str, *sets: dict[str, str]) -> list[Diagnostic]:
    path.write_text(text)
    index = load_index()
    document = read(path.read_bytes(), path, Kind.XACRO)
    document.library = Library()
    return lint_xacro(document, Dispatch(index, ActiveRules(index.facts, {})), expander, sets)


def test_a_defect_in_a_macro_is_said_once_in_its_body(tmp_path: Path, expander: Expander) -> None:
    calls = "".join(f'\n<xacro:leg side="{side}" mass="heavy"/>' for side in "abc")
    text = f'{HEAD}<model name="m">{LEG}</xacro:macro>{calls}</model></sdf>'
    found = [d for d in lint(expander, tmp_path / "r.sdf.xacro", text) if d.span.text == "${mass}"]
    assert len(found) == 1
    assert found[0].message.endswith("(in 3 expansions)")
    assert found[0].span.begin.line == 2
    assert [origin.span.begin.line for origin in found[0].origins] == [3]


def test_the_chain_is_that_of_the_call_at_fault(tmp_path: Path, expander: Expander) -> None:
    masses = ("1", "heavy", "2")
    calls = "".join(f'\n<xacro:leg side="s{n}" mass="{mass}"/>' for n, mass in enumerate(masses))
    text = f'{HEAD}<model name="m">{LEG}</xacro:macro>{calls}</model></sdf>'
    found = [d for d in lint(expander, tmp_path / "r.sdf.xacro", text) if d.span.text == "${mass}"]
    assert [origin.span.begin.line for d in found for origin in d.origins] == [4]


NUMBERS = (
    "<xacro:property name='radius' value='0,05'/>\n<xacro:property name='height' value='0.1 m'/>\n"
    "<xacro:property name='gap' value='${radius}'/>\n<xacro:property name='side' value='left'/>\n"
    "<xacro:macro name='ball' params='name r far:=${height}'><link name='${name}'><visual>"
    "<origin xyz='0 0 ${far / 2}'/><geometry><sphere radius='${r * 2}'/></geometry></visual></link>"
    "<joint name='${name}_joint' type='fixed'><origin xyz='0 0 ${-r}'/><parent link='base'/>"
    "<child link='${name}'/></joint></xacro:macro>\n<link name='base'/>\n"
    "<xacro:ball name='a' r='${gap}'/>\n<xacro:ball name='b' r='5cm' far='1'/>\n"
    "<xacro:ball name='c' r='1' far='1'/>\n"
)


def test_a_value_that_is_no_number_is_said_where_it_is_given_once(tmp_path: Path, expander: Expander) -> None:
    text = f'<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">\n{NUMBERS}</robot>'
    found = [d for d in lint(expander, tmp_path / "r.urdf.xacro", text) if d.severity is Severity.ERROR]
    assert [(d.span.begin.line, d.span.text) for d in found] == [(2, "0,05"), (3, "0.1 m"), (9, "5cm")]
    assert all("is not a number" in d.message for d in found)


ONE_MISTAKE = {
    "<xacro:property name='1st' value='1'/><link name='${first}_link'/>": ["XAC001"],
    "<xacro:macro name='m' paramss='n'><link name='${n}'/></xacro:macro><xacro:m n='a'/>": ["XAC011"],
    "<xacro:macro name='m' params='n $(arg o'><link name='${n}${o}'/></xacro:macro><xacro:m n='a' o='b'/>": [
        "XAC010"
    ],
    "<xacro:propertys name='o'><origin/></xacro:propertys><link name='a'><visual><xacro:insert_block name='o'/>"
    "<geometry><sphere radius='1'/></geometry></visual></link>": ["XAC003"],
    "<link><xacro:attribute name='name' value='a'/></link><link name='b${'/>": ["XAC010"],
    "<xacro:macro name='m' params='n:= o:=1'><link name='${n}${o}'/></xacro:macro><xacro:m n='x'/>": [
        "XAC024"
    ],
    "<xacro:call name='x'/><xacro:macro name='m' params='name'><link name='${name}'/></xacro:macro>": [
        "XAC011"
    ],
    "<link><xacro:attribute name='${1 / 0}' value='a'/></link>": ["XAC001"],
    "<link name='a'/><joint name='j' type='$$'><parent link='a'/><child link='b'/></joint><link name='b'/>": [
        "XAC001"
    ],
}


@pytest.mark.parametrize(("text", "codes"), ONE_MISTAKE.items())
def test_one_mistake_is_one_error(text: str, codes: list[str], tmp_path: Path, expander: Expander) -> None:
    text = f'<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">{text}</robot>'
    found = lint(expander, tmp_path / "r.urdf.xacro", text)
    assert [d.code for d in found if d.severity is Severity.ERROR] == codes


@pytest.mark.parametrize(("lower", "is_fixed"), [("2", True), ("${low}", False)])
def test_an_expression_is_not_fixed(lower: str, is_fixed: bool, tmp_path: Path, expander: Expander) -> None:
    text = (
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:property name="low" value="2"/>'
        '<link name="a"/><link name="b"/><joint name="j" type="revolute"><parent link="a"/><child link="b"/>'
        f'<limit lower="{lower}" upper="1" effort="1" velocity="1"/></joint></robot>'
    )
    (found,) = (d for d in lint(expander, tmp_path / "r.urdf.xacro", text) if d.code == "JNT005")
    assert (found.fix is not None) is is_fixed


def test_each_set_of_arguments_is_tried(tmp_path: Path, expander: Expander) -> None:
    text = f'{HEAD}<xacro:arg name="m" default="1"/><model name="m"><link name="a"><inertial>'
    text += "<mass>$(arg m)</mass></inertial></link></model></sdf>"
    path = tmp_path / "r.sdf.xacro"
    assert not [d for d in lint(expander, path, text) if d.span.text == "$(arg m)"]
    assert [d for d in lint(expander, path, text, {}, {"m": "heavy"}) if d.span.text == "$(arg m)"]


def test_without_expansion_a_file_is_still_read(tmp_path: Path) -> None:
    text = (
        f'{HEAD}<model name="m"><link name="${{nmae}}"/><xacro:property name="name" value="a"/></model></sdf>'
    )
    assert any("nmae" in d.message for d in lint(None, tmp_path / "r.sdf.xacro", text))


@pytest.mark.parametrize(
    ("text", "robot"),
    [
        ('<robot name="r" xmlns:xacro="x"><link name="a"/></robot>', True),
        ('<robot name="r" xmlns:xacro="x"><xacro:if value="1"><xacro:arm/></xacro:if></robot>', True),
        ('<robot name="r" xmlns:xacro="x"><xacro:include filename="a"/></robot>', True),
        (
            '<robot name="r" xmlns:xacro="x"><xacro:include filename="a"/><xacro:macro name="m"/></robot>',
            False,
        ),
        ('<robot name="r" xmlns:xacro="x"><xacro:property name="a" value="1"/></robot>', False),
        ('<robot xmlns:xacro="x"><material name="a"/></robot>', False),
        ('<robot name="r" xmlns:xacro="x"><material name="a"/></robot>', True),
        ('<robot name="r" xmlns:xacro="x"><material name="a"/><xacro:macro name="m"/></robot>', False),
        ('<sdf version="1.9" xmlns:xacro="x"><xacro:arm/></sdf>', True),
        ('<root xmlns:xacro="x"><xacro:arm/></root>', False),
    ],
)
def test_robots_and_libraries(text: str, robot: bool) -> None:
    assert is_robot(read(text.encode(), Path("a.xacro"), Kind.XACRO)) is robot


def test_the_includes_of_a_file_are_seen(tmp_path: Path) -> None:
    (tmp_path / ".git").mkdir()
    (tmp_path / "lib.xacro").write_text(
        '<robot xmlns:xacro="x"><xacro:property name="size" value="1"/>'
        '<xacro:macro name="arm" params="side"><link name="${side}"/></xacro:macro></robot>'
    )
    path = tmp_path / "r.xacro"
    path.write_text(
        '<robot name="r" xmlns:xacro="x"><xacro:property name="dir" value="."/>'
        '<xacro:include filename="${dir}/lib.xacro"/><a b="${size}"/><xacro:arm side="l" left="1"/></robot>'
    )
    library = Library()
    document = library.document(path, Kind.XACRO)
    assert document is not None
    assert [type(problem).__name__ for problem in problems(document)] == ["WrongMacroArguments"]


def test_a_cycle_of_includes_is_reported_without_expanding(tmp_path: Path) -> None:
    for name, other in (("a", "b"), ("b", "a")):
        (tmp_path / f"{name}.xacro").write_text(
            f'<robot name="{name}" xmlns:xacro="x"><xacro:include filename="{other}.xacro"/></robot>'
        )
    document = Library().document(tmp_path / "a.xacro", Kind.XACRO)
    assert document is not None
    (problem,) = problems(document)
    assert type(problem).__name__ == "XacroIncludeCycle"
    assert problem.span.text == "b.xacro"


def test_a_defect_that_several_robots_reach_is_one(tmp_path: Path) -> None:
    xacro = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'
    leg = '<link name="${side}"><visual><geometry><sphere radius="${0 * size}"/></geometry></visual></link>'
    (tmp_path / "leg.xacro").write_text(
        f'<robot {xacro}><xacro:macro name="leg" params="side size">{leg}</xacro:macro></robot>'
    )
    for name in "ab":
        (tmp_path / f"{name}.urdf.xacro").write_text(
            f'<robot name="{name}" {xacro}><xacro:include filename="leg.xacro"/>'
            f'<xacro:leg side="{name}" size="1"/></robot>'
        )
    (found,) = sdfcheck.lint(tmp_path, isolated=True, select=["SCH014"]).diagnostics
    assert found.origins[-1].span.source.path.name == "a.urdf.xacro"


def test_a_macro_that_is_called_again_is_one_mistake(tmp_path: Path, expander: Expander) -> None:
    macro = '<xacro:macro name="leg" params=""><link name="hip"/>\n<link name="knee"/></xacro:macro>'
    head = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
    found = lint(
        expander, tmp_path / "r.xacro", f'{head}{macro}<xacro:leg/>\n<xacro:leg/><link name="knee"/></robot>'
    )
    said = [each.message for each in found if each.code == "NAM001"]
    assert said == [
        "there is another link `hip` in robot `r`, and 1 more like this",
        "there is another link `knee` in robot `r`",
    ]


def test_a_forgotten_dollar_in_an_included_file_is_one_mistake(tmp_path: Path) -> None:
    (tmp_path / "drive.xacro").write_text(
        '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:macro name="drive" params="name">\n'
        '<transmission name="t"><type>transmission_interface/SimpleTransmission</type>\n'
        '<joint name="{name}_wheel"><hardwareInterface>VelocityJointInterface</hardwareInterface></joint>\n'
        '<joint name="${name}_axle"><hardwareInterface>VelocityJointInterface</hardwareInterface></joint>\n'
        '<actuator name="${name}_motor"/></transmission></xacro:macro></robot>'
    )
    (tmp_path / "robot.urdf.xacro").write_text(
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:include filename="drive.xacro"/>'
        '<link name="base"/><xacro:drive name="left"/></robot>'
    )
    found = sdfcheck.lint(tmp_path).diagnostics
    assert [(each.code, each.span.begin.line) for each in found if each.severity is Severity.ERROR] == [
        ("XAC010", 3),
        ("URD011", 4),
    ]


CAMERA = """<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="with_imu" default="false"/>
  <xacro:arg name="prefix" default=""/>
  <xacro:arg name="color" default="true"/>
  <link name="$(arg prefix)body"/>
  <xacro:if value="$(arg with_imu)">
    <link name="imu"/>
    <joint name="j" type="fixed"><parent link="$(arg prefix)body"/><child link="imu_link"/></joint>
  </xacro:if>
  <link name="lamp"/>
  <joint name="k" type="fixed"><parent link="body"/><child link="lamp"/></joint>
</robot>"""


def test_an_error_of_another_argument_is_a_warning_that_names_it(tmp_path: Path, expander: Expander) -> None:
    path = tmp_path / "r.urdf.xacro"
    found = {d.span.text: d for d in lint(expander, path, CAMERA) if ":=" in d.message and d.code == "JNT001"}
    assert found["imu_link"].message.endswith("(with `with_imu:=true`)")
    assert found["body"].message.endswith("(with `prefix:=any_`)")
    assert {(d.severity, d.affects) for d in found.values()} == {(Severity.WARNING, ())}
    given = lint(expander, path, CAMERA, {"color": "true"})
    assert not any(":=" in d.message for d in given)  # somebody has said which robots there are
    whole = lint(expander, path, CAMERA, {"with_imu": "true"})
    assert any(d.code == "JNT001" and d.severity is Severity.ERROR for d in whole)


def test_an_argument_may_leave_out_the_whole_robot(tmp_path: Path, expander: Expander) -> None:
    switched = (
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:arg name="body" default="true"/>'
        '<xacro:if value="$(arg body)"><link name="a"/></xacro:if>{}</robot>'
    )
    joint = '<joint name="j" type="fixed"><parent link="a"/><child link="b"/></joint><link name="b"/>'
    found = lint(expander, tmp_path / "r.urdf.xacro", switched.format(joint))
    assert any(each.message.endswith("(with `body:=false`)") for each in found)
    found = lint(expander, tmp_path / "r.urdf.xacro", switched.format(""))
    assert not any(":=" in each.message for each in found)


def test_a_branch_in_a_branch_is_reached_with_both_arguments(
    tmp_path: Path, expander: Expander, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "package.xml").write_text("<package><name>arm</name></package>")
    (tmp_path / "simulated.xacro").write_text(
        '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:if value="$(arg camera)">'
        '<gazebo reference="base"><sensor name="c" type="camera"><clip><near>1</near></clip></sensor></gazebo>'
        "</xacro:if></robot>"
    )
    text = (
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:arg name="camera" default="false"/>'
        '<xacro:arg name="simulated" default="false"/><xacro:arg name="lamp" default="false"/><link name="base"/>'
        '<xacro:if value="$(arg simulated)"><xacro:include filename="$(find arm)/simulated.xacro"/></xacro:if></robot>'
    )
    found = lint(expander, Path("r.urdf.xacro"), text)
    (clip,) = (each for each in found if each.code == "SCH003")
    assert clip.span.source.path.name == "simulated.xacro"
    assert clip.severity is Severity.WARNING
    assert clip.message.endswith("(with `camera:=true` and `simulated:=true`)")


def test_branches_that_exclude_one_another_are_tried_one_by_one(tmp_path: Path, expander: Expander) -> None:
    switch = '<xacro:if value="$(arg {})"><link name="{}"/></xacro:if>'
    text = (
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
        '<xacro:arg name="real" default="true"/><xacro:arg name="simulated" default="false"/>'
        f'<link name="base"/>{switch.format("real", "arm")}{switch.format("simulated", "arm")}'
        '<joint name="j" type="fixed"><parent link="base"/><child link="arm"/></joint></robot>'
    )
    found = [d.message for d in lint(expander, tmp_path / "r.urdf.xacro", text)]
    assert not any(":=" in message for message in found)


def test_variants_of_a_large_robot_are_left_out(
    tmp_path: Path, expander: Expander, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("sdfcheck.lint.expanded._MOST_ELEMENTS", 3)
    found = lint(expander, tmp_path / "r.urdf.xacro", CAMERA)
    assert not any(":=" in d.message for d in found)


def test_a_warning_about_what_an_argument_brings_names_it(tmp_path: Path, expander: Expander) -> None:
    wheel = (
        '<link name="{0}"><collision><origin rpy="1.5708 0 0"/><geometry><cylinder radius="0.1" length="0.04"/>'
        '</geometry></collision></link><joint name="{0}_joint" type="continuous"><origin xyz="0 {1} 0"/>'
        '<parent link="base"/><child link="{0}"/><axis xyz="0 1 0"/></joint>'
    )
    text = (
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:arg name="ros" default="true"/>'
        f'<link name="base"/>{wheel.format("left", 0.2)}{wheel.format("right", -0.2)}'
        '<xacro:unless value="$(arg ros)"><xacro:include filename="drive.xacro"/></xacro:unless></robot>'
    )
    (tmp_path / "drive.xacro").write_text(
        '<robot><gazebo><plugin name="drive" filename="libgazebo_ros_diff_drive.so">'
        "<left_joint>left_joint</left_joint><right_joint>right_joint</right_joint>"
        "<wheel_separation>0.4</wheel_separation><wheel_diameter>2</wheel_diameter></plugin></gazebo></robot>"
    )
    (found,) = (each for each in lint(expander, tmp_path / "r.urdf.xacro", text) if each.code == "GEO012")
    assert (found.span.text, found.severity, found.affects) == ("2", Severity.WARNING, ())
    assert found.message.endswith("says 2 (with `ros:=false`)")


def test_names_that_calls_give_to_one_place_are_one_finding(tmp_path: Path, expander: Expander) -> None:
    text = (
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><link name="base"/>'
        '<xacro:macro name="driven" params="name"><joint name="${name}"><command_interface name="position"/></joint>'
        '</xacro:macro><ros2_control name="arm" type="system"><hardware><plugin>a/B</plugin></hardware>'
        '<xacro:driven name="first"/><xacro:driven name="second"/><xacro:driven name="third"/>'
        "</ros2_control></robot>"
    )
    (found,) = (each for each in lint(expander, tmp_path / "r.urdf.xacro", text) if each.code == "URD012")
    assert "joint `first`" in found.message
    assert found.message.endswith("(in 3 expansions)")
