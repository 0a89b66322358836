"""Arguments without a default are taken from launch files of the project, which are read and never run."""

from __future__ import annotations

import time
from pathlib import Path

import pytest

import sdfcheck
from sdfcheck.cli.main import main

XACRO = """<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="tool" default="none"/>
  <link name="$(arg side)_base"/>
  <xacro:if value="$(arg gripper)">
    <link name="gripper"/>
  </xacro:if>
</robot>
"""
ROS_1 = """<launch>
  <arg name="s" default="right"/>
  <param name="robot_description"
         command="$(find xacro)/xacro '$(find bot)/urdf/bot.urdf.xacro' side:=$(arg s) gripper:=true"/>
</launch>
"""
ROS_2 = """<launch>
  <arg name="s" default="right"/>
  <let name="file" value="bot.urdf.xacro"/>
  <let name="d" value="$(command 'xacro $(find-pkg-share bot)/urdf/$(var file) side:=$(var s) gripper:=true')"/>
</launch>
"""
PYTHON = """
from launch.substitutions import Command, LaunchConfiguration
open("ran", "w")

def generate_launch_description():
    arguments = [DeclareLaunchArgument("gripper", default_value="true"),
                 DeclareLaunchArgument(name="file", default_value="bot" + ".urdf.xacro")]
    gripper = LaunchConfiguration("gripper")
    robot = Command([
        PathJoinSubstitution([FindExecutable(name="xacro")]), " ",
        PathJoinSubstitution([FindPackageShare("bot"), "urdf", LaunchConfiguration("file")]), " ",
        "side:=", "right", " gripper:=", gripper, " tool:=", LaunchConfiguration("tool"),
    ])
"""
MAPPINGS = """
import os, xacro
folder = get_package_share_directory("bot")
path = os.path.join(folder, "urdf", "bot.urdf.xacro")
robot = xacro.process_file(path, mappings={"side": "right", "gripper": "true", "tool": choose()})
"""
CHOSEN = PYTHON.replace(
    'LaunchConfiguration("file")',
    """PythonExpression(["'other.urdf.xacro' if '", LaunchConfiguration("tool"), "'.endswith('h') and not '",
                         LaunchConfiguration("file"), "' == 'a' else '", LaunchConfiguration("file"), "'"])""",
)
PROCESS = """
ExecuteProcess(
    cmd=["xacro", PathJoinSubstitution([FindPackageShare("bot"), "urdf", "bot.urdf.xacro"]), "side:=right",
         "gripper:=true", "|", "ros2", "run", "gazebo_ros", "spawn_entity.py", "-stdin", "-entity", "bot"],
    shell=True,
)
"""


@pytest.fixture
def package(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "package.xml").write_text("<package><name>bot</name></package>\n")
    (tmp_path / "urdf").mkdir()
    (tmp_path / "launch").mkdir()
    (tmp_path / "urdf" / "bot.urdf.xacro").write_text(XACRO)
    return tmp_path


def found(capsys: pytest.CaptureFixture[str]) -> list[str]:
    main(["lint", "--output-format", "concise", "."])
    return [line for line in capsys.readouterr().out.splitlines() if line.endswith("]")]


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("bot.launch", ROS_1),
        ("bot.launch.xml", ROS_2),
        ("bot_launch.xml", ROS_2),
        ("bot.launch.py", PYTHON),
        ("chosen.launch.py", CHOSEN),
        ("view_launch.py", MAPPINGS),
        ("view.py", MAPPINGS),
        ("spawn.launch.py", PROCESS),
    ],
)
def test_the_robot_is_expanded_as_it_is_launched(
    package: Path, capsys: pytest.CaptureFixture[str], name: str, text: str
) -> None:
    (package / "launch" / name).write_text(text)
    assert found(capsys) == [
        "urdf/bot.urdf.xacro:5:6: error: no joint ties link `gripper` to the rest of the robot [URD004]"
    ]
    assert not (package / "ran").exists()


