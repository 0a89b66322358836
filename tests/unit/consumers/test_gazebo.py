"""The robot that libsdformat builds of a URDF description."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from sdfcheck.consumers.gazebo import GazeboRobot
from sdfcheck.consumers.reaction import Consumer
from sdfcheck.robot.graph import Model
from sdfcheck.robot.root import root_of
from sdfcheck.source.document import read

MASS = '<inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'


def robot(text: str) -> Model:
    return root_of(read(f'<robot name="r">{text}</robot>'.encode(), Path("r.urdf"))).models[0]


def links(names: str, inside: str = "") -> str:
    return "".join(f'<link name="{name}">{inside}</link>' for name in names.split())


def joint(name: str, parent: str, child: str, kind: str = "fixed") -> str:
    return f'<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/></joint>'


def names(nodes: object) -> list[str]:
    return [node.name for node in nodes]  # type: ignore[attr-defined]


KEPT = '<gazebo reference="j"><{0}>true</{0}></gazebo>'


@pytest.mark.parametrize(
    ("text", "tops", "with_mass"),
    [
        (links("a") + links("b", MASS) + joint("j", "a", "b"), ["a"], ["a", "b"]),
        (links("a") + links("b", MASS) + joint("j", "a", "b", "continuous"), ["a"], ["b"]),
        (
            links("a") + links("b", MASS) + joint("j", "a", "b") + KEPT.format("preserveFixedJoint"),
            ["a"],
            ["b"],
        ),
        (
            links("a") + links("b", MASS) + joint("j", "a", "b") + KEPT.format("disableFixedJointLumping"),
            ["a"],
            ["b"],
        ),
        (links("world") + links("b", MASS) + joint("j", "world", "b"), ["b"], ["b"]),
        (links("a", MASS) + links("b") + joint("j", "a", "b"), ["a"], ["a"]),
        (links("a", MASS.replace('"1"', '"0"', 1)), ["a"], []),
        (links("a b", MASS) + joint("j", "a", "b") + joint("k", "b", "a"), [], ["a", "b"]),
        (links("a", MASS.replace('"1"', '"${m}"', 1)), ["a"], ["a"]),
        (
            links("a b") + links("c", MASS) + joint("j", "a", "b") + joint("k", "b", "c"),
            ["a"],
            ["a", "b", "c"],
        ),
    ],
)
def test_links_that_fixed_joints_merge(text: str, tops: list[str], with_mass: list[str]) -> None:
    built = robot(text).as_built_by(Consumer.GAZEBO)
    assert names(built.tops) == tops
    assert sorted(names(built.with_mass)) == with_mass


def test_the_world_is_no_link_that_a_frame_needs() -> None:
    text = links("world") + links("a b", MASS) + joint("j", "world", "a") + joint("k", "a", "b")
    built = robot(text).as_built_by(Consumer.GAZEBO)
    assert built.refused_without(built.model.tree.links["world"]) == ""
    assert "frame loses its link" in built.refused_without(built.model.tree.links["a"])


BODY = '<inertial><mass value="{0}"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="{1}"/></inertial>'
AT = '<joint name="k" type="fixed"><origin xyz="2 0 0"/><parent link="a"/><child link="b"/></joint>'


def test_moments_of_merged_links() -> None:
    built = robot(links("a", BODY.format(1, 1)) + links("b", BODY.format(1, 9)) + AT).as_built_by(
        Consumer.GAZEBO
    )
    a, b = built.model.links
    assert built.base(b) is a
    assert list(built.members(a)) == [a, b]
    # 2 kg, 1 m off their common center on either side.
    assert built.moments(a) == (2, 4, 12, 0, 0, 0)
    assert built.masses[a] == 2


def test_moments_of_merged_links_that_are_turned() -> None:
    """The same as the sum of the links' mass properties, each seen from the first link."""
    body = (
        '<inertial><origin xyz="{0} 0.3 -0.1" {1}/><mass value="{0}"/>'
        '<inertia ixx="1" ixy="0.1" ixz="-0.2" iyy="2" iyz="0.3" izz="2.5"/></inertial>'
    )
    fixed = (
        '<joint name="{0}{1}" type="fixed"><origin xyz="0.5 -1 2" {2}/>'
        '<parent link="{0}"/><child link="{1}"/></joint>'
    )
    model = robot(
        links("a", body.format(2, 'rpy="0.1 0.2 0.3"'))
        + links("b", body.format(3, 'quat_xyzw="0.1 0.2 0.3 0.9"'))
        + links("c", body.format(0.5, ""))
        + fixed.format("a", "b", 'rpy="1 -0.5 0.7"')
        + fixed.format("b", "c", 'quat_xyzw="0 0 1 1"')
    )
    a, b, c = model.links
    poses, bodies = model.root.poses, []
    for link in (a, b, c):
        properties = link.mass_properties
        assert properties is not None
        bodies.append(properties.seen_from(poses.in_scope(link)))
    whole = bodies[0].joined_with(bodies[1]).joined_with(bodies[2]).moments
    merged = model.as_built_by(Consumer.GAZEBO).moments(a)
    tensor = [
        [merged.ixx, merged.ixy, merged.ixz],
        [merged.ixy, merged.iyy, merged.iyz],
        [merged.ixz, merged.iyz, merged.izz],
    ]
    assert np.allclose(tensor, whole, rtol=1e-12, atol=1e-12)


