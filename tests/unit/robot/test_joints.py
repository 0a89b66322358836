"""Joints: their ends and leaders, and the tree that they make."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.robot import joint_problems as kinds
from sdfcheck.robot import joints
from sdfcheck.source.document import read

AXIS = "<axis><xyz>0 0 1</xyz></axis>"


def found(text: str, *, world: bool = False) -> list[kinds.Problem]:
    inside = (
        f'<world name="w">{text}</world>' if world else f'<model name="m"><link name="base"/>{text}</model>'
    )
    return joints.problems(read(f'<sdf version="1.12">{inside}</sdf>'.encode(), Path("example.sdf")))


def joint(parent: str, child: str, name: str = "j", type: str = "fixed", more: str = "") -> str:
    ends = f"<parent>{parent}</parent><child>{child}</child>"
    return f'<joint name="{name}" type="{type}">{ends}{more}</joint>'


@pytest.mark.parametrize(
    ("text", "kind", "role"),
    [
        ('<link name="l"/>' + joint("q", "l"), kinds.UnknownJointEnd, "parent"),
        (joint("base", "q"), kinds.UnknownJointEnd, "child"),
        (joint("base", "j"), kinds.UnknownJointEnd, "child"),
        (joint("__root__", "base"), kinds.UnknownJointEnd, "parent"),
        (
            '<model name="n"><link name="l"/>' + joint("base", "l") + "</model>",
            kinds.UnknownJointEnd,
            "parent",
        ),
        (
            '<model name="n"><static>1</static><link name="l"/></model>' + joint("n", "base"),
            kinds.DetachedFrame,
            "parent",
        ),
    ],
)
def test_ends_that_cannot_be_used(text: str, kind: type, role: str) -> None:
    (problem,) = found(text)
    assert isinstance(problem, kinds.UnknownJointEnd | kinds.DetachedFrame)
    assert type(problem) is kind
    assert problem.role == role


def test_two_unknown_ends_are_two_mistakes() -> None:
    assert [type(problem) for problem in found(joint("p", "q"))] == [kinds.UnknownJointEnd] * 2


@pytest.mark.parametrize(
    "text",
    [
        joint("world", "base"),
        '<frame name="f"/><link name="l"/>' + joint("f", "l"),
        '<model name="n"><link name="l"/></model>' + joint("base", "n::l"),
        '<model name="n"><link name="l"/></model>' + joint("base", "n"),
        '<model name="n"><static>1</static><link name="l"/></model>' + joint("n::l", "base"),
        "<include><uri>not_here</uri><name>n</name></include>" + joint("n::l", "base"),
        joint("base::", "base"),
    ],
)
def test_sound_ends_and_those_of_others(text: str) -> None:
    assert found(text) == []


@pytest.mark.parametrize(
    ("text", "link"),
    [
        (joint("base", "base"), None),
        ('<frame name="f"/>' + joint("f", "base"), "base"),
        (
            '<frame name="f" attached_to="base"/><frame name="g" attached_to="f"/>' + joint("base", "g"),
            "base",
        ),
        ('<model name="n"><link name="l"/></model>' + joint("n", "n::l"), "l"),
    ],
)
def test_joints_that_tie_a_link_to_itself(text: str, link: str | None) -> None:
    (problem,) = found(text)
    assert isinstance(problem, kinds.SelfJoint)
    assert problem.link == link


def test_the_world_as_child() -> None:
    (direct,) = found(joint("base", "world"))
    (attached,) = found(
        '<model name="m"><link name="l"/></model><frame name="f"/>' + joint("m", "f"), world=True
    )
    assert isinstance(direct, kinds.WorldAsChild)
    assert isinstance(attached, kinds.WorldAsChild)


def test_several_parents() -> None:
    links = '<link name="a"/><link name="b"/>'
    (problem,) = found(links + joint("base", "b") + joint("a", "b", "k"))
    assert isinstance(problem, kinds.SeveralParents)
    assert (problem.link, problem.joints, problem.refused) == ("b", ("j", "k"), False)
    assert (
        found(
            links + joint("base", "b") + joint("a", "b", "k", "gearbox", AXIS + AXIS.replace("axis", "axis2"))
        )
        == []
    )


def test_a_loop_is_told_once_from_its_first_joint() -> None:
    links = '<link name="a"/><link name="b"/>'
    (problem,) = found(links + joint("base", "a") + joint("a", "b", "k") + joint("b", "base", "i"))
    assert isinstance(problem, kinds.JointLoop)
    assert problem.links == ("a", "b", "base")
    assert [end.text for end in problem.ends] == ["a", "b", "base"]


def test_joints_of_a_world_and_of_its_models_make_one_tree() -> None:
    model = '<model name="m"><link name="a"/><link name="b"/>' + joint("a", "b") + "</model>"
    (problem,) = found(model + joint("world", "m::b"), world=True)
    assert isinstance(problem, kinds.SeveralParents)


def chain(*leaders: str) -> list[kinds.Problem]:
    """Joints j0, j1 … in a row, each with the mimic that is given (none: empty)."""
    text, parent = "", "base"
    for number, mimic in enumerate(leaders):
        axis = f"<axis><xyz>0 0 1</xyz>{mimic}</axis>"
        text += f'<link name="l{number}"/>' + joint(parent, f"l{number}", f"j{number}", "revolute", axis)
        parent = f"l{number}"
    return found(text)


def test_leaders() -> None:
    assert chain("", '<mimic joint="j0"/>', '<mimic joint="j1"/>') == []
    (unknown,) = chain('<mimic joint="J1"/>', "")
    (axis,) = chain("", '<mimic joint="j0" axis="axis2"/>')
    (odd,) = chain("", '<mimic joint="j0" axis="axis3"/>')
    (link,) = chain('<mimic joint="base"/>')
    assert isinstance(unknown, kinds.UnknownMimicLeader)
    assert unknown.suggestion == "j1"
    assert isinstance(axis, kinds.UnknownMimicLeader)
    assert (axis.axis, axis.value.text) == ("axis2", "axis2")
    assert isinstance(odd, kinds.UnknownMimicLeader)
    assert odd.axis == "axis3"
    assert isinstance(link, kinds.UnknownMimicLeader)


def test_rings_of_mimics() -> None:
    (ring,) = chain('<mimic joint="j1"/>', '<mimic joint="j2"/>', '<mimic joint="j1"/>')
    (alone,) = chain('<mimic joint="j0"/>')
    assert isinstance(ring, kinds.MimicCycle)
    assert ring.joints == ("j1", "j2")
    assert isinstance(alone, kinds.MimicCycle)
    assert alone.joints == ("j0",)
