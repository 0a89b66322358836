"""Ends of joints, the tree that they make, and leaders: what the rules about them report."""

from __future__ import annotations

import pytest

import sdfcheck

AXIS = "<axis><xyz>0 0 1</xyz></axis>"


def reported(text: str) -> list[sdfcheck.Diagnostic]:
    """The reports of the rules about joints in a document."""
    return list(sdfcheck.lint(text, isolated=True, select=["JNT"]).diagnostics)


def codes(text: str) -> list[str]:
    return [diagnostic.code for diagnostic in reported(text)]


def in_urdf(inside: str, type: str = "continuous") -> str:
    """A robot with one joint."""
    joint = f'<joint name="j" type="{type}"><parent link="base"/><child link="l"/>{inside}</joint>'
    return f'<robot name="r"><link name="base"/><link name="l"/>{joint}</robot>'


def sdf(text: str, *, world: bool = False) -> str:
    """A model with a link ``base``, or a world, and more in it."""
    inside = (
        f'<world name="w">{text}</world>' if world else f'<model name="m"><link name="base"/>{text}</model>'
    )
    return f'<sdf version="1.12">{inside}</sdf>'


def tied(parent: str, child: str, name: str = "j", type: str = "fixed", more: str = "") -> str:
    """A joint of SDFormat."""
    ends = f"<parent>{parent}</parent><child>{child}</child>"
    return f'<joint name="{name}" type="{type}">{ends}{more}</joint>'


def links(names: str) -> str:
    return "".join(f'<link name="{name}"/>' for name in names.split())


def hung(name: str, parent: str, child: str, type: str = "fixed", inside: str = "") -> str:
    """A joint of URDF."""
    ends = f'<parent link="{parent}"/><child link="{child}"/>'
    return f'<joint name="{name}" type="{type}">{ends}{inside}</joint>'


@pytest.mark.parametrize(
    ("text", "found"),
    [
        (links("l") + tied("q", "l"), ["JNT001 parent"]),
        (tied("base", "q"), ["JNT001 child"]),
        (tied("base", "j"), ["JNT001 joint"]),
        (tied("__root__", "base"), ["JNT001 parent"]),
        (tied("p", "q"), ["JNT001 parent", "JNT001 child"]),
        ('<model name="n"><link name="l"/>' + tied("base", "l") + "</model>", ["JNT001 parent"]),
        (tied("world", "base"), []),
        ('<frame name="f"/><link name="l"/>' + tied("f", "l"), []),
        ('<model name="n"><link name="l"/></model>' + tied("base", "n::l"), []),
        ('<model name="n"><link name="l"/></model>' + tied("base", "n"), []),
        ('<model name="n"><static>1</static><link name="l"/></model>' + tied("n::l", "base"), []),
        ("<include><uri>not_here</uri><name>n</name></include>" + tied("n::l", "base"), []),
        (tied("base::", "base"), []),
        ('<link name=" l "/>' + tied("base", "l"), []),
    ],
)
def test_unknown_ends_in_sdf(text: str, found: list[str]) -> None:
    assert [f"{each.code} {each.message.split()[0]}" for each in reported(sdf(text))] == found


def test_an_end_that_moves_with_no_link() -> None:
    stand = '<model name="n"><static>1</static><link name="l"/></model>'
    run = sdfcheck.lint(sdf(stand + tied("n", "base")), isolated=True, select=["JNT", "FRM"])
    assert [diagnostic.code for diagnostic in run.diagnostics] == ["FRM008"]


@pytest.mark.parametrize(
    ("text", "says"),
    [
        (tied("base", "base"), "are both `base`"),
        ('<frame name="f"/>' + tied("f", "base"), "are both on link `base`"),
        (
            '<frame name="f" attached_to="base"/><frame name="g" attached_to="f"/>' + tied("base", "g"),
            "are both on link `base`",
        ),
        ('<model name="n"><link name="l"/></model>' + tied("n", "n::l"), "are both on link `l`"),
    ],
)
def test_joints_that_tie_a_link_to_itself(text: str, says: str) -> None:
    (diagnostic,) = reported(sdf(text))
    assert diagnostic.code == "JNT002"
    assert says in diagnostic.message


