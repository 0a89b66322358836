"""The part of a robot without the packages that are not found is checked, and judged as a part."""

from __future__ import annotations

from pathlib import Path

import pytest

import sdfcheck

XACRO = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'
MISSING = '<xacro:include filename="$(find nowhere_near)/urdf/sensor.xacro"/>'
LEG = (
    '<xacro:macro name="leg" params="side *place"><link name="${side}_leg"><visual>'
    '<xacro:insert_block name="place"/><geometry><sphere radius="${radius}"/></geometry></visual></link>'
    '<joint name="${side}" type="fixed"><parent link="sensor_mount"/><child link="${side}_leg"/></joint>'
    "</xacro:macro>"
)
CALL = '<xacro:leg side="left"><origin xyz="0 0 0"/></xacro:leg>'


def found(folder: Path, content: str) -> list[tuple[str, str]]:
    (folder / ".git").mkdir(exist_ok=True)  # no other folder belongs to the project
    (folder / "package.xml").write_text("<package><name>p</name></package>")
    file = folder / "robot.urdf.xacro"
    file.write_text(f'<robot name="r" {XACRO}>{content}</robot>')
    run = sdfcheck.lint(file, isolated=True)
    return [(each.code, each.span.text) for each in run.diagnostics]


def test_values_that_only_an_expansion_shows_are_checked(tmp_path: Path) -> None:
    for radius, more in (("${1 - 0.5}", []), ("${1 - 1.5}", [("SCH014", "${radius}")])):
        content = f'<xacro:property name="radius" value="{radius}"/>{LEG}<xacro:sensor/>{CALL}'
        assert found(tmp_path, MISSING + content) == [("XAC007", "nowhere_near"), *more]


@pytest.mark.parametrize(
    "content",
    [
        '<link name="a"><xacro:sensor_inertia/></link><joint name="j" type="fixed"><xacro:ends/></joint>',
        '<link name="a"/><joint name="j" type="fixed"><parent link="lidar"/><child link="a"/></joint>',
        (
            '<link name="a"><visual><geometry><mesh filename="file://$(find nowhere_near)/a.dae"/></geometry>'
            "</visual></link>"
        ),
        '<link name="a"/><link name="b"/><gazebo reference="lidar"><x/></gazebo>',
        '<link name="${sensor_name}"/>',
        '<xacro:sensor.nested><link name="a"/></xacro:sensor.nested>',
    ],
)
def test_names_that_a_package_may_define_are_not_missing(tmp_path: Path, content: str) -> None:
    assert found(tmp_path, MISSING + content) == [("XAC007", "nowhere_near")]


@pytest.mark.parametrize("content", [MISSING, '<xacro:macro name="never" params="a">{}</xacro:macro>'])
def test_text_beside_what_is_not_known_is_stray(tmp_path: Path, content: str) -> None:
    text = '<link name="a"/>f'
    content = content.format(text) if "{}" in content else content + text
    assert ("SCH010", "f") in found(tmp_path, content)


def test_text_that_ends_as_the_tag_before_it_does(tmp_path: Path) -> None:
    path = tmp_path / "robot.xacro"
    shape = '<visual><geometry><sphere radius="1"/>/></geometry></visual>'
    path.write_text(f'<robot name="r" {XACRO}><link name="a">{shape}</link></robot>')
    stray = [each for each in sdfcheck.lint([path], isolated=True).diagnostics if each.code == "SCH010"]
    assert [each.span.source.text[each.span.start - 2 : each.span.end] for each in stray] == ["/>/>"]


def test_a_text_that_has_no_value_is_reported_once(tmp_path: Path) -> None:
    text = "${1 / 0}"
    assert [code for code, place in found(tmp_path, f'<link name="base"/>{text}') if place == text] == [
        "XAC001"
    ]


def test_a_package_that_only_an_included_file_needs(tmp_path: Path) -> None:
    (tmp_path / "part.xacro").write_text(f"<robot {XACRO}>{MISSING}</robot>")
    content = '<xacro:include filename="part.xacro"/><link name="a"><visual><geometry>'
    content += '<sphere radius="${0 - 1}"/></geometry></visual></link>'
    assert ("SCH014", "${0 - 1}") in found(tmp_path, content)


def test_broken_text_of_an_included_file_is_reported_at_the_include(tmp_path: Path) -> None:
    (tmp_path / "part.xacro").write_text("")
    content = '<link name="a"/><xacro:include filename="part.xacro"/>'
    assert ("XAC001", "part.xacro") in found(tmp_path, content)


@pytest.mark.parametrize(
    ("content", "severity"),
    [
        ('<xacro:property name="unread" value="${1 +}"/>', "warning"),
        ('<xacro:if value="0"><link name="${1 +}"/></xacro:if>', "warning"),
        ('<xacro:sensor name="${1 +}"/>', "error"),
    ],
)
def test_a_link_that_the_rest_does_not_reach_is_not_an_error(
    tmp_path: Path, content: str, severity: str
) -> None:
    assert found(tmp_path, f'{MISSING}<link name="a"/>{content}') == [
        ("XAC007", "nowhere_near"),
        ("XAC001", "${1 +}"),
    ]
    (report,) = sdfcheck.lint(tmp_path / "robot.urdf.xacro", isolated=True, select=["XAC001"]).diagnostics
    assert report.severity.value == severity


@pytest.mark.parametrize(
    ("last", "inside", "expected"),
    [
        ("-1.5", "", [("SCH038", "720")]),
        ("1.5", "", []),
        ("-1.5", "<xacro:settings/>", []),
        ("1.5", "<gz_frame_id>lidar</gz_frame_id>", []),
        (
            "1.5",
            "<plugin name='p' filename='libgazebo_ros_depth_camera.so'><frame_name>a</frame_name></plugin>",
            [],
        ),
    ],
)
def test_sensors_of_blocks_are_checked(
    last: str, inside: str, expected: list[tuple[str, str]], tmp_path: Path
) -> None:
    lidar = (
        f'<xacro:macro name="lidar" params="last"><gazebo reference="front"><sensor type="ray" name="s">{inside}'
        "<ray><scan><horizontal><samples>720</samples><min_angle>-1.5</min_angle><max_angle>${last}</max_angle>"
        "</horizontal></scan><range><min>0.1</min><max>9</max></range></ray></sensor></gazebo></xacro:macro>"
        f'<xacro:lidar last="{last}"/>'
    )
    known = found(tmp_path, f"{MISSING}<xacro:sensor/>{lidar}")
    assert [each for each in known if each[0] not in {"XAC007", "RES019"}] == expected
