"""Features that Drake does not support: where the rules look, and for which consumers they report."""

from __future__ import annotations

import pytest

import sdfcheck

MASS = '<inertial><mass value="{}"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'


def reported(text: str, *codes: str, target: tuple[str, ...] = ()) -> list[sdfcheck.Diagnostic]:
    """The reports of rules in a document; of all rules those that run by default."""
    options = {"select": list(codes)} if codes else {"target": list(target)}
    found = sdfcheck.lint(text, isolated=True, **options).diagnostics  # type: ignore[arg-type]
    return [diagnostic for diagnostic in found if diagnostic.code.startswith("DRK")]


def in_sdf(content: str) -> str:
    links = '<link name="a"/><link name="b"/>'
    return f'<sdf version="1.12"><model name="m">{links}{content}</model></sdf>'


def joint(kind: str, content: str = "", name: str = "j") -> str:
    return f'<joint name="{name}" type="{kind}"><parent>a</parent><child>b</child>{content}</joint>'


def robot(masses: dict[str, float], *joints: tuple[str, str, str], more: str = "") -> str:
    """A robot of links with masses, and joints: type, parent, child."""
    links = "".join(f'<link name="{name}">{MASS.format(mass)}</link>' for name, mass in masses.items())
    tied = "".join(
        f'<joint name="{parent}_{child}" type="{kind}"><parent link="{parent}"/><child link="{child}"/></joint>'
        for kind, parent, child in joints
    )
    return f'<robot name="r">{links}{tied}{more}</robot>'


def test_standard_joints_and_frictions_are_judged_for_those_who_ask() -> None:
    friction = "<surface><friction><ode><mu>0.5</mu></ode></friction></surface>"
    box = "<geometry><box><size>1 1 1</size></box></geometry>"
    collision = f'<link name="c"><collision name="c">{box}{friction}</collision></link>'
    text = in_sdf(collision + joint("gearbox", "<gearbox_reference_body>a</gearbox_reference_body>"))
    assert reported(text) == []
    assert reported(text, target=("gazebo",)) == []
    assert {d.code for d in reported(text, target=("drake",))} >= {"DRK008", "DRK014"}


def test_own_joints_and_frictions_are_judged_for_all() -> None:
    text = '<robot name="r" xmlns:drake="http://drake.mit.edu"><link name="a"/><drake:joint name="j" type="slide">'
    found = reported(f'{text}<parent link="world"/><child link="a"/></drake:joint></robot>')
    assert "DRK008" in {d.code for d in found}


@pytest.mark.parametrize(
    ("before", "kind", "says"),
    [
        ("<static>true</static>", "revolute", "a joint of a static model cannot be `revolute`"),
        ("<static>1</static>", "ball", "a joint of a static model cannot be `ball`"),
        ("<static>true</static>", "fixed", ""),
        ("<static>false</static>", "revolute", ""),
        (
            "",
            "revolute2",
            "a joint of type `revolute2` is not supported: Drake refuses the file; write it as two",
        ),
    ],
)
def test_joint_types(before: str, kind: str, says: str) -> None:
    found = [d for d in reported(in_sdf(before + joint(kind)), target=("drake",)) if d.code == "DRK008"]
    assert [d.message.startswith(says) for d in found] == [True] * bool(says)


def test_joints_in_gazebo_blocks_are_not_read() -> None:
    text = robot({"a": 1, "b": 1}, ("fixed", "a", "b"), more=f"<gazebo>{joint('gearbox')}</gazebo>")
    assert reported(text, target=("drake",)) == []


def test_the_outermost_link_without_mass_is_reported() -> None:
    text = robot({"base": 1, "a": 0, "b": 0, "c": 0}, *(("continuous", *ends) for ends in ("ab", "bc")))
    text = text.replace("</robot>", "")
    text += '<joint name="j" type="revolute"><parent link="base"/><child link="a"/></joint></robot>'
    found = reported(text, "DRK011")
    # The joints are asked in the order of the file, and a link is reported once.
    assert [d.message.partition(":")[0] for d in found] == [
        "link `b` moves by joint `a_b` and with the 1 below it has no mass"
    ]
    assert [label.text for label in found[0].labels] == ["it moves here"]


def test_a_link_is_carried_by_mass_below_it() -> None:
    assert (
        reported(
            robot({"base": 1, "a": 0, "b": 2}, ("continuous", "base", "a"), ("fixed", "a", "b")), "DRK011"
        )
        == []
    )
    (free,) = reported(robot({"a": 0}), "DRK011")
    assert free.severity is sdfcheck.Severity.WARNING
    assert reported(robot({"world": 0, "a": 1}, ("fixed", "world", "a")), "DRK011") == []


@pytest.mark.parametrize(
    ("content", "says"),
    [
        ("", "the transmission has no type: Drake refuses the file"),
        ("<type>SimpleTransmission</type>", "the transmission has no actuator"),
        ("<type>SimpleTransmission</type><actuator name='m'/>", "the transmission has no joint"),
        ("<type>SimpleTransmission</type><joint/><actuator name='m'/>", "the joint has no name"),
        ("<type>SimpleTransmission</type><joint name='none'/><actuator name='m'/>", None),
        ("<type>SimpleTransmission</type><joint name='a_b'/><actuator name='m'/>", "its type is floating"),
        (
            "<type>Other</type><joint name='a_b'/>",
            "`a_b` has no actuator in Drake: its transmission is not a Simple",
        ),
    ],
)
def test_transmissions(content: str, says: str | None) -> None:
    text = robot({"a": 1, "b": 1}, ("floating", "a", "b"), more=f"<transmission>{content}</transmission>")
    found = reported(text, "DRK010")
    assert len(found) == (says is not None)
    assert says is None or says in found[0].message


