"""Whole URDF robots: one mistake makes one diagnostic, and what the rules about them say."""

from __future__ import annotations

from pathlib import Path

import pytest

import sdfcheck

MASS = '<inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'
BARE = '<link name="{}"/>'
SHAPE = '<geometry><sphere radius="1"/></geometry>'
FAMILIES = ["URD", "JNT", "NAM", "GAZ003"]


def links(names: str, inside: str = MASS) -> str:
    return "".join(f'<link name="{name}">{inside}</link>' for name in names.split())


def joint(name: str, parent: str, child: str, kind: str = "fixed", inside: str = "") -> str:
    ends = f'<parent link="{parent}"/><child link="{child}"/>'
    return f'<joint name="{name}" type="{kind}">{ends}{inside}</joint>'


EXPECTED = ("renamed-for-usd", "root-with-inertia")


def reported(text: str) -> list[sdfcheck.Diagnostic]:
    """The reports about a robot, except for the hint that its root has mass, and that names are others in USD."""
    found = sdfcheck.lint(f'<robot name="r">{text}</robot>', isolated=True, select=FAMILIES)
    return [diagnostic for diagnostic in found.diagnostics if diagnostic.name not in EXPECTED]


def names(text: str) -> list[str]:
    return sorted(diagnostic.name for diagnostic in reported(text))


@pytest.mark.parametrize(
    ("text", "found"),
    [
        (links("a b") + joint("j", "a", "b"), []),
        (links("a b"), ["disconnected-link"]),
        (links("a b c d") + joint("j", "a", "b") + joint("k", "c", "d"), ["several-roots"]),
        (links("a b c") + joint("j", "a", "b") + joint("k", "c", "b"), ["several-parents"]),
        (links("a b") + joint("j", "a", "b") + joint("k", "b", "b"), ["self-joint"]),
        (links("a b") + joint("j", "b", "a") + joint("k", "a", "b"), ["joint-loop"]),
        (
            links("a b c") + joint("k", "b", "c") + joint("j", "a", "b") + joint("l", "c", "a"),
            ["joint-loop"],
        ),
        (links("a b") + joint("j", "a", "bb"), ["unknown-joint-end"]),
        (links("base tip") + joint("j", "base", "tipp"), ["unknown-joint-end"]),
        (links("a b") + "<link/>" + joint("j", "a", "b") + joint("k", "b", "c"), []),
        (
            links("a leg1 foot") + joint("j", "a", "leg_1") + joint("k", "leg_1", "foot"),
            ["disconnected-link"],
        ),
        (links("a b world") + joint("j", "a", "b") + joint("k", "a", "world"), ["world-as-child"]),
        (links("a b") + joint("b", "a", "b"), ["clashing-name"]),
        (links("a a"), ["duplicate-name"]),
        (links("a b") + joint("j", "a", "b") + joint("j", "a", "b"), ["duplicate-name"]),
        (links("a::b"), ["delimiter-in-name"]),
        (links("__a__"), ["reserved-name"]),
        (links("a") + '<gazebo reference="b"/>', ["unreferenced-extension"]),
        (links("a") + '<gazebo reference=""/>', []),
        (links("a") + '<gazebo reference="${b}"/>', ["unexpanded-expression"]),
        (
            links("a") + '<transmission name="t"><joint name="j"/></transmission>',
            ["unknown-transmission-joint"],
        ),
        (
            links("a b")
            + '<drake:joint xmlns:drake="http://drake.mit.edu" name="j" type="ball"/>'
            + joint("k", "a", "b")
            + '<transmission name="t"><joint name="j"/></transmission>',
            [],
        ),
        (links("a") + '<ros2_control><joint name="j"/></ros2_control>', ["unknown-control-joint"]),
        (links("a") + '<ros2_control><joint name="${j}"/></ros2_control>', ["unexpanded-expression"]),
    ],
)
def test_one_mistake_is_one_diagnostic(text: str, found: list[str]) -> None:
    assert names(text) == found


def test_ends_of_one_name_are_reported_once() -> None:
    (found,) = reported(
        links("a b c d") + joint("j", "a", "x9") + joint("k", "x9", "b") + joint("l", "x9", "c")
    )
    assert found.name == "unknown-joint-end"
    assert found.message.startswith("child `x9` of joint `j`")


LIMIT = '<limit lower="{}" upper="{}" effort="1" velocity="1"/>'