def test_the_world_as_child() -> None:
    attached = '<model name="m"><link name="l"/></model><frame name="f"/>' + tied("m", "f")
    assert codes(sdf(tied("base", "world"))) == ["JNT003"]
    assert codes(sdf(tied("world", "world"))) == ["JNT003"]
    assert codes(sdf(attached, world=True)) == ["JNT003"]


def test_several_parents() -> None:
    gear = tied("a", "b", "k", "gearbox", AXIS + AXIS.replace("axis", "axis2"))
    (diagnostic,) = reported(sdf(links("a b") + tied("base", "b") + tied("a", "b", "k")))
    assert diagnostic.message == "link `b` is child of 2 joints: `j` and `k`"
    assert diagnostic.severity is sdfcheck.Severity.WARNING
    assert codes(sdf(links("a b") + tied("base", "b") + gear)) == []


def test_joints_of_a_world_and_of_its_models_make_one_tree() -> None:
    model = '<model name="m"><link name="a"/><link name="b"/>' + tied("a", "b") + "</model>"
    assert codes(sdf(model + tied("world", "m::b"), world=True)) == ["JNT007"]


def test_a_loop_is_reported_once_from_its_last_joint() -> None:
    ring = tied("base", "a") + tied("a", "b", "k") + tied("b", "base", "i")
    (diagnostic,) = reported(sdf(links("a b") + ring))
    assert diagnostic.message.endswith("`base` → `a` → `b` → `base`")
    assert [label.span.text for label in diagnostic.labels] == ["a", "b"]
    text = links("a b c") + hung("k", "b", "c") + hung("j", "a", "b") + hung("l", "c", "a")
    (diagnostic,) = reported(f'<robot name="r">{text}</robot>')
    assert (diagnostic.code, diagnostic.severity) == ("JNT008", sdfcheck.Severity.ERROR)
    assert diagnostic.message.endswith("`a` → `b` → `c` → `a`")


@pytest.mark.parametrize(
    ("text", "found"),
    [
        (links("a b") + hung("j", "a", "b"), []),
        (links("a b c") + hung("j", "a", "b") + hung("k", "c", "b"), ["JNT007"]),
        (links("a b") + hung("j", "a", "b") + hung("k", "b", "b"), ["JNT002"]),
        (links("a b") + hung("j", "b", "a") + hung("k", "a", "b"), ["JNT008"]),
        (links("a b") + hung("j", "a", "bb"), ["JNT001"]),
        (links("base tip") + hung("j", "base", "tipp"), ["JNT001"]),
        (links("a b") + "<link/>" + hung("j", "a", "b") + hung("k", "b", "c"), []),
        (links("a leg1 foot") + hung("j", "a", "leg_1") + hung("k", "leg_1", "foot"), []),
        (links("a b world") + hung("j", "a", "b") + hung("k", "a", "world"), ["JNT003"]),
        (links("a b") + hung("j", "a", "b") + hung("j", "a", "b"), []),
        (links("a") + hung("j", "world", "a"), ["JNT001"]),
        (links("a b") + hung("b", "a", "b") + hung("k", "a", "${x}"), []),
        (
            links("a") + "<gazebo>" + tied("q", "q") + tied("a", "world") + tied("a", "q") + "</gazebo>",
            ["JNT002", "JNT003"],
        ),
    ],
)
def test_ends_in_urdf(text: str, found: list[str]) -> None:
    assert codes(f'<robot name="r">{text}</robot>') == found


def test_ends_of_one_name_are_one_mistake() -> None:
    text = links("a b c d") + hung("j", "a", "x9") + hung("k", "x9", "b") + hung("l", "x9", "c")
    (diagnostic,) = reported(f'<robot name="r">{text}</robot>')
    assert diagnostic.message == "child `x9` of joint `j` does not exist (named 3 times)"


