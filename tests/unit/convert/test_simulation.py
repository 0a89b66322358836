"""``sdfcheck simulate``: planted defects of robots, and robots that behave."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from sdfcheck.cli.main import main
from sdfcheck.consumers.engines import SIMULATORS, Engine, is_installed
from sdfcheck.convert.simulation import Subject

ROBOTS = Path(__file__).parents[3] / "fixtures" / "robots"
pytestmark = pytest.mark.peers
ENGINES = [pytest.param(engine, id=engine.value) for engine in SIMULATORS]


def inertial(mass: float, moment: float) -> str:
    return (
        f'<inertial><mass value="{mass}"/>'
        f'<inertia ixx="{moment}" iyy="{moment}" izz="{moment}" ixy="0" ixz="0" iyz="0"/></inertial>'
    )


def box(size: str, at: str = "0 0 0") -> str:
    return f'<collision><origin xyz="{at}"/><geometry><box size="{size}"/></geometry></collision>'


def arm(*, tool_at: str = "0 0 0.2", effort: float = 20, mass: float = 1, extra: str = "") -> str:
    """A base, an upper arm that swings about y, and a tool that swings at its end."""
    return f"""<robot name="r">
<link name="base">{inertial(5, 0.05)}{box(".2 .2 .2")}</link>
<link name="arm">{inertial(1, 0.01)}{box(".05 .05 .2", "0.15 0 0.1")}</link>
<link name="tool">{inertial(mass, 0.01)}{box(".1 .1 .1", tool_at)}</link>
<joint name="shoulder" type="revolute"><origin xyz="0 0 0.15"/><parent link="base"/><child link="arm"/>
<axis xyz="0 1 0"/><limit lower="-0.2" upper="0.2" effort="{effort}" velocity="2"/></joint>
<joint name="wrist" type="revolute"><origin xyz="0.3 0 0.2"/><parent link="arm"/><child link="tool"/>
<axis xyz="0 1 0"/><limit lower="-0.2" upper="0.2" effort="{effort}" velocity="2"/></joint>{extra}</robot>"""


def cart(*, track: float = 0.3, high: float = 0.1, radius: float = 0.1) -> str:
    """A box on four wheels."""
    wheels = "".join(
        f"""<link name="wheel_{n}">{inertial(0.5, 0.002)}<collision><origin rpy="1.5708 0 0"/><geometry>
