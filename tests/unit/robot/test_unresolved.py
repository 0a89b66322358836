"""Facts of the graph about unresolved names, joints across models, leaders and misspelled children."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.robot.graph import Axis, Limit
from sdfcheck.robot.root import Root, root_of
from sdfcheck.source.document import read


def root(text: str) -> Root:
    """The graph of what is in a model, a world (``<world``) or a robot (``<robot``)."""
    if text.startswith("<robot"):
        return root_of(read(text.encode(), Path("r.urdf")))
    inside = text if text.startswith("<world") else f'<model name="m">{text}</model>'
    return root_of(read(f'<sdf version="1.12">{inside}</sdf>'.encode(), Path("m.sdf")))


def joint(name: str, parent: str, child: str, more: str = "") -> str:
    ends = f"<parent>{parent}</parent><child>{child}</child>"
    return f'<joint name="{name}" type="revolute">{ends}{more}</joint>'


def links(names: str) -> str:
    return "".join(f'<link name="{name}"/>' for name in names.split())


@pytest.mark.parametrize(
    ("text", "unresolved", "lost"),
    [
        (links("a b") + joint("j", "a", "b"), {}, set()),
        (links("a") + joint("j", "a", "x") + joint("k", "y", "x"), {"x": 2, "y": 1}, set()),
        (links("a") + "<link/>" + joint("j", "a", "x"), {"x": 1}, set()),
        (links("a") + '<lnik name="x"/>' + joint("j", "a", "x"), {"x": 1}, set()),
        (links("a a") + joint("j", "a", "other"), {"other": 1}, {"other"}),
        (links("arm arm") + joint("j", "arm", "Arm"), {"Arm": 1}, set()),
        (links("a") + joint("j", "x", "x") + joint("k", "y", "world"), {}, set()),
        (links("a") + "<include><uri>model://no</uri></include>" + joint("j", "a", "x"), {}, set()),
    ],
)
def test_names_that_reach_nothing(text: str, unresolved: dict[str, int], lost: set[str]) -> None:
    (model,) = root(text).models
    assert {name: len(ends) for name, ends in model.unresolved.items()} == unresolved
    assert model.lost_names == lost


@pytest.mark.parametrize(
    ("part", "fault"),
    [
        ("<link/>", "link"),
        ('<lnik name="x"/>', "lnik"),
        ('<link nam="x"/>', "nam"),
        ('<link name=" "/>', " "),
        (joint("k", "x", "a"), "x"),
    ],
)
def test_the_fault_of_a_name_that_nothing_has(part: str, fault: str) -> None:
    (model,) = root(links("a") + part + joint("j", "a", "x")).models
    place = model.fault_of("x")
    assert place is not None
    assert place.text == fault
    assert model.fault_of("y") is None or fault != "x"


def test_names_that_reach_nothing_in_urdf() -> None:
    end = '<joint name="j" type="fixed"><parent link="a"/><child link="x"/></joint>'
    (model,) = root(f'<robot name="r">{links("a")}{end}</robot>').models
    assert [value.span.text for value in model.unresolved["x"]] == ["x"]
    assert model.lost_names == set()
    (model,) = root(f'<robot name="r">{links("a")}<link/>{end}</robot>').models
    assert model.lost_names == {"x"}


def test_joints_of_all_models_of_a_file() -> None:
    inner = f'<model name="m">{links("a b c")}{joint("j", "a", "b")}{joint("k", "b", "a")}</model>'
    gear = joint("g", "m::a", "m::c").replace("revolute", "gearbox")
    whole = root(f'<world name="w">{inner}{joint("w", "world", "m::c")}{gear}</world>')
    found = {link.name: [each.name for each in joints] for link, joints in whole.parent_joints.items()}
    assert found == {"b": ["j"], "a": ["k"], "c": ["w"]}
    assert [[each.name for each in loop] for loop in whole.loops] == [["j", "k"]]


def test_whom_a_mimic_follows() -> None:
    def axis(mimic: str) -> str:
        return f"<axis><xyz>0 0 1</xyz>{mimic}</axis>"

    text = links("a b c d") + joint("j", "a", "b", axis('<mimic joint="k"/>'))
    text += joint("k", "a", "c", axis('<mimic joint="J"/>'))
    text += joint("l", "a", "d", axis('<mimic joint="j" axis="axis2"/>'))
    first, second, third = root(text).each("Mimic")
    assert first.next is second
    assert second.next is None
    assert second.leader_guess == "j"
    assert third.is_without_axis
    assert third.next is None


@pytest.mark.parametrize("mimic", ["<mimic/>", '<mimic joint=" "/>', '<mimic joint="x"/>'])
def test_a_mimic_of_nothing_has_no_leader(mimic: str) -> None:
    (found,) = root(links("a b") + joint("j", "a", "b", f"<axis><xyz>0 0 1</xyz>{mimic}</axis>")).each(
        "Mimic"
    )
    assert found.leader is None
    assert (found.leader_value is None) is ("x" not in mimic.replace("mimic", ""))


def test_the_axes_of_a_joint_have_names() -> None:
    axes = "<axis><xyz>0 0 1</xyz></axis><axis2><xyz>0 1 0</xyz></axis2>"
    (both,) = root(links("a b") + joint("j", "a", "b", axes)).each("Joint")
    assert (both.axis.name, both.axis2.name) == ("axis", "axis2")


def test_misspelled_children() -> None:
    (one,) = root(links("a b") + joint("j", "a", "b", "<axsi/>")).each("Joint")
    assert one.misnamed("axis")
    assert not one.misnamed("axis2")
    end = '<joint name="j" type="fixed"><limti lower="0"/></joint>'
    (one,) = root(f'<robot name="r">{links("a")}{end}</robot>').each("Joint")
    assert one.misnamed("limit")
    assert not one.misnamed("axis")


@pytest.mark.parametrize(
    ("xyz", "length"),
    [("0 3 4", "5.0"), ("0 0 0", "0.0"), ("0 0", "nan"), ("a b c", "nan"), ("0 0 inf", "nan")],
)
def test_the_length_of_an_axis(xyz: str, length: str) -> None:
    (axis,) = root(links("a b") + joint("j", "a", "b", f"<axis><xyz>{xyz}</xyz></axis>")).each(Axis)
    assert str(axis.length) == length


def test_axes_and_limits_are_in_joints_only() -> None:
    block = '<gazebo reference="a"><axis><limit/></axis><limit/><joint name="k"><axis><limit/></axis></joint></gazebo>'
    whole = root(f'<robot name="r">{links("a")}{block}</robot>')
    (axis,), (limit,) = list(whole.each(Axis)), list(whole.each(Limit))
    assert axis.joint.name == limit.joint.name == "k"
    assert axis.is_extension
    assert limit.is_extension
