"""How links hang together: trees, groups, loops, names of links, and what libsdformat merges."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from sdfcheck.robot.model import Model
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


CHAIN = joint("j", "a", "b") + joint("k", "b", "c") + joint("l", "b", "d")


def test_a_tree() -> None:
    tree = robot(links("a b c d") + CHAIN).tree
    assert names(tree.roots) == names(tree.main_roots) == ["a"]
    assert names(tree.below(tree.links["b"])) == ["b", "c", "d"]
    assert [names(group) for group in tree.groups] == [["a", "b", "c", "d"]]
    assert tree.loops() == []
    assert tree.loose_groups == []
    assert names(tree.children[tree.links["b"]]) == ["k", "l"]


def test_groups_come_by_size() -> None:
    tree = robot(links("a b c d") + joint("j", "c", "b") + joint("k", "c", "d")).tree
    assert [names(group) for group in tree.groups] == [["b", "c", "d"], ["a"]]
    assert names(tree.roots) == ["a", "c"]
    assert names(tree.main_roots) == ["c"]
    assert [names(group) for group in tree.loose_groups] == [["a"]]
    assert tree.top(tree.groups[0]).name == "c"


@pytest.mark.parametrize(
    ("text", "loose"),
    [
        (links("a b"), [["b"]]),
        (links("a gripper") + joint("j", "a", "griper"), []),
        (links("a b c") + joint("j", "a", "nowhere"), [["b"], ["c"]]),
        (links("a b c") + joint("j", "b", "c") + joint("k", "c", "b"), []),
        (links("a b ${p}c") + joint("j", "a", "b"), []),
    ],
)
def test_groups_are_loose_unless_a_joint_is_at_fault(text: str, loose: list[list[str]]) -> None:
    assert [names(group) for group in robot(text).tree.loose_groups] == loose


def test_a_loop_begins_with_its_first_joint() -> None:
    tree = robot(links("a b c") + joint("k", "b", "c") + joint("j", "a", "b") + joint("l", "c", "a")).tree
    assert [names(loop) for loop in tree.loops()] == [["k", "l", "j"]]
    assert tree.main_roots == []


def test_long_chains_take_no_recursion() -> None:
    count = 3000
    text = "".join(f'<link name="l{n}"/>' for n in range(count))
    text += "".join(joint(f"j{n}", f"l{n}", f"l{n + 1}") for n in range(count - 1))
    tree = robot(text).tree
    assert len(list(tree.below(tree.links["l0"]))) == count
    assert tree.loops() == []


def test_names_of_links_are_compared_as_written() -> None:
    model = robot('<link name="a "/><link name="b"/>' + joint("j", "a", "b") + joint("k", "${p}", "b"))
    assert list(model.link_names.unknown) == ["a"]
    assert model.joints[0].parent is None


def test_a_joint_may_have_the_name_of_a_link() -> None:
    mimic = '<joint name="c" type="fixed"><parent link="a"/><child link="c"/><mimic joint="b"/></joint>'
    model = robot(links("a b c") + joint("b", "a", "b") + mimic)
    assert model.joints[0].child is model.links[1]
    follower = model.joints[1].axis.mimic
    assert follower is not None
    assert follower.leader is model.joints[0]


USE = joint("j", "a", "leg_1") + joint("k", "leg_1", "foot")


@pytest.mark.parametrize(
    ("text", "lost", "misspelled"),
    [
        (links("a leg_1 foot") + USE, set(), {}),
        (links("a leg1 foot") + USE, set(), {"leg_1": "leg1"}),
        (links("a foot") + "<link/>" + USE, {"leg_1"}, {}),
        (links("a foot") + '<lnk name="leg_1"/>' + USE, {"leg_1"}, {}),
        (links("a a foot") + USE, {"leg_1"}, {}),
        (links("a foot leg_2 leg_3") + USE, set(), {"leg_1": "leg_2"}),
        (links("a foot ${p}leg_1") + USE, {"leg_1"}, {}),
    ],
)
def test_unknown_names_that_links_explain(text: str, lost: set[str], misspelled: dict[str, str]) -> None:
    found = robot(text).link_names
    assert found.lost == lost
    assert {name: link.name for name, link in found.misspelled.items()} == misspelled
    assert found.explained == {*lost, *misspelled}


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
    lumping = robot(text).lumping
    assert names(lumping.tops) == tops
    assert sorted(names(lumping.with_mass)) == with_mass


BODY = '<inertial><mass value="{0}"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="{1}"/></inertial>'
AT = '<joint name="k" type="fixed"><origin xyz="2 0 0"/><parent link="a"/><child link="b"/></joint>'


def test_moments_of_merged_links() -> None:
    lumping = robot(links("a", BODY.format(1, 1)) + links("b", BODY.format(1, 9)) + AT).lumping
    a, b = lumping.model.links
    assert lumping.base(b) is a
    assert list(lumping.members(a)) == [a, b]
    # 2 kg, 1 m off their common center on either side.
    assert lumping.moments(a) == (2, 4, 12, 0, 0, 0)
    assert lumping.masses[a] == 2


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
    merged = model.lumping.moments(a)
    tensor = [
        [merged.ixx, merged.ixy, merged.ixz],
        [merged.ixy, merged.iyy, merged.iyz],
        [merged.ixz, merged.iyz, merged.izz],
    ]
    assert np.allclose(tensor, whole, rtol=1e-12, atol=1e-12)


def test_moments_that_cannot_be_summed() -> None:
    lumping = robot(links("a", BODY.format(1, "x")) + links("b", BODY.format(1, 9)) + AT).lumping
    assert math.isnan(lumping.moments(lumping.tops[0]).trace)


@pytest.mark.parametrize(
    ("text", "dropped"),
    [
        (links("a", MASS) + links("b") + links("c", MASS) + joint("j", "b", "c") + AT, []),
        (links("a", MASS) + links("b") + joint("j", "a", "b", "continuous"), ["b"]),
        (
            links("a", MASS)
            + links("b", BODY.format("1e-7", 1))
            + links("c", MASS)
            + joint("j", "a", "b", "continuous")
            + joint("k", "b", "c", "continuous"),
            ["b", "c"],
        ),
        (links("world") + links("b", MASS) + joint("j", "world", "b"), []),
        (links("a b", MASS) + joint("j", "a", "b") + joint("k", "b", "a"), []),
    ],
)
def test_links_that_are_left_out(text: str, dropped: list[str]) -> None:
    model = robot(text)
    named = [link for link in model.links if link.name != "world"]
    assert [link.name for link in named if model.lumping.is_dropped(link)] == dropped
