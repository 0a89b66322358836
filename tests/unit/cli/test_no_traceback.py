"""Documents that once ended a command with an internal error, or with numpy's warnings."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

from sdfcheck.cli.main import main

NESTED = '<sdf version="1.6"><world name="default"></re' + '<model name="m">' * 300
CUT = "<sdf version='1.6'><plugin"
HALF_JOINT = "<robot<xacro:/<joint name='j'"
HUGE = (
    '<sdf version="1.9"><model name="m"><link name="l"><pose>1e308 1e308 1e308 0 0 0</pose>'
    "<inertial><mass>1e308</mass></inertial></link></model></sdf>"
)


@pytest.mark.parametrize("text", [NESTED, CUT], ids=["nested", "cut"])
@pytest.mark.parametrize("version", ["1.4", "1.5", "1.7", "1.8", "1.12"])
@pytest.mark.parametrize("lint", ["--lint", "--no-lint"])
def test_broken_text_is_converted_or_refused(
    tmp_path: Path, text: str, version: str, lint: str, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "m.sdf"
    file.write_text(text)
    main(["convert", "sdf-to-sdf", "--sdf-version", version, lint, str(file)])
    assert "internal error" not in capsys.readouterr().err


@pytest.mark.parametrize("kind", ["frames", "poses", "joints"])
def test_half_a_joint_is_drawn(tmp_path: Path, kind: str, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "m.urdf"
    file.write_text(HALF_JOINT)
    main(["graph", kind, str(file)])
    assert "internal error" not in capsys.readouterr().err


def run(*arguments: object) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "sdfcheck", *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, check=False)


def test_json_has_no_nan(tmp_path: Path) -> None:
    file = tmp_path / "m.sdf"
    file.write_text(
        HUGE.replace("</model>", HUGE[HUGE.index("<link") :].partition("</sdf>")[0].replace('"l"', '"k"'))
    )
    done = run("inertia", "--output-format", "json", "--isolated", file)
    assert done.returncode == 0

    def refuse(name: str) -> object:
        raise AssertionError(f"{name} is not JSON")

    assert json.loads(done.stdout, parse_constant=refuse)["total"]["mass"] is None


def test_numpy_does_not_warn(tmp_path: Path) -> None:
    file = tmp_path / "m.sdf"
    file.write_text(HUGE)
    assert "Warning" not in run("print", "--isolated", file).stderr
