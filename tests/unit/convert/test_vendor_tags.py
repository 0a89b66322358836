"""Drake's tags, written as the other dialect has them."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from sdfcheck.convert import sdf_to_urdf
from sdfcheck.convert.result import Conversion
from sdfcheck.convert.urdf_to_sdf.conversion import urdf_to_sdf
from sdfcheck.convert.urdf_to_sdf.options import Options
from sdfcheck.source.document import read
from sdfcheck.source.sniff import Kind
from tests.vendor_rules import reported

MASS = '<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'
TURNING = (
    '<joint name="j" type="revolute"><parent link="a"/><child link="b"/>'
    '<limit lower="-1" upper="1" effort="5" velocity="3"{}/></joint>'
)
GROUP = (
    '<drake:collision_filter_group name="g"><drake:member link="a"/><drake:member link="b"/>'
    '<drake:ignored_collision_filter_group name="g"/></drake:collision_filter_group>'
)
ACTUATOR = (
    '<transmission name="t"><type>transmission_interface/SimpleTransmission</type><joint name="j"/>'
    '<actuator name="m"><drake:rotor_inertia value="0.01"/><drake:gear_ratio value="120"/></actuator></transmission>'
)


def urdf(inside: str = "", *, a: str = "", joint: str = TURNING.format("")) -> str:
    return (
        f'<robot name="r" xmlns:drake="http://drake.mit.edu"><link name="a">{MASS}{a}</link>'
        f'<link name="b">{MASS}</link>{joint}{inside}</robot>'
    )


def collision(shape: str, properties: str = "") -> str:
    return f'<collision name="c"><geometry>{shape}</geometry>{properties}</collision>'


def to_sdf(text: str) -> Conversion:
    done = urdf_to_sdf(read(text.encode(), Path("r.urdf"), Kind.URDF), Options())
    assert done.verification is not None
    assert done.verification.is_equal, done.verification.differences
    return done


def flat(text: str) -> str:
    return re.sub(r">\s+<", "><", text)


def faults(text: str, kind: Kind) -> list[object]:
    """The diagnostics of the rules about Drake's elements in a result."""
    return list(reported(read(text.encode(), Path(f"r.{kind.value}"), kind)))


