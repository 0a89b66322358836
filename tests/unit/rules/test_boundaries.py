"""Where conditions of rules end: the last value that is reported, the first that is not, and what is said."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

import sdfcheck
from sdfcheck.cli.main import main

SDF = '<sdf version="1.12"><model name="m"><link name="a"/><link name="b"/>{}</model></sdf>'
URDF = (
    '<robot name="r"><link name="a"/><link name="b"/><joint name="j" type="revolute"><parent link="a"/>'
    '<child link="b"/>{}</joint></robot>'
)


def messages(text: str, code: str, name: str = "a.sdf") -> list[str]:
    found = sdfcheck.lint(text, name=name, isolated=True, select=("ALL",)).diagnostics
    return [diagnostic.message for diagnostic in found if diagnostic.code == code]


@pytest.mark.parametrize(
    ("axes", "count"),
    [
        ("<axis><xyz>1 0 0</xyz></axis><axis2><xyz>0 1 0</xyz></axis2>", 0),
        ("<axis><xyz>1 0 0</xyz></axis>", 1),
        ("<axis><xyz>1 0 0</xyz></axis><axs2><xyz>0 1 0</xyz></axs2>", 0),
    ],
)
def test_a_misspelled_axis_is_not_missing(axes: str, count: int) -> None:
    joint = f'<joint name="j" type="universal"><parent>a</parent><child>b</child>{axes}</joint>'
    assert len(messages(SDF.format(joint), "JNT004")) == count


@pytest.mark.parametrize(("upper", "count"), [(29, 0), (30, 1), (720, 1), (721, 0)])
def test_limits_that_look_like_degrees(upper: int, count: int) -> None:
    limit = f"<limit><lower>0</lower><upper>{upper}</upper></limit>"
    axis = f"<axis><xyz>0 0 1</xyz>{limit}</axis>"
    joint = f'<joint name="j" type="revolute"><parent>a</parent><child>b</child>{axis}</joint>'
    assert len(messages(SDF.format(joint), "JNT014")) == count


@pytest.mark.parametrize("size", ["1e160 1e160 1e160", "1e200 1 1"])
def test_an_inertia_is_not_compared_with_that_of_an_endless_solid(size: str) -> None:
    solid = f'<collision name="c"><geometry><box><size>{size}</size></box></geometry></collision>'
    moments = "<inertia><ixx>2</ixx><iyy>2</iyy><izz>2</izz></inertia>"
    link = f'<link name="c"><inertial><mass>1</mass>{moments}</inertial>{solid}</link>'
    run = sdfcheck.lint(SDF.format(link), isolated=True, select=("INR",))
    assert [each.message for each in run.diagnostics if "link `c`" not in each.message] == []


@pytest.mark.parametrize(("outer", "count"), [(2 * math.pi, 0), (6.3, 1)])
def test_a_cone_is_no_wider_than_all(outer: float, count: int) -> None:
    spot = (
        f"<spot><inner_angle>0.1</inner_angle><outer_angle>{outer!r}</outer_angle><falloff>1</falloff></spot>"
    )
    light = f'<light name="s" type="spot"><direction>0 0 -1</direction>{spot}</light>'
    text = f'<sdf version="1.12"><world name="w">{light}</world></sdf>'
    assert len(messages(text, "SCH021")) == count


@pytest.mark.parametrize(
    ("limit", "count"),
    [
        ('<limit effort="1" velocity="1"/>', 1),
        ('<limit lower="-1" effort="1" velocity="1"/>', 0),
        ('<limit upper="1" effort="1" velocity="1"/>', 0),
    ],
)
def test_a_joint_with_one_limit_is_not_locked(limit: str, count: int) -> None:
    assert len(messages(URDF.format(f'<axis xyz="0 0 1"/>{limit}'), "URD005", "a.urdf")) == count


def test_the_old_namespace_is_taken_out_at_each_element(tmp_path: Path) -> None:
    old = 'xmlns:ignition="http://ignitionrobotics.org/schema"'
    new = 'xmlns:gz="http://gazebosim.org/schema"'
    text = (
        f'<sdf version="1.9" {old} {new}><model name="m" {old}><link name="a" ignition:b="1"/></model></sdf>'
    )
    file = tmp_path / "a.sdf"
    file.write_text(text)
    main(["lint", "--isolated", "--fix", "--unsafe-fixes", "--select", "GAZ", "--quiet", str(file)])
    assert "ignition" not in file.read_text()


def test_the_first_misspelling_of_a_plugin_is_named() -> None:
    hardware = "<hardware><plugn>a</plugn><plugi>b</plugi></hardware>"
    text = (
        '<robot name="r"><link name="a"/><ros2_control name="c" type="system">'
        f'{hardware}<joint name="j"/></ros2_control></robot>'
    )
    found = sdfcheck.lint(text, name="a.urdf", isolated=True, select=("ALL",)).diagnostics
    (place,) = (
        d.span.text for d in found if "did you mean `plugin`" in d.message and d.code.startswith("R2C")
    )
    assert place == "plugn"


def test_a_second_document_is_called_so() -> None:
    text = '<sdf version="1.9"/>\n<?xml version="1.0"?><sdf version="1.9"/>'
    found = [d.message for d in sdfcheck.lint(text, name="a.sdf", isolated=True).diagnostics]
    assert "a second document begins after the root element" in found


def test_names_in_a_configuration_are_suggested_where_they_may_be_meant(tmp_path: Path) -> None:
    (tmp_path / "model.sdf").write_text(SDF.format(""))
    config = tmp_path / "model.config"
    config.write_text('<model><name>m</name><version>1</version><sdf version="1.12">modl.sdf</sdf></model>')
    found = [diagnostic.message for diagnostic in sdfcheck.lint(config, isolated=True).diagnostics]
    assert any("did you mean `model.sdf`?" in message for message in found)
