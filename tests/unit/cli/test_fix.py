"""``--fix`` and ``--diff``, with the real rules."""

from __future__ import annotations

import io
import json
import os
import stat
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from sdfcheck.cli.main import main
from sdfcheck.lint.one_file import Selected, lint_file

WRONG = b"""\xef\xbb\xbf<?xml version="1.0"?>\r
<!-- a -- b, caf\xc3\xa9 -->\r
<sdf version='1.9'>\r
  <world name="w"><drake:a/></world>\r
</sdf>"""
LATIN = """<?xml version="1.0" encoding="latin-1"?>
<!-- -- käse -->
<sdf version="1.9"><world name="w"/></sdf>
""".encode("latin-1")


class Shell:
    """Runs ``sdfcheck lint`` in a folder of its own."""

    def __init__(self, capfdbinary: pytest.CaptureFixture[bytes]) -> None:
        self._captured = capfdbinary
        self.out, self.err = b"", ""

    def __call__(self, *arguments: str) -> int:
        code = main(["lint", "--isolated", "--color", "never", *arguments])
        sys.stdout.flush()
        self.out, err = self._captured.readouterr()
        self.err = err.decode()
        return code


@pytest.fixture
def lint(capfdbinary: pytest.CaptureFixture[bytes], monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Shell:
    monkeypatch.chdir(tmp_path)
    Path("a.sdf").write_bytes(WRONG)
    return Shell(capfdbinary)


def test_fixing_changes_nothing_but_the_mistakes(lint: Shell) -> None:
    Path("a.sdf").chmod(0o640)
    lint("--fix", "a.sdf")
    fixed = Path("a.sdf").read_bytes()
    assert fixed.startswith(b'\xef\xbb\xbf<?xml version="1.0"?>\r\n<!-- a - - b, caf\xc3\xa9 -->\r\n')
    assert fixed.count(b"\r\n") == 4 == fixed.count(b"\n")
    assert b"<sdf version='1.9' xmlns:drake=" in fixed
    assert stat.S_IMODE(Path("a.sdf").stat().st_mode) == 0o640
    assert b"Fixed 2 of 3 findings." in lint.out
    assert os.listdir() == ["a.sdf"]


def test_fixing_twice_is_fixing_once(lint: Shell) -> None:
    lint("--fix")
    once, stamp = Path("a.sdf").read_bytes(), Path("a.sdf").stat().st_mtime_ns
    lint("--fix")
    assert Path("a.sdf").read_bytes() == once
    assert Path("a.sdf").stat().st_mtime_ns == stamp, "written without need"
    assert b"Fixed" not in lint.out


def test_a_bug_on_one_file_does_not_keep_others_from_being_fixed(
    lint: Shell, monkeypatch: pytest.MonkeyPatch
) -> None:
    def faulty(file: Selected, *given: Any) -> Any:
        if file.path.name == "b.sdf":
            raise ValueError("no luck")
        return lint_file(file, *given)

    Path("b.sdf").write_bytes(WRONG)
    monkeypatch.setattr("sdfcheck.lint.session.lint_file", faulty)
    assert lint("--fix", "a.sdf", "b.sdf") == 2
    assert Path("a.sdf").read_bytes() != WRONG == Path("b.sdf").read_bytes()
    assert b"Fixed 2 of 3 findings." in lint.out
    assert lint.err.count("b.sdf: internal error: ValueError: no luck") == 1


def test_the_summary_says_how_much_was_fixed(lint: Shell) -> None:
    Path("a.sdf").write_text('<sdf version="1.9"><!-- -- --><world name="w"><light/></world></sdf>')
    assert lint("--fix", "--output-format", "json", "--select", "XML,SCH", "a.sdf") == 1
    summary = json.loads(lint.out)["summary"]
    assert summary["fixed"] == 1
    left = summary["errors"] + summary["warnings"] + summary["infos"]
    assert lint.err.startswith(f"Fixed 1 of {1 + left} findings. Found ")


def test_all_fixed_is_clean(lint: Shell) -> None:
    Path("a.sdf").write_bytes(LATIN)
    assert lint("--fix", "a.sdf") == 0
    assert Path("a.sdf").read_bytes() == LATIN.replace(b"-- -- k", b"-- - - k")


def test_a_diff_shows_and_writes_nothing(lint: Shell) -> None:
    assert lint("--diff", "a.sdf") == 1
    assert Path("a.sdf").read_bytes() == WRONG
    lines = lint.out.decode().split("\n")
    assert lines[:4] == ["--- a/a.sdf", "+++ b/a.sdf", "@@ -1,5 +1,5 @@", ' \ufeff<?xml version="1.0"?>\r']
    assert "-<!-- a -- b, café -->\r" in lines
    assert "+<!-- a - - b, café -->\r" in lines
    assert "\\ No newline at end of file" in lines
    assert lint.err == "Would fix 2 of 3 findings.\n"
    assert lint("--diff", "--exit-zero", "a.sdf") == 0


def test_a_diff_can_be_applied(lint: Shell) -> None:
    lint("--diff", "a.sdf")
    Path("a.patch").write_bytes(lint.out)
    lint("--fix", "a.sdf")
    fixed = Path("a.sdf").read_bytes()
    Path("a.sdf").write_bytes(WRONG)
    patched = subprocess.run(["git", "apply", "a.patch"], capture_output=True, text=True, check=False)
    assert patched.returncode == 0, patched.stderr
    assert Path("a.sdf").read_bytes() == fixed


def test_nothing_to_fix_is_no_difference(lint: Shell) -> None:
    Path("a.sdf").write_text('<sdf version="1.9"><world name="w"><light/></world></sdf>')
    assert lint("--diff", "a.sdf") == 0
    assert lint.out == b""
    assert lint.err == "Nothing to fix.\n"


def test_a_silenced_finding_is_not_fixed(lint: Shell) -> None:
    silent = '<sdf version="1.9"><!-- sdfcheck: ignore-file --><!-- -- --><world name="w"/></sdf>'
    Path("a.sdf").write_text(silent)
    assert lint("--fix", "a.sdf") == 0
    assert Path("a.sdf").read_text() == silent


def test_stdin_is_fixed_to_stdout(lint: Shell, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO(LATIN)))
    assert lint("--fix", "--stdin-filename", "b.sdf", "-") == 0
    assert lint.out == LATIN.replace(b"-- -- k", b"-- - - k")
    assert lint.err.startswith("Fixed 1 finding. All clear")


