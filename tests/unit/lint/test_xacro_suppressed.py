"""Suppressions in the files that a xacro file includes."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.lint.config.configuration import Configuration
from sdfcheck.lint.session import Options, run

LIBRARY = """<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="wheel" params="side">
    {}<joint name="${{side}}" type="revolute">
      <parent link="base"/><child link="${{side}}_l"/>
    </joint>
    <link name="${{side}}_l"/>
  </xacro:macro>
</robot>
"""
ROBOT = """<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="library.xacro"/>
  <link name="base"/>
  {}<xacro:wheel side="left"/>
</robot>
"""
IGNORE = "<!-- sdfcheck:ignore[missing-limit] -->"


@pytest.mark.parametrize(("library", "robot", "left"), [("", "", 1), (IGNORE, "", 0), ("", IGNORE, 0)])
def test_a_macro_can_be_silenced_where_it_is_written_and_called(
    tmp_path: Path, library: str, robot: str, left: int
) -> None:
    (tmp_path / "library.xacro").write_text(LIBRARY.format(library))
    (tmp_path / "robot.urdf.xacro").write_text(ROBOT.format(robot))
    done = run([tmp_path], Options(Configuration(isolated=True)))
    found = [d.name for d in done.diagnostics if d.severity.value != "info"]
    assert found == ["missing-limit"] * left
    assert done.suppressed == 1 - left