<cylinder radius="{radius}" length="0.04"/></geometry></collision></link>
<joint name="turn_{n}" type="continuous"><origin xyz="{x} {y} 0"/><parent link="base"/>
<child link="wheel_{n}"/><axis xyz="0 1 0"/></joint>"""
        for n, (x, y) in enumerate(((0.2, track), (0.2, -track), (-0.2, track), (-0.2, -track)))
    )
    body = inertial(5, 0.05).replace("<inertial>", f'<inertial><origin xyz="0 0 {high}"/>')
    return f'<robot name="cart"><link name="base">{body}{box(".5 .2 .1")}</link>{wheels}</robot>'


def findings(
    text: str, engine: Engine, folder: Path, capsys: pytest.CaptureFixture[str], name: str = "r.urdf"
) -> list[dict[str, str]]:
    if not is_installed(engine):
        pytest.skip(f"{engine.value} is not installed: {engine.advice}")
    file = folder / name
    file.write_text(text, encoding="utf-8")
    line = ["simulate", str(file), "--isolated", "--in", engine.value, "--seconds", "1"]
    assert main([*line, "--output-format", "json", "-q"]) in {0, 1}
    found: list[dict[str, str]] = json.loads(capsys.readouterr().out)["diagnostics"]
    return found


def codes(found: list[dict[str, str]]) -> set[str]:
    return {one["code"] for one in found if one["severity"] != "info"}


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize("text", [arm(), cart()], ids=["arm", "cart"])
def test_robots_that_behave(
    engine: Engine, text: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert findings(text, engine, tmp_path, capsys) == []


AXIS, PLACE = '<child link="wheel_3"/><axis xyz="0 1 0"/>', '<origin xyz="-0.2 -0.3 0"/>'


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        (AXIS, AXIS.replace("0 1 0", "0 -1 0"), "joint `turn_3` moves the other way than in `cart.xacro`"),
        (PLACE, '<origin xyz="-0.1 -0.3 0"/>', "joint `turn_3` is 100 mm from where it is in `cart.xacro`"),
        ('name="turn_3"', 'name="other"', ""),
        ('name="cart"', 'name="truck"', ""),
    ],
    ids=["axis", "place", "name-of-joint", "name-of-robot"],
)
def test_a_joint_that_another_description_has_otherwise(
    old: str, new: str, says: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / ".git").mkdir()
    source = cart().replace("<robot ", '<robot xmlns:xacro="http://wiki.ros.org/xacro" ')
    source = source.replace("</robot>", '<xacro:property name="p" value="1"/></robot>')
    (tmp_path / "cart.xacro").write_text(source, encoding="utf-8")
    found = findings(cart().replace(old, new), Engine.MUJOCO, tmp_path, capsys)
    assert [one["code"] for one in found if one["code"] == "SIM013"] == ["SIM013"] * bool(says)
    assert any(says in one["message"] for one in found) or not says
    (tmp_path / "copy.urdf").write_text(cart(), encoding="utf-8")
    assert findings(cart(), Engine.MUJOCO, tmp_path, capsys) == []


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize(
    ("text", "code", "says"),
    [
        (arm(tool_at="-0.3 0 -0.3"), "SIM004", "link `base` overlaps link `tool`"),
        (arm(effort=1), "SIM008", "joint `shoulder` needs "),
        (cart(track=0.12, high=2), "", ""),
        (cart(radius=0.02), "SIM009", "stands on `base` and not on its wheels"),
    ],
    ids=["overlap", "effort", "high", "small-wheels"],
)
def test_planted_defects(
    engine: Engine, text: str, code: str, says: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    found = findings(text, engine, tmp_path, capsys)
    assert codes(found) == ({code} if code else set())
    assert any(says in one["message"] for one in found) or not code


def test_an_effort_that_a_spring_may_help_is_an_info(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    found = findings(arm(effort=2), Engine.MUJOCO, tmp_path, capsys)
    assert {(one["code"], one["severity"]) for one in found} == {("SIM008", "info")}
    assert any("where it starts" in one["message"] for one in found)


def test_a_body_whose_mass_is_in_its_parts_has_mass(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    hull = f"<link name='hull'>{inertial(0, 0)}{box('.1 .1 .1')}</link>"
    rotor = f"<link name='rotor'>{inertial(1, 0.01)}</link>"
    joints = (
        "<joint name='free' type='floating'><parent link='world'/><child link='hull'/></joint>"
        "<joint name='mount' type='fixed'><parent link='hull'/><child link='rotor'/></joint>"
    )
    text = f"<robot name='r'><link name='world'/>{hull}{rotor}{joints}</robot>"
    assert codes(findings(text, Engine.MUJOCO, tmp_path, capsys)) == set()
    light = text.replace(inertial(1, 0.01), inertial(0, 0))
    assert codes(findings(light, Engine.MUJOCO, tmp_path, capsys)) != set()


def test_a_robot_that_leans_tips_over(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = cart(high=0.1).replace('<origin xyz="0 0 0.1"/>', '<origin xyz="0 0.6 0.5"/>')
    (found,) = findings(text, Engine.MUJOCO, tmp_path, capsys)
    assert found["code"] == "SIM009"
    assert "tips over" in found["message"]


def test_masses_that_a_simulator_invents_are_its_doing(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text = arm().replace(inertial(1, 0.01) + box(".1 .1 .1", "0 0 0.2"), box(".1 .1 .1", "0 0 0.2"))
    (found,) = findings(text, Engine.MUJOCO, tmp_path, capsys)
    assert found["code"] == "SIM002"
    assert found["message"] == "link `tool` has no mass here, and 1 kg by MuJoCo's own choice"


def test_a_joint_that_moves_parts_into_one_another(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text = arm(tool_at="-0.6 0 0.05").replace('lower="-0.2" upper="0.2"', 'lower="-1.2" upper="0"')
    found = findings(text, Engine.MUJOCO, tmp_path, capsys)
    assert {one["code"] for one in found} == {"SIM007"}
    assert all("joint `" in one["message"] and "into `" in one["message"] for one in found)
    page = tmp_path / "r.html"
    line = [
        "simulate",
        str(tmp_path / "r.urdf"),
        "--in",
        "mujoco",
        "--output-format",
        "html",
        "-o",
        str(page),
        "-q",
    ]
    assert main([*line, "--isolated", "--exit-zero"]) == 0
    assert '"moment":{"positions":{"' in page.read_text(encoding="utf-8").replace(" ", "")


def test_a_joint_that_would_meet_nothing_with_the_opposite_axis(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text = arm(tool_at="-0.6 0 0.05").replace('lower="-0.2" upper="0.2"', 'lower="-1.2" upper="0"')
    found = findings(text, Engine.MUJOCO, tmp_path, capsys)
    assert any("with the opposite axis" in one["message"] for one in found)
    assert codes(found) == {"SIM007"}
    turned = text.replace('<axis xyz="0 1 0"/>', '<axis xyz="0 -1 0"/>')
    assert codes(findings(turned, Engine.MUJOCO, tmp_path, capsys)) == set()


def arms(axes: dict[str, int]) -> str:
    """A body with an arm on each side that swings about x, down into the body or up; the axis of each side."""
    sides = "".join(
        f"""<link name="{side}_mount">{inertial(1, 0.01)}{box(".02 .02 .02")}</link>
