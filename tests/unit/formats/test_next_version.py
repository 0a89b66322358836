"""A new version of SDFormat is a change of data: a row of the table, and the number of the newest version."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import sdfcheck

PACKAGE = Path(sdfcheck.__file__).parent
RULES = PACKAGE.parent / "rules"
LINK = '<sdf version="1.{}"><model name="m"><link name="l" grip="{}"/></model></sdf>'


@pytest.fixture(scope="module")
def following(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of sdfcheck that knows a version more, in which links have an attribute `grip`."""
    copy = tmp_path_factory.mktemp("following")
    shutil.copytree(PACKAGE, copy / "sdfcheck")
    shutil.copytree(RULES, copy / "sdfcheck_rules", ignore=shutil.ignore_patterns("conditions*"))
    change(
        copy / "sdfcheck/formats/data/sdf.txt",
        "\nlink\t",
        "\n @name",
        "\n @grip\t13-\tdouble\t0\t1.0\n @name",
    )
    change(copy / "sdfcheck/formats/version.py", "", "Version(1, 12)", "Version(1, 13)")
    return copy


def change(file: Path, after: str, before: str, now: str) -> None:
    """Replace the first text ``before`` that comes after another one."""
    head, found, tail = (
        file.read_text("utf-8").partition(after) if after else ("", "", file.read_text("utf-8"))
    )
    assert before in tail
    file.write_text(head + found + tail.replace(before, now, 1), encoding="utf-8")


def run(following: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    environment = {**os.environ, "PYTHONPATH": str(following), "PYTHONDONTWRITEBYTECODE": "1"}
    return subprocess.run(
        [sys.executable, "-m", "sdfcheck", *arguments],
        cwd=following,
        env=environment,
        capture_output=True,
        text=True,
        check=False,
    )


@pytest.mark.parametrize(
    ("minor", "value", "said"),
    [
        (13, "2.5", "All clear"),
        (13, "wide", "`wide`"),
        (12, "2.5", "1.13"),
    ],
)
def test_the_attribute_is_known_from_that_version_on(
    following: Path, minor: int, value: str, said: str
) -> None:
    (following / "m.sdf").write_text(LINK.format(minor, value))
    done = run(following, "lint", "--isolated", "--ignore", "INR", "m.sdf")
    assert said in done.stdout + done.stderr
    assert done.returncode == (0 if said == "All clear" else 1)


def test_conversions_reach_it_and_say_what_older_versions_lack(following: Path) -> None:
    (following / "m.sdf").write_text(LINK.format(13, "2.5"))
    older = run(following, "convert", "sdf-to-sdf", "--sdf-version", "1.12", "m.sdf")
    assert 'version="1.12"' in older.stdout
    assert "grip=" not in older.stdout
    assert "grip" in older.stderr
    (following / "old.sdf").write_text('<sdf version="1.12"><model name="m"><link name="l"/></model></sdf>')
    newer = run(following, "convert", "sdf-to-sdf", "--sdf-version", "1.13", "old.sdf")
    assert 'version="1.13"' in newer.stdout
    described = run(following, "describe", "link/@grip", "--sdf-version", "1.13")
    assert "1.13" in described.stdout