@pytest.mark.parametrize(
    ("source", "result"),
    [
        (
            urdf(a=collision('<box size="1 1 1"/>', "<drake:proximity_properties>"
                 '<drake:mu_static value="0.8"/><drake:mu_dynamic value="0.7"/></drake:proximity_properties>')),
            ("<drake:proximity_properties><drake:mu_static>0.8</drake:mu_static>"
            "<drake:mu_dynamic>0.7</drake:mu_dynamic></drake:proximity_properties></collision>"),
        ),
        (
            urdf(a=collision('<drake:capsule radius="0.1" length="2"/>')),
            "<capsule><radius>0.1</radius><length>2</length></capsule>",
        ),
        (
            urdf(a=collision('<drake:ellipsoid a="1" b="2" c="3"/>')),
            "<ellipsoid><radii>1 2 3</radii></ellipsoid>",
        ),
        (
            urdf(a=collision('<mesh filename="m.obj"><drake:declare_convex/></mesh>')),
            "<uri>m.obj</uri><drake:declare_convex/></mesh>",
        ),
        (urdf(joint=TURNING.format(' drake:acceleration="7"')), "<drake:acceleration>7</drake:acceleration></limit>"),
        (
            urdf(ACTUATOR),
            "<drake:rotor_inertia>0.01</drake:rotor_inertia><drake:gear_ratio>120</drake:gear_ratio></joint>",
        ),
        (
            urdf(GROUP),
            ('<drake:collision_filter_group name="g"><drake:member>a</drake:member><drake:member>b</drake:member>'
            "<drake:ignored_collision_filter_group>g</drake:ignored_collision_filter_group>"),
        ),
        (
            urdf('<frame name="f" link="b" xyz="1 0 0"/><drake:linear_bushing_rpy>'
                 '<drake:bushing_frameA name="a"/><drake:bushing_frameC name="f"/>'
                 '<drake:bushing_torque_stiffness value="1 2 3"/><drake:bushing_torque_damping value="1 2 3"/>'
                 '<drake:bushing_force_stiffness value="1 2 3"/><drake:bushing_force_damping value="1 2 3"/>'
                 "</drake:linear_bushing_rpy>"),
            ('<frame name="f" attached_to="b"><pose>1 0 0 0 0 0</pose></frame><drake:linear_bushing_rpy>'
            "<drake:bushing_frameA>a</drake:bushing_frameA><drake:bushing_frameC>f</drake:bushing_frameC>"
            "<drake:bushing_torque_stiffness>1 2 3</drake:bushing_torque_stiffness>"),
        ),
        (
            urdf(joint='<drake:joint name="j" type="ball"><parent link="a"/><child link="b"/></drake:joint>'),
            '<joint name="j" type="ball"><pose relative_to="a">0 0 0 0 0 0</pose><parent>a</parent><child>b</child>',
        ),
        (
            urdf(joint='<drake:joint name="j" type="universal"><parent link="a"/><child link="b"/>'
                 '<dynamics damping="0.5"/></drake:joint>'),
            "<axis><xyz>1 0 0</xyz><dynamics><damping>0.5</damping></dynamics></axis><axis2><xyz>0 1 0</xyz>",
        ),
        (
            urdf(joint='<drake:joint name="j" type="screw"><parent link="a"/><child link="b"/><axis xyz="0 0 2"/>'
                 '<drake:screw_thread_pitch value="0.02"/></drake:joint>'),
            "<axis><xyz>0 0 1</xyz></axis><screw_thread_pitch>0.02</screw_thread_pitch></joint>",
        ),
        (
            urdf(joint='<joint name="j" type="planar"><parent link="a"/><child link="b"/><axis xyz="0 0 1"/>'
                 '<origin xyz="1 2 3"/><dynamics damping="1 2 3"/></joint>'),
            ('<frame name="j_frame" attached_to="a"><pose>1 2 3 0 0 0</pose></frame>'
            '<drake:joint name="j" type="planar"><drake:parent>j_frame</drake:parent>'
            "<drake:child>b</drake:child><drake:damping>1 2 3</drake:damping></drake:joint>"),
        ),
        (
            urdf(joint='<drake:joint name="j" type="curvilinear"><parent link="a"/><child link="b"/>'
                 '<drake:is_periodic value="true"/><drake:initial_tangent xyz="0 1 0"/><drake:curves>'
                 '<drake:circular_arc radius="1" angle="2"/></drake:curves></drake:joint>'),
            ("<drake:is_periodic>true</drake:is_periodic><drake:initial_tangent><xyz>0 1 0</xyz>"
            "</drake:initial_tangent><drake:curves><drake:circular_arc><drake:radius>1</drake:radius>"
            "<drake:angle>2</drake:angle></drake:circular_arc></drake:curves>"),
        ),
    ],
    ids=[
        "friction", "capsule", "ellipsoid", "convex", "acceleration", "actuator", "group", "bushing",
        "ball", "universal", "screw", "planar", "curvilinear",
    ],
)  # fmt: skip
def test_urdf_becomes_sdf(source: str, result: str) -> None:
    done = to_sdf(source)
    assert result in flat(done.text)
    assert faults(done.text, Kind.SDF) == []


def test_a_tag_that_drake_ignores_in_urdf_is_left_out_and_reported() -> None:
    done = to_sdf(
        urdf(joint=TURNING.format("").replace("</joint>", '<drake:rotor_inertia value="1"/></joint>'))
    )
    assert "rotor_inertia" not in done.text
    assert any("Drake ignores it here" in loss.message for loss in done.losses)


def test_members_of_groups_follow_links_that_are_merged() -> None:
    text = (
        urdf(GROUP)
        .replace(MASS, "", 1)
        .replace(
            TURNING.format(""), '<joint name="j" type="fixed"><parent link="a"/><child link="b"/></joint>'
        )
    )
    done = to_sdf(text)
    assert "<drake:member>b</drake:member>" not in done.text
    assert any("`b` is now `a`" in loss.message for loss in done.losses)


