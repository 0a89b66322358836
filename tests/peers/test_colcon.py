"""colcon builds the linter of ament, runs it in a package that has a mistake, and reports the mistake."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

import pytest

COLCON = shutil.which("colcon")
ROOT = Path(__file__).parents[2]

pytestmark = [
    pytest.mark.peers,
    pytest.mark.skipif(COLCON is None, reason="colcon is not installed"),
]

SETUP = """\
from setuptools import setup

setup(
    name="bot_description",
    version="0.1.0",
    packages=["bot_description"],
    data_files=[("share/bot_description", ["package.xml"])],
    extras_require={"test": ["pytest"]},
)
"""
MANIFEST = """\
<?xml version="1.0"?>
<package format="3">
  <name>bot_description</name>
  <version>0.1.0</version>
  <description>A robot</description>
  <maintainer email="bot@example.org">Bot</maintainer>
  <license>Apache-2.0</license>
  <test_depend>ament_sdfcheck</test_depend>
  <test_depend>python3-pytest</test_depend>
  <export><build_type>ament_python</build_type></export>
</package>
"""
TEST = """\
import pytest
from ament_sdfcheck.main import main


@pytest.mark.linter
@pytest.mark.sdfcheck
def test_sdfcheck():
    assert main(["urdf"]) == 0
"""
SOUND = '<robot name="bot"><link name="base"/></robot>'
BROKEN = '<robot name="bot"><link name="base"/><link name="base"/></robot>'


@pytest.fixture
def workspace(tmp_path: Path) -> Path:
    shutil.copytree(ROOT / "ros/ament_sdfcheck", tmp_path / "src/ament_sdfcheck")
    package = tmp_path / "src/bot_description"
    for name, text in {
        "setup.py": SETUP,
        "package.xml": MANIFEST,
        "bot_description/__init__.py": "",
        "test/test_sdfcheck.py": TEST,
        "urdf/bot.urdf": SOUND,
    }.items():
        (package / name).parent.mkdir(parents=True, exist_ok=True)
        (package / name).write_text(text)
    return tmp_path


def colcon(workspace: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    # A sourced workspace has its packages on this path; sdfcheck itself is read where it is developed.
    built = [*workspace.glob("install/*/lib/python*/site-packages"), ROOT]
    return subprocess.run(
        [str(COLCON), *arguments],
        cwd=workspace,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(map(str, built)), "PYTEST_ADDOPTS": ""},
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )


@pytest.mark.parametrize(("robot", "failures"), [(SOUND, 0), (BROKEN, 1)])
def test_colcon_reports_what_lint_finds(workspace: Path, robot: str, failures: int) -> None:
    (workspace / "src/bot_description/urdf/bot.urdf").write_text(robot)
    built = colcon(workspace, "build")
    assert built.returncode == 0, built.stderr
    colcon(workspace, "test", "--packages-select", "bot_description")
    results = colcon(workspace, "test-result", "--all", "--verbose")
    assert f"1 test, 0 errors, {failures} failure" in results.stdout, results.stdout
    assert results.returncode == (1 if failures else 0)
    log = (workspace / "log/latest_test/bot_description/stdout.log").read_text()
    assert ("urdf/bot.urdf:1:" in log) == bool(failures), log
