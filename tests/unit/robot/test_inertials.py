"""The masses and moments in the graph that are not written in the text."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

import sdfcheck
from sdfcheck.lint.expanded import parts_in_macros
from sdfcheck.robot.graph import Inertial
from sdfcheck.robot.root import root_of
from sdfcheck.robot.solids import Moments
from sdfcheck.source.document import read
from sdfcheck.source.sniff import Kind

MOMENTS = "<ixx>{}</ixx><iyy>2</iyy><izz>3</izz>"
BOX = "<collision name='{}'>{}<geometry><box><size>1 1 1</size></box></geometry></collision>"
URDF = '<robot name="r"><link name="l"><inertial><mass value="1"/><inertia {}/></inertial></link></robot>'


def inertial(inside: str, around: str = "") -> Inertial:
    text = f'<sdf version="1.12"><model name="m">{around}<link name="l">{inside}</link></model></sdf>'
    return root_of(read(text.encode(), Path("example.sdf"))).models[0].links[0].inertial


@pytest.mark.parametrize(
    ("inertia", "legible"),
    [
        (f"<inertia>{MOMENTS.format(1)}</inertia>", True),
        ("<inertia><ixx>1</ixx></inertia>", True),
        ("", True),
        (f"<inertia>{MOMENTS.format('one')}</inertia>", False),
        (f"<inertia>{MOMENTS.format('')}</inertia>", False),
        (f"<inertia>{MOMENTS.format('inf')}</inertia>", False),
        ("<inertia><Ixx>1</Ixx></inertia>", False),
        ('<inertia ixx="1"/>', False),
        ("<inretia/>", False),
    ],
)
def test_legible_moments(inertia: str, legible: bool) -> None:
    assert inertial(f"<inertial><mass>1</mass>{inertia}</inertial>").is_legible is legible


@pytest.mark.parametrize(
    ("given", "legible"),
    [
        ('ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"', True),
        ('ixx="1" iyy="1" izz="1"', False),
        ('ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="${i}"', False),
    ],
)
def test_urdf_leaves_no_moment_out(given: str, legible: bool) -> None:
    root = root_of(read(URDF.format(given).encode(), Path("r.urdf")))
    assert root.models[0].links[0].inertial.is_legible is legible


def test_principal_moments() -> None:
    moments = "<inertia><ixx>2</ixx><iyy>2</iyy><izz>3</izz><ixy>1</ixy></inertia>"
    assert inertial(f"<inertial>{moments}</inertial>").principal == pytest.approx((1, 3, 3))


def test_principal_moments_are_exact_where_two_are_alike() -> None:
    # A thin rod along (1, 1, 0), whose least moment is 1e-12 of the others.
    half = (1 - 1e-12) / 2
    rod = Moments(1 - half, 1 - half, 1.0, -half, 0.0, 0.0)
    assert rod.principal() == pytest.approx((1e-12, 1, 1), abs=1e-15)
    assert not rod.is_indefinite


@pytest.mark.parametrize(
    ("inside", "trace"),
    [
        (BOX.format("a", ""), 0.5),
        (BOX.format("a", "<pose>2 0 0 0 0 0</pose>"), 0.5 + 2 * 4),
        (BOX.format("a", "") + BOX.format("b", "<pose>2 0 0 0 0 0</pose>"), 0.5 + 4),
        (BOX.format("a", "") + BOX.format("b", "<pose relative_to='f'/>"), 0.5),
        (BOX.format("a", "").replace("collision", "visual"), 0.5),
        ("<collision name='c'><geometry><mesh/></geometry></collision>", None),
        ("", None),
    ],
)
def test_the_trace_of_the_solids_of_a_link(inside: str, trace: float | None) -> None:
    found = inertial(f"<inertial><mass>1</mass></inertial>{inside}").solid_trace
    assert math.isnan(found) if trace is None else found == pytest.approx(trace)


@pytest.mark.parametrize(("static", "may_be"), [("true", True), ("ture", True), ("0", False), ("", True)])
def test_parts_that_may_be_static(static: str, may_be: bool) -> None:
    assert inertial("<inertial/>", f"<static>{static}</static>").link.may_be_static is may_be


@pytest.mark.parametrize(("static", "is_static"), [("true", True), ("1", True), ("false", False)])
def test_a_block_makes_a_robot_static(static: str, is_static: bool) -> None:
    text = f'<robot name="r"><link name="a"/><gazebo><static>{static}</static></gazebo></robot>'
    assert sdfcheck.parse(text).models[0].is_static is is_static


def test_inertials_of_macros_have_no_solids_yet() -> None:
    text = (
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:macro name="part">'
        '<link name="a"><inertial><mass value="1"/></inertial><collision><geometry><box size="1 1 1"/>'
        '</geometry></collision></link><link name="b"/></xacro:macro></robot>'
    )
    document = read(text.encode(), Path("r.xacro"), Kind.XACRO)
    assert document.root is not None
    (macro,) = document.root.children()
    inertials = [element for link in macro.children("link") for element in link.children("inertial")]
    (found,) = parts_in_macros(document, inertials)
    assert isinstance(found, Inertial)
    assert found.link.name == "a"
    assert found.link.solids == ()
    assert math.isnan(found.solid_trace)


@pytest.mark.parametrize("declared", [' xmlns:xacro="http://www.ros.org/wiki/xacro"', ""])
def test_a_macro_counts_as_the_link_whose_parts_it_writes(declared: str) -> None:
    inside = '<inertial><mass value="1"/></inertial>'
    text = f'<robot name="r"{declared}><xacro:macro name="part">{inside}</xacro:macro></robot>'
    document = read(text.encode(), Path("r.xacro"), Kind.XACRO)
    assert document.root is not None
    (macro,) = document.root.children()
    (found,) = parts_in_macros(document, macro.children("inertial"))
    assert isinstance(found, Inertial)
    assert found.mass.number == 1


def test_models_in_extensions_are_looked_at() -> None:
    inner = '<model name="m"><link name="l"><inertial><mass>-3</mass></inertial></link></model>'
    run = sdfcheck.lint(f'<robot name="r"><link name="a"/><gazebo>{inner}</gazebo></robot>', isolated=True)
    assert [each.span.text for each in run.diagnostics if each.code == "INR001"] == ["-3"]


@pytest.mark.parametrize(
    ("mass", "codes"), [("x", ["SCH011"]), ("1", ["INR002"]), ("", ["SCH011", "INR002"])]
)
def test_moments_beside_a_mass(mass: str, codes: list[str]) -> None:
    text = (
        f'<sdf version="1.12"><model name="m"><link name="l"><inertial><mass>{mass}</mass>'
        f"<inertia>{MOMENTS.format(-1)}</inertia></inertial></link></model></sdf>"
    )
    run = sdfcheck.lint(text, isolated=True, name="model.sdf")
    assert [each.code for each in run.diagnostics] == codes


def test_moments_in_a_macro_are_looked_at_whatever_the_mass() -> None:
    text = (
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:macro name="part" params="m">'
        '<link name="a"><inertial><mass value="${m}"/><inertia ixx="-1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>'
        "</inertial></link></xacro:macro></robot>"
    )
    run = sdfcheck.lint(text, isolated=True, name="r.xacro")
    assert [each.span.text for each in run.diagnostics if each.code == "INR002"] == ["-1"]