@pytest.mark.parametrize(
    ("kind", "inside", "found"),
    [
        ("revolute", "", ["missing-limit"]),
        ("revolute", '<limti lower="0" upper="1" effort="1" velocity="1"/>', ["unknown-urdf-element"]),
        ("revolute", '<limit effort="1" velocity="1"/>', ["missing-limit"]),
        ("revolute", '<limit lower="0" upper="1" efort="1" velocity="1"/>', ["unknown-urdf-attribute"]),
        ("revolute", LIMIT.format(0, 0), []),
        ("continuous", '<limit effort="1"/>', ["missing-limit"]),
        ("continuous", '<limit effort="" velocity="1"/>', []),
        ("fixed", LIMIT.format(1, -1), []),
        ("planar", "", ["unconverted-joint"]),
        ("continuous", '<mimic joint="jj"/>', ["unknown-mimic-leader"]),
        ("continuous", '<mimic joint="j"/>', ["mimic-cycle"]),
    ],
)
def test_joints(kind: str, inside: str, found: list[str]) -> None:
    assert names(links("a b") + joint("j", "a", "b", kind, inside)) == found


def test_a_limit_or_inertia_says_all_that_it_lacks() -> None:
    (limit,) = reported(links("a b") + joint("j", "a", "b", "continuous", '<limit lower="0"/>'))
    assert limit.message == "the limit of joint `j` has no `effort` and no `velocity`"
    (inertia,) = reported(
        links("a", '<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1"/></inertial>')
    )
    assert inertia.message == "the inertia of link `a` has no `ixy`, `ixz` or `iyz`"
    assert names(links("a", "<inertial><mas/></inertial>"))[:1] == ["incomplete-inertia"]


def test_mimics() -> None:
    text = links("a b c d") + joint("j", "a", "b") + joint("k", "a", "c", "continuous", '<mimic joint="j"/>')
    assert names(text + joint("l", "a", "d")) == ["mimic-of-fixed-joint"]
    ring = "".join(
        joint(f"j{n}", "a", end, "continuous", f'<mimic joint="j{(n + 1) % 3}"/>')
        for n, end in enumerate("bcd")
    )
    assert names(links("a b c d") + ring) == ["mimic-cycle"]


KEPT = '<gazebo reference="j"><preserveFixedJoint>true</preserveFixedJoint></gazebo>'


@pytest.mark.parametrize(
    ("text", "found"),
    [
        (BARE.format("a"), ["vanishing-root"]),
        (BARE.format("a") + links("b") + joint("j", "a", "b"), []),
        (BARE.format("a") + links("b") + joint("j", "a", "b", "continuous"), ["vanishing-root"]),
        (BARE.format("world") + links("b") + joint("j", "world", "b"), []),
        (BARE.format("world") + BARE.format("b") + joint("j", "world", "b"), ["vanishing-root"]),
        (links("a") + BARE.format("b") + joint("j", "a", "b", "continuous"), ["massless-moving-link"]),
        (links("a") + BARE.format("b") + joint("j", "a", "b"), []),
        (links("a") + BARE.format("b") + joint("j", "a", "b") + KEPT, ["massless-moving-link"]),
        (BARE.format("a") + links("b") + joint("j", "a", "b") + KEPT, ["vanishing-root"]),
    ],
)
def test_masses(text: str, found: list[str]) -> None:
    assert names(text) == found


def test_a_robot_without_any_mass_gets_one_hint() -> None:
    (found,) = reported(BARE.format("a") + BARE.format("b") + joint("j", "a", "b", "continuous"))
    assert (found.name, found.severity) == ("vanishing-root", sdfcheck.Severity.INFO)


def visual(material: str, geometry: str = SHAPE) -> str:
    return f'<link name="a">{MASS}<visual>{geometry}{material}</visual></link>'


@pytest.mark.parametrize(
    ("text", "found"),
    [
        (visual('<material name="m"/>'), ["undefined-material"]),
        (visual('<material name="m"/>') + '<material name="m"><color rgba="1 1 1 1"/></material>', []),
        (visual('<material name="m"><color/></material>'), []),
        ('<material name="m"/>' + visual('<material name="m"/>'), ["undefined-material"]),
        (
            '<material name="m"><colr rgba="1 1 1 1"/></material>' + visual('<material name="m"/>'),
            ["unknown-urdf-element"],
        ),
        ('<material><color rgba="1 1 1 1"/></material>' + visual('<material name="m"/>'), []),
        (visual('<material name="${m}"/>'), ["unexpanded-expression"]),
    ],
)
def test_materials(text: str, found: list[str]) -> None:
    assert names(text) == found


