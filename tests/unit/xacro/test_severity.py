"""A warning of xacro is a warning, and a part that it ignores does not hide or excuse anything."""

from __future__ import annotations

from pathlib import Path

import pytest

import sdfcheck

XACRO = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'
ROBOT = f'<robot name="r" {XACRO}>{{}}</robot>'
PART = f"<robot {XACRO}>{{}}</robot>"
ASIDE = ["URD013", "URD008"]

Found = list[tuple[str, str]]


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "package.xml").write_text("<package><name>p</name></package>")
    return tmp_path


def found(folder: Path, text: str = "", name: str = "robot.urdf.xacro") -> Found:
    if text:
        (folder / name).write_text(text if text.startswith("<robot") else ROBOT.format(text))
    run = sdfcheck.lint(folder / name, isolated=True, ignore=ASIDE)
    return [(each.code, each.severity.value) for each in run.diagnostics]


BRANCH = (
    '<xacro:arg name="f" default="-"/><xacro:property name="f" value="$(arg f)"/><link name="a"/>'
    '<xacro:if value="${{f != \'-\'}}"><xacro:include filename="{}.xacro"/></xacro:if>'
)


@pytest.mark.parametrize(
    ("content", "expected"),
    [
        ('<xacro:property name="w" value="1" comment="m"/><link name="a${w}"/>', [("XAC011", "warning")]),
        ('<xacro:property name="w" vaule="1"/><link name="a${w}"/>', [("XAC011", "error")]),
        (
            '<xacro:if value="0"><xacro:arg name="a" defalt="1"/></xacro:if><link name="a"/>',
            [("XAC011", "warning")],
        ),
        ('<xacro:include filename="parts/*.xacro"/><link name="a"/>', [("XAC001", "warning")]),
        ('<xacro:include filename="parts/*.xacro" optional="true"/><link name="a"/>', []),
        ('<xacro:include filename="parts/a.xacro"/><link name="a"/>', [("XAC001", "error")]),
        ('<xacro:include filename="/etc/no/such/a.xacro"/><link name="a"/>', [("XAC001", "warning")]),
        (BRANCH.format("a"), [("XAC001", "warning")]),
        (BRANCH.format("${f}_cal"), []),
        ('<link name="$(env NOT_SET_HERE)"/>', [("XAC001", "warning")]),
    ],
)
def test_it_is_an_error_only_if_xacro_stops(folder: Path, content: str, expected: Found) -> None:
    assert found(folder, content) == expected


def test_another_argument_may_bring_the_plugin_of_the_hardware(folder: Path) -> None:
    text = (
        '<xacro:arg name="sim" default="false"/><link name="a"/><ros2_control name="c" type="system"><hardware>'
        '<xacro:if value="$(arg sim)">{}</xacro:if></hardware></ros2_control>'
    )
    assert found(folder, text.format("<plugin>a/B</plugin>")) == [("R2C007", "warning")]
    assert ("R2C007", "error") in found(folder, text.format("<group>a</group>"))


def test_settings_of_a_world_are_a_part_of_the_file_that_includes_them(folder: Path) -> None:
    sdf = f'<sdf version="1.9" {XACRO}>{{}}</sdf>'
    (folder / "physics.xacro").write_text(sdf.format("<gravity>0 0 -9</gravity>"))
    assert found(folder, name="physics.xacro") == [("SCH003", "error")]
    world = sdf.format('<world name="w"><xacro:include filename="physics.xacro"/></world>')
    (folder / "w.world.xacro").write_text(world)
    assert found(folder, name="physics.xacro") == []


def test_a_path_from_another_folder_is_for_another_program(folder: Path) -> None:
    (folder / "urdf").mkdir()
    (folder / "urdf" / "part.xacro").write_text(PART.format(""))
    text = '<xacro:include filename="urdf/{}.xacro"/><link name="a"/>'
    assert found(folder, text.format("part"), "urdf/robot.urdf.xacro") == [("XAC001", "warning")]
    assert found(folder, text.format("prat"), "urdf/robot.urdf.xacro") == [("XAC001", "error")]


