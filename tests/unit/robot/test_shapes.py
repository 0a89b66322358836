from __future__ import annotations

import math
from pathlib import Path

import pytest

import sdfcheck
from sdfcheck.robot.solids import Solid


def test_an_element_before_the_shape_in_sdf_is_not_the_shape() -> None:
    text = (
        '<sdf version="1.9" xmlns:x="urn:x"><model name="m"><link name="l">'
        '<visual name="a"><geometry><x:y/><box><size>1 2 3</size></box></geometry></visual>'
        '<visual name="b"><geometry><x:y/></geometry></visual>'
        '<visual name="c"><geometry/></visual></link></model></sdf>'
    )
    first, second, third = (each.geometry for each in sdfcheck.parse(text).models[0].link("l").visuals)
    assert (first.shape, first.size) == ("box", (1, 2, 3))
    assert second.shape == "x:y"
    assert third.shape == ""


def test_urdfdom_takes_the_first_element_for_the_shape() -> None:
    text = (
        '<robot name="r" xmlns:x="urn:x"><link name="l"><visual><geometry><x:y/><box size="1 2 3"/></geometry>'
        "</visual></link></robot>"
    )
    (visual,) = sdfcheck.parse(text).models[0].link("l").visuals
    assert visual.geometry.shape == "x:y"


def solid_of(shape: str) -> Solid | None:
    text = (
        '<sdf version="1.9"><model name="m"><link name="l"><visual name="v"><geometry>'
        f"{shape}</geometry></visual></link></model></sdf>"
    )
    (visual,) = sdfcheck.parse(text).models[0].link("l").visuals
    return visual.geometry.solid


def test_a_shape_without_volume_is_not_a_solid() -> None:
    assert solid_of("<box><size>0 1 1</size></box>") is None
    assert solid_of("<sphere><radius>-1</radius></sphere>") is None
    assert solid_of("<box><size>2 1 1</size></box>") is not None


@pytest.mark.parametrize(
    ("shape", "volume", "moments", "center"),
    [
        ("<cone><radius>2</radius><length>4</length></cone>", 16 / 3, (1.2, 1.2, 1.2), -1),
        ("<capsule><radius>1</radius><length>2</length></capsule>", 10 / 3, (1.21, 1.21, 0.46), 0),
        ("<cylinder><radius>1</radius><length>2</length></cylinder>", 2, (7 / 12, 7 / 12, 0.5), 0),
        ("<sphere><radius>3</radius></sphere>", 36, (3.6, 3.6, 3.6), 0),
        ("<ellipsoid><radii>1 2 3</radii></ellipsoid>", 8, (2.6, 2, 1), 0),
    ],
)
def test_the_moments_of_round_solids(
    shape: str, volume: float, moments: tuple[float, ...], center: float
) -> None:
    solid = solid_of(shape)
    assert solid is not None
    assert solid.volume == pytest.approx(volume * math.pi)
    assert solid.moments == pytest.approx((*moments, 0, 0, 0))
    assert solid.center == center


@pytest.mark.parametrize(
    ("shape", "half"),
    [
        ("<box><size>1 2 3</size></box>", (0.5, 1, 1.5)),
        ("<sphere><radius>2</radius></sphere>", (2, 2, 2)),
        ("<ellipsoid><radii>1 2 3</radii></ellipsoid>", (1, 2, 3)),
        ("<cylinder><radius>2</radius><length>3</length></cylinder>", (2, 2, 1.5)),
        ("<capsule><radius>2</radius><length>3</length></capsule>", (2, 2, 3.5)),
    ],
)
def test_the_bounds_of_a_link_are_those_of_its_shapes(shape: str, half: tuple[float, ...]) -> None:
    text = (
        '<sdf version="1.12"><model name="m"><link name="l"><visual name="v"><pose>1 2 3 0 0 0</pose><geometry>'
        f"{shape}</geometry></visual></link></model></sdf>"
    )
    bounds = sdfcheck.parse(text).models[0].link("l").bounds
    assert bounds is not None
    low, high = bounds.tolist()
    assert low == pytest.approx([at - size for at, size in zip((1, 2, 3), half, strict=True)])
    assert high == pytest.approx([at + size for at, size in zip((1, 2, 3), half, strict=True)])