def test_the_friction_of_drake_stays_where_gazebo_has_another() -> None:
    block = '<gazebo reference="a"><mu1>0.2</mu1><mu2>0.2</mu2></gazebo>'
    done = to_sdf(urdf(block, a=collision('<box size="1 1 1"/>')))
    assert "<drake:mu_static>1</drake:mu_static><drake:mu_dynamic>1</drake:mu_dynamic>" in flat(done.text)


def test_a_block_without_friction_leaves_drake_its_own() -> None:
    block = '<gazebo reference="a"><fdir1>1 0 0</fdir1></gazebo>'
    assert "drake:mu" not in to_sdf(urdf(block, a=collision('<box size="1 1 1"/>'))).text


def test_a_direction_that_drake_cannot_read_stays_as_it_is() -> None:
    done = to_sdf(urdf(a='<drake:surface_velocity_axis axis="up"/>'))
    assert "<drake:surface_velocity_axis>up</drake:surface_velocity_axis>" in done.text


def test_a_joint_that_follows_another_does_so_for_drake() -> None:
    follower = TURNING.format("").replace('"j"', '"k"').replace('child link="b"', 'child link="c"')
    follower = follower.replace("</joint>", '<mimic joint="j" multiplier="2"/></joint>')
    done = to_sdf(urdf(f'<link name="c">{MASS}</link>{follower}'))
    assert '<drake:mimic joint="j" multiplier="2" offset="0"/>' in done.text
    assert faults(done.text, Kind.SDF) == []


# The way back

BODY = "<inertial><mass>1</mass></inertial>"
DRIVEN = (
    "<joint name='j' type='revolute'><parent>a</parent><child>b</child><axis><xyz>0 0 1</xyz>"
    "<limit><lower>-1</lower><upper>1</upper>{}</limit></axis>{}</joint>"
)


def sdf(inside: str = "", *, a: str = "", b: str = "", joint: str = DRIVEN.format("", "")) -> str:
    return (
        "<sdf version='1.9' xmlns:drake='http://drake.mit.edu'><model name='r'>"
        f"<link name='a'>{BODY}{a}</link><link name='b'>{b}{BODY}</link>{joint}{inside}</model></sdf>"
    )


def to_urdf(text: str) -> str:
    done = sdf_to_urdf.convert(read(text.encode(), Path("r.sdf"), Kind.SDF))
    assert done.verification is not None
    assert done.verification.is_equal, done.verification.differences
    assert not [loss.message for loss in done.losses if loss.kind.code == "CNV030"]
    return flat(done.text)


