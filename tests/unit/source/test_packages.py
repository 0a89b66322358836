"""Where packages are, without ROS."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

import sdfcheck
from sdfcheck.files.library import Library, SearchPaths
from sdfcheck.files.packages import Packages, absent_installs, has_file, project_root
from sdfcheck.files.regular import names_in
from sdfcheck.xacro.expansion import expand


def package(folder: Path, name: str) -> Path:
    folder.mkdir(parents=True)
    (folder / "package.xml").write_text(f"<package><!-- <name>old</name> --><name> {name} </name></package>")
    return folder


def test_packages_go_by_the_name_in_their_file(tmp_path: Path) -> None:
    arm = package(tmp_path / "a" / "folder", "arm_description")
    package(tmp_path / "build" / "copy", "built")
    packages = Packages(tmp_path, environment={})
    assert packages.find("arm_description") == arm
    assert packages.find("folder") == arm, "else by the only folder of that name"
    assert packages.find("built") is None
    assert packages.find("none") is None
    assert packages.names == ["arm_description"]


def test_the_named_part_comes_first(tmp_path: Path) -> None:
    package(tmp_path / "project" / "arm", "arm")
    other = package(tmp_path / "other" / "arm", "arm")
    root = tmp_path / "project"
    assert Packages(root, {"arm": tmp_path}, environment={}).find("arm") == tmp_path
    assert Packages(root, paths=[tmp_path / "other"], environment={}).find("arm") == other


def test_of_copies_the_nearest_counts(tmp_path: Path) -> None:
    (tmp_path / ".git").mkdir()
    for workspace, link in (("one", "a"), ("two", "b")):
        package = tmp_path / workspace / "src/arm"
        package.mkdir(parents=True)
        (package / "package.xml").write_text("<package><name>arm</name></package>")
        (package / "part.xacro").write_text(f'<robot><link name="{link}"/></robot>')
        mesh = '<link name="l"><visual><geometry><mesh filename="package://arm/{}.stl"/></geometry></visual></link>'
        (package / f"{link}.stl").write_text("solid a\nendsolid a")
        (tmp_path / workspace / "robot.urdf.xacro").write_text(
            '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
            f'<xacro:include filename="$(find arm)/part.xacro"/>{mesh.format(link)}</robot>'
        )
    packages = Packages(tmp_path, environment={})
    assert packages.find("arm") == tmp_path / "one/src/arm"
    assert packages.find("arm", tmp_path / "two/robot.urdf.xacro") == tmp_path / "two/src/arm"
    for workspace, link in (("one", "a"), ("two", "b")):
        robot = tmp_path / workspace / "robot.urdf.xacro"
        assert f'name="{link}"' in str(expand(robot).text)
        assert not [each for each in sdfcheck.lint(robot, isolated=True).diagnostics if each.code == "RES001"]


def test_folders_of_one_name_decide_nothing(tmp_path: Path) -> None:
    for parent in ("a", "b"):
        (tmp_path / parent / "arm").mkdir(parents=True)
    assert Packages(tmp_path, environment={}).find("arm") is None


def test_a_ros_installation_is_looked_into(tmp_path: Path) -> None:
    (tmp_path / "ros" / "share" / "arm").mkdir(parents=True)
    old = package(tmp_path / "old" / "wheel", "wheel")
    environment = {"AMENT_PREFIX_PATH": str(tmp_path / "ros"), "ROS_PACKAGE_PATH": str(tmp_path / "old")}
    (tmp_path / "project").mkdir()
    packages = Packages(tmp_path / "project", environment=environment)
    assert packages.find("arm") == tmp_path / "ros" / "share" / "arm"
    assert packages.find("wheel") == old


@pytest.mark.parametrize(
    ("rule", "asked", "found"),
    [
        (
            "install(DIRECTORY description/urdf DESTINATION share/${PROJECT_NAME})",
            "urdf/a",
            "description/urdf/a",
        ),
        ("install(DIRECTORY description/ DESTINATION share/${PROJECT_NAME})", "urdf/a", "description/urdf/a"),
        (
            "install(DIRECTORY description/urdf # x\n DESTINATION share/arm/deep)",
            "deep/urdf/a",
            "description/urdf/a",
        ),
        ("install(FILES description/urdf/a DESTINATION share/arm)", "a", "description/urdf/a"),
        ("install(DIRECTORY description/urdf DESTINATION lib/arm)", "urdf/a", "urdf/a"),
    ],
)
def test_a_path_that_holds_after_installation(tmp_path: Path, rule: str, asked: str, found: str) -> None:
    arm = package(tmp_path / "arm", "arm")
    (arm / "description" / "urdf").mkdir(parents=True)
    (arm / "description" / "urdf" / "a").touch()
    (arm / "CMakeLists.txt").write_text(f"project(arm)\n{rule}\n")
    assert Packages(tmp_path, environment={}).locate(arm / asked) == arm / found


def test_a_build_may_expand_a_file(tmp_path: Path) -> None:
    arm = package(tmp_path / "arm", "arm")
    source = arm / "arm.urdf.xacro"
    source.touch()
    assert Packages(tmp_path, environment={}).locate(arm / "arm.urdf") == arm / "arm.urdf"
    (arm / "CMakeLists.txt").write_text(
        "project(arm)\nxacro_add_files(arm.urdf.xacro INSTALL DESTINATION urdf)\n"
    )
    assert Packages(tmp_path, environment={}).locate(arm / "arm.urdf") == source


def test_the_project_is_the_repository_or_the_workspace(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir("/")
    monkeypatch.setenv("HOME", str(tmp_path))
    urdf = package(tmp_path / "ws" / "src" / "repo" / "arm", "arm") / "urdf"
    urdf.mkdir()
    file = urdf / "a.xacro"
    assert project_root(file) == tmp_path / "ws" / "src" / "repo"
    (tmp_path / "ws" / "src" / "repo" / "arm" / ".git").mkdir()
    assert project_root(file) == tmp_path / "ws" / "src" / "repo" / "arm"
    (tmp_path / "ws" / "install").mkdir()
    assert project_root(file) == tmp_path / "ws" / "src"


def test_the_home_folder_is_no_project(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.chdir(tmp_path)
    (tmp_path / "robots").mkdir()
    assert project_root(tmp_path / "robots" / "a.xacro") == tmp_path / "robots"


def test_a_lone_file_in_the_home_folder_has_the_files_beside_it_only(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("HOME", str(tmp_path))
    package(tmp_path / "secret", "secret")
    for name in ("a.xacro", "b.yaml", ".hidden.yaml"):
        (tmp_path / name).touch()
    (tmp_path / "link.yaml").symlink_to("secret/package.xml")
    (tmp_path / "below").mkdir()
    packages = Packages(project_root(tmp_path / "a.xacro"), environment={}, is_flat=True)
    assert packages.places == (tmp_path / "a.xacro", tmp_path / "b.yaml")
    assert packages.find("secret") is None
    assert list(packages.files(".xacro", 9)) == [tmp_path / "a.xacro"]
    around = Library().around(tmp_path / "a.xacro")
    assert around.hold(tmp_path / "b.yaml", str(tmp_path / "b.yaml"))
    assert not around.hold(tmp_path / "below/c.yaml", str(tmp_path / "below/c.yaml"))
    named = Library(SearchPaths(packages_in=(tmp_path,))).packages(tmp_path / "a.xacro")
    assert named.find("secret") == tmp_path / "secret"


def test_xacro_reads_beside_a_file_in_the_home_folder_only(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.chdir("/")
    (tmp_path / "below").mkdir()
    for place in ("beside.yaml", "below/secret.yaml"):
        (tmp_path / place).write_text("{mass: 5}")
        (tmp_path / "a.xacro").write_text(
            '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
            f"<link name=\"l${{xacro.load_yaml('{place}')['mass']}}\"/></robot>"
        )
        text = expand(tmp_path / "a.xacro").text
        assert (text is not None and "l5" in text) == (place == "beside.yaml")


def test_folders_that_cannot_be_listed_hold_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "closed").mkdir()
    (tmp_path / "a.xacro").touch()
    listing = os.listdir

    def closed(folder: str) -> list[str]:
        if os.path.basename(folder) == "closed":
            raise OSError(22, "Invalid argument")
        return listing(folder)

    monkeypatch.setattr(os, "listdir", closed)
    assert list(Packages(tmp_path, environment={}).files(".xacro", 9)) == [tmp_path / "a.xacro"]


@pytest.mark.skipif(not Path("/proc/self").exists(), reason="no such folder")
def test_folders_of_the_kernel_are_in_no_project() -> None:
    assert Packages(Path("/proc"), environment={}).names == []
    assert list(Packages(Path("/proc/self"), environment={}).files("", 9)) == []


def test_folders_are_listed_once_until_they_are_forgotten(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for number in range(5):
        (tmp_path / f"p{number}").mkdir()
        (tmp_path / f"p{number}" / "a.yaml").write_text("")
    packages, listed = Packages(tmp_path, environment={}), list[str]()

    def noted(folder: str) -> list[str]:
        listed.append(folder)
        return names_in(folder)

    monkeypatch.setattr("sdfcheck.files.packages.names_in", noted)
    assert len(list(packages.files(".yaml", 100))) == 5
    seen = len(listed)
    (tmp_path / "p0" / "b.yaml").write_text("")
    assert len(list(packages.files(".yaml", 100))) == 5
    assert list(packages.files("c.dae", 100)) == []
    assert len(listed) == seen
    packages.forget()
    assert len(list(packages.files(".yaml", 100))) == 6


@pytest.mark.parametrize(
    ("name", "is_one"),
    [
        ("a.launch", True),
        ("a.launch.xml", True),
        ("a.launch.py", True),
        ("a.yml", True),
        ("package.xml", False),
    ],
)
def test_files_that_say_what_ros_starts(name: str, is_one: bool, tmp_path: Path) -> None:
    (tmp_path / "a.urdf").write_text("")
    packages = Packages(tmp_path, environment={})
    assert not packages.has_ros_files
    (tmp_path / name).write_text("")
    assert not packages.has_ros_files, "the answer holds until files are looked for again"
    packages.forget()
    assert packages.has_ros_files is is_one


def test_a_build_does_not_ask_for_folders_outside_of_its_package(tmp_path: Path) -> None:
    (tmp_path / "package.xml").write_text(
        "<package><name>bot</name><buildtool_depend>ament_cmake</buildtool_depend></package>"
    )
    installs = "install(DIRECTORY urdf/../../elsewhere/meshes {} DESTINATION share/bot)"
    lists = tmp_path / "CMakeLists.txt"
    lists.write_text(installs.format(""))
    assert absent_installs(str(tmp_path)) is None
    lists.write_text(installs.format("meshes"))
    assert absent_installs(str(tmp_path)) == ("bot", "CMakeLists.txt", ("meshes",))


@pytest.mark.parametrize("path", ["../secret.stl", "meshes/../../secret.stl", "link.stl"])
def test_a_path_that_leads_out_of_a_package_is_none_of_its_files(tmp_path: Path, path: str) -> None:
    arm = tmp_path / "arm"
    (arm / "meshes").mkdir(parents=True)
    (tmp_path / "secret.stl").touch()
    (arm / "meshes" / "own.stl").touch()
    (arm / "link.stl").symlink_to(tmp_path / "secret.stl")
    assert has_file(arm, "meshes/own.stl")
    assert not has_file(arm, path)
    assert not has_file(arm, str(tmp_path / "secret.stl"))
