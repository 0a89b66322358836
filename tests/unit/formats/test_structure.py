"""Parts of composite elements that are used together."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from sdfcheck.formats import problems
from sdfcheck.formats.sdf.structure import SHAPES, structure_problems
from sdfcheck.source.document import read
from tests.unit.only import only

BOX, SPHERE = "<box><size>1 1 1</size></box>", "<sphere><radius>1</radius></sphere>"


def found(text: str, version: str = "1.12") -> list[Any]:
    return structure_problems(read(f'<sdf version="{version}">{text}</sdf>'.encode(), Path("example.sdf")))


def in_link(text: str, version: str = "1.12") -> list[Any]:
    return found(f'<model name="m"><link name="l">{text}</link></model>', version)


# The root


@pytest.mark.parametrize("version", ["1.5", "1.12"])
def test_a_file_holds_one_entity(version: str) -> None:
    problem = only(found('<model name="a"/><actor name="b"/>', version), problems.RepeatedElement)
    assert (problem.element.name, problem.first.name, problem.refused) == ("actor", "model", True)


def test_worlds_do_not_count() -> None:
    assert found('<world name="a"/><model name="m"/><world name="b"/>') == []


# Shapes


def test_the_shape_that_comes_first_in_the_librarys_order_is_taken() -> None:
    text = f'<visual name="v"><geometry>{SPHERE}{BOX}</geometry></visual>'
    problem = only(in_link(text), problems.SeveralShapes)
    assert (problem.element.name, problem.first.name) == ("sphere", "box")


@pytest.mark.parametrize("shape", SHAPES)
def test_every_shape_is_one(shape: str) -> None:
    assert in_link(f'<collision name="v"><geometry><!-- here --><{shape}/></geometry></collision>') == []


def test_a_visible_plane_without_a_size_ends_somewhere() -> None:
    problem = only(
        in_link('<visual name="v"><geometry><plane/></geometry></visual>'), problems.MissingElement
    )
    assert (problem.element.name, problem.child, problem.default) == ("plane", "size", "1 1")


@pytest.mark.parametrize("child", ["<p:torus/>", "<torus/>"])
def test_an_unknown_shape_is_anothers_problem(child: str) -> None:
    assert in_link(f'<visual name="v"><geometry>{child}</geometry></visual>') == []


def test_references_are_no_shapes() -> None:
    contact = '<sensor name="s" type="contact"><contact><collision>c</collision></contact></sensor>'
    sonar = '<sensor name="t" type="sonar"><sonar><geometry>cone</geometry></sonar></sensor>'
    assert in_link(contact + sonar) == []


# Lights


@pytest.mark.parametrize("version", ["1.4", "1.5"])
def test_lights_of_old_files_need_a_name_too(version: str) -> None:
    problem = only(in_link('<light type="point"/>', version), problems.MissingAttribute)
    assert (problem.attribute, problem.empty) == ("name", False)
    assert in_link('<light name="l" type="point"/>', version) == []


def test_the_walk_reports_violations_of_the_table() -> None:
    assert in_link('<light type="point"/>', "1.6") == []


def test_states_are_not_what_they_are_of() -> None:
    link = '<model name="m"><link name="l"><collision name="c"/></link></model>'
    assert found(f'<world name="w"><state world_name="w">{link}</state></world>', "1.9") == []


# Inertia


def test_moments_without_mass() -> None:
    inertia = "<inertial{}><inertia><ixx>1</ixx></inertia></inertial>"
    problem = only(in_link(inertia.format("")), problems.MissingElement)
    assert (problem.child, problem.default, problem.refused) == ("mass", "1", False)
    assert in_link("<inertial><pose/></inertial>") == []


def test_in_a_static_model_the_mass_does_not_matter() -> None:
    text = (
        '<model name="m"><static>true</static><link name="l"><inertial><inertia/></inertial></link></model>'
    )
    assert found(text) == []


# Sensors


@pytest.mark.parametrize(
    ("kind", "content"),
    [
        ("imu", ""),
        ("multicamera", '<camera name="a"/><camera name="b"/>'),
        ("custom", "<camera/>"),
        ("odd", "<imu/>"),
    ],
)
def test_settings_that_are_fine(kind: str, content: str) -> None:
    assert in_link(f'<sensor name="s" type="{kind}">{content}</sensor>') == []


@pytest.mark.parametrize(
    ("kind", "settings", "since", "successor"),
    [
        ("ray", "ray", "1.6", "lidar"),
        ("gpu_ray", "ray", "1.6", "gpu_lidar"),
        ("gps", "gps", "1.7", "navsat"),
    ],
)
def test_types_with_a_newer_name(kind: str, settings: str, since: str, successor: str) -> None:
    sensor = f'<sensor name="s" type="{kind}"><{settings}/></sensor>'
    problem = only(in_link(sensor), problems.DeprecatedElement)
    assert (problem.value.text, problem.successor, problem.since) == (kind, successor, since)
    assert problem.announced
    assert problem.settings.name == settings
    assert in_link(sensor, "1.5") == []


def test_settings_with_a_newer_name() -> None:
    problem = only(in_link('<sensor name="s" type="lidar"><ray/></sensor>'), problems.DeprecatedElement)
    assert (problem.element.name, problem.value, problem.successor) == ("ray", None, "lidar")


# The rest


def test_normal_maps() -> None:
    shader = '<visual name="v"><geometry><empty/></geometry><material><shader type="{}"/></material></visual>'
    problem = only(in_link(shader.format("normal_map_tangentspace")), problems.MissingElement)
    assert (problem.child, problem.refused) == ("normal_map", True)
    assert in_link(shader.format("pixel")) == []


def test_custom_surfaces_need_their_axes() -> None:
    text = "<spherical_coordinates><surface_model>{}</surface_model>{}</spherical_coordinates>"
    axis = "<surface_axis_polar>1</surface_axis_polar>"
    world = '<world name="w">{}</world>'
    problem = only(found(world.format(text.format("CUSTOM_SURFACE", axis))), problems.MissingElement)
    assert (problem.child, problem.refused) == ("surface_axis_equatorial", True)
    assert found(world.format(text.format("EARTH_WGS84", ""))) == []


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("<camera><clip><near>2</near><far>1</far></clip></camera>", "near 2 is above far 1"),
        ("<camera><clip><near>1</near><far>1</far></clip></camera>", None),
        ("<camera><clip><near>1</near><far>far</far></clip></camera>", None),
        ("<camera><clip><near>1</near><far>inf</far></clip></camera>", None),
    ],
)
def test_ends_in_order(text: str, said: str | None) -> None:
    problems_found = in_link(f'<sensor name="s" type="camera">{text}</sensor>')
    assert [p.text for p in problems_found] == ([said] if said else [])


@pytest.mark.parametrize("holder", ["<ode><solver>{}</solver></ode>", "<simbody>{}</simbody>"])
def test_steps_in_order(holder: str) -> None:
    step = holder.format("<min_step_size>0.1</min_step_size>")
    text = f'<world name="w"><physics type="ode"><max_step_size>0.001</max_step_size>{step}</physics></world>'
    problem = only(found(text), problems.ReversedRange)
    assert problem.lower.text == "0.1"
    assert problem.upper.text == "0.001"
