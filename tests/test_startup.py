"""A clean file costs no more than it must: what its run does not need is not imported."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from benchmarks.conversions import urdf

ROBOTS = Path(__file__).parents[1] / "fixtures" / "robots"
OF_ROS = ("sdfcheck.robot.bridges", "sdfcheck.robot.ros_files", "sdfcheck.xacro.static.launches")
HEAVY = (
    *OF_ROS,
    "sdfcheck.formats.findings",
    "sdfcheck.robot.semantics",
    "sdfcheck.robot.vendor",
    "dataclasses",
    "difflib",
    "lxml",
    "numpy",
    "pathspec",
    "rich",
    "statistics",
    "subprocess",
    "tomllib",
    "xacro",
    "yaml",
    "yourdfpy",
)
PROBE = f"""
import sys
from sdfcheck.cli.main import main
code = main(sys.argv[1:])
rules = {{name for name in sys.modules if name.startswith("sdfcheck_rules.")}}
rules -= {{"sdfcheck_rules.rule_index", "sdfcheck_rules.conditions"}}
print("loaded", code, *(name for name in {HEAVY} if name in sys.modules), *rules)
"""


def loaded(*arguments: str) -> str:
    command = [sys.executable, "-c", PROBE, *arguments]
    child = subprocess.run(command, capture_output=True, text=True, check=True, stdin=subprocess.DEVNULL)
    return child.stdout.splitlines()[-1]


@pytest.mark.parametrize("output_format", ["concise", "full"])
@pytest.mark.parametrize(
    "file", ["diff_drive/model.sdf", "desk_arm/desk_arm.urdf", "diff_drive/model.config"]
)
def test_a_clean_file_loads_nothing_heavy_and_no_rule(file: str, output_format: str, tmp_path: Path) -> None:
    folder, name = file.split("/")
    shutil.copytree(ROBOTS / folder, tmp_path / folder)
    report = loaded("lint", "--isolated", "--output-format", output_format, str(tmp_path / folder / name))
    assert report == "loaded 0"


def test_a_file_in_a_project_for_ros_loads_what_reads_the_files_beside_it(tmp_path: Path) -> None:
    shutil.copytree(ROBOTS / "diff_drive", tmp_path / "diff_drive")
    (tmp_path / "diff_drive" / "start.launch.py").write_text("")
    assert loaded("lint", "--isolated", str(tmp_path / "diff_drive/model.sdf")).split()[2:] == [*OF_ROS]


def test_a_robot_of_plain_shapes_loads_no_numpy(tmp_path: Path) -> None:
    """Also where moments are compared with those of its shapes, axis by axis."""
    (tmp_path / "arm.urdf").write_text(urdf("arm", 20_000))
    assert "numpy" not in loaded("lint", "--isolated", str(tmp_path / "arm.urdf")).split()


def test_the_probe_sees_a_rule_that_reports(tmp_path: Path) -> None:
    (tmp_path / "model.sdf").write_text('<sdf version="1.12"><modle/></sdf>')
    assert "sdfcheck_rules." in loaded("lint", "--isolated", str(tmp_path / "model.sdf"))


def test_the_probe_sees_what_is_loaded() -> None:
    report = loaded(
        "lint", "--config", str(ROBOTS / "sdfcheck.toml"), str(ROBOTS / "diff_drive" / "model.sdf")
    )
    assert "tomllib" in report or sys.version_info < (3, 11)