def chain(*leaders: str) -> list[sdfcheck.Diagnostic]:
    """The reports about joints j0, j1 … in a row, each with the mimic that is given (empty: without one)."""
    text, parent = "", "base"
    for number, mimic in enumerate(leaders):
        axis = f"<axis><xyz>0 0 1</xyz>{mimic}</axis>"
        text += f'<link name="l{number}"/>' + tied(parent, f"l{number}", f"j{number}", "revolute", axis)
        parent = f"l{number}"
    return reported(sdf(text))


def test_leaders() -> None:
    assert chain("", '<mimic joint="j0"/>', '<mimic joint="j1"/>') == []
    (unknown,) = chain('<mimic joint="J1"/>', "")
    (axis,) = chain("", '<mimic joint="j0" axis="axis2"/>')
    (odd,) = chain("", '<mimic joint="j0" axis="axis3"/>')
    (link,) = chain('<mimic joint="base"/>')
    assert {each.code for each in (unknown, axis, odd, link)} == {"JNT009"}
    assert "`j1` differs in case only" in unknown.message
    assert (axis.span.text, odd.span.text) == ("axis2", "axis3")
    assert "`base`, which is not a joint of its model" in link.message


def test_rings_of_mimics() -> None:
    (ring,) = chain('<mimic joint="j1"/>', '<mimic joint="j2"/>', '<mimic joint="j1"/>')
    (alone,) = chain('<mimic joint="j0"/>')
    assert ring.message.endswith("in a ring: `j1` → `j2` → `j1`")
    assert alone.message == "joint `j0` mimics itself"
    three = "".join(
        hung(f"j{n}", "a", end, "continuous", f'<mimic joint="j{(n + 1) % 3}"/>')
        for n, end in enumerate("bcd")
    )
    (ring,) = reported(f'<robot name="r">{links("a b c d")}{three}</robot>')
    assert ring.message.endswith("in a ring: `j0` → `j1` → `j2` → `j0`")


def test_leaders_in_urdf() -> None:
    assert codes(in_urdf('<mimic joint="jj"/>')) == ["JNT009"]
    assert codes(in_urdf('<mimic joint="jj"/>', "fixed")) == []
    assert codes(in_urdf('<mimic joint="j"/>')) == ["JNT012"]
    (diagnostic,) = reported(in_urdf('<mimic joint="K"/>').replace("</robot>", f"{links('k')}</robot>"))
    assert "did you mean" not in diagnostic.message


@pytest.mark.parametrize(
    ("joints", "is_refused"),
    [
        ((("base", "c"), ("b", "c")), False),
        ((("world", "c"), ("b", "c")), False),
        ((("base", "c"), ("b", "c"), ("base", "b")), True),
        ((("b", "c"), ("base", "c"), ("b", "base")), True),
        ((("world", "c"), ("b", "c"), ("world", "b")), True),
    ],
)
def test_drake_takes_two_parents_unless_they_close_a_loop(
    joints: tuple[tuple[str, str], ...], is_refused: bool
) -> None:
    ends = "".join(tied(parent, child, f"j{at}") for at, (parent, child) in enumerate(joints))
    found = [
        each for each in reported(sdf(f'<link name="b"/><link name="c"/>{ends}')) if each.code == "JNT007"
    ]
    assert found
    assert {dict(each.affects)["drake"].is_refusal for each in found} == {is_refused}


@pytest.mark.parametrize(("kind", "is_refused"), [("ball", True), ("fixed", False)])
def test_drake_cannot_reverse_every_joint(kind: str, is_refused: bool) -> None:
    ends = tied("base", "c") + tied("b", "c", "k").replace("fixed", kind)
    found = reported(sdf(f'<link name="b"/><link name="c"/>{ends}'))
    (reaction,) = (dict(each.affects)["drake"] for each in found if each.code == "JNT007")
    assert reaction.is_refusal is is_refused