@pytest.mark.parametrize(
    ("mistake", "code"),
    [
        ('<link name="${nothere}"/>', "XAC004"),
        ("<xacro:nothere/>", "XAC003"),
        ('<xacro:m side="l"/>', "XAC008"),
        ('<link name="${1 +}"/>', "XAC001"),
        ('<xacro:insert_block name="orign"/>', "XAC004"),
        ('<link name="$(arg prefx)"/>', "XAC013"),
    ],
)
def test_a_mistake_that_xacro_does_not_reach_is_a_warning(folder: Path, mistake: str, code: str) -> None:
    rest = (
        '<xacro:arg name="prefix" default="a"/><xacro:property name="origin"><origin/></xacro:property>'
        '<xacro:macro name="m" params="n"><link name="${n}$(arg prefix)"/></xacro:macro><xacro:m n="a"/>'
    )
    for condition, severity in ((0, "warning"), (1, "error")):
        branch = f'<xacro:if value="{condition}">{mistake}</xacro:if>'
        assert (code, severity) in found(folder, rest + branch)


def test_children_of_an_include_are_ignored(folder: Path) -> None:
    (folder / "part.xacro").write_text(PART.format('<link name="b"/>'))
    content = '<xacro:include filename="part.xacro"><xacro:arg name="g" value="${g}"/></xacro:include>'
    assert found(folder, content) == [("XAC014", "warning")]


def test_a_branch_that_is_not_taken_says_nothing_of_a_file_that_is_not_known(folder: Path) -> None:
    macro = '<xacro:macro name="tip" params="{}"><link name="${{a}}"/></xacro:macro>'
    (folder / "none.xacro").write_text(PART.format(macro.format("a")))
    (folder / "soft.xacro").write_text(PART.format(macro.format("a b")))
    assert not found(
        folder,
        '<xacro:property name="kind" value="soft"/><xacro:property name="none" value="${kind == \'none\'}"/>'
        '<xacro:if value="${none}"><xacro:include filename="none.xacro"/></xacro:if>'
        '<xacro:include filename="${kind + str()}.xacro"/><xacro:tip a="1" b="2"/>',
    )


@pytest.mark.parametrize(
    "body",
    ["${0.1 * mass} 0 0", '<xacro:include filename="part.xacro"/>'],
    ids=["text", "included file"],
)
def test_a_parameter_may_be_read_in_text_and_in_an_included_file(folder: Path, body: str) -> None:
    (folder / "part.xacro").write_text(PART.format('<link name="l${mass}"/>'))
    macro = f'<xacro:macro name="m" params="mass">{body}</xacro:macro>'
    call = (
        '<xacro:m mass="1"/>'
        if "include" in body
        else "<gazebo><plugin><xacro:m mass='1'/></plugin></gazebo>"
    )
    assert ("XAC009", "info") not in found(folder, f'{macro}<link name="a"/>{call}')


def test_the_constants_of_a_file_that_another_includes_are_for_that_one(folder: Path) -> None:
    (folder / "base.xacro").write_text(PART.format('<xacro:property name="z" value="1"/>'))
    constants = '<xacro:include filename="base.xacro"/><xacro:property name="offset" value="1"/>'
    assert found(folder, constants, "const.xacro") == [("XAC005", "info")]
    (folder / "robot.xacro").write_text(
        ROBOT.format('<xacro:include filename="const.xacro"/><link name="${z}${offset}"/>')
    )
    assert found(folder, name="const.xacro") == []


def test_a_macro_for_gazebo_is_not_urdf(folder: Path) -> None:
    macro = '<xacro:macro name="red"><material>Gazebo/Red</material></xacro:macro>'
    assert found(folder, PART.format(f'{macro}<gazebo reference="b"><xacro:red/></gazebo>')) == []
    assert found(folder, PART.format(macro)) == []


@pytest.mark.parametrize("name", ["cage", "cages"])
def test_a_block_for_a_link_that_other_arguments_bring_is_not_unreferenced(folder: Path, name: str) -> None:
    (folder / "cage.xacro").write_text(
        PART.format(
            f'<xacro:if value="$(arg cage)"><link name="cage"/></xacro:if><!-- <link name="{name}s"/> -->'
        )
    )
    blocks = (
        f'<gazebo reference="{name}"><mu1>1</mu1></gazebo><gazebo reference="{name}s"><mu1>1</mu1></gazebo>'
    )
    text = f'<xacro:arg name="cage" default="false"/><xacro:include filename="cage.xacro"/><link name="a"/>{blocks}'
    assert found(folder, text).count(("GAZ003", "error")) == (1 if name == "cage" else 2)


