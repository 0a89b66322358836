"""The verdicts of consumers on a robot with a mistake: predicted, and their own."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from sdfcheck.cli.parts.descriptions import SearchContext
from sdfcheck.cli.targets import verdicts
from sdfcheck.consumers.engines import RUN_BY, Answer, Limits, Question, ask_all, is_installed
from sdfcheck.consumers.reaction import Consumer, Verdict
from sdfcheck.lint.config.configuration import Configuration
from tests.each import each

pytestmark = pytest.mark.peers

ROBOT = """
<robot name="r"><material name="m"><color rgba="1 0 0 1"/></material>
<link name="a"><inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>
<visual><geometry><box size="1 1 1"/></geometry><material name="m"/></visual></link>
<link name="b"><inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>
<collision><geometry><sphere radius="1"/></geometry></collision></link>
<joint name="j" type="revolute"><parent link="a"/><child link="b"/><axis xyz="0 0 1"/>
<limit lower="0" upper="1" effort="1" velocity="1"/></joint></robot>
""".strip()

OLDEST = 17
"""The release of libsdformat whose verdicts are predicted."""
WITHOUT = {
    "the name of the robot": (' name="r"', ""),
    "the name of a link": ('<link name="b">', "<link>"),
    "the name of a joint": (' name="j"', ""),
    "the type of a joint": (' type="revolute"', ""),
    "the link of a parent": ('<parent link="a"/>', "<parent/>"),
    "the parent": ('<parent link="a"/>', ""),
    "the child": ('<child link="b"/>', ""),
    "the size of a box": ('<box size="1 1 1"/>', "<box/>"),
    "the file of a mesh": ('<box size="1 1 1"/>', "<mesh/>"),
    "the radius of a sphere": ('<sphere radius="1"/>', "<sphere/>"),
    "the length of a cylinder": ('<sphere radius="1"/>', '<cylinder radius="1"/>'),
    "the geometry of a visual": ('<geometry><box size="1 1 1"/></geometry>', ""),
    "the mass": ('<mass value="1"/>', "<mass/>"),
    "the direction of an axis": (' xyz="0 0 1"', ""),
    "the limit": ('<limit lower="0" upper="1" effort="1" velocity="1"/>', ""),
    "the effort": (' effort="1"', ""),
    "the name of a material": ('<material name="m"><', "<material><"),
    "the name of a visual's material": ('<material name="m"/>', "<material/>"),
    "the name of a visual's color": ('<material name="m"/>', '<material><color rgba="1 0 0 1"/></material>'),
    "a color": (' rgba="1 0 0 1"', ""),
    "the file of a texture": ('<color rgba="1 0 0 1"/>', "<texture/>"),
    "the leader of a mimic": ("</joint>", "<mimic/></joint>"),
    "the letters of a joint's name": ('name="j"', 'name=""'),
    "the letters of a type": ('type="revolute"', 'type=""'),
    "the letters of a file": ('<box size="1 1 1"/>', '<mesh filename=""/>'),
    "the number of a mass": ('mass value="1"', 'mass value=""'),
    "the number of a moment": ('ixx="1"', 'ixx=""'),
    "the number of a radius": ('radius="1"', 'radius=""'),
    "the number of a limit": ('lower="0"', 'lower=""'),
    "the numbers of an axis": ('xyz="0 0 1"', 'xyz=""'),
    "the numbers of a color": ('rgba="1 0 0 1"', 'rgba=""'),
    "the numbers of an origin": ("<visual>", '<visual><origin xyz=""/>'),
    "one number of an axis": ('xyz="0 0 1"', 'xyz="0 1"'),
    "one number of an origin": ("<visual>", '<visual><origin xyz="0 0"/>'),
    "one number of a color": ('rgba="1 0 0 1"', 'rgba="1 0 0"'),
    "spaces between numbers": ('xyz="0 0 1"', 'xyz="0,0,1"'),
    "an exponent": ('ixx="1"', 'ixx="1e"'),
    "nothing but a unit": ('radius="1"', 'radius="1m"'),
    "a number": ('upper="1"', 'upper="pi"'),
    "a type that is known": ('type="revolute"', 'type="hinge"'),
    "a type that all know": ('type="revolute"', 'type="spherical"'),
    "a link that is there": ('child link="b"', 'child link="c"'),
    "another link of a name": ("</robot>", '<link name="b"/></robot>'),
    "another joint of a name": (
        "</robot>",
        '<link name="c"/><joint name="j" type="fixed"><parent link="b"/><child link="c"/></joint></robot>',
    ),
    "another material of a name": (
        "</robot>",
        '<material name="m"><color rgba="1 0 0 1"/></material></robot>',
    ),
    "another child of a joint": ('child link="b"', 'child link="a"'),
    "a second mass": ("<visual>", '<inertial><mass value="1"/></inertial><visual>'),
    "a second axis": ("</joint>", '<axis xyz="0 1 0"/></joint>'),
    "limits in order": ('lower="0" upper="1"', 'lower="1" upper="0"'),
    "a positive mass": ('mass value="1"', 'mass value="-1"'),
    "a material that is defined": ('<material name="m"/>', '<material name="n"/>'),
    "a joint to mimic": ("</joint>", '<mimic joint="k"/></joint>'),
    "a joint to the link": ("</robot>", '<link name="c"/></robot>'),
    "a single axis": ('type="revolute"', 'type="floating"'),
    "the digits of a mass": ('<mass value="1"/>', '<mass value="kg"/>'),
}
"""Missing part → the text that has it, and the one that does not."""


@pytest.mark.parametrize("consumer", list(Consumer))
def test_the_verdict_is_that_of_the_consumer(tmp_path: Path, consumer: Consumer) -> None:
    engine = RUN_BY[consumer]
    if not is_installed(engine):
        pytest.skip(f"{engine.value} is not installed")
    files = [
        written(tmp_path / f"{number}" / "robot.urdf", *texts)
        for number, texts in enumerate(WITHOUT.values())
    ]
    answers = list(ask_all(engine, map(Question, files), Limits(20.0)))
    version = answers[0].version
    if consumer is Consumer.GAZEBO and int(version.partition(".")[0] or 0) < OLDEST:
        pytest.skip(f"libsdformat {version} is older than the one whose verdicts are predicted")

    def check(case: tuple[str, Path, Answer]) -> None:
        _, file, answer = case
        (row,) = verdicts(file, (consumer,), SearchContext(Configuration(isolated=True)))
        words = re.sub(r"\s+", " ", answer.error)[:200]
        assert (row.verdict is Verdict.REJECT) is (not answer.is_accepted), (row.verdict, words)

    each(list(zip(WITHOUT, files, answers, strict=True)), check, lambda case: case[0])


def written(file: Path, with_it: str, without: str) -> Path:
    assert with_it in ROBOT
    file.parent.mkdir()
    file.write_text(ROBOT.replace(with_it, without, 1), "utf-8")
    return file
