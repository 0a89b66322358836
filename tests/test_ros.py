"""The packages for ROS 2: the command of ament, its CMake function, and what their manifests say."""

from __future__ import annotations

import importlib.util
import re
import shutil
import subprocess
from pathlib import Path
from types import ModuleType
from xml.etree import ElementTree

import pytest

from sdfcheck.release import __version__

ROS = Path(__file__).parents[1] / "ros"
PACKAGES = sorted(path.parent for path in ROS.glob("*/package.xml"))
SOUND = '<robot name="r"><link name="base"/></robot>'
BROKEN = '<robot name="r"><link name="base"/><link name="base"/></robot>'

_SCRIPT = """
cmake_minimum_required(VERSION 3.12)
function(find_package)
endfunction()
function(ament_register_extension point package file)
  message(STATUS "hook ${point} ${package} ${file}")
endfunction()
function(ament_add_test)
  message(STATUS "test ${ARGN}")
endfunction()
function(set_tests_properties)
  message(STATUS "properties ${ARGN}")
endfunction()
function(find_program variable)
  set(${variable} "bin/ament_sdfcheck" PARENT_SCOPE)
endfunction()
set(PROJECT_NAME robot_description)
set(AMENT_TEST_RESULTS_DIR "${CMAKE_BINARY_DIR}/test_results")
"""
"""What CMake's script mode and this computer lack: the parts of ament_cmake that are called."""


@pytest.fixture(scope="module")
def command() -> ModuleType:
    place = ROS / "ament_sdfcheck" / "ament_sdfcheck" / "main.py"
    spec = importlib.util.spec_from_file_location("ament_sdfcheck_main", place)
    assert spec
    assert spec.loader
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.parametrize("package", PACKAGES, ids=lambda path: path.name)
def test_manifests_are_of_this_version(package: Path) -> None:
    root = ElementTree.parse(package / "package.xml").getroot()
    assert (root.get("format"), root.findtext("name"), root.findtext("version")) == (
        "3",
        package.name,
        __version__,
    )
    setup = package / "setup.py"
    assert not setup.exists() or f'version="{__version__}"' in setup.read_text(encoding="utf-8")


def test_the_command_fails_for_what_fails_a_run(command: ModuleType, tmp_path: Path) -> None:
    (tmp_path / "good.urdf").write_text(SOUND)
    (tmp_path / "bad.urdf").write_text(BROKEN)
    results = tmp_path / "results.xunit.xml"
    assert command.main(["--xunit-file", str(results), str(tmp_path)]) == 1
    root = ElementTree.parse(results).getroot()
    assert {Path(each.get("name", "")).name: each.get("failures") for each in root} == {
        "good.urdf": "0",
        "bad.urdf": "1",
    }
    assert command.main([str(tmp_path), "--exclude", str(tmp_path / "bad.urdf")]) == 0
    assert command.main([str(tmp_path / "good.urdf"), "--fail-on", "info"]) == 1, (
        "further options are handed on"
    )


def test_a_missing_package_is_skipped(command: ModuleType, tmp_path: Path) -> None:
    (tmp_path / "a.urdf").write_text(
        '<robot name="r"><link name="base"><visual><geometry>'
        '<mesh filename="package://nowhere_description/a.stl"/></geometry></visual></link></robot>'
    )
    results = tmp_path / "results.xunit.xml"
    assert command.main(["--xunit-file", str(results), str(tmp_path)]) == 0
    (suite,) = ElementTree.parse(results).getroot()
    assert (suite.get("failures"), suite.get("skipped")) == ("0", "1")


def cmake(script: str, folder: Path) -> list[str]:
    program = shutil.which("cmake")
    if program is None:
        pytest.skip("cmake is not installed")
    file = folder / "script.cmake"
    file.write_text(_SCRIPT + script)
    done = subprocess.run([program, "-P", file], cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return re.findall(r"^-- (.*)$", done.stdout, re.MULTILINE)


def test_the_cmake_function_adds_a_test(tmp_path: Path) -> None:
    module = ROS / "ament_cmake_sdfcheck" / "cmake" / "ament_sdfcheck.cmake"
    call = "ament_sdfcheck(urdf TESTNAME arms CONFIG_FILE c.toml EXCLUDE old.urdf ARGUMENTS --fail-on error)"
    added, properties = cmake(f'include("{module}")\n{call}\n', tmp_path)
    words = added.split(";")
    results = f"{tmp_path}/test_results/robot_description/arms.xunit.xml"
    start = words.index("COMMAND")
    assert words[start + 1 : words.index("OUTPUT_FILE")] == [
        *("bin/ament_sdfcheck", "--xunit-file", results, "--config", "c.toml"),
        *("--fail-on", "error", "urdf", "--exclude", "old.urdf"),
    ]
    assert words[words.index("RESULT_FILE") + 1] == results
    assert properties == "properties arms;PROPERTIES;LABELS;sdfcheck;linter"


@pytest.mark.parametrize(("file", "tests"), [("a.urdf", 1), ("notes.txt", 0)])
def test_ament_lint_auto_adds_it_where_there_are_descriptions(tmp_path: Path, file: str, tests: int) -> None:
    (tmp_path / file).write_text(SOUND)
    folder = ROS / "ament_cmake_sdfcheck"
    said = cmake(
        f'set(ament_cmake_sdfcheck_DIR "{folder}/cmake")\n'
        f'include("{folder}/ament_cmake_sdfcheck-extras.cmake")\n'
        f'include("{folder}/cmake/ament_cmake_sdfcheck_lint_hook.cmake")\n',
        tmp_path,
    )
    assert said[0] == "hook ament_lint_auto ament_cmake_sdfcheck ament_cmake_sdfcheck_lint_hook.cmake"
    assert sum(line.startswith("test ") for line in said) == tests