def test_a_material_defined_twice() -> None:
    red, pale = (f'<material name="m"><color rgba="{share} 0 0 1"/></material>' for share in ("1", "0.5"))
    assert names(red + visual(pale)) == ["undefined-material"]
    assert names(red + visual(red.replace('"1 0', '"1.0 0'))) == []


@pytest.mark.parametrize(
    ("geometry", "message"),
    [
        ("", "`visual` has no `geometry`"),
        ("<geometry/>", "the geometry of `visual` has no shape"),
        ("<geometry><mesh/></geometry>", "the mesh of `visual` has no `filename`"),
        ('<geometry><mesh filenam="a.stl"/></geometry>', ""),
        ("<geometri/>", ""),
        ("<geometry><cone/></geometry>", "`cone` is not a shape of URDF"),
        (SHAPE.replace("</", "<mesh/></"), "the mesh of `visual` has no `filename`"),
    ],
)
def test_shapes(geometry: str, message: str) -> None:
    found = [d.message for d in reported(visual("", geometry)) if d.name == "missing-geometry"]
    assert found == [message] * bool(message)


def test_names_and_what_they_clash_with() -> None:
    assert names(links("a b b") + joint("a", "a", "b")) == ["clashing-name", "duplicate-name"]


@pytest.mark.parametrize(
    ("pitch", "found"),
    [("1.57", 1), ("-1.57", 1), ("1.5707963", 0), ("1.5708", 0), ("1.56", 0), ("4.7124", 0), ("4.712", 1)],
)
def test_pitch(pitch: str, found: int) -> None:
    assert names(visual("", f'<origin rpy="0 {pitch} 0"/>{SHAPE}')) == ["singular-pitch"] * found
    # Poses of joints and masses are not converted that way.
    turned = joint("j", "a", "b", inside=f'<origin rpy="0 {pitch} 0"/>')
    assert names(links("a b") + turned) == []


def test_colons_in_comments() -> None:
    (found,) = reported(
        '<!-- a: b --><!-- c:d --><link name="x:"/><!-- e:-->' + links("a") + joint("j", "a", "x:")
    )
    assert found.span.begin.column == len('<robot name="r"><!-- a:')


LIBRARY = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro">{}</robot>'


@pytest.mark.parametrize(
    ("inside", "messages"),
    [
        ('<inertial><mass value="1"/></inertial>', ["the inertial of xacro:macro `m` has no `inertia`"]),
        ('<inertial><mass value="1"/><inetria ixx="${a}"/></inertial>', []),
        ('<inertial><mass value="1"/><xacro:insert_block name="inertia"/></inertial>', []),
        (
            '<inertial><mass value="1"/><xacro:insert_block name="origin"/></inertial>',
            ["the inertial of xacro:macro `m` has no `inertia`"],
        ),
        ('<inertial><mass value="1"/><xacro:moments r="1"/></inertial>', []),
        (
            '<link name="${a}"><xacro:if value="${a}"><visual/></xacro:if></link>',
            ["`visual` has no `geometry`"],
        ),
        ('<link name="${a}"><visual><geometry><xacro:shape/></geometry></visual></link>', []),
        (
            '<joint name="${a}" type="revolute"><parent link="b"/><child link="c"/><limit effort="1"/></joint>',
            ["has no `lower` and no `upper`", "has no `velocity`"],
        ),
    ],
)
def test_macros_that_nothing_calls(inside: str, messages: list[str], tmp_path: Path) -> None:
    path = tmp_path / "library.xacro"
    path.write_text(LIBRARY.format(f'<xacro:macro name="m" params="a">{inside}</xacro:macro>'))
    wanted = {"incomplete-inertia", "missing-geometry", "missing-limit"}
    found = [d.message for d in sdfcheck.lint([path], isolated=True).diagnostics if d.name in wanted]
    assert len(found) == len(messages)
    assert all(message in text for message, text in zip(messages, found, strict=True)), found


@pytest.mark.parametrize(("shape", "is_refused"), [("drake:ellipsoid", False), ("sphear", True)])
def test_drake_knows_its_own_shapes(shape: str, is_refused: bool) -> None:
    (found,) = reported(f'<link name="a">{MASS}<visual><geometry><{shape}/></geometry></visual></link>')
    assert dict(found.affects)["drake"].is_refusal is is_refused