<joint name="{side}_slide" type="prismatic"><origin xyz="0 {0.25 * out} 0.3"/><parent link="base"/>
<child link="{side}_mount"/><axis xyz="1 0 0"/>{limit(-0.01, 0.01)}</joint>
<link name="{side}_arm">{inertial(1, 0.01)}{box(".1 .4 .1", f"0 {0.2 * out} 0")}</link>
<joint name="{side}_shoulder" type="revolute"><parent link="{side}_mount"/><child link="{side}_arm"/>
<axis xyz="{axes[side]} 0 0"/>{limit(-1.4, 0) if out > 0 else limit(0, 1.4)}</joint>"""
        for side, out in (("left", 1), ("right", -1))
    )
    body = inertial(50, 5) + box(".6 1.2 .1")
    return f'<robot name="r"><link name="base">{body}</link>{sides}</robot>'


def limit(lower: float, upper: float) -> str:
    return f'<limit lower="{lower}" upper="{upper}" effort="99" velocity="1"/>'


@pytest.mark.parametrize(("right", "turns"), [(-1, True), (1, False)], ids=["one-side", "both-sides"])
def test_joints_of_both_sides_meet_the_body(
    right: int, turns: bool, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    found = findings(arms({"left": 1, "right": right}), Engine.MUJOCO, tmp_path, capsys)
    assert any(one["code"] == "SIM007" and "left_shoulder" in one["message"] for one in found)
    assert any("with the opposite axis" in one["message"] for one in found) is turns


@pytest.mark.parametrize(("count", "severity"), [(1, "warning"), (4, "info")], ids=["near", "far"])
def test_a_part_many_joints_away_may_be_elsewhere(
    count: int, severity: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A lift beside a block lets a tool down into it, which hangs on more joints."""
    links = [f'<link name="l{n}">{inertial(1, 0.01)}{box(".02 .02 .02")}</link>' for n in range(count)]
    links.append(
        f'<link name="l{count}">{inertial(1, 0.01)}{box(".05 .05 .05", f"-0.5 0 {-0.074 - 0.05 * count}")}</link>'
    )
    joints = [
        f"""<joint name="j{n}" type="revolute"><origin xyz="0 0 0.05"/><parent link="l{n}"/><child link="l{n + 1}"/>
<axis xyz="0 0 1"/>{limit(-0.01, 0.01)}</joint>"""
        for n in range(count)
    ]
    lift = (
        '<joint name="lift" type="prismatic"><origin xyz="0.5 0 0.2"/><parent link="base"/><child link="l0"/>'
        f'<axis xyz="0 0 1"/>{limit(-0.018, 0)}</joint>'
    )
    base = f'<link name="base">{inertial(5, 0.05)}{box(".2 .2 .2")}</link>'
    text = f'<robot name="r">{base}{"".join(links)}{lift}{"".join(joints)}</robot>'
    (found,) = [one for one in findings(text, Engine.MUJOCO, tmp_path, capsys) if one["code"] == "SIM007"]
    assert "joint `lift` moves link `" in found["message"]
    assert found["severity"] == severity


