"""The robot of a URDF file as Gazebo builds it, written as SDFormat."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck import Consumer, NotConvertible, WrongUsage, convert
from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.result import Conversion
from sdfcheck.convert.urdf_to_sdf.conversion import urdf_to_sdf
from sdfcheck.convert.urdf_to_sdf.options import Options
from sdfcheck.source.document import read

BODY = (
    '<inertial><mass value="{}"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'.format
)
BOX = '<visual{}><geometry><box size="1 1 1"/></geometry>{}</visual>'.format
BALL = '<collision><geometry><sphere radius="1"/></geometry></collision>'


def joint(name: str, parent: str, child: str, kind: str = "fixed") -> str:
    ends = f'<parent link="{parent}"/><child link="{child}"/><origin xyz="0 0 1"/>'
    return f'<joint name="{name}" type="{kind}">{ends}<axis xyz="0 0 1"/></joint>'


def link(name: str, inside: str = "") -> str:
    return f'<link name="{name}">{inside}</link>'


ARM = (
    link("base", BODY(1) + BOX("", ""))
    + link("tool", BODY(2) + BOX(' name="v"', "") + BALL + BALL)
    + joint("to_tool", "base", "tool")
)


def built(inside: str) -> Conversion:
    source = read(f'<robot name="r">{inside}</robot>'.encode(), Path("r.urdf"))
    done = urdf_to_sdf(source, Options(like=Consumer.GAZEBO))
    assert done.verification is not None
    assert done.verification.is_equal
    return done


def test_merged_links_and_the_names_of_their_shapes() -> None:
    text = built(ARM).text
    assert text.count("<link name=") == 1
    assert "<mass>3</mass>" in text
    for name in ("base_visual", "base_fixed_joint_lump__v_visual_1"):
        assert f'<visual name="{name}"' in text
    for name in ("tool_collision", "tool_collision_1"):
        assert f'<collision name="base_fixed_joint_lump__{name}"' in text
    assert '<frame name="to_tool" attached_to="base">' in text
    assert '<frame name="tool" attached_to="base"' in text


def test_blocks_of_merged_joints_are_lost() -> None:
    sensor = '<gazebo reference="to_tool"><sensor name="s" type="imu"/></gazebo>'
    done = built(ARM + sensor)
    assert "<sensor" not in done.text
    assert "<sensor> is left out: joint `to_tool` was merged" in [loss.message for loss in done.losses]


@pytest.mark.parametrize("hint", ["preserveFixedJoint", "disableFixedJointLumping"])
def test_fixed_joints_that_stay(hint: str) -> None:
    done = built(ARM + f'<gazebo reference="to_tool"><{hint}>true</{hint}></gazebo>')
    assert '<joint name="to_tool" type="fixed">' in done.text
    locked = [loss for loss in done.losses if loss.kind is LossKind.APPROXIMATED_JOINT]
    assert len(locked) == (hint == "disableFixedJointLumping")


def test_links_without_mass_are_dropped_with_what_hangs_on_them() -> None:
    hanging = link("ghost", BOX("", "")) + link("hand", BODY(1))
    joints = joint("a", "tool", "ghost", "continuous") + joint("b", "ghost", "hand", "continuous")
    block = '<gazebo reference="hand"><mu1>1</mu1></gazebo>'
    done = built(ARM + hanging + joints + block)
    assert "ghost" not in done.text
    assert "hand" not in done.text
    lost = {loss.message.partition(" is left out")[0] for loss in done.losses}
    assert lost >= {"link `ghost`", "link `hand`", "joint `a`", "joint `b`", "a <gazebo> block"}


def test_the_root_world_is_the_world() -> None:
    done = built(link("world", BODY(1)) + ARM + joint("w", "world", "base"))
    assert "<parent>world</parent>" in done.text
    assert done.text.count("<link name=") == 1


def test_shapes_that_are_not_read() -> None:
    odd = '<collision><geometry><capsule radius="1" length="1"/></geometry></collision>'
    done = built(link("base", BODY(1) + odd + BALL))
    assert "<collision" not in done.text
    assert len([loss for loss in done.losses if loss.kind is LossKind.UNSUPPORTED_GEOMETRY]) == 2


@pytest.mark.parametrize(
    "first", [BODY(1).replace(' iyz="0"', ""), BODY(1) + BOX("", "<material/>")], ids=["moments", "material"]
)
def test_a_link_is_read_up_to_what_urdfdom_cannot_read(first: str) -> None:
    done = built(link("base", first + BALL + BOX("", "")))
    assert "<collision" not in done.text
    assert "<visual" not in done.text


def test_settings_reach_the_shapes_whose_names_begin_with_that_of_the_link() -> None:
    own, other = (BALL.replace(">", f' name="{name}">', 1) for name in ("arm_tip", "tip"))
    block = '<gazebo reference="arm"><mu1>0.2</mu1></gazebo>'
    done = built(link("arm", BODY(1) + own + other) + block)
    assert done.text.count("<mu>0.2</mu>") == 1
    assert done.text.index("arm_tip") < done.text.index("<mu>") < done.text.index("lump__tip")
    assert "<mu>" not in built(link("arm", BODY(1) + other) + block).text


def test_colors_are_brighter() -> None:
    color = '<material name="m"><color rgba="0.4 0.9 0 0.5"/></material>'
    done = built(color + link("base", BODY(1) + BOX("", '<material name="m"/>')))
    assert "<diffuse>0.5 1 0 0.5</diffuse>" in done.text
    assert "the color 0.4 0.9 0 0.5 is written as Gazebo has it: 0.5 1 0 0.5" in [
        loss.message for loss in done.losses
    ]


def test_a_robot_of_which_nothing_is_left() -> None:
    with pytest.raises(NotConvertible, match="Gazebo makes nothing of it: no link has mass"):
        built(link("base") + link("arm", BODY(1)) + joint("j", "base", "arm", "continuous"))


def test_limits_are_exchanged_where_the_lower_one_is_above_the_upper_one() -> None:
    slide = joint("j", "base", "arm", "prismatic").replace(
        "</joint>", '<limit lower="0.02" upper="-0.02" effort="1" velocity="1"/></joint>'
    )
    done = built(link("base", BODY(1)) + link("arm", BODY(1)) + slide)
    assert "<lower>-0.02</lower>" in done.text
    assert "<upper>0.02</upper>" in done.text
    assert LossKind.CHANGED_LIMIT in {loss.kind for loss in done.losses}


def test_from_python() -> None:
    robot = f'<robot name="r">{ARM}</robot>'
    assert "base_fixed_joint_lump__v_visual_1" in convert(robot, "sdf", like=Consumer.GAZEBO).text
    with pytest.raises(WrongUsage, match="like Drake"):
        convert(robot, "sdf", like=Consumer.DRAKE)
    with pytest.raises(WrongUsage, match="like Gazebo"):
        convert(
            '<sdf version="1.9"><model name="m"><link name="l"/></model></sdf>', "sdf", like=Consumer.GAZEBO
        )