@pytest.mark.parametrize(
    ("source", "result"),
    [
        (
            sdf(joint=DRIVEN.format("<drake:acceleration>7</drake:acceleration>", "")),
            'drake:acceleration="7"/>',
        ),
        (
            sdf(joint=DRIVEN.format("", "<drake:rotor_inertia>0.01</drake:rotor_inertia>"
                                        "<drake:gear_ratio>120</drake:gear_ratio>"
                                        '<drake:controller_gains p="1" d="2"/>')),
            ('<actuator name="j"><drake:rotor_inertia value="0.01"/><drake:gear_ratio value="120"/>'
            '<drake:controller_gains p="1" d="2"/></actuator>'),
        ),
        (
            sdf(a="<collision name='c'><geometry><capsule><radius>0.1</radius><length>2</length></capsule></geometry>"
                  "<drake:proximity_properties><drake:mu_static>0.8</drake:mu_static><drake:compliant_hydroelastic/>"
                  "<drake:hydroelastic_modulus>1e6</drake:hydroelastic_modulus>"
                  "<drake:mesh_resolution_hint>0.1</drake:mesh_resolution_hint>"
                  "<drake:mu_dynamic>much</drake:mu_dynamic></drake:proximity_properties></collision>"),
            ('<drake:capsule radius="0.1" length="2"/></geometry><drake:proximity_properties>'
            '<drake:mu_static value="0.8"/><drake:compliant_hydroelastic/>'
            '<drake:hydroelastic_modulus value="1e6"/><drake:mesh_resolution_hint value="0.1"/>'
            '<drake:mu_dynamic value="0"/></drake:proximity_properties>'),
        ),
        (
            sdf(a="<visual name='v'><geometry><drake:ellipsoid><a>1</a><b>2</b><c>3</c></drake:ellipsoid></geometry>"
                  "<material><diffuse>1 0 0 1</diffuse><drake:diffuse_map>m.png</drake:diffuse_map></material>"
                  "</visual>"),
            ('<drake:ellipsoid a="1" b="2" c="3"/></geometry><material name="color_2"><color rgba="1 0 0 1"/>'
            '<texture filename="m.png"/></material>'),
        ),
        (
            sdf(a="<collision name='c'><geometry><box><size>1 1 1</size></box></geometry><surface><friction><ode>"
                  "<mu>0.5</mu><mu2>0.4</mu2></ode></friction></surface></collision>"),
            '<drake:mu_static value="0.5"/><drake:mu_dynamic value="0.4"/>',
        ),
        (
            sdf("<frame name='f' attached_to='b'><pose>1 0 0 0 0 0</pose></frame><drake:linear_bushing_rpy>"
                "<drake:bushing_frameA>a</drake:bushing_frameA><drake:bushing_frameC>f</drake:bushing_frameC>"
                "<drake:bushing_torque_stiffness>1 2 3</drake:bushing_torque_stiffness>"
                "<drake:bushing_torque_damping>1 2 3</drake:bushing_torque_damping>"
                "<drake:bushing_force_stiffness>1 2 3</drake:bushing_force_stiffness>"
                "<drake:bushing_force_damping>1 2 3</drake:bushing_force_damping></drake:linear_bushing_rpy>"),
            '<frame name="f" link="b" xyz="1 0 0" rpy="0 0 0"/>',
        ),
        (
            sdf(joint="<frame name='p' attached_to='a'><pose>0 0 1 0 0 0</pose></frame>"
                      "<drake:joint name='j' type='planar'><drake:parent>p</drake:parent>"
                      "<drake:child>b</drake:child><drake:damping>0 0 0</drake:damping></drake:joint>"),
            ('<joint name="j" type="planar"><origin xyz="0 0 1"/><parent link="a"/><child link="b"/>'
            '<axis xyz="0 0 1"/></joint>'),
        ),
        (
            sdf(joint="<joint name='j' type='ball'><parent>a</parent><child>b</child></joint>"),
            '<drake:joint name="j" type="ball"><parent link="a"/><child link="b"/></drake:joint>',
        ),
        (
            sdf("<link name='c'/><joint name='k' type='revolute'><parent>a</parent><child>c</child>"
                '<axis><xyz>0 0 1</xyz></axis><drake:mimic joint="j" multiplier="2" offset="1"/></joint>'),
            '<mimic joint="j" multiplier="2" offset="1"/>',
        ),
        (
            sdf("<drake:ball_constraint><drake:ball_constraint_body_A>a</drake:ball_constraint_body_A>"
                "<drake:ball_constraint_body_B>b</drake:ball_constraint_body_B>"
                "<drake:ball_constraint_p_AP>0 0 1</drake:ball_constraint_p_AP>"
                "<drake:ball_constraint_p_BQ>0 0 1</drake:ball_constraint_p_BQ></drake:ball_constraint>",
                joint=DRIVEN.format("", "").replace("<parent>", "<pose>0 0 5 0 0 0</pose><parent>")),
            '<drake:ball_constraint_p_AP value="0 0 1"/><drake:ball_constraint_p_BQ value="0 0 -4"/>',
        ),
    ],
    ids=[
        "acceleration", "actuator", "properties", "ellipsoid", "friction", "bushing", "planar", "ball",
        "mimic", "constraint",
    ],
)  # fmt: skip
def test_sdf_becomes_urdf(source: str, result: str) -> None:
    written = to_urdf(source)
    assert result in written
    assert faults(written, Kind.URDF) == []


def test_tags_that_drake_has_in_sdf_only_come_back() -> None:
    properties = "<drake:deformable_properties><drake:mass_density>5</drake:mass_density></drake:deformable_properties>"
    there = to_urdf(sdf(a=properties))
    assert f'<gazebo reference="a">{properties}</gazebo>' in there
    assert properties in flat(to_sdf(there).text)


def test_an_attribute_that_drake_ignores_in_sdf_is_left_out_and_reported() -> None:
    text = sdf(joint=DRIVEN.format("", "").replace("<limit>", "<limit drake:acceleration='7'>"))
    assert "acceleration" not in to_urdf(text)
