"""Questions to engines: the packages and models that a description names, by the ways in which they are found here."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.consumers.engines import Question
from sdfcheck.consumers.engines.pybullet import with_packages
from sdfcheck.consumers.engines.staging import Stage, packages_in
from sdfcheck.files.library import Library, SearchPaths
from sdfcheck.source.document import read
from sdfcheck.source.sniff import Kind

WORLD = '<sdf version="1.9"><world name="w"><include><uri>model://cart</uri></include></world></sdf>'
CART = '<sdf version="1.9"><model name="cart"><include><uri>model://wheel</uri></include></model></sdf>'
WHEEL = '<sdf version="1.9"><model name="wheel"><link name="l"/></model></sdf>'


def asked(path: Path, kind: Kind) -> Question:
    document = Library().document(path, kind)
    assert document is not None
    with Stage() as stage:
        return stage.question(document)


def test_models_beside_the_world_and_those_that_they_include(tmp_path: Path) -> None:
    world = tmp_path / "worlds" / "w.sdf"
    for file, text in {
        world: WORLD,
        tmp_path / "models" / "cart" / "model.sdf": CART,
        tmp_path / "models" / "wheel" / "model.sdf": WHEEL,
    }.items():
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
    question = asked(world, Kind.SDF)
    assert question.path == world
    assert dict(question.packages) == {name: str(tmp_path / "models" / name) for name in ("cart", "wheel")}
    assert question.model_paths == (str(tmp_path / "models"),)


def test_a_package_of_ros(tmp_path: Path) -> None:
    (tmp_path / "package.xml").write_text("<package><name>arm</name></package>")
    robot = tmp_path / "urdf" / "arm.urdf"
    robot.parent.mkdir()
    robot.write_text(
        '<robot name="r"><link name="l"><visual><geometry><mesh filename="package://arm/m.stl"/></geometry></visual>'
        "</link></robot>"
    )
    question = asked(robot, Kind.URDF)
    assert dict(question.packages) == {"arm": str(tmp_path)}


def test_a_file_of_any_line_ends_is_read_in_its_place(tmp_path: Path) -> None:
    robot = tmp_path / "arm.urdf"
    robot.write_bytes(b'<robot name="r">\r\n<link name="l"/>\r\n</robot>\r\n')
    question = asked(robot, Kind.URDF)
    assert (question.path, question.is_copy) == (robot, False)


def test_pybullet_finds_the_packages_of_a_copy(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    robot = tmp_path / "arm.urdf"
    robot.write_text('<mesh filename="package://arm/m.stl"/>')
    question = {"path": str(robot), "packages": [("arm", str(tmp_path / "arm"))]}
    assert with_packages(question) == str(robot)
    question["packages"] = [("arm", "/robots/arm")]
    other = Path(with_packages(question))
    assert other.read_text() == '<mesh filename="/robots/arm/m.stl"/>', "it is not above the file"
    other = Path(with_packages({**question, "packages": [("arm", "/robots/a")]}))
    assert other.read_text() == '<mesh filename="/robots/a/m.stl"/>', "PyBullet goes by the names of folders"
    robot.write_text('<mesh filename="package://arm/m.stl"/><mesh filename="b.stl"/>')
    other = Path(with_packages({**question, "packages": [("arm", "/robots/a")]}))
    assert f'<mesh filename="{tmp_path}/b.stl"/>' in other.read_text(), "from the file, not from the copy"
    robot.write_text('<mesh filename="package://arm/m.stl"/>')
    copy = with_packages({**question, "is_copy": True})
    assert Path(copy).read_text() == '<mesh filename="/robots/arm/m.stl"/>'
    assert robot.read_text() == '<mesh filename="package://arm/m.stl"/>'


def test_a_name_of_a_model_may_have_spaces(tmp_path: Path) -> None:
    folder = tmp_path / "Pine Tree"
    (folder / "meshes").mkdir(parents=True)
    (folder / "model.config").write_text("<model><sdf>model.sdf</sdf></model>")
    (folder / "meshes/tree.dae").write_text("")
    document = read(
        b'<sdf version="1.9"><!-- model://Pine Tree/meshes/tree.dae --></sdf>', folder / "model.sdf"
    )
    document.library = Library(SearchPaths(models=(tmp_path,)))
    assert packages_in(document.source.text, document) == {"Pine Tree": str(folder)}


def test_engines_get_the_copy_of_a_model_that_has_what_is_asked_for(tmp_path: Path) -> None:
    for folder in ("a/box", "b/box"):
        (tmp_path / folder / "meshes").mkdir(parents=True)
        (tmp_path / folder / "model.config").write_text("<model><sdf>model.sdf</sdf></model>")
    (tmp_path / "b/box/meshes/box.obj").write_text("")
    file = tmp_path / "a/box/model.sdf"
    file.write_text(
        '<sdf version="1.9"><model name="box"><link name="l"><visual name="v"><geometry><mesh>'
        "<uri>model://box/meshes/box.obj</uri></mesh></geometry></visual></link></model></sdf>"
    )
    paths = SearchPaths(models=(tmp_path / "a", tmp_path / "b"))
    document = read(file.read_bytes(), file)
    document.library = Library(paths)
    assert packages_in(document.source.text, document) == {"box": str(tmp_path / "b/box")}