def test_an_include_of_its_own_name_does_not_make_a_robot_a_library(folder: Path) -> None:
    for name in ("base_arm", "my_arm"):
        (folder / name).mkdir()
        (folder / name / "package.xml").write_text(f"<package><name>{name}</name></package>")
    (folder / "base_arm" / "arm.xacro").write_text(ROBOT.format('<link name="a"/>'))
    content = (
        '<xacro:include filename="$(find base_arm)/arm.xacro"/><xacro:sensor_mount/><link name="${prefix}"/>'
    )
    assert found(folder, content, "my_arm/arm.xacro") == [("XAC003", "error"), ("XAC004", "error")]


def test_a_file_of_another_package_is_another_file(folder: Path) -> None:
    whole = ROBOT.format('<link name="torso"/><xacro:include filename="$(find nowhere_near)/part.xacro"/>')
    (folder / "whole.xacro").write_text(whole)
    joint = '<joint name="j" type="fixed"><parent link="torso"/><child link="b"/></joint>'
    assert ("JNT001", "warning") in found(folder, f'<link name="b"/>{joint}', "part.xacro")


@pytest.mark.parametrize(
    ("path", "is_part"),
    [("robots/parts/arm.urdf", True), ("parts/arm.urdf", False), ("$(arg a)/parts/arm.urdf", False)],
)
def test_a_package_that_is_not_there_had_two_folders_of_the_part(
    folder: Path, path: str, is_part: bool
) -> None:
    (folder / "robots" / "parts").mkdir(parents=True)
    (folder / "whole.xacro").write_text(
        ROBOT.format(f'<link name="torso"/><xacro:include filename="$(find old)/{path}"/>')
    )
    joint = '<joint name="j" type="fixed"><parent link="torso"/><child link="b"/></joint>'
    assert (
        ("JNT001", "error") not in found(folder, f'<link name="b"/>{joint}', "robots/parts/arm.urdf")
    ) == is_part


def test_links_that_nothing_ties_are_parts_where_they_are_included(folder: Path) -> None:
    hands = '<link name="left"/><link name="right"/>'
    assert ("URD004", "error") in found(folder, hands, "hands.urdf")
    (folder / "whole.xacro").write_text(
        ROBOT.format('<link name="torso"/><xacro:include filename="hands.urdf"/>')
    )
    assert ("URD004", "error") not in found(folder, hands, "hands.urdf")


def test_blocks_about_links_are_a_part(folder: Path) -> None:
    block = '<gazebo><plugin name="p" filename="libp.so"><ns>${nowhere}</ns></plugin></gazebo>'
    assert ("XAC004", "error") not in found(folder, block)
    assert ("XAC004", "error") in found(folder, f'<link name="a"/>{block}')


def test_the_default_of_a_variable_is_a_part(folder: Path) -> None:
    (folder / "empty.urdf").write_text("<robot/>")
    assert found(folder, name="empty.urdf") == [("SCH004", "warning")]
    extras = '<xacro:include filename="$(optenv EXTRAS empty.urdf)"/>'
    (folder / "whole.xacro").write_text(ROBOT.format(f'<link name="torso"/>{extras}'))
    assert found(folder, name="empty.urdf") == []


def test_a_part_is_judged_where_it_is_included(folder: Path) -> None:
    joint = '<joint name="j" type="{}"><parent link="torso"/><child link="b"/></joint>'
    content = f'<link name="b"/>{joint}'
    assert ("JNT001", "error") in found(folder, content.format("fixed"), "part.xacro")
    (folder / "whole.xacro").write_text(
        ROBOT.format('<link name="torso"/><xacro:include filename="part.xacro"/>')
    )
    assert found(folder, content.format("fixed"), "part.xacro") == []
    assert found(folder, content.format("fixd"), "part.xacro") == [("SCH015", "error")]
    assert found(folder, name="whole.xacro") == [("SCH015", "error")]


@pytest.mark.parametrize(
    ("content", "code"),
    [
        (
            '<visual><geometry><sphere radius="1"/></geometry><material name="{}"/></visual>',
            "URD006",
        ),
        ('</link><gazebo reference="{}"/><link name="c">', "GAZ003"),
        ('</link><transmission name="t"><joint name="{}"/></transmission><link name="c">', "URD011"),
    ],
)
def test_a_part_names_parts_of_the_file_that_includes_it(folder: Path, content: str, code: str) -> None:
    part = '<link name="b">' + content.format("torso") + "</link>"
    assert code in dict(found(folder, part, "part.xacro"))
    has = '<material name="torso"><color rgba="1 1 1 1"/></material><link name="torso"/>'
    include = '<xacro:include filename="part.xacro"/>'
    (folder / "whole.xacro").write_text(ROBOT.format(has + include))
    assert code not in dict(found(folder, name="part.xacro"))


