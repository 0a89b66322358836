"""From URIs to files."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

import sdfcheck
from sdfcheck.files.uris import locate
from sdfcheck.robot.includes.uri_spelling import UriFault, is_absolute, misspelling, other_case
from sdfcheck.source.document import Value, read
from tests.unit.robot.files import ARM, CONFIG, MODEL, opened, write


def value(text: str) -> Value:
    root = read(f'<robot name="{text}"/>'.encode(), Path("a.urdf")).root
    assert root is not None
    return Value(root, "name", text)


@pytest.mark.parametrize(
    ("uri", "found"),
    [
        ("near.dae", "worlds/near.dae"),
        ("../arm/mesh.dae", "arm/mesh.dae"),
        ("file://near.dae", "worlds/near.dae"),
        ("file://skin.dae", "Media/models/skin.dae"),
        ("model://arm", "arm"),
        ("model://arm/mesh.dae", "arm/mesh.dae"),
        ("model://lamp/lamp.sdf", "models/lamp/lamp.sdf"),
        ("lamp", "models/lamp"),
        ("file://lamp", "models/lamp"),
        ("file://lamp/lamp.sdf", "models/lamp/lamp.sdf"),
        ("package://arm/mesh.dae", "arm/mesh.dae"),
        ("package://worlds/near.dae", "worlds/near.dae"),
        ("model://faraway/far.sdf", "elsewhere/faraway/far.sdf"),
    ],
)
def test_found(tmp_path: Path, uri: str, found: str) -> None:
    home = tmp_path / "home"
    write(
        tmp_path,
        {
            "home/worlds/main.sdf": MODEL,
            "home/worlds/near.dae": "",
            "home/arm/mesh.dae": "",
            "home/Media/models/skin.dae": "",
            "home/models/lamp/lamp.sdf": "",
            "home/elsewhere/faraway/far.sdf": "",
        },
    )
    location = locate(opened(home / "worlds/main.sdf", home / "elsewhere"), uri)
    assert location.path is not None
    assert os.path.samefile(location.path, home / found)


def test_a_mesh_that_a_build_installs_elsewhere(tmp_path: Path) -> None:
    lists = "project(arm)\ninstall(DIRECTORY parts/meshes ../meshes DESTINATION share/${PROJECT_NAME})\n"
    package = {"package.xml": "<package><name>arm</name></package>", "CMakeLists.txt": lists}
    write(
        tmp_path,
        {f"arm/{name}": text for name, text in package.items()}
        | {"arm/urdf/arm.sdf": MODEL, "arm/parts/meshes/a.dae": "", "meshes/outside.dae": ""},
    )
    document = opened(tmp_path / "arm/urdf/arm.sdf", tmp_path)
    found = locate(document, "package://arm/meshes/a.dae").path
    assert found is not None
    assert os.path.samefile(found, tmp_path / "arm/parts/meshes/a.dae")
    assert locate(document, "package://arm/meshes/outside.dae").path is None


def test_a_model_of_a_package_is_not_in_a_folder_of_that_name(tmp_path: Path) -> None:
    write(
        tmp_path,
        {
            "package.xml": "<package><name>arm</name></package>",
            "arm/module.py": "",
            "meshes/a.dae": "",
            "models/a/a.sdf": MODEL,
        },
    )
    found = locate(opened(tmp_path / "models/a/a.sdf", tmp_path), "model://arm/meshes/a.dae").path
    assert found is not None
    assert os.path.samefile(found, tmp_path / "meshes/a.dae")


@pytest.mark.parametrize("uri", ["../arm/mesh.dae", "./mesh.dae", "file://../arm/mesh.dae"])
def test_a_path_that_climbs_is_relative_to_its_file_alone(tmp_path: Path, uri: str) -> None:
    write(tmp_path, {"worlds/deep/main.sdf": MODEL, "worlds/mesh.dae": "", "arm/mesh.dae": ""})
    assert locate(opened(tmp_path / "worlds/deep/main.sdf"), uri).path is None


def test_a_model_of_another_package_of_the_project_is_found_the_nearest_first(tmp_path: Path) -> None:
    for workspace in ("a", "b"):
        write(tmp_path / workspace / "src/robots/models/arm", {"model.config": CONFIG, "arm.sdf": ARM})
        write(tmp_path / workspace / "src/worlds/models", {"main.sdf": MODEL})
    write(tmp_path, {".git/HEAD": "", "c/lamp/lamp.sdf": ""})
    for workspace in ("b", "a"):
        world = opened(tmp_path / workspace / "src/worlds/models/main.sdf")
        assert locate(world, "model://arm").path == tmp_path / workspace / "src/robots/models/arm"
    assert locate(world, "model://lamp/lamp.sdf").path is None, "without model.config it is a folder only"


def test_a_package_is_a_model_of_its_name(tmp_path: Path) -> None:
    package = "<package><name>{}</name></package>"
    write(
        tmp_path,
        {
            "package.xml": package.format("worlds"),
            "worlds/main.sdf": MODEL,
            "deep/source/package.xml": package.format("arm"),
            "deep/source/mesh.dae": "",
            "deep/lamp/mesh.dae": "",
        },
    )
    document = opened(tmp_path / "worlds/main.sdf")
    assert locate(document, "model://arm/mesh.dae").path == tmp_path / "deep/source/mesh.dae"
    assert locate(document, "model://arm/other.dae").owner == tmp_path / "deep/source"
    assert locate(document, "model://lamp/mesh.dae").owner is None


def test_a_python_package_has_its_files_beside_its_modules(tmp_path: Path) -> None:
    package = {
        "work/package.xml": "<package><name>hand</name></package>",
        "work/src/hand/meshes/palm.stl": "",
        "work/urdf/hand.urdf": '<robot name="r"/>',
    }
    write(tmp_path, package)
    found = locate(opened(tmp_path / "work/urdf/hand.urdf"), "package://hand/meshes/palm.stl").path
    assert found == tmp_path / "work/src/hand/meshes/palm.stl"


def test_packages_export_their_media_to_each_other(tmp_path: Path) -> None:
    write(tmp_path / "a", {"package.xml": "<package><name>a</name></package>", "models/main.sdf": MODEL})
    write(tmp_path / "b", {"package.xml": "<package><name>b</name></package>", "Media/sky.dae": ""})
    write(tmp_path, {".git/HEAD": ""})
    world = opened(tmp_path / "a/models/main.sdf")
    assert locate(world, "file://Media/sky.dae").path == tmp_path / "b/Media/sky.dae"
    assert locate(world, "file://Media/gone.dae").path is None


@pytest.mark.parametrize("variable", ["GZ_SIM_RESOURCE_PATH", "SDF_PATH", "GAZEBO_MODEL_PATH"])
def test_the_environment_names_model_folders(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, variable: str
) -> None:
    write(tmp_path, {"a/main.sdf": MODEL, "b/c/d/arm/arm.sdf": ""})
    monkeypatch.setenv(variable, os.pathsep.join(("", str(tmp_path / "b/c/d"))))
    assert (
        locate(opened(tmp_path / "a/main.sdf"), "model://arm/arm.sdf").path == tmp_path / "b/c/d/arm/arm.sdf"
    )


def test_not_found_names_the_tries_and_the_near_names(tmp_path: Path) -> None:
    write(tmp_path, {"main.sdf": MODEL, "arm/meshes/Arm.dae": ""})
    location = locate(opened(tmp_path / "main.sdf"), "model://arm/meshes/arm.DAE")
    assert location.path is None
    assert str(tmp_path / "arm/meshes/arm.DAE") in location.tried
    assert location.near == tmp_path / "arm/meshes/Arm.dae"
    assert (location.name, location.owner) == ("arm", tmp_path / "arm")


def test_nothing_on_the_network_is_a_file(tmp_path: Path) -> None:
    write(tmp_path, {"main.sdf": MODEL})
    location = locate(opened(tmp_path / "main.sdf"), "https://example.org/arm")
    assert location.is_remote
    assert location.tried == ()


@pytest.mark.parametrize("uri", ["a" * 5000, "loop", "\x01", "model://../../../../..", "//", ""])
def test_any_text_is_looked_up(tmp_path: Path, uri: str) -> None:
    write(tmp_path, {"main.sdf": MODEL})
    (tmp_path / "loop").symlink_to("loop")
    locate(opened(tmp_path / "main.sdf"), uri)


@pytest.mark.parametrize(
    ("uri", "fault", "meant"),
    [
        ("package:/arm/a.stl", UriFault.SLASHES, "package://arm/a.stl"),
        ("model:arm", UriFault.SLASHES, "model://arm"),
        ("package:///arm", UriFault.SLASHES, "package://arm"),
        (r"model:\\arm\a.stl", UriFault.BACKSLASH, "model://arm/a.stl"),
        (r"meshes\a.stl", UriFault.BACKSLASH, "meshes/a.stl"),
        ("Package://arm/a.stl", UriFault.SCHEME_CASE, "package://arm/a.stl"),
        ("pakcage://arm/a.stl", UriFault.UNKNOWN_SCHEME, "package://arm/a.stl"),
        ("model://", UriFault.NO_NAME, None),
        (" package://arm/a.stl", UriFault.BLANK, "package://arm/a.stl"),
    ],
)
def test_malformed(uri: str, fault: UriFault, meant: str | None) -> None:
    found = misspelling(value(uri))
    assert found is not None
    assert (found.fault, found.meant) == (fault, meant)


@pytest.mark.parametrize(
    "uri",
    [
        "model://a/b.dae",
        "a b/c.dae",
        "https://x.org/a",
        "file:///a",
        "C:/a",
        "x:y",
        "drake://a",
        "a:b.stl",
        "package:///a.stl",
    ],
)
def test_sound(uri: str) -> None:
    assert misspelling(value(uri)) is None


@pytest.mark.parametrize(
    "uri", ["/home/ann/a.dae", "file:///home/ann/a.dae", "C:\\a.dae", "file:///C:/a.dae"]
)
def test_absolute(uri: str) -> None:
    assert is_absolute(value(uri))


@pytest.mark.parametrize("uri", ["a.dae", "file://a.dae", "model://a", "$(find arm)/a.dae"])
def test_not_absolute(uri: str) -> None:
    assert not is_absolute(value(uri))


@pytest.mark.parametrize(
    ("uri", "meant"),
    [
        ("model://Arm/MESHES/a.dae", "model://arm/meshes/a.dae"),
        ("arm/meshes/A.dae", "arm/meshes/a.dae"),
        ("../home/arm/Meshes/a.dae", "../home/arm/meshes/a.dae"),
    ],
)
def test_wrong_case(tmp_path: Path, uri: str, meant: str) -> None:
    write(tmp_path, {"home/main.sdf": MODEL, "home/arm/meshes/a.dae": ""})
    found = other_case(value(uri), locate(opened(tmp_path / "home/main.sdf"), uri))
    assert found is not None
    assert found.meant == meant


def test_a_file_is_not_another_spelling_of_a_package(tmp_path: Path) -> None:
    (tmp_path / "a.stl").write_text("")
    file = tmp_path / "r.urdf"
    mesh = '<mesh filename="package://a.stl"/>'
    file.write_text(
        f'<robot name="r"><link name="l"><visual><geometry>{mesh}</geometry></visual></link></robot>'
    )
    run = sdfcheck.lint(file, isolated=True)
    (found,) = (each for each in run.diagnostics if each.code.startswith("RES"))
    assert (found.code, found.message) == ("RES001", "`package://a.stl` names a file and no package")
    assert not run.missing


def test_nothing_is_looked_up_outside_for_what_may_be_meant(tmp_path: Path) -> None:
    (tmp_path / "outside.stl").write_text("solid")
    path = tmp_path / "r.urdf"
    path.write_text(
        '<robot name="r"><link name="a"><visual><geometry>'
        f'<mesh filename="package:///{tmp_path}/outside.stl"/></geometry></visual></link></robot>'
    )
    (found,) = (each for each in sdfcheck.lint(path).diagnostics if each.code == "RES004")
    assert f"did you mean `package:/{tmp_path}/outside.stl`?" in found.message