def test_moments_that_cannot_be_summed() -> None:
    built = robot(links("a", BODY.format(1, "${x}")) + links("b", BODY.format(1, 9)) + AT).as_built_by(
        Consumer.GAZEBO
    )
    assert math.isnan(built.moments(built.tops[0]).trace)


def test_moments_are_0_after_a_number_that_urdfdom_cannot_read() -> None:
    built = robot(links("a", MASS.replace('iyy="1"', 'iyy="x"'))).as_built_by(Consumer.GAZEBO)
    assert not any(built.moments(built.tops[0]))


@pytest.mark.parametrize(
    ("text", "dropped"),
    [
        (links("a", MASS) + links("b") + links("c", MASS) + joint("j", "b", "c") + AT, []),
        (links("a", MASS) + links("b") + joint("j", "a", "b", "continuous"), ["b"]),
        (links("a", MASS) + links("b", BODY.format("1e-7", 1)) + joint("j", "a", "b", "continuous"), []),
        (
            links("a", MASS)
            + links("b", BODY.format("-1", 1))
            + links("c", MASS)
            + joint("j", "a", "b", "continuous")
            + joint("k", "b", "c", "continuous"),
            ["b", "c"],
        ),
        (links("world") + links("b", MASS) + joint("j", "world", "b"), []),
        (links("a b", MASS) + joint("j", "a", "b") + joint("k", "b", "a"), []),
        (
            links("world a")
            + links("b", MASS)
            + joint("j", "world", "a")
            + joint("k", "a", "b", "continuous"),
            ["a"],
        ),
        (
            links("world a")
            + links("b", MASS)
            + joint("j", "world", "a", "continuous")
            + joint("k", "a", "b", "continuous"),
            ["a", "b"],
        ),
    ],
)
def test_links_that_are_left_out(text: str, dropped: list[str]) -> None:
    model = robot(text)
    named = [link for link in model.links if link.name != "world"]
    assert [link.name for link in named if model.as_built_by(Consumer.GAZEBO).is_dropped(link)] == dropped


HEAVY = links("base", MASS) + links("arm tool", MASS + '<visual/><collision name="c"/><collision/>').replace(
    "<visual/>", '<visual><geometry><box size="1 1 1"/></geometry></visual>'
).replace('name="c"/>', 'name="c"><geometry><sphere radius="1"/></geometry></collision>').replace(
    "<collision/>", '<collision><geometry><sphere radius="1"/></geometry></collision>'
)
MERGED = HEAVY + joint("elbow", "base", "arm", "continuous") + joint("wrist", "arm", "tool")


def built(text: str) -> GazeboRobot:
    return robot(text).as_built_by(Consumer.GAZEBO)


def test_names_of_shapes() -> None:
    arm = built(MERGED).links["arm"]
    assert names(arm.members) == ["arm", "tool"]
    assert names(arm.visuals) == ["arm_visual", "arm_fixed_joint_lump__tool_visual_1"]
    assert names(arm.collisions) == [
        "arm_fixed_joint_lump__c_collision",
        "arm_collision_1",
        "arm_fixed_joint_lump__c_collision_2",
        "arm_fixed_joint_lump__tool_collision_3",
    ]
    assert [shape.origin.link.name for shape in arm.collisions] == ["arm", "arm", "tool", "tool"]


def test_joints_and_frames() -> None:
    made = built(MERGED)
    assert list(made.links) == ["base", "arm"]
    assert [(j.name, j.type, j.parent, j.child) for j in made.joints.values()] == [
        ("elbow", "revolute", "base", "arm")
    ]
    assert [(frame.name, frame.attached_to) for frame in made.frames] == [("wrist", "arm"), ("tool", "wrist")]


