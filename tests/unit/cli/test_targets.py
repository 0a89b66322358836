"""``sdfcheck targets``."""

from __future__ import annotations

import json
from pathlib import Path
from typing import NamedTuple

import pytest

from sdfcheck.cli.main import main
from sdfcheck.cli.parts.descriptions import SearchContext
from sdfcheck.cli.targets import lines, verdicts
from sdfcheck.consumers import engines, measured
from sdfcheck.consumers.engines import Answer, Engine, Limits, Outcome, Question
from sdfcheck.consumers.reaction import Consumer
from sdfcheck.lint.config.configuration import Configuration

ROBOTS = Path(__file__).parents[3] / "fixtures" / "robots"
SOUND = str(ROBOTS / "two_link_arm" / "model.sdf")
SOUND_URDF = str(ROBOTS / "desk_arm" / "desk_arm.urdf")
BROKEN = str(ROBOTS / "with_mistakes" / "crane.urdf")


def test_a_sound_file(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["targets", SOUND, "--isolated"]) == 0
    unread = "not read: it does not know SDFormat"
    assert capsys.readouterr().out.splitlines() == [
        "drake      accept",
        "gazebo     accept",
        *(f"{name:9}  {unread}" for name in ("isaac", "mujoco", "pinocchio")),
        "pybullet   not measured: nobody has measured what its loadSDF does",
        *(f"{name:9}  {unread}" for name in ("ros", "urdfdom")),
    ]