COMMON = ROS_1.replace('<arg name="s" default="right"/>', '<arg name="s"/>')
INCLUDING = {
    "all": (
        "common.launch",
        COMMON,
        "right.launch",
        """<launch>
  <arg name="s" value="right"/>
  <include file="$(find bot)/launch/common.launch" pass_all_args="true"/>
</launch>
""",
    ),
    "one": (
        "common.launch",
        COMMON,
        "right.launch",
        """<launch>
  <arg name="which" default="common"/>
  <include file="$(find bot)/launch/$(arg which).launch">
    <arg name="s" value="right"/>
  </include>
</launch>
""",
    ),
    "ROS 2": (
        "common.launch.xml",
        ROS_2.replace('<arg name="s" default="right"/>', '<arg name="s"/>'),
        "right.launch.xml",
        """<launch>
  <let name="s" value="right"/>
  <include file="$(find-pkg-share bot)/launch/common.launch.xml"/>
</launch>
""",
    ),
    "Python": (
        "common.launch.py",
        PYTHON.replace('"right"', 'LaunchConfiguration("s")'),
        "right.launch.py",
        """
arguments = {"s": LaunchConfiguration("where")}
declared = DeclareLaunchArgument("where", default_value="right")
source = PythonLaunchDescriptionSource(
    PathJoinSubstitution([FindPackageShare("bot"), "launch", "common.launch.py"]))
launch = IncludeLaunchDescription(source, launch_arguments=arguments.items())
""",
    ),
}


@pytest.mark.parametrize("case", INCLUDING)
def test_a_launch_file_gives_arguments_to_those_that_it_includes(
    package: Path, capsys: pytest.CaptureFixture[str], case: str
) -> None:
    name, text, other, including = INCLUDING[case]
    (package / "launch" / name).write_text(text)
    assert "argument `side` has no value" in found(capsys)[0]
    (package / "launch" / other).write_text(including)
    (message,) = found(capsys)
    assert message.endswith("error: no joint ties link `gripper` to the rest of the robot [URD004]")


def test_a_launch_file_may_include_itself(package: Path, capsys: pytest.CaptureFixture[str]) -> None:
    include = '<include file="a.launch" pass_all_args="true"/>'
    (package / "launch" / "a.launch").write_text(f"<launch>{include}{include}{include}</launch>")
    assert "argument `side` has no value" in found(capsys)[0]


NEEDS_FILE = """<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="sizes" default=""/>
  <xacro:property name="size" value="${xacro.load_yaml('$(arg sizes)')}"/>
  <link name="${size['base']}"/>
</robot>
"""
GIVES_FILE = """<launch>
  <arg name="sizes" default="$(find bot)/config/sizes.yaml"/>
  <param name="robot_description" command="xacro '$(find bot)/urdf/bot.urdf.xacro' sizes:=$(arg sizes)"/>
</launch>
"""


