"""Where conditions of rules end: the last value that is reported, the first that is not, and what is said."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

import sdfcheck
from sdfcheck.cli.main import main

SDF = '<sdf version="1.12"><model name="m"><link name="a"/><link name="b"/>{}</model></sdf>'
URDF = (
    '<robot name="r"><link name="a"/><link name="b"/><joint name="j" type="revolute"><parent link="a"/>'
    '<child link="b"/>{}</joint></robot>'
)


def messages(text: str, code: str, name: str = "a.sdf") -> list[str]:
    found = sdfcheck.lint(text, name=name, isolated=True, select=("ALL",)).diagnostics
    return [diagnostic.message for diagnostic in found if diagnostic.code == code]


@pytest.mark.parametrize(
    ("axes", "count"),
    [
        ("<axis><xyz>1 0 0</xyz></axis><axis2><xyz>0 1 0</xyz></axis2>", 0),
        ("<axis><xyz>1 0 0</xyz></axis>", 1),
        ("<axis><xyz>1 0 0</xyz></axis><axs2><xyz>0 1 0</xyz></axs2>", 0),
    ],
)
def test_a_misspelled_axis_is_not_missing(axes: str, count: int) -> None:
    joint = f'<joint name="j" type="universal"><parent>a</parent><child>b</child>{axes}</joint>'
    assert len(messages(SDF.format(joint), "JNT004")) == count


@pytest.mark.parametrize(("upper", "count"), [(29, 0), (30, 1), (720, 1), (721, 0)])
def test_limits_that_look_like_degrees(upper: int, count: int) -> None:
    limit = f"<limit><lower>0</lower><upper>{upper}</upper></limit>"
    axis = f"<axis><xyz>0 0 1</xyz>{limit}</axis>"
    joint = f'<joint name="j" type="revolute"><parent>a</parent><child>b</child>{axis}</joint>'
    assert len(messages(SDF.format(joint), "JNT014")) == count


@pytest.mark.parametrize(("mass", "found"), [(-1, ["INR001"]), (0, ["INR001", "INR002"]), (1, ["INR002"])])
def test_moments_are_judged_with_any_mass_that_libsdformat_takes(mass: int, found: list[str]) -> None:
    moments = "<inertia><ixx>-1</ixx><iyy>1</iyy><izz>1</izz></inertia>"
    link = f'<link name="c"><inertial><mass>{mass}</mass>{moments}</inertial></link>'
    run = sdfcheck.lint(SDF.format(link), isolated=True, select=("INR001", "INR002", "INR003", "INR006"))
    assert [each.code for each in run.diagnostics] == found


@pytest.mark.parametrize(
    ("moments", "off_diagonal", "verdict", "is_rounding"),
    [
        (
            "6.53141172142094E-07 2.25074855995339E-07 8.3591152010311E-07",
            "-1.1293745176837E-07 -2.06371785964382E-08 -1.15620016000655E-07",
            "accept",
            True,
        ),
        ("9e-6 1e-6 1e-5", "-1e-6 0 0", "reject", True),
        ("0.1 0.1 0.3", "0 0 0", "reject", False),
    ],
)
def test_moments_at_the_edge_are_refused_by_those_whose_rounding_errors_break_the_rule(
    moments: str, off_diagonal: str, verdict: str, is_rounding: bool
) -> None:
    names = zip(
        ("ixx", "iyy", "izz", "ixy", "ixz", "iyz"), (moments + " " + off_diagonal).split(), strict=True
    )
    inertia = "<inertia " + " ".join(f'{name}="{value}"' for name, value in names) + "/>"
    link = f'<link name="c"><inertial><mass value="1"/>{inertia}</inertial></link>'
    run = sdfcheck.lint(
        URDF.format("").replace("</robot>", f"{link}</robot>"), isolated=True, select=("INR003",)
    )
    (found,) = run.diagnostics
    assert dict(found.affects)["mujoco"].manner.value == verdict
    assert ("rounding" in (found.help or "")) == is_rounding


BOX = '<collision name="c"><pose>{0} 0 0 0 0 0</pose><geometry><box><size>1 1 1</size></box></geometry></collision>'


@pytest.mark.parametrize("mass", [0.5, 2])
@pytest.mark.parametrize(
    ("factor", "offset", "found"),
    [
        (0.009, 0, ["INR006"]),
        (0.011, 0, []),
        (99, 0, []),
        (101, 0, ["INR006"]),
        (9.9, 1.49, ["INR007"]),
        (10.1, 1.51, ["INR007"]),
    ],
)
def test_moments_far_from_those_of_a_box(mass: float, factor: float, offset: float, found: list[str]) -> None:
    own = mass / 6 * (factor if not offset else 1)
    about = own + mass * offset**2
    assert about * 2 + own == pytest.approx(mass / 2 * factor, rel=0.01)
    moments = f"<inertia><ixx>{own}</ixx><iyy>{about}</iyy><izz>{about}</izz></inertia>"
    inertial = f"<inertial><pose>{offset} 0 0 0 0 0</pose><mass>{mass}</mass>{moments}</inertial>"
    link = f'<link name="c">{inertial}{BOX.format(offset)}</link>'
    run = sdfcheck.lint(SDF.format(link), isolated=True, select=("INR006", "INR007"))
    assert [each.code for each in run.diagnostics] == found


@pytest.mark.parametrize("x", [0, 6])
@pytest.mark.parametrize(("mass", "count"), [(400, 0), (590, 0), (610, 1)])
def test_moments_of_1_may_be_right_for_a_heavy_box(mass: int, count: int, x: int) -> None:
    moments = "<inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia>"
    inertial = f"<inertial><pose>{x} 0 0 0 0 0</pose><mass>{mass}</mass>{moments}</inertial>"
    assert len(messages(SDF.format(f'<link name="c">{inertial}{BOX.format(x)}</link>'), "INR005")) == count


LEAST_TURN = 2 * math.pi - 1e-3


@pytest.mark.parametrize(
    ("upper", "count"), [(LEAST_TURN, 1), (math.nextafter(LEAST_TURN, 7), 0), (6.283, 0)]
)
def test_limits_of_a_whole_turn_exclude_nothing(upper: float, count: int) -> None:
    limit = f'<axis xyz="0 0 1"/><limit lower="0" upper="{upper!r}" effort="1" velocity="1"/>'
    assert len(messages(URDF.replace("revolute", "continuous").format(limit), "JNT011", "a.urdf")) == count


@pytest.mark.parametrize(("lower", "upper", "count"), [(0, 0, 1), (1, 0, 0), (-1, 1, 1)])
def test_limits_that_a_continuous_joint_does_not_have(lower: int, upper: int, count: int) -> None:
    limit = f"<limit><lower>{lower}</lower><upper>{upper}</upper></limit>"
    ends = "<parent>a</parent><child>b</child>"
    joint = f'<joint name="j" type="continuous">{ends}<axis><xyz>0 0 1</xyz>{limit}</axis></joint>'
    assert len(messages(SDF.format(joint), "JNT011")) == count


@pytest.mark.parametrize(("sine", "count"), [(0.99999, 1), (0.999989, 0)])
def test_from_a_sine_on_a_pitch_is_taken_for_a_right_angle(sine: float, count: int) -> None:
    pitch = math.asin(sine)
    assert math.sin(pitch) == sine
    box = f'<origin rpy="0 {pitch!r} 0"/><geometry><box size="1 1 1"/></geometry>'
    text = f'<robot name="r"><link name="a"><visual>{box}</visual></link></robot>'
    assert len(messages(text, "URD016", "a.urdf")) == count


@pytest.mark.parametrize("size", ["1e160 1e160 1e160", "1e200 1 1"])
def test_an_inertia_is_not_compared_with_that_of_an_endless_solid(size: str) -> None:
    solid = f'<collision name="c"><geometry><box><size>{size}</size></box></geometry></collision>'
    moments = "<inertia><ixx>2</ixx><iyy>2</iyy><izz>2</izz></inertia>"
    link = f'<link name="c"><inertial><mass>1</mass>{moments}</inertial>{solid}</link>'
    run = sdfcheck.lint(SDF.format(link), isolated=True, select=("INR",))
    assert [each.message for each in run.diagnostics if "link `c`" not in each.message] == []


@pytest.mark.parametrize(("outer", "count"), [(2 * math.pi, 0), (6.3, 1)])
def test_a_cone_is_no_wider_than_all(outer: float, count: int) -> None:
    spot = (
        f"<spot><inner_angle>0.1</inner_angle><outer_angle>{outer!r}</outer_angle><falloff>1</falloff></spot>"
    )
    light = f'<light name="s" type="spot"><direction>0 0 -1</direction>{spot}</light>'
    text = f'<sdf version="1.12"><world name="w">{light}</world></sdf>'
    assert len(messages(text, "SCH021")) == count


@pytest.mark.parametrize(
    ("limit", "count"),
    [
        ('<limit effort="1" velocity="1"/>', 1),
        ('<limit lower="-1" effort="1" velocity="1"/>', 0),
        ('<limit upper="1" effort="1" velocity="1"/>', 0),
    ],
)
def test_a_joint_with_one_limit_is_not_locked(limit: str, count: int) -> None:
    assert len(messages(URDF.format(f'<axis xyz="0 0 1"/>{limit}'), "URD005", "a.urdf")) == count


def test_the_old_namespace_is_taken_out_at_each_element(tmp_path: Path) -> None:
    old = 'xmlns:ignition="http://ignitionrobotics.org/schema"'
    new = 'xmlns:gz="http://gazebosim.org/schema"'
    text = (
        f'<sdf version="1.9" {old} {new}><model name="m" {old}><link name="a" ignition:b="1"/></model></sdf>'
    )
    file = tmp_path / "a.sdf"
    file.write_text(text)
    main(["lint", "--isolated", "--fix", "--unsafe-fixes", "--select", "GAZ", "--quiet", str(file)])
    assert "ignition" not in file.read_text()


def test_the_first_misspelling_of_a_plugin_is_named() -> None:
    hardware = "<hardware><plugn>a</plugn><plugi>b</plugi></hardware>"
    text = (
        '<robot name="r"><link name="a"/><ros2_control name="c" type="system">'
        f'{hardware}<joint name="j"/></ros2_control></robot>'
    )
    found = sdfcheck.lint(text, name="a.urdf", isolated=True, select=("ALL",)).diagnostics
    (place,) = (
        d.span.text for d in found if "did you mean `plugin`" in d.message and d.code.startswith("R2C")
    )
    assert place == "plugn"


@pytest.mark.parametrize(("name", "title"), [("waxed", "write `waxed`"), ("wax&amp;ed", None)])
def test_a_name_is_written_where_it_was_meant_unless_it_would_be_escaped(
    name: str, title: str | None
) -> None:
    material = f'<material name="{name}"><color rgba="1 1 1 1"/></material>'
    visual = f'<visual><geometry><sphere radius="1"/></geometry><material name="{name}d"/></visual>'
    text = f'<robot name="r">{material}<link name="a">{visual}</link></robot>'
    (found,) = sdfcheck.lint(text, name="a.urdf", isolated=True, select=("URD006",)).diagnostics
    assert (found.fix and found.fix.title) == title


def test_letters_that_are_not_utf_8_are_reported(tmp_path: Path) -> None:
    file = tmp_path / "a.sdf"
    file.write_bytes('<sdf version="1.9"><world name="Wörld"/></sdf>'.encode("latin-1"))
    (found,) = (each for each in sdfcheck.lint(file, isolated=True).diagnostics if each.code == "XML005")
    assert "is not stored as UTF-8" in found.message
    assert found.help == "save the file as UTF-8"


@pytest.mark.parametrize("encoding", ["utf-16", "utf-16-le", "utf-16-be"])
def test_simulators_cannot_read_wide_characters(encoding: str, tmp_path: Path) -> None:
    file = tmp_path / "a.sdf"
    file.write_bytes('\ufeff<sdf version="1.9"/>'.encode(encoding))
    found = [each.message for each in sdfcheck.lint(file, isolated=True).diagnostics if each.code == "XML005"]
    assert found == ["the file is UTF-16, and simulators read UTF-8 only"]


def test_a_second_document_is_called_so() -> None:
    text = '<sdf version="1.9"/>\n<?xml version="1.0"?><sdf version="1.9"/>'
    found = [d.message for d in sdfcheck.lint(text, name="a.sdf", isolated=True).diagnostics]
    assert "a second document begins after the root element" in found


def test_names_in_a_configuration_are_suggested_where_they_may_be_meant(tmp_path: Path) -> None:
    (tmp_path / "model.sdf").write_text(SDF.format(""))
    config = tmp_path / "model.config"
    config.write_text('<model><name>m</name><version>1</version><sdf version="1.12">modl.sdf</sdf></model>')
    found = [diagnostic.message for diagnostic in sdfcheck.lint(config, isolated=True).diagnostics]
    assert any("did you mean `model.sdf`?" in message for message in found)


MOVED = '<gazebo reference="a"><slip1>{}</slip1></gazebo>'
WORLD = (
    '<robot name="r"{}><link name="a"/>'
    '<joint name="j" type="fixed"><parent link="world"/><child link="a"/></joint></robot>'
)
MASS = '<sdf version="1.12"><model name="m"><link name="a"><inertial><mass>{}</mass></inertial></link></model></sdf>'
STATE = '<robot name="r">{}<group_state name="home" group="legs"/></robot>'


@pytest.mark.parametrize(
    ("text", "name", "code", "severity"),
    [
        (f'<robot name="r"><link name="a"/>{MOVED.format("0.0")}</robot>', "a.urdf", "SCH003", "warning"),
        (f'<robot name="r"><link name="a"/>{MOVED.format("0.1")}</robot>', "a.urdf", "SCH003", "error"),
        (SDF.format("<slip1>0.0</slip1>"), "a.sdf", "SCH003", "error"),
        (WORLD.format(' xmlns:drake="http://drake.mit.edu"'), "a.urdf", "JNT001", "warning"),
        (WORLD.format(""), "a.urdf", "JNT001", "error"),
        (MASS.format("1 1"), "a.sdf", "SCH012", "warning"),
        (MASS.format("1 2"), "a.sdf", "SCH012", "error"),
        ('<gazebo reference="a"/>', "gazebo.urdf", "XML009", "warning"),
        ("<html/>", "gazebo.urdf", "XML009", "error"),
        (STATE.format(""), "r.srdf", "SRD002", "warning"),
        (STATE.format('<group name="arm"><link name="a"/></group>'), "r.srdf", "SRD002", "error"),
    ],
)
def test_it_is_an_error_only_where_somebody_gets_another_robot(
    text: str, name: str, code: str, severity: str
) -> None:
    found = sdfcheck.lint(text, name=name, isolated=True).diagnostics
    assert [each.severity.value for each in found if each.code == code] == [severity]


@pytest.mark.parametrize(("tool", "severity"), [("catkin", "error"), ("ament_cmake", "warning")])
def test_nothing_reads_a_transmission_of_ros_control_in_ros_2(
    tool: str, severity: str, tmp_path: Path
) -> None:
    manifest = f"<package><name>p</name><buildtool_depend>{tool}</buildtool_depend></package>"
    (tmp_path / "package.xml").write_text(manifest)
    interface = "<hardwareInterface>hardware_interface/EfortJointInterface</hardwareInterface>"
    drive = f'<transmission name="t"><type>transmission_interface/SimpleTransmission</type><joint name="j">{interface}'
    drive += '</joint><actuator name="m"/></transmission>'
    (tmp_path / "a.urdf").write_text(URDF.format("").replace("</robot>", f"{drive}</robot>"))
    found = sdfcheck.lint(tmp_path / "a.urdf", isolated=True).diagnostics
    assert [each.severity.value for each in found if each.code == "URD028"] == [severity]


@pytest.mark.parametrize(("moment", "codes"), [(0.01, ["INR003"]), (1, ["SCH004"])])
def test_a_missing_moment_is_one_finding(moment: float, codes: list[str], tmp_path: Path) -> None:
    written = f"<inertia>\n<ixx>{moment}</ixx><iyy>{moment}</iyy></inertia>"
    path = tmp_path / "a.sdf"
    path.write_text(
        f'<sdf version="1.12"><model name="m"><link name="a">\n<inertial><mass>1</mass>\n{written}</inertial>'
        "</link></model></sdf>"
    )
    assert [each.code for each in sdfcheck.lint(path, isolated=True).diagnostics] == codes


@pytest.mark.parametrize(
    ("beside", "severity"),
    [
        ("", "warning"),
        ("pyproject.toml", "info"),
        ("package.xml", "warning"),
        ("pyproject.toml package.xml", "warning"),
    ],
)
def test_a_robot_of_a_project_of_python_is_not_one_of_ros(beside: str, severity: str, tmp_path: Path) -> None:
    for name in beside.split():
        (tmp_path / name).write_text("<package><name>p</name></package>" if name == "package.xml" else "")
    (tmp_path / "a").mkdir()
    path = tmp_path / "a" / "a.urdf"
    moments = '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>'
    limit = '<limit lower="0" upper="1" effort="1" velocity="1"/>'
    for code, mass, joint in (("URD008", 1, "revolute"), ("INR001", 0, "fixed")):
        text = URDF.format(limit).replace('"a"', '"base_link"').replace("revolute", joint)
        for name, kilograms in (("base_link", mass), ("b", 1)):
            link = f'<link name="{name}"><inertial><mass value="{kilograms}"/>{moments}'
            text = text.replace(f'<link name="{name}"/>', link)
        path.write_text(text)
        found = sdfcheck.lint(path, isolated=True).diagnostics
        assert [each.severity.value for each in found if each.code == code] == [severity]


@pytest.mark.parametrize(("settings", "severity"), [("", "error"), ("<mujoco/>", "warning")])
def test_mujoco_takes_a_link_without_joint(settings: str, severity: str) -> None:
    text = URDF.format("").replace("</robot>", f'<link name="ground"/>{settings}</robot>')
    found = sdfcheck.lint(text, name="a.urdf", isolated=True).diagnostics
    assert [each.severity.value for each in found if each.code == "URD004"] == [severity]


WALKER = (
    '<sdf version="1.12"><world name="w"><actor name="a"><skin><filename>https://example.org/w.dae</filename></skin>'
    '<animation name="walk"><filename>https://example.org/w.dae</filename></animation>'
    '<script><trajectory id="0" type="walk">{}</trajectory></script></actor></world></sdf>'
)


@pytest.mark.parametrize(
    ("waypoints", "found"),
    [
        ([(0, 0), (9, 0), (1, 1), (8, 1), (2, 2), (7, 2), (3, 3), (6, 3)], []),
        ([(0, 0), (9, 0), (1, 1), (8, 1), (2, 2), (7, 2), (3, 3), (3, 3)], ["time 1 is not after 9"]),
        ([(0, 0), (2, 2), (1, 1), (3, 3)], []),
        ([(0, 0), (2, 1), (1, 2), (3, 3)], ["time 1 is not after 2"]),
        ([(3, 0), (2, 2)], ["time 2 is not after 3"]),
    ],
)
def test_waypoints_in_another_order_are_one_way_when_sorted(
    waypoints: list[tuple[int, int]], found: list[str]
) -> None:
    form = "<waypoint><time>{}</time><pose>{} 0 0 0 0 0</pose></waypoint>"
    text = WALKER.format("".join(form.format(*each) for each in waypoints))
    assert [each.split(",")[0] for each in messages(text, "SCH028")] == found


def test_the_way_of_an_actor_is_measured_in_the_order_of_the_times() -> None:
    form = "<waypoint><time>{}</time><pose>{} 0 0 0 0 0</pose></waypoint>"
    there_and_back = ((0, 0), (9, 0), (1, 1), (8, 1), (2, 2), (7, 2))
    text = WALKER.format("".join(form.format(*each) for each in there_and_back))
    assert messages(text, "SCH035") == ["the steps of actor `a` are not fitted to its way of 4 m"]