def test_a_file_that_cannot_be_written_is_said(lint: Shell, monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(path: Path, data: bytes, *, instead: bool) -> None:
        raise PermissionError(13, "Permission denied", str(path))

    monkeypatch.setattr("sdfcheck.cli.rewrite.overwrite", fail)
    assert lint("--fix", "a.sdf") == 2
    assert lint.err == "error: a.sdf: cannot be written: Permission denied\n"
    assert Path("a.sdf").read_bytes() == WRONG


def test_a_refusal_is_said_and_writes_nothing(lint: Shell) -> None:
    # A byte that the declared encoding leaves undefined cannot be written back.
    text = (
        b'<?xml version="1.0" encoding="cp1252"?><!-- -- \x81 --><sdf version="1.9"><world name="w"/></sdf>'
    )
    Path("a.sdf").write_bytes(text)
    assert lint("--fix", "a.sdf") == 1
    assert lint.err == "warning: a.sdf: not fixed: its bytes are not cp1252 throughout\n"
    assert Path("a.sdf").read_bytes() == text


def test_a_file_that_only_an_include_leads_to_is_not_fixed(lint: Shell) -> None:
    Path("part.sdf").write_text('<sdf version="1.9"><model name="m"><link name="l"/><drake:x/></model></sdf>')
    Path("a.sdf").write_text(
        '<sdf version="1.9"><world name="w"><include><uri>part.sdf</uri></include></world></sdf>'
    )
    before = Path("part.sdf").read_bytes()
    lint("--fix", "a.sdf")
    assert Path("part.sdf").read_bytes() == before
    lint("--fix", "a.sdf", "part.sdf")
    assert Path("part.sdf").read_bytes() != before


MISSPELLED = """<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
<link name="base"/>
<xacro:macro name="wheel" params="side radius:=1"><link name="${side}_wheel"/>
<joint name="${side}" type="fixed"><parent link="base"/><child link="${side}_wheel"/></joint></xacro:macro>
<xacro:weel side="left"></xacro:weel>
<xacro:wheel side="right" raduis="2"/>
</robot>
"""


def test_fixes_are_listed_by_file_and_rule(lint: Shell) -> None:
    Path("b.urdf.xacro").write_text(MISSPELLED)
    lint("--fix", "--unsafe-fixes", "--show-fixes")
    assert lint.err.splitlines()[:6] == [
        "- a.sdf:",
        "    1 × NS003 undeclared-prefix: declare it on the root element",
        "    1 × XML002 double-hyphen-in-comment: put spaces between the hyphens",
        "- b.urdf.xacro:",
        "    1 × XAC003 undefined-macro: write `wheel`",
        "    1 × XAC008 wrong-macro-arguments: write `radius`",
    ]
    text = Path("b.urdf.xacro").read_text()
    assert '<xacro:wheel side="left"></xacro:wheel>' in text
    assert 'radius="2"' in text
    lint("--fix", "--unsafe-fixes", "--show-fixes")
    assert "×" not in lint.err


def test_a_diff_can_list_its_fixes_too(lint: Shell) -> None:
    assert lint("--diff", "--show-fixes", "a.sdf") == 1
    assert "    1 × NS003 undeclared-prefix" in lint.err
    assert Path("a.sdf").read_bytes() == WRONG
    assert lint("--show-fixes", "a.sdf") == 2
    assert "--show-fixes goes with" in lint.err


def test_fixing_only_reports_nothing_that_is_left(lint: Shell) -> None:
    Path("b.sdf").write_text('<sdf version="1.9"><model/></sdf>')
    assert lint("b.sdf") == 1
    before = Path("b.sdf").read_bytes()
    assert lint("--fix-only") == 0
    assert lint.out == b""
    assert lint.err == "Fixed 2 findings.\n"
    assert Path("a.sdf").read_bytes() != WRONG
    assert Path("b.sdf").read_bytes() == before
    assert lint("--fix-only") == 0
    assert lint.err == "Nothing to fix.\n"
    assert lint("--fix-only", "--quiet") == 0
    assert lint.err == ""
    assert lint("--fix-only", "--add-ignore") == 2


def test_errors_that_a_repaired_text_shows_stop_no_fix_of_it(
    tmp_path: Path, capfdbinary: pytest.CaptureFixture[bytes]
) -> None:
    """Tags without an end: once one of them has its end, the robot without a name is seen."""
    file = tmp_path / "r.urdf"
    file.write_bytes(b"<robot<a<a</robot>")
    shell = Shell(capfdbinary)
    shell("--fix", "--unsafe-fixes", str(file))
    once = file.read_bytes()
    shell("--fix", "--unsafe-fixes", str(file))
    assert file.read_bytes() == once == b"<robot><a></a></robot>"
