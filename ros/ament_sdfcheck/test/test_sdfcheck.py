"""The command writes what colcon reads, and fails for what fails a run."""

from __future__ import annotations

from pathlib import Path
from xml.etree import ElementTree

import pytest
from ament_sdfcheck.main import main

SOUND = '<robot name="r"><link name="base"/></robot>'
BROKEN = '<robot name="r"><link name="base"/><link name="base"/></robot>'


@pytest.mark.linter
@pytest.mark.sdfcheck
def test_own_files() -> None:
    assert main([]) == 0


def test_a_finding_fails_and_is_written(tmp_path: Path) -> None:
    (tmp_path / "good.urdf").write_text(SOUND)
    (tmp_path / "bad.urdf").write_text(BROKEN)
    results = tmp_path / "sdfcheck.xunit.xml"
    assert main(["--xunit-file", str(results), str(tmp_path)]) == 1
    root = ElementTree.parse(results).getroot()
    assert root.tag == "testsuites"
    assert {Path(suite.get("name", "")).name: suite.get("failures") for suite in root} == {
        "good.urdf": "0",
        "bad.urdf": "1",
    }


def test_files_can_be_left_out(tmp_path: Path) -> None:
    (tmp_path / "good.urdf").write_text(SOUND)
    (tmp_path / "bad.urdf").write_text(BROKEN)
    assert main([str(tmp_path), "--exclude", str(tmp_path / "bad.urdf")]) == 0
