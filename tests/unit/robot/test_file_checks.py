"""Files and things that descriptions name."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.robot.root import root_of
from tests.unit.robot.files import MODEL, codes, document, opened, reported, write

MESH = "<geometry><mesh><uri>{}</uri></mesh></geometry>"
LINK = MODEL.format('<link name="l">{}</link>')
VISUAL = LINK.format('<visual name="v">{}</visual>')
FILES = {
    "meshes/arm.dae": "",
    "materials/textures/wood.png": "",
    "other/model.config": "",
    "models/hand.dae": "",
}


def kinds(folder: Path, text: str) -> list[str]:
    write(folder, FILES)
    return codes(document(folder, text))


@pytest.mark.parametrize(
    ("uri", "expected"),
    [
        ("meshes/arm.dae", []),
        ("file://meshes/arm.dae", []),
        ("file://hand.dae", []),
        ("file://Hand.dae", ["RES005"]),
        ("https://example.org/arm.dae", []),
        ("__default__", []),
        ("meshes/leg.dae", ["RES001"]),
        ("model://other/leg.dae", ["RES001"]),
        ("model://other/meshes/leg.dae", ["RES001"]),
        ("model://nowhere/leg.dae", ["RES001"]),
        ("package://nowhere/leg.dae", ["RES001"]),
        ("Meshes/arm.dae", ["RES005"]),
        ("/nowhere/arm.dae", ["RES006"]),
    ],
)
def test_meshes(tmp_path: Path, uri: str, expected: list[str]) -> None:
    assert kinds(tmp_path, VISUAL.format(MESH.format(uri))) == expected


@pytest.mark.parametrize(("uri", "expected"), [("wood.png", []), ("old/wood.png", ["RES001"])])
def test_pictures_beside_the_model_are_found_by_their_bare_names(
    tmp_path: Path, uri: str, expected: list[str]
) -> None:
    write(tmp_path, {"materials/textures/old/wood.png": ""})
    material = f"<material><pbr><metal><albedo_map>{uri}</albedo_map></metal></pbr></material>"
    assert kinds(tmp_path, VISUAL.format(material)) == expected


@pytest.mark.parametrize(
    "text",
    [
        VISUAL.format("<material><pbr><metal><albedo_map>no.png</albedo_map></metal></pbr></material>"),
        VISUAL.format("<material><pbr><specular><normal_map>no.png</normal_map></specular></pbr></material>"),
        VISUAL.format("<geometry><heightmap><uri>no.png</uri></heightmap></geometry>"),
        VISUAL.format(
            "<geometry><heightmap><texture><diffuse>no.png</diffuse></texture></heightmap></geometry>"
        ),
        VISUAL.format("<material><script><uri>no.material</uri><name>x</name></script></material>"),
        LINK.format("<audio_source><uri>no.mp3</uri></audio_source>"),
        LINK.format('<projector name="p"><texture>no.png</texture></projector>'),
        '<sdf version="1.12"><actor name="a"><skin><filename>no.dae</filename></skin></actor></sdf>',
    ],
)
def test_other_files(tmp_path: Path, text: str) -> None:
    assert kinds(tmp_path, text) == ["RES001"]


@pytest.mark.parametrize(
    "text",
    [
        VISUAL.format("<material><pbr><metal><albedo_map>wood.png</albedo_map></metal></pbr></material>"),
        VISUAL.format("<material><diffuse>1 0 0 1</diffuse></material>"),
        VISUAL.format("<geometry><plane><normal>0 0 1</normal></plane></geometry>"),
        VISUAL.format(
            "<material><script><uri>file://media/materials/scripts/gazebo.material</uri>"
            "<name>Gazebo/Red</name></script></material>"
        ),
    ],
)
def test_no_files_or_found_ones(tmp_path: Path, text: str) -> None:
    assert kinds(tmp_path, text) == []


def test_an_absent_whole_is_reported_once(tmp_path: Path) -> None:
    shapes = "".join(
        f'<visual name="{n}">{MESH.format(uri)}</visual>'
        for n, uri in enumerate(["gone/a.dae", "gone/b.dae", "model://lost/a.dae", "model://lost/b.dae"])
    )
    found = [diagnostic.message for diagnostic in reported(document(tmp_path, LINK.format(shapes)))]
    assert found == [
        "there is no folder `gone`, needed for 2 files",
        "model `lost` is not on the search path, needed for 2 files",
    ]


def test_urdf(tmp_path: Path) -> None:
    meshes = [
        "package://lost/a.stl",
        "meshes/arm.dae",
        "model://other/a.stl",
        "$(find x)/a.stl",
        "file://b.stl",
    ]
    visuals = "".join(f'<visual><geometry><mesh filename="{m}"/></geometry></visual>' for m in meshes)
    write(tmp_path, {**FILES, "r.urdf": f'<robot name="r"><link name="l">{visuals}</link></robot>'})
    found = [(diagnostic.code, diagnostic.message) for diagnostic in reported(opened(tmp_path / "r.urdf"))]
    assert found == [
        ("RES001", "package `lost` is not on the search path"),
        ("RES013", "a relative path is not resolved by ROS programs"),
        ("RES001", "mesh `model://other/a.stl` does not exist"),
        ("RES013", "`model://` is not resolved by ROS programs"),
        ("RES001", "mesh `file://b.stl` does not exist"),
    ]


def test_a_robot_names_the_folder_of_its_meshes_for_mujoco(tmp_path: Path) -> None:
    setting = '<mujoco><compiler meshdir="meshes"/></mujoco>'
    visual = '<visual><geometry><mesh filename="{}"/></geometry></visual>'
    visuals = visual.format("arm.dae") + visual.format("leg.dae")
    write(tmp_path, {**FILES, "r.urdf": f'<robot name="r">{setting}<link name="l">{visuals}</link></robot>'})
    found = [each.message for each in reported(opened(tmp_path / "r.urdf")) if each.code == "RES001"]
    assert found == ["mesh `leg.dae` does not exist"]


def test_resources_know_what_they_are_and_where_they_lead(tmp_path: Path) -> None:
    write(tmp_path, FILES)
    material = "<material><pbr><metal><albedo_map>no.png</albedo_map></metal></pbr></material>"
    root = root_of(document(tmp_path, VISUAL.format(MESH.format("meshes/arm.dae") + material)))
    mesh, texture = root.resources
    assert (mesh.what, mesh.uri, mesh.is_missing) == ("mesh", "meshes/arm.dae", False)
    assert (texture.what, texture.uri, texture.is_missing) == ("texture", "no.png", True)
    assert mesh.location is not None
    assert mesh.location.path == tmp_path / "meshes/arm.dae"


def test_without_a_library_only_the_spelling_counts(tmp_path: Path) -> None:
    found = document(tmp_path, VISUAL.format(MESH.format("gone.dae")))
    found.library = None
    assert codes(found) == []


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ('<sensor name="s" type="contact"><contact><collision>c</collision></contact></sensor>', None),
        ('<sensor name="s" type="contact"><contact><collision>d</collision></contact></sensor>', "d"),
        ("<audio_source><contact><collision>d</collision></contact></audio_source>", "d"),
    ],
)
def test_collisions(tmp_path: Path, text: str, name: str | None) -> None:
    found = reported(document(tmp_path, LINK.format('<collision name="c"/>' + text)))
    assert [d.message for d in found] == ([] if name is None else [f"link `l` has no collision `{name}`"])


def test_gripper_links_may_be_included(tmp_path: Path) -> None:
    text = (
        "<include><uri>arm.sdf</uri></include>"
        '<gripper name="g"><gripper_link>arm::tip</gripper_link><palm_link>arm::grip</palm_link></gripper>'
    )
    found = reported(document(tmp_path, MODEL.format(text)))
    assert [d.span.text for d in found] == ["arm::grip"], "a frame is not a link"


def test_a_name_with_an_empty_part_is_reported_once(tmp_path: Path) -> None:
    text = '<link name="l"/><gripper name="g"><gripper_link>arm::</gripper_link></gripper>'
    assert reported(document(tmp_path, MODEL.format(text))) == []
