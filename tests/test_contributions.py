"""Frequent contributions touch one place each: tried in a copy of the program."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from sdfcheck.report import OutputFormat

ROOT = Path(__file__).parents[1]
RULE = '''
from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Sensor, Severity


class SleepingSensor(Rule):
    """A sensor with the update rate 0 is updated in each step."""

    code = "GAZ900"
    name = "sleeping-sensor"
    severity = Severity.WARNING
    looks_at = (Sensor,)
    scaffold = (
        '<sdf version="1.9"><model name="m"><link name="l"><sensor name="s" type="imu">{}</sensor>'
        "</link></model></sdf>"
    )
    bad = (Bad("<update_rate>«0»</update_rate>"),)
    good = (Good("<update_rate>5</update_rate>"),)

    @staticmethod
    def applies(sensor: Sensor) -> bool:
        return sensor.get("update_rate") == "0"

    def check(self, sensor: Sensor) -> Iterator[Diagnostic]:
        rate = sensor.element.find("update_rate")
        assert rate is not None
        yield self.diagnostic(rate.own_value, f"sensor `{sensor.name}` is updated in each step")
'''
MODEL = (
    '<sdf version="1.9"><model name="m"><link name="l"><sensor name="s" type="imu"><update_rate>0</update_rate>'
    "</sensor></link></model></sdf>"
)
MASS = '<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'
ROBOT = '<robot name="r"><link name="a"/></robot>'
REPORT = """
from sdfcheck.lint.run import Run


def render(run: Run) -> str:
    return f"{len(run.diagnostics)} in {len(run.files)}\\n"
"""


class Copy:
    """A copy of the program that may be changed."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        # With what Python has compiled, so that each start of the copy compiles the changes alone.
        shutil.copytree(ROOT / "sdfcheck", folder / "sdfcheck")
        shutil.copytree(ROOT / "rules", folder / "sdfcheck_rules")

    def add(self, name: str, text: str) -> None:
        path = self.folder / name
        assert not path.exists()
        path.write_text(text, encoding="utf-8")

    def change(self, name: str, old: str, new: str) -> None:
        path = self.folder / name
        text = path.read_text(encoding="utf-8")
        assert text.count(old) == 1
        path.write_text(text.replace(old, new), encoding="utf-8")

    def python(self, *arguments: str) -> str:
        """The output of a module of the copy."""
        environment = {**os.environ, "PYTHONPATH": str(self.folder)}
        command = [sys.executable, "-m", *arguments]
        done = subprocess.run(
            command, capture_output=True, text=True, check=False, env=environment, cwd=self.folder
        )
        assert done.returncode in {0, 1}, done.stderr
        return done.stdout


@pytest.fixture
def copy(tmp_path: Path) -> Iterator[Copy]:
    made = Copy(tmp_path)
    (tmp_path / "m.sdf").write_text(MODEL)
    (tmp_path / "r.urdf").write_text(ROBOT)
    yield made
    shutil.rmtree(tmp_path)


def test_a_rule_is_one_file(copy: Copy) -> None:
    copy.add("sdfcheck_rules/gaz/sleeping_sensor.py", RULE)
    for generator in ("index", "conditions"):
        copy.python(f"sdfcheck.lint.rulebook.{generator}")
    shown = copy.python("sdfcheck", "lint", "--isolated", "--output-format", "concise", "m.sdf")
    assert "m.sdf:1:92: warning: sensor `s` is updated in each step [GAZ900]" in shown
    assert "sleeping-sensor" in copy.python("sdfcheck", "rules", "GAZ")


def test_a_report_is_one_module_and_its_name(copy: Copy) -> None:
    copy.add("sdfcheck/report/formats/tally.py", REPORT)
    copy.change(
        "sdfcheck/report/__init__.py", '    HTML = "html"\n', '    HTML = "html"\n    TALLY = "tally"\n'
    )
    shown = copy.python("sdfcheck", "lint", "--isolated", "--output-format", "tally", "r.urdf")
    assert shown.endswith(" in 1\n")


def test_every_report_is_documented() -> None:
    text = (ROOT / "docs" / "output.md").read_text(encoding="utf-8")
    assert [kind.value for kind in OutputFormat if f"`{kind.value}`" not in text] == []


def test_a_consumer_is_one_line_and_measured_by_nobody(copy: Copy) -> None:
    copy.change(
        "sdfcheck/consumers/reaction.py",
        '    ISAAC = "isaac"',
        '    WEBOTS = "webots", "Webots", ("urdf",)\n    ISAAC = "isaac"',
    )
    shown = copy.python("sdfcheck", "targets", "--isolated", "--target", "webots", "r.urdf")
    assert re.search(r"^webots +not measured", shown, re.MULTILINE)
    assert "not read" in copy.python("sdfcheck", "targets", "--isolated", "--target", "webots", "m.sdf")


HINTED = (
    f'<robot name="r"><link name="a">{MASS}</link><link name="b">{MASS}</link>'
    '<joint name="j" type="fixed"><parent link="a"/><child link="b"/></joint>'
    '<gazebo reference="j"><keepFixedJoint>{}</keepFixedJoint></gazebo></robot>'
)


@pytest.mark.parametrize(
    ("way", "value", "before", "after"),
    [(("--like", "gazebo"), "true", 1, 2), (("--fixed-joints", "merge"), "false", 2, 1)],
)
def test_which_links_merge_is_decided_once(
    way: tuple[str, str], value: str, before: int, after: int, copy: Copy
) -> None:
    """A word that keeps joints is written once, for all that merge links."""
    (copy.folder / "r.urdf").write_text(HINTED.replace("{}", value))
    command = ("sdfcheck", "convert", "urdf-to-sdf", "--isolated", "r.urdf", *way)
    assert copy.python(*command).count("<link ") == before
    copy.change(
        "sdfcheck/robot/graph.py",
        '("preserveFixedJoint", ',
        '("keepFixedJoint", "preserveFixedJoint", ',
    )
    assert copy.python(*command).count("<link ") == after
