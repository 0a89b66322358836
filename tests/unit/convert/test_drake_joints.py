"""Joints that Drake alone has, and their settings; settings of joints that URDF does not have."""

from __future__ import annotations

import pytest

from sdfcheck.convert.call import convert
from sdfcheck.convert.loss import LossKind
from sdfcheck.source.sniff import Kind
from tests.unit.convert.test_vendor_tags import BODY, TURNING, faults, flat, sdf, to_sdf, to_urdf, urdf

FIXED = "<joint name='{}' type='fixed'><parent>{}</parent><child>{}</child></joint>"


@pytest.mark.parametrize(
    ("source", "result"),
    [
        (
            sdf(joint="<joint name='j' type='ball'><parent>a</parent><child>b</child><axis><xyz>0 0 1</xyz>"
                      "<dynamics><damping>0.5</damping></dynamics></axis></joint>"),
            '<parent link="a"/><child link="b"/><dynamics damping="0.5"/></drake:joint>',
        ),
        (
            sdf(joint="<drake:joint name='j' type='curvilinear'><drake:parent>a</drake:parent>"
                      "<drake:child>b</drake:child><drake:initial_tangent><xyz>0 1 0</xyz></drake:initial_tangent>"
                      "<drake:curves><drake:line_segment><drake:length>1</drake:length></drake:line_segment></drake:curves></drake:joint>"),
            '<drake:initial_tangent xyz="0 1 0"/><drake:curves><drake:line_segment length="1"/></drake:curves>',
        ),
        (
            sdf(f"<model name='n'><link name='c'>{BODY}</link><link name='d'>{BODY}</link>"
                "<drake:collision_filter_group name='g'><drake:member>c</drake:member>"
                "<drake:member>d</drake:member>"
                "<drake:ignored_collision_filter_group>g</drake:ignored_collision_filter_group></drake:collision_filter_group>{0}</model>{1}".format(
                    FIXED.format("k", "c", "d"), FIXED.format("f", "a", "n::c"))),
            ('<drake:member link="n__c"/><drake:member link="n__d"/>'
            '<drake:ignored_collision_filter_group name="n__g"/>'),
        ),
    ],
    ids=["damped-ball", "curvilinear", "group-of-a-nested-model"],
)  # fmt: skip
def test_sdf_becomes_urdf(source: str, result: str) -> None:
    written = to_urdf(source)
    assert result in written
    assert faults(written, Kind.URDF) == []


def test_a_ball_joint_loses_its_limit() -> None:
    ends = '<parent link="a"/><child link="b"/><limit effort="1" velocity="2"/>'
    done = to_sdf(urdf(joint=f'<drake:joint name="j" type="ball">{ends}</drake:joint>'))
    assert [loss.message for loss in done.losses] == [
        "<limit> of ball drake:joint `j` is left out: nobody reads it there"
    ]


def test_physics_are_those_of_the_joint_where_a_link_has_its_name() -> None:
    block = '<gazebo reference="b"><physics><ode><limit><cfm>0.5</cfm></limit></ode></physics></gazebo>'
    done = to_sdf(urdf(block, joint=TURNING.format("").replace('"j"', '"b"')))
    assert "<physics><ode><limit><cfm>0.5</cfm></limit></ode></physics></joint>" in flat(done.text)


@pytest.mark.parametrize(
    ("limit", "lost"),
    [
        ("<stiffness>1e8</stiffness><dissipation>1.0</dissipation>", []),
        ("<stiffness>1e7</stiffness>", ["URDF has no `stiffness` (1e7) in `limit`"]),
        ("<dissipation>2</dissipation>", ["URDF has no `dissipation` (2) in `limit`"]),
    ],
)
def test_the_stiffness_of_a_limit_is_lost_unless_it_is_the_usual(limit: str, lost: list[str]) -> None:
    axis = f"<axis><xyz>0 0 1</xyz><limit><lower>-1</lower><upper>1</upper>{limit}</limit></axis>"
    joint = f"<joint name='j' type='revolute'><parent>a</parent><child>b</child>{axis}</joint>"
    done = convert(sdf(joint=joint), "urdf")
    assert [loss.message for loss in done.losses if loss.kind is LossKind.DROPPED_ELEMENT] == lost
