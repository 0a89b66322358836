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


LONG = "x" * 300
"""Longer than the name of a file may be."""
WITH_LONG_NAMES = {
    "a.sdf": "<sdf version='1.11'><model name='m'><link name='l'><collision name='c'><geometry><mesh>"
    "<uri>LONG.stl</uri></mesh></geometry></collision></link><include><uri>LONG</uri></include><include><uri>model://LONG</uri></include>"
    "<include><uri>file:///LONG</uri></include></model></sdf>",
    "a.urdf": "<robot name='r'><link name='l'><visual><geometry><mesh filename='package://LONG/LONG.stl'/></geometry>"
    "</visual><visual><geometry><mesh filename='LONG.stl'/></geometry></visual></link><gazebo><plugin name='p' "
    "filename='libgz_ros2_control-system.so'><parameters>$(find LONG)/LONG.yaml</parameters></plugin></gazebo></robot>",
    "find.urdf.xacro": "<robot name='r' X><xacro:include filename='$(find LONG)/LONG.xacro'/></robot>",
    "include.urdf.xacro": "<robot name='r' X><xacro:include filename='LONG/LONG.xacro'/></robot>",
    "argument.urdf.xacro": "<robot name='r' X><xacro:arg name='f' default='LONG'/>"
    "<xacro:include filename='$(arg f).xacro'/></robot>",
    "several.urdf.xacro": "<robot name='r' X><xacro:include filename='LONG/*.xacro'/><link name='l'/></robot>",
    "yaml.urdf.xacro": "<robot name='r' X><link name='${xacro.load_yaml(&quot;LONG&quot;)}'/></robot>",
    "model.config": "<model><name>m</name><sdf version='1.9'>LONG.sdf</sdf></model>",
}


@pytest.mark.parametrize("name", WITH_LONG_NAMES)
def test_names_that_no_file_can_have(name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / ".git").mkdir()
    text = WITH_LONG_NAMES[name].replace("LONG", LONG)
    (tmp_path / name).write_text(text.replace(" X>", ' xmlns:xacro="http://www.ros.org/wiki/xacro">'))
    for command in (
        *(
            "lint",
            "lint --no-expand",
            "targets",
            "expand",
            "print --expand-includes",
            "inertia",
            "graph frames",
        ),
        *("view", "convert urdf-to-sdf", "convert sdf-to-urdf", "convert sdf-to-sdf --sdf-version 1.7"),
    ):
        assert main([*command.split(), "--isolated", str(tmp_path / name)]) in {0, 1, 2}
        assert "internal error" not in "".join(capsys.readouterr())


@pytest.mark.parametrize("place", [LONG, f"{LONG}/{LONG}"])
@pytest.mark.parametrize(
    "words",
    [
        *(
            "lint --config",
            "lint --baseline",
            "lint --package-path",
            "lint --model-path",
            "lint --package p=",
        ),
        *("lint -o", "lint --output-format json=", "lint --stdin-filename", "lint", "lint --show-settings"),
        *("print", "print -o", "print --model-path", "view -o", "targets -o", "diff -o", "graph frames -o"),
        *("convert sdf-to-urdf", "convert sdf-to-urdf -o", "convert sdf-to-urdf --output-dir"),
        *("convert sdf-to-urdf --report", "expand", "expand -o", "inertia", "rules --test", "schema --for"),
    ],
)
def test_options_with_names_that_no_file_can_have(
    words: str,
    place: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("a.sdf").write_text('<sdf version="1.9"><model name="m"><link name="l"/></model></sdf>')
    joined = f"{words}{place}" if words.endswith("=") else f"{words} {place}"
    assert main([*joined.split(), *["a.sdf"] * (2 if "diff" in words else 1)]) == 2
    error = capsys.readouterr().err
    assert "error" in error.lower()
    assert "internal error" not in error
