"""How links hang together: trees, groups, loops, names of links."""

from __future__ import annotations

from pathlib import Path

import pytest

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