def test_a_block_in_a_file_of_several_robots_is_for_one_of_them(folder: Path) -> None:
    (folder / "blocks.xacro").write_text(PART.format('<gazebo reference="arm"><mu1>1</mu1></gazebo>'))
    include = '<xacro:include filename="blocks.xacro"/>'
    assert ("GAZ003", "error") in found(folder, f'<link name="base"/>{include}', "cart.xacro")
    (folder / "armed.xacro").write_text(ROBOT.format(f'<link name="arm"/>{include}'))
    assert ("GAZ003", "error") not in found(folder, name="cart.xacro")
    own = '<link name="base"/><gazebo reference="arm"/>'
    assert ("GAZ003", "error") in found(folder, own, "cart.xacro")


def test_a_robot_names_parts_of_one_that_includes_it(folder: Path) -> None:
    plugin = '<plugin name="g" filename="libgrip.so"><link_name>{}</link_name></plugin>'
    arm = f'<link name="arm"/><gazebo>{plugin}</gazebo>'
    assert found(folder, arm.format("hand"), "arm.xacro") == [("RES014", "error")]
    hand = '<link name="hand"/><joint name="j" type="fixed"><parent link="arm"/><child link="hand"/></joint>'
    (folder / "whole.xacro").write_text(ROBOT.format(f'<xacro:include filename="arm.xacro"/>{hand}'))
    assert found(folder, name="arm.xacro") == []
    assert found(folder, arm.format("hound"), "arm.xacro") == [("RES014", "error")]


@pytest.mark.parametrize("where", ['<xacro:include filename="{}"/>', '<xacro:arg name="f" default="{}"/>'])
def test_a_robot_without_links_that_another_file_includes_lacks_nothing(folder: Path, where: str) -> None:
    (folder / "empty.urdf").write_text('<robot name="r"></robot>')
    assert ("SCH004", "error") in found(folder, name="empty.urdf")
    (folder / "robot.xacro").write_text(ROBOT.format(where.format("empty.urdf")))
    assert found(folder, name="empty.urdf") == []


@pytest.mark.parametrize(
    "content",
    [
        '<link name="a"/><xacro:unless value="1"><joint name="j" type="fixd"/></xacro:unless>',
        '<link name="a"><xacro:if value="0"><visul/></xacro:if></link>',
        (
            '<link name="a"/><xacro:macro name="m" params="sim:=1"><xacro:unless value="${sim}"><link name="p"/>'
            '<joint name="j" type="fixd"><parent link="a"/><child link="p"/></joint></xacro:unless></xacro:macro>'
            "<xacro:m/>"
        ),
    ],
    ids=["top", "inside a link", "in a macro"],
)
def test_a_branch_that_is_not_taken_is_checked_as_it_is_written(folder: Path, content: str) -> None:
    assert [severity for _, severity in found(folder, content) if severity != "info"]
    taken = content.replace("fixd", "fixed").replace("<visul/>", "")
    assert not {code for code, _ in found(folder, taken)} & {"SCH015", "URD001"}


def test_a_macro_that_nobody_calls_stops_nothing(folder: Path) -> None:
    broken = '<xacro:macro name="wheel" params="r"><link name="${r)}"/></xacro:macro>'
    (folder / "wheel.xacro").write_text(PART.format(broken))
    assert found(folder, name="wheel.xacro") == [("XAC001", "warning")]
    (folder / "robot.urdf.xacro").write_text(
        ROBOT.format('<xacro:include filename="wheel.xacro"/><xacro:wheel r="1"/>')
    )
    assert found(folder, name="wheel.xacro") == [("XAC001", "error")]


def test_a_wrong_value_is_one_mistake_wherever_it_is_asked_for(folder: Path) -> None:
    uses = '<xacro:if value="${cut}"><link name="b"/></xacro:if>' * 2
    macro = f'<xacro:macro name="m" params="cut">{uses}</xacro:macro>'
    text = f'<xacro:arg name="cut" default="flase"/>{macro}<link name="a"/><xacro:m cut="$(arg cut)"/>'
    assert found(folder, text) == [("XAC001", "error")]