def test_reasons(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["targets", BROKEN, "--isolated"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert "drake      reject" in lines
    assert any(
        "reject 5:" in line
        and "mass -20 is negative [INR001] (refuses the file, for nothing is left)" in line
        for line in lines
    )
    assert any(line.strip().startswith("and ") for line in lines)


@pytest.mark.parametrize(
    ("file", "consumer", "code"),
    [(SOUND, "gazebo", 0), (SOUND, "urdfdom", 1), (BROKEN, "urdfdom", 1)],
)
def test_one_consumer_decides(
    file: str, consumer: str, code: int, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["targets", file, "--isolated", "--target", consumer]) == code
    assert capsys.readouterr().out.startswith(consumer)


def test_json(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["targets", BROKEN, "--isolated", "--output-format", "json"]) == 0
    output = json.loads(capsys.readouterr().out)
    assert [row["consumer"] for row in output["consumers"]] == [
        "drake", "gazebo", "isaac", "mujoco", "pinocchio", "pybullet", "ros", "urdfdom"
    ]  # fmt: skip
    reason = output["consumers"][1]["reasons"][0]
    assert (reason["code"], reason["verdict"], reason["line"]) == ("INR001", "reject", 5)


def test_impossible_requests(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["targets", str(tmp_path / "none.sdf")]) == 2
    assert "no such file" in capsys.readouterr().err


def test_xacro_elements_left_in_urdf(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Simulators ignore it; a file for xacro is refused."""
    text = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><link name="a"/><xacro:grey/></robot>'
    for name, verdict in (("r.urdf", "warn"), ("r.urdf.xacro", "reject")):
        (tmp_path / name).write_text(text)
        main(["targets", str(tmp_path / name), "--isolated", "--output-format", "json"])
        answer = json.loads(capsys.readouterr().out)
        assert {row["consumer"]: row["verdict"] for row in answer["consumers"]}["urdfdom"] == verdict


class Stand(NamedTuple):
    """An engine that gives one answer to every question, and keeps them."""

    answer: Answer
    questions: list[Question]

    def ask(self, engine: Engine, question: Question, limits: Limits = engines.LIMITS) -> Answer:
        self.questions.append(question)
        return self.answer._replace(engine=engine)


@pytest.mark.parametrize(
    ("file", "outcome", "differs"),
    [
        (BROKEN, Outcome.REFUSED, False),
        (BROKEN, Outcome.CRASHED, False),
        (BROKEN, Outcome.ACCEPTED, True),
        (SOUND_URDF, Outcome.ACCEPTED, False),
        (SOUND_URDF, Outcome.REFUSED, True),
        (SOUND_URDF, Outcome.MISSING, False),
    ],
)
def test_predicted_and_real(
    file: str,
    outcome: Outcome,
    differs: bool,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    stand = Stand(
        Answer(Engine.URDFDOM, outcome, "7.1", "" if outcome is Outcome.ACCEPTED else "so it says"), []
    )
    monkeypatch.setattr(engines, "ask", stand.ask)
    line = ["targets", file, "--isolated", "--run", "--target", "urdfdom"]
    code = main(line)
    out = capsys.readouterr().out
    assert ("(differs)" in out) is differs
    assert ("so it says" in out) is (outcome is not Outcome.ACCEPTED)
    assert code == int(file == BROKEN or outcome is Outcome.REFUSED)
    main([*line, "--output-format", "json"])
    (row,) = json.loads(capsys.readouterr().out)["consumers"]
    assert (row["run"]["verdict"], row["run"]["differs"]) == (outcome.value, differs)


def test_a_refusal_for_what_is_not_here_is_no_difference(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    stand = Stand(Answer(Engine.DRAKE, Outcome.REFUSED, "1.0", "mesh not found"), [])
    monkeypatch.setattr(engines, "ask", stand.ask)
    file = tmp_path / "r.urdf"
    shape = '<geometry><mesh filename="package://lost/a.obj"/></geometry>'
    file.write_text(f'<robot name="r"><link name="a"><visual>{shape}</visual></link></robot>')
    main(["targets", str(file), "--isolated", "--run", "--target", "drake"])
    out = capsys.readouterr().out
    assert "run: drake 1.0: reject, as package `lost` is not found here (RES001)" in out
    assert "(differs)" not in out
    file.write_text(file.read_text().replace("package://lost/", "meshes/"))
    main(["targets", str(file), "--isolated", "--run", "--target", "drake"])
    assert "run: drake 1.0: reject, as a file is not found here (RES001)" in capsys.readouterr().out


def test_a_refusal_for_a_package_that_is_not_here_is_no_difference(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "r.urdf.xacro"
    file.write_text(
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><link name="a"/>'
        '<xacro:include filename="$(find lost)/a.xacro"/></robot>'
    )
    main(["targets", str(file), "--isolated", "--run", "--target", "urdfdom"])
    out = capsys.readouterr().out
    assert "run: urdfdom: reject, as package `lost` is not found here (XAC007)" in out
    assert "(differs)" not in out


def test_engines_get_xacro_expanded(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    stand = Stand(Answer(Engine.URDFDOM, Outcome.ACCEPTED), [])
    monkeypatch.setattr(engines, "ask", stand.ask)
    file = tmp_path / "r.urdf.xacro"
    file.write_text(
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><link name="${1 + 1}"/></robot>'
    )
    assert main(["targets", str(file), "--isolated", "--run", "--target", "urdfdom"]) == 0
    (question,) = stand.questions
    assert question.path != file
    assert question.path.suffix == ".urdf"
    assert not question.path.exists()
    assert list(tmp_path.iterdir()) == [file]


def test_reactions_that_nobody_has_measured_are_not_acceptance(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "r.urdf"
    file.write_text('<robot name="r"><link name="a"/><link name="b"/></robot>')
    line = ["targets", str(file), "--isolated", "--target", "pybullet"]
    assert main(line) == 1
    assert capsys.readouterr().out.startswith("pybullet  reject")
    monkeypatch.setattr(measured, "table", lambda: measured.Table("# pybullet: 1"))
    assert main(line) == 0
    assert capsys.readouterr().out.startswith("pybullet  not measured\n")
    file.write_text('<robot name="r"><link name="a"/></robot>')
    assert main(line) == 0
    assert capsys.readouterr().out == "pybullet  accept\n"
    monkeypatch.setattr(measured, "table", lambda: measured.Table(""))
    assert main(line) == 0
    assert capsys.readouterr().out.startswith("pybullet  not measured: ")


def test_consumers_with_another_parser_do_as_it_does(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "r.urdf"
    file.write_text('<robot name="r"><link name="a"/><link name="b"/></robot>')
    assert main(["targets", str(file), "--isolated", "--target", "urdfdom,ros"]) == 1
    assert [line.split()[:2] for line in capsys.readouterr().out.splitlines() if line[0] != " "] == [
        ["ros", "reject"],
        ["urdfdom", "reject"],
    ]


def test_reasons_fold_at_the_width_and_all_of_them_can_be_shown(tmp_path: Path) -> None:
    links = "".join(f'<link name="l{n}"><inertial><mass value="-1"/></inertial></link>' for n in range(9))
    (tmp_path / "r.urdf").write_text(f'<robot name="r">{links}</robot>')
    rows = verdicts(tmp_path / "r.urdf", [Consumer.MUJOCO], SearchContext(Configuration(isolated=True)))
    folded = list(lines(rows, tmp_path / "r.urdf", width=60, color=True))
    assert folded[0] == "mujoco  \x1b[1;31mreject\x1b[0m"
    assert max(map(len, folded[1:])) <= 60
    assert folded[-1].endswith("--all shows each place")
    assert any("like it: " in line for line in folded)
    whole = list(lines(rows, tmp_path / "r.urdf", most=None))
    assert len(whole) == 1 + len(rows[0].reasons) > 6


@pytest.mark.parametrize(
    ("name", "text", "consumer", "code"),
    [
        (
            "a.urdf",
            (
                '<robot name="r"><link name="l"><visual><geometry><mesh filename="m.glb"/></geometry></visual>'
                "</link></robot>"
            ),
            "pybullet",
            "GEO019",
        ),
        (
            "w.sdf",
            '<sdf version="1.9"><world name="w"><include><uri>model://cart</uri></include></world></sdf>',
            "drake",
            "DRK023",
        ),
    ],
)
def test_rules_that_are_on_for_one_consumer(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], name: str, text: str, consumer: str, code: str
) -> None:
    (tmp_path / name).write_text(text)
    assert main(["targets", "--target", consumer, str(tmp_path / name)]) == 1
    assert f"[{code}]" in capsys.readouterr().out
    main(["lint", "--target", "gazebo", "--output-format", "concise", str(tmp_path / name)])
    assert f"[{code}]" not in capsys.readouterr().out


XACRO = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'


def included(folder: Path, content: str, name: str = "") -> Path:
    """A file for xacro that another one includes."""
    (folder / "whole.urdf.xacro").write_text(
        f'<robot name="whole" {XACRO}><xacro:arg name="side" default="left"/>'
        '<xacro:include filename="part.urdf.xacro"/></robot>'
    )
    path = folder / "part.urdf.xacro"
    path.write_text(f"<robot {name} {XACRO}>{content}</robot>")
    return path


def test_a_part_of_robots_is_not_read(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    part = included(tmp_path, '<link name="base"/>')
    assert main(["targets", str(part), "--isolated", "--target", "drake"]) == 1
    assert capsys.readouterr().out.startswith(
        "drake  not read: it is a part for other xacro files: a robot has a"
    )


def test_an_included_robot_is_judged_as_a_whole(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    part = included(tmp_path, '<link name="$(arg side)_base"/>', 'name="part"')
    assert main(["lint", str(part), "--isolated"]) == 0
    capsys.readouterr()
    assert main(["targets", str(part), "--isolated"]) == 0
    shown = capsys.readouterr().out
    assert shown.count("reject\n") == len(Consumer)
    assert "(gets no robot description)" in shown


def test_reasons_that_read_alike_share_a_line(tmp_path: Path) -> None:
    links = "".join(
        f'<link name="l{n}"><collision><geometry><mesh filename="m.dae"/></geometry></collision></link>'
        for n in range(3)
    )
    (tmp_path / "r.urdf").write_text(f'<robot name="r">{links}</robot>')
    (tmp_path / "m.dae").write_text("<COLLADA/>")
    rows = verdicts(tmp_path / "r.urdf", [Consumer.DRAKE], SearchContext(Configuration(isolated=True)))
    said = [line for line in lines(rows, tmp_path / "r.urdf") if "DRK009" in line]
    assert len(said) == 1
    assert "and 2 other places: a `.dae` file cannot be a collision" in said[0]
    each = [line for line in lines(rows, tmp_path / "r.urdf", most=None) if "DRK009" in line]
    assert len(each) == 3


def test_macros_and_materials_are_a_part_of_robots(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "cabinet.urdf.xacro"
    material = '<material name="m"><color rgba="1 0 0 1"/></material>'
    macro = '<xacro:macro name="cabinet" params="parent"><link name="cabinet"/></xacro:macro>'
    file.write_text(f'<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">{material}{macro}</robot>')
    main(["targets", str(file), "--isolated", "--target", "urdfdom"])
    assert "urdfdom  not read: it is a part for other xacro files" in capsys.readouterr().out


def test_xacro_of_sdformat_is_for_readers_of_sdformat(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "m.sdf.xacro"
    model = '<model name="m"><link name="${n}"/></model>'
    file.write_text(
        '<sdf version="1.9" xmlns:xacro="http://www.ros.org/wiki/xacro">'
        f'<xacro:property name="n" value="l"/>{model}</sdf>'
    )
    main(["targets", str(file), "--isolated", "--target", "gazebo,urdfdom"])
    gazebo, *_, urdfdom = capsys.readouterr().out.splitlines()
    assert gazebo.startswith("gazebo   ")
    assert urdfdom == "urdfdom  not read: it does not know SDFormat"


def test_macros_with_links_that_nothing_calls_make_no_robot(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "robot.xacro"
    robot = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">{}</robot>'
    inner = '<xacro:macro name="inner" params="n"><link name="${n}"/></xacro:macro>'
    outer = '<xacro:macro name="outer" params="n"><xacro:inner n="${n}"/></xacro:macro>'
    (tmp_path / "macros.xacro").write_text(robot.format(inner + outer))
    include = '<xacro:include filename="macros.xacro"/><transmission name="t"/><gazebo reference="a"/>'
    for call, is_robot in (("", False), ('<xacro:outer n="a"/>', True)):
        file.write_text(robot.format(include + call))
        main(["targets", str(file), "--isolated", "--target", "urdfdom"])
        assert ("not read: it is a part" not in capsys.readouterr().out) is is_robot


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("version https://git-lfs.github.com/spec/v1\noid sha256:aa\nsize 12\n", "a Git LFS pointer"),
        ('{% for x in y %}<sdf version="1.9">{% endfor %}</sdf>', "a template"),
        ("<mujoco/>", "MJCF"),
    ],
)
def test_a_file_of_another_kind_gets_no_verdict(
    text: str, words: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "model.sdf"
    file.write_text(text)
    assert main(["targets", str(file), "--isolated"]) == 2
    shown = capsys.readouterr()
    assert words in shown.err
    assert "accept" not in shown.out


def test_settings_alone_are_a_part_of_robots(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "robot.gazebo.xacro"
    gazebo = '<gazebo reference="base"><material>Gazebo/Red</material></gazebo>'
    file.write_text(f'<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">{gazebo}</robot>')
    main(["targets", str(file), "--isolated", "--target", "urdfdom"])
    assert "urdfdom  not read: it is a part for other xacro files" in capsys.readouterr().out


def test_macros_for_worlds_are_a_part(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "ball.xacro"
    macro = (
        '<xacro:macro name="ball" params="name"><model name="${name}"><link name="l"/></model></xacro:macro>'
    )
    file.write_text(f'<sdf version="1.7" xmlns:xacro="http://www.ros.org/wiki/xacro">{macro}</sdf>')
    main(["targets", str(file), "--isolated", "--target", "drake"])
    assert "drake  not read: it is a part for other xacro files" in capsys.readouterr().out


def test_links_in_an_element_of_another_format_make_no_robot(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "pond.xacro"
    model = '<model name="floor"><link name="floor"/></model>'
    file.write_text(f'<robot name="pond" xmlns:xacro="http://www.ros.org/wiki/xacro">{model}</robot>')
    main(["targets", str(file), "--isolated", "--target", "urdfdom"])
    assert "urdfdom  not read: it is a part for other xacro files" in capsys.readouterr().out


def test_version_1_0_is_read_by_drake_alone(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "old.sdf"
    file.write_text(
        '<sdf version="1.0"><model name="m"><link name="a"><pose frame="">0 0 0 0 0 0</pose></link></model></sdf>'
    )
    main(["targets", str(file), "--isolated", "--target", "drake,gazebo"])
    shown = capsys.readouterr().out
    assert "drake   accept" in shown
    assert "gazebo  reject" in shown


def test_repeated_names_in_an_unknown_element(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    interfaces = '<state_interface name="velocity"/>' * 2
    control = f'<ros2_control name="c"><joint name="j">{interfaces}</joint></ros2_control>'
    file = tmp_path / "controlled.sdf"
    file.write_text(f'<sdf version="1.9"><model name="m"><link name="a"/>{control}</model></sdf>')
    main(["targets", str(file), "--isolated", "--target", "gazebo"])
    assert "its checker refuses the file for a repeated name" in capsys.readouterr().out


def test_a_name_of_another_kind_hides_no_repeated_one(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    shapes = [f'<{kind} name="v"><geometry><empty/></geometry></{kind}>' for kind in ("visual", "collision")]
    file = tmp_path / "arm.sdf"
    content = "".join((*shapes, shapes[1]))
    file.write_text(f'<sdf version="1.9"><model name="m"><link name="a">{content}</link></model></sdf>')
    main(["targets", str(file), "--isolated", "--target", "drake"])
    assert "there is another collision `v` in link `a`" in capsys.readouterr().out


def test_materials_alone_are_no_robot(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "colors.urdf").write_text(
        '<robot name="colors"><material name="gray"><color rgba="0.5 0.5 0.5 1"/></material></robot>'
    )
    assert main(["targets", str(tmp_path / "colors.urdf"), "--target", "urdfdom"]) == 1
    assert "urdfdom  not read: it is a part for other files: a robot has a link" in capsys.readouterr().out
