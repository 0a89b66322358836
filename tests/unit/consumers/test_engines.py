"""Asking consumers that are installed; a stand-in plays those that misbehave."""

from __future__ import annotations

import math
import os
import stat
from pathlib import Path

import pytest

from sdfcheck.consumers import engines
from sdfcheck.consumers.engines import Engine, Limits, Outcome, Question, ask, ask_all, is_installed
from sdfcheck.consumers.engines import urdfdom as check_urdf
from sdfcheck.consumers.reaction import Consumer
from sdfcheck.source.errors import WrongUsage

ARM = """<robot name="r">
<link name="base"><inertial><mass value="5"/>
<inertia ixx=".05" iyy=".05" izz=".05" ixy="0" ixz="0" iyz="0"/></inertial></link>
<link name="arm"><inertial><origin xyz=".1 0 0" rpy="0 0 .3"/><mass value="2"/>
<inertia ixx=".01" iyy=".02" izz=".025" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="turn" type="revolute"><origin xyz="0 0 .5" rpy="0 0 1"/><parent link="base"/><child link="arm"/>
<axis xyz="0 1 0"/><limit lower="-1" upper="1.5" effort="10" velocity="3"/></joint></robot>"""
PYTHON = [engine for engine in Engine if engine.package and engine is not Engine.USD]


@pytest.fixture
def arm(tmp_path: Path) -> Path:
    file = tmp_path / "arm.urdf"
    file.write_text(ARM)
    return file


def skip_without(engine: Engine) -> None:
    if not is_installed(engine):
        pytest.skip(f"{engine.value} is not installed: {engine.advice}")


@pytest.mark.peers
@pytest.mark.parametrize("engine", PYTHON, ids=lambda engine: engine.value)
def test_facts(engine: Engine, arm: Path) -> None:
    skip_without(engine)
    answer = ask(engine, Question(arm, "facts", {"configurations": [{}, {"turn": 0.7}]}))
    assert answer.outcome is Outcome.ACCEPTED, answer.error
    assert answer.version
    mass, center, moments = answer.result["bodies"]["arm"]
    assert mass == pytest.approx(2)
    assert center == pytest.approx([0.1, 0, 0], abs=1e-7)
    assert moments[2][2] == pytest.approx(0.025)
    assert moments[0][1] == pytest.approx(-0.01 * math.sin(0.3) * math.cos(0.3), abs=1e-7)
    joint = answer.result["joints"]["turn"]
    assert (joint["lower"], joint["upper"]) == pytest.approx((-1, 1.5))
    assert joint["axis"] == pytest.approx([-math.sin(1), math.cos(1), 0], abs=1e-6)
    still, turned = answer.result["poses"]
    assert still["arm"][2][3] == pytest.approx(0.5, abs=1e-6)
    assert turned["arm"][2][2] == pytest.approx(math.cos(0.7), abs=1e-6)


@pytest.mark.peers
@pytest.mark.parametrize("engine", list(Engine), ids=lambda engine: engine.value)
def test_refusals(engine: Engine, arm: Path) -> None:
    skip_without(engine)
    broken = arm.with_name("broken.urdf")
    broken.write_text('<robot name="r"><link name="a"/><joint name="j" type="fixed"></robot>')
    bad, good = ask_all(engine, [Question(broken), Question(arm)])
    assert bad.outcome in {Outcome.REFUSED, Outcome.CRASHED}
    assert bad.error
    assert good.is_accepted


def merged_frame(folder: Path, monkeypatch: pytest.MonkeyPatch, script: str) -> None:
    """A program in the place of ``check_urdf``."""
    if os.name != "posix":
        pytest.skip("the program is a script of a shell")
    program = folder / "bin" / "check_urdf"
    program.parent.mkdir()
    program.write_text(f"#!/bin/sh\n{script}\n")
    program.chmod(program.stat().st_mode | stat.S_IXUSR)
    monkeypatch.setenv("PATH", str(program.parent), prepend=os.pathsep)
    assert check_urdf.program() == str(program)


@pytest.mark.parametrize(
    ("script", "outcome", "error"),
    [
        ("echo 'root Link: base has 0 child(ren)'", Outcome.ACCEPTED, ""),
        ("echo 'Error: no such link' >&2; exit 255", Outcome.REFUSED, "Error: no such link"),
        ("kill -SEGV $$", Outcome.CRASHED, "it ended by SIGSEGV"),
        ("sleep 20", Outcome.TOO_LONG, "it was not done after 1 s"),
    ],
)
def test_outcomes(
    script: str, outcome: Outcome, error: str, arm: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    merged_frame(arm.parent, monkeypatch, script)
    answer = ask(Engine.URDFDOM, Question(arm), Limits(1.0))
    assert (answer.outcome, answer.error) == (outcome, error)


def test_a_missing_engine_is_named_with_how_to_install_it(arm: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(engines, "is_installed", lambda engine: False)
    answer = ask(Engine.PYBULLET, Question(arm))
    assert answer.outcome is Outcome.MISSING
    assert answer.error == "pip install 'sdfcheck[pybullet]'"


def test_modules_of_the_current_folder_are_not_loaded(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    merged_frame(tmp_path, monkeypatch, "echo 'root Link: base has 0 child(ren)'")
    (tmp_path / "json.py").write_text(f"open({str(tmp_path / 'loaded')!r}, 'w')\nraise SystemExit\n")
    (tmp_path / "arm.urdf").write_text(ARM)
    monkeypatch.chdir(tmp_path)
    assert ask(Engine.URDFDOM, Question(Path("arm.urdf"))).is_accepted
    assert not (tmp_path / "loaded").exists()


def test_each_consumer_is_run_by_an_engine() -> None:
    assert set(engines.RUN_BY) == set(Consumer)


def test_a_variable_that_names_no_program_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(engines.VARIABLE, "/nowhere/python")
    monkeypatch.setattr(engines, "find_spec", lambda name: None)
    engines.interpreter.cache_clear()
    try:
        with pytest.raises(WrongUsage, match="SDFCHECK_ENGINES: cannot run /nowhere/python: No such file"):
            engines.is_installed(Engine.DRAKE)
    finally:
        engines.interpreter.cache_clear()