def test_the_bounds_of_meshes_are_those_of_their_files(tmp_path: Path) -> None:
    (tmp_path / "a.obj").write_text("v 0 0 0\nv 1000 0 0\nv 0 2000 -500\nf 1 2 3\n")
    geometry = '<geometry><mesh filename="a.obj" scale="0.001 0.001 -0.001"/></geometry>'
    mesh = f'<visual><origin xyz="0 0 1"/>{geometry}</visual>'
    joint = '<joint name="j" type="fixed"><origin xyz="5 0 0"/><parent link="a"/><child link="b"/></joint>'
    file = tmp_path / "r.urdf"
    file.write_text(
        f'<robot name="r"><link name="a">{mesh}</link><link name="b">{mesh}</link>{joint}</robot>'
    )
    model = sdfcheck.load(file).models[0]
    bounds, whole = model.link("a").bounds, model.bounds
    assert bounds is not None
    assert bounds.tolist() == [[0, 0, 1], pytest.approx([1, 2, 1.5])]
    assert whole is not None
    assert whole.tolist() == [[0, 0, 1], pytest.approx([6, 2, 1.5])]


def test_a_submesh_and_a_mesh_that_is_not_there_have_no_bounds(tmp_path: Path) -> None:
    (tmp_path / "a.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 2 0\nf 1 2 3\n")
    file = tmp_path / "m.sdf"
    shapes = "".join(
        f'<visual name="v{number}"><geometry><mesh>{mesh}</mesh></geometry></visual>'
        for number, mesh in enumerate(
            (
                "<uri>a.obj</uri><submesh><name>s</name></submesh>",
                "<uri>b.obj</uri>",
                "<uri>http://x/a.obj</uri>",
            )
        )
    )
    file.write_text(f'<sdf version="1.12"><model name="m"><link name="l">{shapes}</link></model></sdf>')
    assert sdfcheck.load(file).models[0].link("l").bounds is None


def test_where_joints_and_links_are_at_rest() -> None:
    text = (
        '<robot name="r"><link name="a"><visual><geometry><box size="2 2 2"/></geometry></visual></link>'
        '<link name="b"/><link name="c"><visual><geometry><box size="1 4 1"/></geometry></visual></link>'
        '<joint name="j" type="revolute"><origin xyz="0 0 5" rpy="0 0 1.5707963267948966"/><parent link="a"/>'
        '<child link="b"/><axis xyz="2 0 0"/></joint>'
        '<joint name="k" type="prismatic"><origin xyz="7 0 0"/><parent link="b"/><child link="c"/>'
        '<axis xyz="0 1 0"/></joint></robot>'
    )
    model = sdfcheck.parse(text).models[0]
    first, second = model.joints
    assert first.direction == pytest.approx((0, 1, 0))
    assert second.at_rest is not None
    assert second.at_rest.position == pytest.approx((0, 7, 5))
    assert second.direction == pytest.approx((-1, 0, 0))
    assert second.at_rest.seen(second.at_rest.applied_to((1, 2, 3))) == pytest.approx((1, 2, 3))
    a, b, c = model.links
    assert a.distance_to(c) == c.distance_to(a) == pytest.approx(math.hypot(5.5, 3.5))
    assert a.distance_to(b) == 0


def test_a_joint_with_a_wrong_number_is_nowhere() -> None:
    text = (
        '<robot name="r"><link name="a"/><link name="b"/><joint name="j" type="continuous"><origin xyz="0 0 x"/>'
        '<parent link="a"/><child link="b"/></joint></robot>'
    )
    (joint,) = sdfcheck.parse(text).models[0].joints
    assert joint.at_rest is None
    assert joint.direction is None
