"""The tree of a URDF robot, its joints, masses and references."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.robot import joint_problems, robot_problems, urdf_joints, urdf_links, urdf_references
from sdfcheck.robot.names import ClashingName, DuplicateName
from sdfcheck.robot.urdf_tree import UrdfTree, tree
from sdfcheck.source.document import Document, read

MASS = '<inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'


def document(text: str) -> Document:
    return read(f'<robot name="r">{text}</robot>'.encode(), Path("r.urdf"))


def links(names: str, inside: str = MASS) -> str:
    return "".join(f'<link name="{name}">{inside}</link>' for name in names.split())


def joint(name: str, parent: str, child: str, kind: str = "fixed", inside: str = "") -> str:
    ends = f'<parent link="{parent}"/><child link="{child}"/>'
    return f'<joint name="{name}" type="{kind}">{ends}{inside}</joint>'


def robot(text: str) -> UrdfTree:
    return tree(document(text))


def kinds(text: str) -> list[str]:
    """The names of the kinds of all problems of links and joints, but for hints."""
    doc = document(text)
    found = [*urdf_links.problems(doc), *urdf_joints.problems(doc), *urdf_references.problems(doc)]
    return sorted(type(p).__name__ for p in found if not isinstance(p, robot_problems.RootWithInertia))


def test_a_tree() -> None:
    made = robot(links("a b c d") + joint("j", "a", "b") + joint("k", "b", "c") + joint("l", "b", "d"))
    assert made.roots == ["a"]
    assert list(made.below("b")) == ["b", "c", "d"]
    assert made.parts() == [["a", "b", "c", "d"]]
    assert made.loops() == []
    assert [each.name for each in made.children["b"]] == ["k", "l"]


def test_parts_come_by_size() -> None:
    made = robot(links("a b c d") + joint("j", "c", "b") + joint("k", "c", "d"))
    assert made.parts() == [["b", "c", "d"], ["a"]]
    assert made.roots == ["a", "c"]


def test_a_loop_begins_with_its_first_joint() -> None:
    doc = document(links("a b c") + joint("k", "b", "c") + joint("j", "a", "b") + joint("l", "c", "a"))
    assert [each.name for each in tree(doc).loops()[0]] in (["k", "l", "j"], ["l", "j", "k"], ["j", "k", "l"])
    (loop,) = (p for p in urdf_joints.problems(doc) if isinstance(p, joint_problems.JointLoop))
    assert loop.links == ("c", "a", "b")
    assert kinds(links("a b c") + joint("k", "b", "c") + joint("j", "a", "b") + joint("l", "c", "a")) == [
        "JointLoop"
    ]


def test_long_chains_take_no_recursion() -> None:
    count = 3000
    text = "".join(f'<link name="l{n}"/>' for n in range(count))
    text += "".join(joint(f"j{n}", f"l{n}", f"l{n + 1}") for n in range(count - 1))
    made = robot(text)
    assert len(list(made.below("l0"))) == count
    assert made.loops() == []


@pytest.mark.parametrize(
    ("text", "found"),
    [
        (links("a b") + joint("j", "a", "b"), []),
        (links("a b"), ["DisconnectedLink"]),
        (links("a b c d") + joint("j", "a", "b") + joint("k", "c", "d"), ["SeveralRoots"]),
        (links("a b c") + joint("j", "a", "b") + joint("k", "c", "b"), ["SeveralParents"]),
        (links("a b") + joint("j", "a", "b") + joint("k", "b", "b"), ["SelfJoint"]),
        (links("a b") + joint("j", "b", "a") + joint("k", "a", "b"), ["JointLoop"]),
        (links("a b") + joint("j", "a", "bb"), ["UnknownJointEnd"]),
        (links("base tip") + joint("j", "base", "tipp"), ["UnknownJointEnd"]),
        (links("a b") + "<link/>" + joint("j", "a", "b") + joint("k", "b", "c"), []),
        (
            links("a leg_1 foot").replace("leg_1", "leg1")
            + joint("j", "a", "leg_1")
            + joint("k", "leg_1", "foot"),
            ["MisnamedLink"],
        ),
        (links("a b world") + joint("j", "a", "b") + joint("k", "a", "world"), ["WorldAsChild"]),
        (links("a b") + joint("b", "a", "b"), ["ClashingName"]),
        (links("a a"), ["DuplicateName"]),
        (links("a b") + joint("j", "a", "b") + joint("j", "a", "b"), ["DuplicateName"]),
        (links("a::b"), ["DelimiterInName"]),
        (links("__a__"), ["ReservedName"]),
        (links("a") + '<gazebo reference="b"/>', ["UnreferencedExtension"]),
        (links("a") + '<gazebo reference=""/>', []),
        (
            links("a") + '<transmission name="t"><joint name="j"/></transmission>',
            ["UnknownTransmissionJoint"],
        ),
        (links("a") + '<ros2_control><joint name="j"/></ros2_control>', ["UnknownControlJoint"]),
    ],
)
def test_one_mistake_is_one_problem(text: str, found: list[str]) -> None:
    assert kinds(text) == found


def test_ends_of_one_name_are_one_problem() -> None:
    doc = document(links("a b c d") + joint("j", "a", "x9") + joint("k", "x9", "b") + joint("l", "x9", "c"))
    (problem,) = (p for p in urdf_joints.problems(doc) if isinstance(p, joint_problems.UnknownJointEnd))
    assert (problem.role, len(problem.others)) == ("child", 2)


LIMIT = '<limit lower="{}" upper="{}" effort="1" velocity="1"/>'


@pytest.mark.parametrize(
    ("kind", "inside", "found"),
    [
        ("revolute", "", ["MissingLimit"]),
        ("revolute", '<limti lower="0" upper="1" effort="1" velocity="1"/>', []),
        ("revolute", '<limit effort="1" velocity="1"/>', ["LockedByDefault"]),
        ("revolute", LIMIT.format(0, 0), []),
        ("revolute", LIMIT.format("high", 0), []),
        ("fixed", LIMIT.format(1, -1), []),
        ("continuous", "<dynamics/>", ["MissingAttribute"]),
        ("continuous", '<dynamics dampng="1"/>', []),
        ("planar", "", ["UnconvertedJoint"]),
        ("continuous", '<mimic joint="jj"/>', ["UnknownMimicLeader"]),
        ("continuous", '<mimic joint="j"/>', ["MimicCycle"]),
    ],
)
def test_joints(kind: str, inside: str, found: list[str]) -> None:
    assert kinds(links("a b") + joint("j", "a", "b", kind, inside)) == found


def test_mimics() -> None:
    text = links("a b c d") + joint("j", "a", "b") + joint("k", "a", "c", "continuous", '<mimic joint="j"/>')
    assert kinds(text + joint("l", "a", "d")) == ["MimicOfFixedJoint"]
    ring = "".join(
        joint(f"j{n}", "a", end, "continuous", f'<mimic joint="j{(n + 1) % 3}"/>')
        for n, end in enumerate("bcd")
    )
    doc = document(links("a b c d") + ring)
    (cycle,) = urdf_joints.problems(doc)
    assert isinstance(cycle, joint_problems.MimicCycle)
    assert cycle.joints == ("j0", "j1", "j2")


BARE = '<link name="{}"/>'


@pytest.mark.parametrize(
    ("text", "found"),
    [
        (BARE.format("a"), ["VanishingRoot"]),
        (BARE.format("a") + links("b") + joint("j", "a", "b"), []),
        (BARE.format("a") + links("b") + joint("j", "a", "b", "continuous"), ["VanishingRoot"]),
        (BARE.format("world") + links("b") + joint("j", "world", "b"), []),
        (BARE.format("world") + BARE.format("b") + joint("j", "world", "b"), ["VanishingRoot"]),
        (links("a") + BARE.format("b") + joint("j", "a", "b", "continuous"), ["MasslessMovingLink"]),
        (links("a") + BARE.format("b") + joint("j", "a", "b"), []),
        (
            BARE.format("a")
            + links("b")
            + joint("j", "a", "b")
            + '<gazebo reference="j"><preserveFixedJoint>true</preserveFixedJoint></gazebo>',
            ["VanishingRoot"],
        ),
    ],
)
def test_masses(text: str, found: list[str]) -> None:
    assert kinds(text) == found


def test_a_link_below_a_joint_that_is_kept() -> None:
    kept = '<gazebo reference="j"><disableFixedJointLumping>true</disableFixedJointLumping></gazebo>'
    assert kinds(links("a") + BARE.format("b") + joint("j", "a", "b") + kept) == ["MasslessMovingLink"]


def test_a_robot_without_any_mass() -> None:
    doc = document(BARE.format("a") + BARE.format("b") + joint("j", "a", "b", "continuous"))
    (problem,) = urdf_links.problems(doc)
    assert isinstance(problem, robot_problems.VanishingRoot)
    assert (problem.links, problem.massless) == (2, True)


def visual(material: str) -> str:
    return f'<link name="a">{MASS}<visual><geometry><sphere radius="1"/></geometry>{material}</visual></link>'


@pytest.mark.parametrize(
    ("text", "found"),
    [
        (visual('<material name="m"/>'), ["UndefinedMaterial"]),
        (visual('<material name="m"/>') + '<material name="m"><color rgba="1 1 1 1"/></material>', []),
        (visual('<material name="m"><color/></material>'), []),
        ('<material name="m"/>' + visual('<material name="m"/>'), ["EmptyMaterial"]),
        ('<material><color rgba="1 1 1 1"/></material>' + visual('<material name="m"/>'), []),
        (visual('<material name="${m}"/>'), []),
    ],
)
def test_materials(text: str, found: list[str]) -> None:
    assert kinds(text) == found


def test_a_material_defined_twice() -> None:
    red, pale = (f'<material name="m"><color rgba="{share} 0 0 1"/></material>' for share in ("1", "0.5"))
    assert kinds(red + visual(pale)) == ["DifferentMaterial"]
    assert kinds(red + visual(red.replace('"1 0', '"1.0 0'))) == []


def test_names_and_what_they_clash_with() -> None:
    doc = document(links("a b b") + joint("a", "a", "b"))
    found = {type(problem): problem for problem in urdf_links.problems(doc)}
    assert found[DuplicateName].name == "b"  # type: ignore[attr-defined]
    assert found[ClashingName].first_kind == "link"  # type: ignore[attr-defined]


@pytest.mark.parametrize(
    ("pitch", "found"),
    [("1.57", 1), ("-1.57", 1), ("1.5707963", 0), ("1.5708", 0), ("1.56", 0), ("4.7124", 0), ("4.712", 1)],
)
def test_pitch(pitch: str, found: int) -> None:
    doc = document(visual("").replace("<geometry>", f'<origin rpy="0 {pitch} 0"/><geometry>'))
    assert sum(isinstance(p, robot_problems.SingularPitch) for p in urdf_references.problems(doc)) == found