def test_a_parameter_that_a_macro_asks_for_and_does_not_take_is_one_mistake(folder: Path) -> None:
    macro = '<xacro:macro name="m" params=""><link name="${side}"/></xacro:macro>'
    calls = '<xacro:m side="l"/><xacro:m side="r"/>'
    assert found(folder, f"{macro}{calls}") == [("XAC004", "error")]


def test_a_macro_may_be_in_a_file_that_another_argument_includes(folder: Path) -> None:
    for name in ("arm_short", "arm_long"):
        macro = f'<xacro:macro name="{name}" params=""><link name="{name}"/></xacro:macro>'
        (folder / f"{name}.xacro").write_text(PART.format(macro))
    text = (
        '<xacro:arg name="size" default="short"/><xacro:include filename="arm_$(arg size).xacro"/>'
        "<xacro:if value=\"${'$(arg size)' == 'short'}\"><xacro:arm_short/></xacro:if>"
        "<xacro:if value=\"${'$(arg size)' == 'long'}\"><xacro:arm_long/></xacro:if>"
    )
    assert found(folder, text) == []


def test_a_part_of_a_robot_that_nobody_includes_lacks_a_link_with_a_warning(folder: Path) -> None:
    found(folder, '<link name="hand"/>')
    part = '<link name="tip"/><joint name="j" type="fixed"><parent link="{}"/><child link="tip"/></joint>'
    assert found(folder, part.format("hand"), "tip.xacro") == [("JNT001", "warning")]
    assert found(folder, part.format("arm"), "tip.xacro") == [("JNT001", "error")]


def test_a_block_that_an_includer_defines_is_not_missing(folder: Path) -> None:
    part = '<robot name="r" xmlns:xacro="http://ros.org/wiki/xacro"><link name="b"/>{}</robot>'
    (folder / "links.xacro").write_text(part.format('<xacro:insert_block name="mount"/>'))
    assert found(folder, name="links.xacro") == [("XAC001", "error")]
    blocks = '<xacro:property name="mount"><link name="a"/></xacro:property>'
    (folder / "robot.urdf.xacro").write_text(ROBOT.format(f'{blocks}<xacro:include filename="links.xacro"/>'))
    assert found(folder, name="links.xacro") == []


def test_a_file_that_the_build_of_its_package_makes_is_not_missing(folder: Path) -> None:
    text = '<xacro:include filename="$(find p)/urdf/made.urdf"/><link name="a"/>'
    (folder / "package.xml").write_text("<package><name>p</name></package>")
    (folder / "CMakeLists.txt").write_text("install(FILES urdf/made.urdf DESTINATION share/p/urdf)")
    assert found(folder, text) == [("XAC001", "error")]
    (folder / "CMakeLists.txt").write_text("file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/urdf/made.urdf x)")
    assert found(folder, text) == [("XAC001", "warning")]


def test_a_macro_that_another_file_calls_in_a_plugin_is_not_of_a_robot(folder: Path) -> None:
    macro = (
        '<xacro:macro name="left_out" params="side"><joint name="${side}_a"/><joint name="b"/></xacro:macro>'
    )
    (folder / "names.xacro").write_text(PART.format(macro))
    assert {code for code, _ in found(folder, name="names.xacro")} == {"SCH004", "SCH005"}
    call = '<xacro:left_out side="l"/>'
    plugin = f'<gazebo><plugin name="n" filename="f"><ignore>{call}</ignore></plugin></gazebo>'
    (folder / "plugin.xacro").write_text(PART.format(f'<xacro:include filename="names.xacro"/>{plugin}'))
    assert found(folder, name="names.xacro") == []


def test_a_value_over_several_lines_is_one_for_xacro(folder: Path) -> None:
    joint = (
        '<joint name="j" type="fixed"><parent link="a"/><child link="b"/><origin xyz="0\n  1\n  0"/></joint>'
    )
    text = f'<link name="a"/><link name="b"/><xacro:macro name="m" params="">{joint}</xacro:macro>'
    assert "SCH011" not in {code for code, _ in found(folder, text)}
    assert "SCH011" not in {code for code, _ in found(folder, f"{text}<xacro:m/>")}
    plain = f'<robot name="r"><link name="a"/><link name="b"/>{joint}</robot>'
    assert found(folder, plain, "robot.urdf") == [("SCH011", "error")]