@pytest.mark.parametrize(
    ("setting", "kind"), [("preserveFixedJoint", "fixed"), ("disableFixedJointLumping", "revolute")]
)
def test_fixed_joints_that_are_kept(setting: str, kind: str) -> None:
    made = built(MERGED + f'<gazebo reference="wrist"><{setting}>true</{setting}></gazebo>')
    assert made.joints["wrist"].type == kind
    assert made.joints["wrist"].parent == "arm"
    assert "tool" in made.links


def test_settings_and_sensors_of_merged_links() -> None:
    made = built(
        MERGED
        + '<gazebo reference="tool"><mu1>0.3</mu1><sensor name="s" type="imu"/></gazebo>'
        + '<gazebo reference="arm"><mu1>0.5</mu1></gazebo>'
        + '<gazebo reference="wrist"><sensor name="lost" type="force_torque"/></gazebo>'
    )
    arm = made.links["arm"]
    assert names(arm.sensors) == ["s"]
    # A block reaches the shapes of its link that have no name of their own.
    assert [[each.content for each in shape.settings] for shape in arm.collisions] == [
        [],
        ["0.5"],
        [],
        ["0.3"],
    ]
    assert [(block.reference, joint.name) for block, joint in made.lost.items()] == [("wrist", "wrist")]


def test_names_that_plugins_write() -> None:
    model = robot(
        MERGED
        + '<gazebo><plugin name="p" filename="f"><bodyName>tool</bodyName><link_name>tool</link_name></plugin></gazebo>'
    )
    (plugin,) = model.plugins
    found = model.as_built_by(Consumer.GAZEBO).rewritten(plugin)
    assert [(element.name, name) for element, name in found.items()] == [("bodyName", "arm")]


def test_a_link_ends_at_what_urdfdom_cannot_read() -> None:
    shape = "<{0}><geometry><{1}/></geometry></{0}>"
    inside = (
        MASS
        + shape.format("visual", "box")
        + shape.format("visual", "cone")
        + shape.format("collision", "box")
    )
    link = built(links("a", inside)).links["a"]
    assert (len(link.visuals), len(link.collisions)) == (1, 0)


@pytest.mark.parametrize(
    ("old", "new", "mass", "left"),
    [
        ('rpy="0 0 0"', 'rpy="0 0, 0"', 0.0, []),
        ('ixx="1"', 'ixx="1kg"', 1.0, []),
        ('ixx="1"', 'ixx="${ixx}"', 1.0, ["a_visual", "a_visual_1", "a_collision"]),
        ('scale="1 1 1"', 'scale="1 1 1 1"', 1.0, ["a_visual"]),
        ('rgba="1 0 0 1"', 'rgba="1 0 0"', 1.0, ["a_visual", "a_visual_1", "a_collision"]),
        ('<box size="1 1 1"/>', '<box size="1 1 1 "/>', 1.0, ["a_visual", "a_visual_1", "a_collision"]),
        ('<box size="1 1 1"/>', '<box size="1 1&#9;1"/>', 1.0, ["a_visual", "a_visual_1"]),
    ],
)
def test_a_link_ends_at_a_number_that_urdfdom_cannot_read(
    old: str, new: str, mass: float, left: list[str]
) -> None:
    inertial = MASS.replace("<mass", '<origin xyz="0 0 0" rpy="0 0 0"/><mass')
    red = '<material name="m"><color rgba="1 0 0 1"/></material>'
    ball = f'<visual><geometry><sphere radius="1"/></geometry>{red}</visual>'
    mesh = '<visual><geometry><mesh filename="m.stl" scale="1 1 1"/></geometry></visual>'
    box = '<collision><geometry><box size="1 1 1"/></geometry></collision>'
    model = robot(f'<link name="a">{inertial}{ball}{mesh}{box}</link>'.replace(old, new))
    built = GazeboRobot(model)
    link = built._link(model.links[0])
    assert built.masses[model.links[0]] == mass
    assert names([*link.visuals, *link.collisions]) == left


def test_consumers_of_which_that_is_not_known() -> None:
    with pytest.raises(ValueError, match="Drake"):
        robot(links("a")).as_built_by(Consumer.DRAKE)


def test_a_long_chain_of_merged_links() -> None:
    count = 3_000
    chain = "".join(f'<link name="l{i}">{MASS}</link>' for i in range(count)) + "".join(
        joint(f"j{i}", f"l{i}", f"l{i + 1}") for i in range(count - 1)
    )
    made = built(chain)
    assert list(made.links) == ["l0"]
    assert len(made.links["l0"].members) == count
