"""Masses of links, models and whole files."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from sdfcheck.robot.motion.mass_report import MassOrigin, MassReport, mass_report
from sdfcheck.robot.root import root_of
from tests.unit.robot.files import document, opened, write

ROBOTS = Path(__file__).parents[3] / "fixtures" / "robots"
POINT = "<inertial><mass>{}</mass><inertia><ixx>0.1</ixx><iyy>0.1</iyy><izz>0.1</izz></inertia></inertial>"
BOX = "<collision name='c'><geometry><box><size>1 2 3</size></box></geometry>{}</collision>"


def measured(folder: Path, content: str, **files: str) -> MassReport:
    return mass_report(root_of(document(folder, f'<sdf version="1.12">{content}</sdf>', **files)).scopes)


def test_links_and_total_are_in_the_models_frame(tmp_path: Path) -> None:
    report = measured(
        tmp_path,
        f'<model name="m"><link name="a">{POINT.format(1)}</link>'
        f'<link name="b"><pose>2 0 0 0 0 1.5707963267948966</pose>{POINT.format(3)}</link></model>',
    )
    (model,) = report.models
    assert [link.name for link in model.links] == ["a", "b"]
    assert model.links[1].body is not None
    assert model.links[1].body.center == pytest.approx([2, 0, 0])
    assert model.total is not None
    assert model.total.mass == 4
    assert model.total.center == pytest.approx([1.5, 0, 0])
    # Two points 2 m apart turn about their center with the reduced mass.
    assert np.diag(model.total.moments) == pytest.approx([0.2, 0.2 + 3, 0.2 + 3])
    assert report.total is model.total or np.allclose(report.total.moments, model.total.moments)  # type: ignore[union-attr]
    assert report.is_complete


def test_nested_models_count_in_what_holds_them(tmp_path: Path) -> None:
    report = measured(
        tmp_path,
        f'<model name="out"><link name="a">{POINT.format(1)}</link>'
        f'<model name="in"><pose>0 0 4 0 0 0</pose><link name="b">{POINT.format(1)}</link></model></model>',
    )
    assert [model.name for model in report.walk()] == ["out", "out::in"]
    outer, inner = report.walk()
    assert outer.total is not None
    assert inner.total is not None
    assert outer.total.center == pytest.approx([0, 0, 2])
    assert inner.total.center == pytest.approx([0, 0, 0])


def test_a_link_without_inertial_has_what_simulators_take(tmp_path: Path) -> None:
    (model,) = measured(tmp_path, '<model name="m"><link name="a"/></model>').models
    (link,) = model.links
    assert link.origin is MassOrigin.DEFAULT
    assert link.body is not None
    assert link.body.mass == 1
    assert np.array_equal(link.body.moments, np.eye(3))


def test_automatic_inertia_is_computed(tmp_path: Path) -> None:
    link = f'<link name="a"><inertial auto="true"/>{BOX.format("<density>2</density>")}</link>'
    (model,) = measured(tmp_path, f'<model name="m">{link}</model>').models
    assert model.links[0].origin is MassOrigin.AUTOMATIC
    assert model.total is not None
    assert model.total.mass == pytest.approx(12)
    assert np.diag(model.total.moments) == pytest.approx([13, 10, 5])


def test_the_inertia_of_a_mesh(tmp_path: Path) -> None:
    trimesh = pytest.importorskip("trimesh")
    trimesh.creation.box((1, 1, 1)).export(tmp_path / "cube.stl")
    mesh = "<geometry><mesh><uri>cube.stl</uri><scale>1 2 3</scale></mesh></geometry>"
    collision = f'<collision name="c">{mesh}</collision>'
    link = f'<link name="a"><inertial auto="true"><density>2</density></inertial>{collision}'
    (model,) = measured(tmp_path, f'<model name="m">{link}</link></model>').models
    assert model.total is not None
    assert model.total.mass == pytest.approx(12)
    assert np.diag(model.total.moments) == pytest.approx([13, 10, 5])


def test_a_part_of_a_mesh_is_not_measured(tmp_path: Path) -> None:
    trimesh = pytest.importorskip("trimesh")
    trimesh.creation.box((1, 1, 1)).export(tmp_path / "cube.stl")
    mesh = "<mesh><uri>cube.stl</uri><submesh><name>lid</name></submesh></mesh>"
    collision = f'<collision name="c"><geometry>{mesh}</geometry></collision>'
    link = f'<link name="a"><inertial auto="true"/>{collision}</link>'
    (model,) = measured(tmp_path, f'<model name="m">{link}</model>').models
    assert "the mass of a submesh cannot be computed" in model.links[0].note


def test_a_folder_is_no_mesh(tmp_path: Path) -> None:
    pytest.importorskip("trimesh")
    (tmp_path / "cube.stl").mkdir()
    collision = '<collision name="c"><geometry><mesh><uri>cube.stl</uri></mesh></geometry></collision>'
    link = f'<link name="a"><inertial auto="true"/>{collision}</link>'
    (model,) = measured(tmp_path, f'<model name="m">{link}</model>').models
    assert "mesh `cube.stl` is a folder, not a file" in model.links[0].note


def test_a_value_that_cannot_be_computed_is_reported(tmp_path: Path) -> None:
    links = f'<link name="a"><inertial auto="true"/></link><link name="b">{POINT.format(2)}</link>'
    report = measured(tmp_path, f'<model name="m">{links}</model>')
    unknown = report.models[0].links[0]
    assert unknown.origin is MassOrigin.UNKNOWN
    assert unknown.body is None
    assert "no collision" in unknown.note
    assert not report.is_complete
    assert report.total is not None
    assert report.total.mass == 2


def test_the_total_leaves_static_models_out(tmp_path: Path) -> None:
    static = f'<model name="wall"><static>1</static><link name="a">{POINT.format(5)}</link></model>'
    moving = f'<model name="m"><pose>1 0 0 0 0 0</pose><link name="a">{POINT.format(2)}</link></model>'
    report = measured(tmp_path, f'<world name="w">{static}{moving}</world>')
    assert [model.is_static for model in report.models] == [True, False]
    assert report.total is not None
    assert report.total.mass == 2
    assert report.total.center == pytest.approx([1, 0, 0])


def test_includes_are_followed(tmp_path: Path) -> None:
    include = "<include><uri>arm.sdf</uri><name>left</name><pose>0 3 0 0 0 0</pose></include>"
    report = measured(tmp_path, f'<world name="w">{include}</world>')
    (model,) = report.models
    assert model.name == "left"
    assert report.total is not None
    assert report.total.mass == 2
    assert report.total.center == pytest.approx([0, 3, 0])


def test_an_include_that_is_missing_is_reported(tmp_path: Path) -> None:
    report = measured(tmp_path, '<world name="w"><include><uri>nowhere.sdf</uri></include></world>')
    assert report.total is None
    assert not report.is_complete


def test_a_urdf_link_without_inertial_has_no_mass(tmp_path: Path) -> None:
    urdf = (
        '<robot name="r"><link name="base"/><link name="arm"><inertial><origin xyz="1 0 0"/><mass value="2"/>'
        '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>'
        '<joint name="j" type="fixed"><parent link="base"/><child link="arm"/>'
        '<origin xyz="0 0 1"/></joint></robot>'
    )
    write(tmp_path, {"r.urdf": urdf})
    report = mass_report(root_of(opened(tmp_path / "r.urdf")).scopes)
    base, arm = report.models[0].links
    assert base.origin is MassOrigin.NONE
    assert arm.body is not None
    assert arm.body.center == pytest.approx([1, 0, 1])
    included = measured(tmp_path, '<world name="w"><include><uri>r.urdf</uri></include></world>')
    assert included.total is not None
    assert report.total is not None
    assert np.allclose(included.total.moments, report.total.moments)
