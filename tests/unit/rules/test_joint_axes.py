"""Axes and limits of joints: what the rules about them report, and what they leave to others."""

from __future__ import annotations

import pytest

import sdfcheck

AXIS = "<axis><xyz>0 0 1</xyz></axis>"


def reported(text: str) -> list[sdfcheck.Diagnostic]:
    """The reports of the rules about joints in a document."""
    return list(sdfcheck.lint(text, isolated=True, select=["JNT"]).diagnostics)


def codes(text: str) -> list[str]:
    return [diagnostic.code for diagnostic in reported(text)]


def in_sdf(axis: str, type: str = "revolute") -> str:
    """A model with one joint."""
    joint = f'<joint name="j" type="{type}"><parent>base</parent><child>l</child>{axis}</joint>'
    links = '<link name="base"/><link name="l"/>'
    return f'<sdf version="1.12"><model name="m">{links}{joint}</model></sdf>'


def in_urdf(inside: str, type: str = "continuous") -> str:
    """A robot with one joint."""
    joint = f'<joint name="j" type="{type}"><parent link="base"/><child link="l"/>{inside}</joint>'
    return f'<robot name="r"><link name="base"/><link name="l"/>{joint}</robot>'


@pytest.mark.parametrize(
    ("type", "given", "missing"),
    [
        ("revolute", "", ["axis"]),
        ("Prismatic", "", ["axis"]),
        ("universal", AXIS, ["axis2"]),
        ("universal", "", ["axis", "axis2"]),
        ("ball", "", []),
        ("fixed", "", []),
        ("no_such_type", "", []),
    ],
)
def test_missing_axes(type: str, given: str, missing: list[str]) -> None:
    found = reported(in_sdf(given, type))
    assert [diagnostic.code for diagnostic in found] == ["JNT004"] * bool(missing)
    assert [name for each in found for name in each.message.split("`")[3::2]] == missing


def test_urdf_has_an_axis_without_words() -> None:
    assert codes(in_urdf("")) == []


@pytest.mark.parametrize(
    ("xyz", "of_sdf", "of_urdf"),
    [
        ("0 0 0", "JNT006", "JNT006"),
        ("0 0 1e-7", "JNT006", "JNT013"),
        ("0 0 2", "JNT013", "JNT013"),
        ("0.577 0.577 0.577", None, None),
        ("0 0 nan", None, None),
        ("0 0 inf", None, None),
        ("0 0", None, None),
        ("a b c", None, None),
        ("", None, None),
    ],
)
def test_directions(xyz: str, of_sdf: str | None, of_urdf: str | None) -> None:
    assert codes(in_sdf(f"<axis><xyz>{xyz}</xyz></axis>")) == ([of_sdf] if of_sdf else [])
    assert codes(in_urdf(f'<axis xyz="{xyz}"/>')) == ([of_urdf] if of_urdf else [])


def test_directions_that_nobody_reads() -> None:
    axis = "<axis><xyz>0 0 1</xyz></axis><axis><xyz>0 0 2</xyz></axis>"
    assert codes(in_sdf(axis)) == []
    assert codes(in_urdf('<axis xyz="0 0 0"/>', "fixed")) == []
    assert codes(in_urdf('<axis xyz="0 0 0"/>', "floating")) == []


def test_the_direction_of_unit_length() -> None:
    (diagnostic,) = reported(in_sdf("<axis><xyz>-0 -3 4</xyz></axis>"))
    assert diagnostic.fix is not None
    assert diagnostic.fix.edits[0].text == "0 -0.6 0.8"


@pytest.mark.parametrize(
    ("limits", "type", "code"),
    [
        ("<lower>1</lower><upper>-1</upper>", "revolute", "JNT005"),
        ("<lower>1</lower><upper>-1</upper>", "continuous", "JNT005"),
        ("<lower>1</lower><upper>1</upper>", "revolute", "JNT023"),
        ("<lower>1</lower><upper>1</upper>", "continuous", "JNT011"),
        ("<lower>0</lower><upper>-0.0</upper>", "revolute", None),
        ("<lower>high</lower><upper>-1</upper>", "revolute", None),
        ("<lower>-1</lower><upper>1</upper>", "continuous", "JNT011"),
        ("<upper>1</upper>", "continuous", "JNT011"),
        ("<lower>-1e16</lower><upper>inf</upper>", "continuous", None),
        ("<effort>-1</effort><velocity>-inf</velocity>", "revolute", None),
        ("<effort>-2</effort>", "revolute", "JNT010"),
        ("<velocity>-0.5</velocity>", "revolute", "JNT010"),
    ],
)
def test_limits_in_sdf(limits: str, type: str, code: str | None) -> None:
    found = codes(in_sdf(f"<axis><xyz>0 0 1</xyz><limit>{limits}</limit></axis>", type))
    assert found == ([code] if code else [])


@pytest.mark.parametrize(
    ("limits", "type", "code"),
    [
        ('lower="1" upper="-1"', "revolute", "JNT005"),
        ('lower="1" upper="-1"', "fixed", None),
        ('lower="-1" upper="1"', "continuous", "JNT011"),
        ('lower="-1" upper="1"', "planar", "JNT011"),
        ('lower="-6.2832" upper="6.2832"', "continuous", None),
        ('lower="0" upper="0"', "continuous", None),
        ('lower="high" upper="0"', "continuous", None),
        ('effort="-5" velocity="1"', "continuous", "JNT010"),
        ('effort="-5" velocity="-1"', "fixed", None),
    ],
)
def test_limits_in_urdf(limits: str, type: str, code: str | None) -> None:
    assert codes(in_urdf(f"<limit {limits}/>", type)) == ([code] if code else [])


def test_limits_that_nobody_reads() -> None:
    first = '<limit lower="-1" upper="1" effort="5" velocity="2"/>'
    second = '<limit lower="1" upper="-1" effort="-5" velocity="2"/>'
    assert codes(in_urdf(first + second, "revolute")) == []
    block = f'<gazebo reference="j"><axis xyz="0 0 0">{second}</axis>{second}</gazebo>'
    assert codes(in_urdf(first, "revolute").replace("</robot>", f"{block}</robot>")) == []


def test_negative_dynamics() -> None:
    dynamics = "<dynamics><damping>-0.1</damping><friction>-1</friction></dynamics>"
    found = reported(in_sdf(f"<axis><xyz>0 0 1</xyz>{dynamics}</axis>"))
    assert [diagnostic.message.split()[0] for diagnostic in found] == ["damping", "friction"]
    assert codes(in_urdf('<dynamics damping="-1"/>')) == ["JNT010"]
