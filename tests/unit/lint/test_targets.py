"""Which reader accepts a file."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.cli.targets import verdicts
from sdfcheck.lint.config import Configuration
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.lint.packs import load_index
from sdfcheck.lint.rule import Consumer
from sdfcheck.lint.targets import Verdict, judge

INERTIAL = '<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'


def told(text: str, name: str, folder: Path, *readers: Consumer) -> dict[str, str]:
    file = folder / name
    file.write_text(text, encoding="utf-8")
    rows = verdicts(file, readers or tuple(Consumer), Configuration(isolated=True))
    return {row.reader.value: row.verdict.value for row in rows}


@pytest.mark.parametrize(
    ("effect", "severity", "verdict"),
    [
        ("", Severity.ERROR, Verdict.REJECT),
        ("", Severity.WARNING, Verdict.WARN),
        ("", Severity.INFO, Verdict.ACCEPT),
        ("refuses the file", Severity.INFO, Verdict.REJECT),
        ("refuses the file, or ignores it", Severity.WARNING, Verdict.WARN),
        ("refuses the file, or ignores it", Severity.ERROR, Verdict.REJECT),
        ("crashes", Severity.WARNING, Verdict.REJECT),
        ("refuses a collision mesh", Severity.ERROR, Verdict.WARN),
        ("ignores it", Severity.ERROR, Verdict.WARN),
        ("takes it", Severity.ERROR, Verdict.ACCEPT),
        ("takes it: the link hardly turns", Severity.WARNING, Verdict.WARN),
    ],
)
def test_effects(effect: str, severity: Severity, verdict: Verdict) -> None:
    assert judge(effect, severity) is verdict


def test_readers_in_the_rules_are_known() -> None:
    known = {reader.value for reader in Consumer}
    for facts in load_index().facts:
        assert facts.affects.keys() <= known, facts.code
        assert all(effect == effect.strip() and effect for effect in facts.affects.values()), facts.code


def test_a_sound_file(tmp_path: Path) -> None:
    text = f'<robot name="r"><link name="base">{INERTIAL}</link></robot>'
    assert told(text, "r.urdf", tmp_path) == dict.fromkeys(("drake", "gazebo", "mujoco", "urdfdom"), "accept")


def test_a_format_that_is_not_theirs(tmp_path: Path) -> None:
    text = '<sdf version="1.9"><model name="m"><static>true</static><link name="l"/></model></sdf>'
    assert told(text, "m.sdf", tmp_path) == {
        "drake": "accept",
        "gazebo": "accept",
        "mujoco": "not read",
        "urdfdom": "not read",
    }


def test_readers_differ(tmp_path: Path) -> None:
    text = (
        '<sdf version="1.9"><model name="m"><static>true</static><link name="l"><foo/></link></model></sdf>'
    )
    assert told(text, "m.sdf", tmp_path, Consumer.DRAKE, Consumer.GAZEBO) == {
        "drake": "reject",
        "gazebo": "warn",
    }


def test_what_is_off_by_default_counts(tmp_path: Path) -> None:
    text = (
        '<sdf version="1.9"><model name="m"><static>true</static><link name="l"/>'
        '<plugin name="a" filename="libgazebo_ros_imu.so"/></model></sdf>'
    )
    assert told(text, "m.sdf", tmp_path, Consumer.GAZEBO) == {"gazebo": "warn"}


def test_an_undeclared_prefix_is_no_reason(tmp_path: Path) -> None:
    text = (
        '<sdf version="1.9"><model name="m"><static>true</static><link name="l"><p:a/></link></model></sdf>'
    )
    assert told(text, "m.sdf", tmp_path, Consumer.GAZEBO) == {"gazebo": "accept"}