def test_a_default_that_is_not_used_as_it_is(package: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Also, packages in the arguments of a launch file are found."""
    (package / "urdf" / "bot.urdf.xacro").write_text(NEEDS_FILE)
    (package / "config").mkdir()
    (package / "config" / "sizes.yaml").write_text("base: b\n")
    assert "[XAC001]" in found(capsys)[0]
    (package / "launch" / "bot.launch").write_text(GIVES_FILE)
    assert found(capsys) == []


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("none.txt", ""),
        ("other.launch", ROS_1.replace("bot.urdf", "cart.urdf")),
        ("unknown.launch", ROS_1.replace('default="right"', "")),
        ("unknown.launch.py", PYTHON.replace('"side:=", "right"', '"side:=", choose()')),
        ("broken.launch.py", PYTHON + "("),
        ("deep.launch.py", "# xacro\n" + "(" * 5000),
        ("ring.launch.py", PYTHON.replace('"right"', "side") + "\nside = other\nother = side\n"),
        ("ring.launch", ROS_1.replace('default="right"', 'default="$(arg s)"')),
    ],
)
def test_without_a_value_the_argument_is_missing(
    package: Path, capsys: pytest.CaptureFixture[str], name: str, text: str
) -> None:
    (package / "launch" / name).write_text(text)
    (message, *others) = found(capsys)
    assert message.endswith("argument `side` has no value, so what depends on it is not checked [XAC001]")
    assert all("[XAC001]" in other for other in others)


def test_two_launch_files_of_one_name(package: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for folder, text in (("launch", "<launch/>"), ("other", ROS_1)):
        (package / folder).mkdir(exist_ok=True)
        (package / folder / "bot.launch").write_text(text)
    assert "no joint ties link `gripper`" in found(capsys)[0]


def test_arguments_of_an_include_are_not_those_of_the_file(
    package: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    include = '<include file="other.launch"><arg name="s" value="right"/></include>'
    (package / "launch" / "bot.launch").write_text(
        ROS_1.replace('<arg name="s" default="right"/>', f"{include}<include file='x'/>")
    )
    assert "argument `side` has no value" in found(capsys)[0]


_LAUGHS = "".join(f'<arg name="a{n}" default="{f"$(arg a{n + 1})" * 60}"/>' for n in range(20))
BOMBS = {
    "references.launch": f'<launch>{_LAUGHS}<param command="xacro bot.urdf.xacro side:=$(arg a0)"/></launch>',
    "word.launch": f'<launch><param command="xacro bot.urdf.xacro side:= {"a" * 60_000}"/></launch>',
    "sums.launch.py": "\n".join(f"a{n} = [a{n + 1}, a{n + 1}, a{n + 1}, a{n + 1}]" for n in range(28))
    + "\na28 = 'x'\nCommand(['xacro bot.urdf.xacro side:=', a0])\n",
    "long.launch.py": "# xacro\nx" + ".a" * 200_000,
    "open.launch": "<launch>" + "<include>" * 100_000,
    "quotes.launch": "<launch>xacro" + "<include file='<arg name=" * 40_000,
    "self.launch": "<launch>"
    + "<include file='self.launch' pass_all_args='true'/>" * 100
    + "<param command='xacro cart.urdf.xacro side:=$(arg a)'/>" * 2_000
    + "</launch>",
    "names.launch": "<launch>"
    + "".join(f"<arg name='a{n}' default='{n}'/>" for n in range(10_000))
    + "<include file='names.launch' pass_all_args='true'/>" * 5_000
    + "</launch>",
    "names.launch.py": "".join(f"DeclareLaunchArgument('a{n}', default_value='{n}')\n" for n in range(5_000))
    + "IncludeLaunchDescription('names.launch.py', launch_arguments={'a': 'b'})\n" * 1_000,
}


@pytest.mark.parametrize("name", BOMBS)
def test_launch_files_do_not_take_long(package: Path, capsys: pytest.CaptureFixture[str], name: str) -> None:
    (package / "launch" / name).write_text(BOMBS[name])
    begin = time.process_time()
    assert all("[XAC001]" in line for line in found(capsys))
    assert time.process_time() - begin < 5


def test_arguments_of_the_command_line_are_stronger(
    package: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (package / "launch" / "bot.launch").write_text(ROS_1)
    assert main(["lint", ".", "gripper:=false"]) == 0


def codes(package: Path) -> list[str]:
    """The warnings and errors of all files, by their codes."""
    run = sdfcheck.lint(package, isolated=True)
    return [each.code for each in run.diagnostics if each.severity is not sdfcheck.Severity.INFO]


NOTED = """<!-- author: me -->
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <link name="base_link"/><link name="a"/><xacro:macro name="m" params=""/><xacro:m/>
  <joint name="j" type="fixed"><parent link="base_link"/><child link="a"/></joint>
</robot>
"""
AS_YAML = """
robot = Command(["xacro ", PathJoinSubstitution([FindPackageShare("bot"), "urdf", "bot.urdf.xacro"])])
"""


@pytest.mark.parametrize(
    ("launch", "manifest", "is_found"),
    [
        (AS_YAML, "<package><name>bot</name></package>", True),
        (AS_YAML.replace("Command(", "ParameterValue(Command(") + ", value_type=str)", "", False),
        (AS_YAML, "<package><name>bot</name><buildtool_depend>catkin</buildtool_depend></package>", False),
        (MAPPINGS, "<package><name>bot</name></package>", False),
        (AS_YAML.replace('"bot.urdf.xacro"', "choose()"), "", True),
        (AS_YAML.replace('"bot.urdf.xacro"', "choose()") + "text = ParameterValue(robot)\n", "", False),
        ("", "", True),
    ],
)
def test_colons_break_what_is_read_as_yaml(
    package: Path, launch: str, manifest: str, *, is_found: bool
) -> None:
    (package / "package.xml").write_text(manifest or "<package><name>bot</name></package>")
    (package / "urdf" / "bot.urdf.xacro").write_text(NOTED)
    (package / "launch" / "bot.launch.py").write_text(launch)
    assert ("URD015" in codes(package)) is is_found


OPENED = """
import os, xacro
path = os.path.join(get_package_share_directory("bot"), "urdf", "bot.urdf")
robot = xacro.parse(open(path))
xacro.process_doc(robot)
"""


@pytest.mark.parametrize(
    ("launch", "is_launched"),
    [
        ("", False),
        (AS_YAML.replace(".xacro", ""), True),
        (OPENED, True),
        (OPENED.replace("process_", ""), False),
    ],
)
def test_a_source_may_be_called_urdf(package: Path, launch: str, *, is_launched: bool) -> None:
    (package / "urdf" / "bot.urdf.xacro").unlink()
    (package / "urdf" / "bot.urdf").write_text(
        '<robot name="r"><link name="${1 + 1}"/><link name="2"/></robot>'
    )
    (package / "launch" / "bot.launch.py").write_text(launch)
    assert codes(package)[0] == ("NAM001" if is_launched else "URD009")


def test_launched_arguments_count_without_a_package(package: Path) -> None:
    include = '<xacro:include filename="$(find absent)/a.xacro"/></robot>'
    (package / "urdf" / "bot.urdf.xacro").write_text(XACRO.replace("</robot>", include))
    (package / "launch" / "bot.launch").write_text(ROS_1)
    assert codes(package) == ["XAC007"]


def test_an_include_that_an_expansion_passes_is_found(package: Path) -> None:
    (package / "urdf" / "part.xacro").write_text(
        XACRO.replace("$(arg side)", "").replace("$(arg gripper)", "1")
    )
    (package / "urdf" / "bot.urdf.xacro").write_text(
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:arg name="side" default="/nowhere"/>'
        '<xacro:include filename="$(arg side)/part.xacro"/></robot>'
    )
    launch = MAPPINGS.replace('"side": "right"', '"side": folder + "/urdf"')
    (package / "launch" / "bot.launch.py").write_text(launch)
    assert "XAC001" not in codes(package)


def test_parts_in_plain_urdf_are_seen_where_they_are_included(package: Path) -> None:
    (package / "launch" / "bot.launch").write_text(ROS_1)
    (package / "urdf" / "colors.urdf").write_text('<robot name="r"><material name="red"/></robot>')
    (package / "urdf" / "part.urdf").write_text('<robot name="r"><link name="$(arg side)"/></robot>')
    assert "URD009" in codes(package)
    (package / "urdf" / "bot.urdf.xacro").write_text(
        XACRO.replace("</robot>", '<xacro:include filename="part.urdf"/></robot>')
    )
    assert "URD009" not in codes(package)


GENERATED = """<!-- | This document was autogenerated by xacro from ../urdf/old.urdf | -->
<robot name="r"><link name="left"/></robot>
"""


@pytest.mark.parametrize(
    ("file", "text", "part"),
    [
        (
            "urdf/bot.urdf",
            XACRO.replace("</robot>", '<xacro:include filename="part.urdf"/></robot>'),
            "part.urdf",
        ),
        ("made/old.urdf", GENERATED, "old.urdf"),
    ],
    ids=["included by plain URDF", "source of what is kept"],
)
def test_plain_urdf_is_a_source_where_the_project_says_so(
    package: Path, file: str, text: str, part: str
) -> None:
    (package / "urdf" / part).write_text('<robot name="r"><link name="${1}"/></robot>')
    assert "URD009" in codes(package)
    (package / file).parent.mkdir(exist_ok=True)
    (package / file).write_text(text)
    assert "URD009" not in codes(package)


def test_a_remark_of_xacro_without_an_end_costs_nothing(package: Path) -> None:
    (package / "urdf" / "old.urdf").write_text('<robot name="r"><link name="${1}"/></robot>')
    remark = GENERATED.replace("../urdf/old.urdf |", "a" * 300_000)
    (package / "made.urdf").write_text(remark)
    start = time.process_time()
    assert "URD009" in codes(package)
    assert time.process_time() - start < 5


@pytest.mark.parametrize(
    "choice",
    [
        "'a' if",
        "[c for c in 'a'] if 1 else 2",
        "open('ran', 'w')",
        "'a'.lower(1) == 2",
        "'a'.mro()",
        "1 < 2",
        "x",
    ],
)
def test_an_expression_that_is_no_choice_of_texts_is_not_known(package: Path, choice: str) -> None:
    (package / "launch" / "bot.launch.py").write_text(
        CHOSEN.replace("'other.urdf.xacro' if '", f"{choice} or '")
    )
    messages = [each.message for each in sdfcheck.lint(package, isolated=True).diagnostics]
    assert any(message.startswith("argument `side` has no value") for message in messages)
    assert not (package / "ran").exists()