def test_joints_that_follow_others_move_with_them(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    fingers = "".join(
        f"""<link name="{name}">{inertial(0.1, 0.0001)}{box(".02 .04 .1")}</link>
<joint name="{name}_joint" type="prismatic"><origin xyz="0 {at} 0.2"/><parent link="base"/><child link="{name}"/>
<axis xyz="0 1 0"/><limit lower="0" upper="0.2" effort="20" velocity="2"/>{mimic}</joint>"""
        for name, at, mimic in (("first", -0.08, ""), ("second", 0.02, '<mimic joint="first_joint"/>'))
    )
    text = f'<robot name="r"><link name="base">{inertial(5, 0.05)}{box(".2 .2 .2")}</link>{fingers}</robot>'
    assert "SIM007" not in {one["code"] for one in findings(text, Engine.MUJOCO, tmp_path, capsys)}
    alone = text.replace('<mimic joint="first_joint"/>', "")
    assert "SIM007" in {one["code"] for one in findings(alone, Engine.MUJOCO, tmp_path, capsys)}


def test_links_with_nothing_solid_between_them_are_neighbors(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text = arm(tool_at="-0.3 0 -0.3").replace(box(".05 .05 .2", "0.15 0 0.1"), "")
    assert "SIM004" not in codes(findings(text, Engine.MUJOCO, tmp_path, capsys))


def test_pairs_that_srdf_disables_may_overlap(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = arm(tool_at="-0.3 0 -0.3")
    assert codes(findings(text, Engine.MUJOCO, tmp_path, capsys)) == {"SIM004"}
    (tmp_path / "r.srdf").write_text(
        '<robot name="r"><disable_collisions link1="tool" link2="base" reason="Never"/></robot>'
    )
    assert codes(findings(text, Engine.MUJOCO, tmp_path, capsys)) == set()


def test_a_robot_that_cannot_be_loaded_is_a_finding(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text = arm().replace('child link="tool"', 'child link="nothing"')
    (found,) = findings(text, Engine.MUJOCO, tmp_path, capsys)
    assert (found["code"], found["severity"]) == ("SIM001", "error")


def test_meshes_that_are_not_found_are_left_out(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    mesh = '<collision><geometry><mesh filename="package://p/none.stl"/></geometry></collision>'
    text = arm().replace(box(".1 .1 .1", "0 0 0.2"), mesh)
    (found,) = findings(text, Engine.MUJOCO, tmp_path, capsys)
    assert (found["code"], found["severity"]) == ("SIM011", "info")


def test_sdformat_is_converted(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = """<sdf version="1.9"><world name="w"><model name="m">{}</model></world></sdf>""".format(
        "".join(
            f'<link name="{name}"><pose>0 0 {z} 0 0 0</pose><inertial><mass>1</mass></inertial>'
            f'<collision name="c"><geometry><box><size>{s} {s} {s}</size></box></geometry></collision></link>'
            for name, z, s in (("a", 0.5, 0.3), ("b", 1.5, 0.1), ("c", 0.5, 0.1))
        )
        + '<joint name="ab" type="revolute"><parent>a</parent><child>b</child><axis><xyz>0 0 1</xyz></axis></joint>'
        + '<joint name="bc" type="revolute"><parent>b</parent><child>c</child><axis><xyz>0 0 1</xyz></axis></joint>'
    )
    (found,) = findings(text, Engine.MUJOCO, tmp_path, capsys, "w.sdf")
    assert found["code"] == "SIM004"
    assert "link `a` overlaps link `c`" in found["message"]


def test_a_world_with_models_of_other_names(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "lamp").mkdir()
    model = '<model name="lamp"><link name="a"><inertial><mass>1</mass></inertial></link></model>'
    (tmp_path / "lamp" / "model.sdf").write_text(f'<sdf version="1.9">{model}</sdf>')
    about = '<model><name>lamp</name><sdf version="1.9">model.sdf</sdf></model>'
    (tmp_path / "lamp" / "model.config").write_text(about)
    include = "<include><name>{}</name><pose>{} 0 0 0 0 0</pose><uri>model://lamp</uri></include>"
    models = include.format("one", 0) + include.format("two", 1)
    text = f'<sdf version="1.9"><world name="w">{models}</world></sdf>'
    assert not codes(findings(text, Engine.MUJOCO, tmp_path, capsys, "w.sdf"))


def test_a_robot_of_our_own_in_all_simulators(capsys: pytest.CaptureFixture[str]) -> None:
    engines = [engine for engine in (Engine.MUJOCO, Engine.DRAKE) if is_installed(engine)]
    if len(engines) < 2:
        pytest.skip("MuJoCo or Drake is not installed")
    file = str(ROBOTS / "desk_arm" / "desk_arm.urdf")
    assert main(["simulate", file, "--isolated", "--in", "mujoco,drake"]) == 0
    assert "All clear" in capsys.readouterr().out


@pytest.mark.parametrize("engine", ENGINES)
def test_a_robot_that_falls_differently_after_a_conversion(
    engine: Engine, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    tilted = arm().replace('xyz="0 1 0"', 'xyz="1 0 0"')
    monkeypatch.setattr(Subject, "returned", tilted)
    (found,) = findings(arm(), engine, tmp_path, capsys)
    assert found["code"] == "SIM012"
    assert found["message"].startswith("link `tool` is ")
    assert "when the robot was SDFormat in between" in found["message"]
    monkeypatch.setattr(Subject, "returned", arm().replace('child link="tool"', 'child link="nothing"'))
    (found,) = findings(arm(), engine, tmp_path, capsys)
    assert "does not load what comes back from SDFormat" in found["message"]


def test_wrong_usage(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "r.urdf"
    file.write_text(arm())
    assert main(["simulate", str(file), "--in", "mujocco"]) == 2
    assert "--in: unknown simulator `mujocco`; did you mean `mujoco`?" in capsys.readouterr().err


def test_a_broken_text_is_not_simulated(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "r.urdf"
    file.write_text('<robot name="r"><link name="a">')
    assert main(["simulate", str(file)]) == 2
    assert "r.urdf:1:31: the text is broken here; `sdfcheck lint` says how" in capsys.readouterr().err


def silenced(
    text: str, configuration: str, folder: Path, capsys: pytest.CaptureFixture[str]
) -> list[tuple[str, str]]:
    """Code and severity of what is left in MuJoCo under a configuration."""
    if not is_installed(Engine.MUJOCO):
        pytest.skip(f"mujoco is not installed: {Engine.MUJOCO.advice}")
    (folder / "robot.urdf").write_text(text, encoding="utf-8")
    (folder / "sdfcheck.toml").write_text(configuration, encoding="utf-8")
    line = ["simulate", str(folder / "robot.urdf"), "--in", "mujoco", "--seconds", "1"]
    assert main([*line, "--output-format", "json", "-q"]) in {0, 1}
    return [(one["code"], one["severity"]) for one in json.loads(capsys.readouterr().out)["diagnostics"]]


@pytest.mark.parametrize(
    ("comment", "configuration", "left"),
    [
        ("", "", [("SIM008", "warning")]),
        ("ignore[weak-joint] held by a brake", "", []),
        ("ignore[tipping]", "", [("SIM008", "warning")]),
        ("", 'ignore = ["SIM008"]', []),
        ("", 'ignore = ["SIM"]\n[severity]\nSIM008 = "error"', [("SIM008", "error")]),
        ("", '[severity]\nweak-joint = "off"', []),
        ("", '[per-file-ignores]\n"*.urdf" = ["weak-joint"]', []),
        ("", 'ignore = ["ALL"]', [("SIM008", "warning")]),
    ],
)
def test_findings_are_silenced_like_those_of_rules(
    comment: str,
    configuration: str,
    left: list[tuple[str, str]],
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    before = f"<!-- sdfcheck:{comment} -->" if comment else ""
    text = arm(effort=1).replace('<joint name="shoulder"', f'{before}<joint name="shoulder"')
    assert silenced(text, configuration, tmp_path, capsys) == left