def test_joints_for_drake_alone_have_actuators() -> None:
    own = '<drake:joint name="s" type="screw"><parent link="a"/><child link="b"/></drake:joint>'
    drive = (
        '<transmission><type>SimpleTransmission</type><joint name="s"/><actuator name="m"/></transmission>'
    )
    (one,) = reported(robot({"a": 1, "b": 1}, more=own), "DRK010")
    assert one.message == "`s` has no actuator in Drake: no transmission names it"
    assert reported(robot({"a": 1, "b": 1}, more=own + drive), "DRK010") == []


def test_reductions_of_a_transmission_and_of_its_actuators() -> None:
    reduction = "<mechanicalReduction>{}</mechanicalReduction>"
    content = f'{reduction.format(2)}<actuator name="m">{reduction.format(1)}{reduction.format(3)}</actuator>'
    text = robot({"a": 1}, more=f"<transmission>{content}</transmission>")
    assert [d.span.text for d in reported(text, "DRK013")] == ["2", "3"]


@pytest.mark.parametrize(
    ("velocity", "is_special"), [("-1", False), ("-1.0", False), ("-2", True), ("3", False)]
)
def test_velocity_limits(velocity: str, is_special: bool) -> None:
    axis = f"<axis><xyz>0 0 1</xyz><limit><velocity>{velocity}</velocity></limit></axis>"
    assert len(reported(in_sdf(joint("revolute", axis)), "DRK013")) == is_special


@pytest.mark.parametrize(
    ("kind", "dynamics", "does"),
    [
        ("revolute", "<damping>-1</damping>", ["refuses the file"]),
        ("fixed", "<damping>-1</damping>", []),
        ("revolute", "<spring_stiffness>-1</spring_stiffness>", ["aborts"]),
        ("prismatic", "<spring_stiffness>-1</spring_stiffness>", ["refuses the file"]),
        ("ball", "<spring_stiffness>-1</spring_stiffness>", []),
        ("revolute", "<damping>less</damping>", []),
    ],
)
def test_dynamics(kind: str, dynamics: str, does: list[str]) -> None:
    axis = f"<axis><xyz>0 0 1</xyz><dynamics>{dynamics}</dynamics></axis>"
    assert [d.message.partition("Drake ")[2] for d in reported(in_sdf(joint(kind, axis)), "DRK015")] == does


def test_automatic_inertias_of_meshes() -> None:
    mesh = "<geometry><mesh><uri>{}</uri></mesh></geometry>"
    link = f'<link name="c"><inertial auto="true"/><collision name="c">{mesh}</collision></link>'
    (one,) = reported(in_sdf(link.format("a.obj")), "DRK015")
    assert one.span.text == "a.obj"
    assert reported(in_sdf(link.format("model://m/a.obj")), "DRK015") == []
    assert reported(in_sdf(link.format("a.obj").replace("true", "false")), "DRK015") == []


@pytest.mark.parametrize(("part", "is_refused"), [("light", True), ("model", True), ("insertions", False)])
def test_drake_refuses_old_elements_in_ignored_ones(part: str, is_refused: bool) -> None:
    state = f'<state world_name="w"><{part} name="a"/></state>'
    (found,) = reported(f'<sdf version="1.6"><world name="w">{state}</world></sdf>', "DRK012")
    assert dict(found.affects)["drake"].is_refusal is is_refused


def test_a_part_ignored_at_the_top_matters_where_the_file_is_read() -> None:
    light = '<light name="sun" type="directional"/>'
    alone = reported(f'<sdf version="1.12">{light}</sdf>', "DRK012", "DRK015")
    assert [d.code for d in alone] == ["DRK015"]
    beside = reported(
        f'<sdf version="1.12"><model name="m"><link name="l"/></model>{light}</sdf>', "DRK012", "DRK015"
    )
    assert [d.code for d in beside] == ["DRK012"]


@pytest.mark.parametrize(
    ("suffix", "own", "count"),
    [
        (".vtk", "", 0),
        (".vtk", "<drake:rigid_hydroelastic/>", 0),
        (".gltf", "", 0),
        (".gltf", "<drake:rigid_hydroelastic/>", 1),
        ("", "", 0),
    ],
)
def test_formats_of_meshes(suffix: str, own: str, count: int) -> None:
    mesh = f"<geometry><mesh><uri>https://example.org/arm{suffix}</uri></mesh></geometry>"
    own = f"<drake:proximity_properties>{own}</drake:proximity_properties>" if own else ""
    text = in_sdf(f'<link name="c"><collision name="c">{mesh}{own}</collision></link>')
    text = text.replace("<sdf ", '<sdf xmlns:drake="http://drake.mit.edu" ')
    assert len(reported(text, "DRK009")) == count


def test_a_tag_that_is_too_new_is_reported_once() -> None:
    tag = "<drake:surface_velocity_axis>0 0 1</drake:surface_velocity_axis>"
    text = in_sdf(f'<link name="c">{tag}</link><link name="d">{tag}</link>')
    text = text.replace("<sdf", '<sdf xmlns:drake="drake.mit.edu"')
    assert len(reported(text, "DRK018")) == 1
