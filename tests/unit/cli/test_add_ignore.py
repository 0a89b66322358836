"""``--add-ignore``: comments that silence what is found, with the real rules."""

from __future__ import annotations

import io
import shutil
import sys
from pathlib import Path

import pytest

from sdfcheck.cli.main import main

ROBOTS = Path(__file__).parents[3] / "fixtures" / "robots" / "with_mistakes"


class Shell:
    """Runs ``sdfcheck lint`` in a folder of its own."""

    def __init__(self, captured: pytest.CaptureFixture[str]) -> None:
        self._captured = captured
        self.out, self.err = "", ""

    def __call__(self, *arguments: str) -> int:
        code = main(["lint", "--isolated", "--color", "never", *arguments])
        self.out, self.err = self._captured.readouterr()
        return code

    def after(self, text: str, *arguments: str, name: str = "a.sdf") -> str:
        """The outcome for a file."""
        Path(name).write_bytes(text.encode())
        self(name, "--add-ignore", *arguments)
        return Path(name).read_bytes().decode()


@pytest.fixture
def lint(capfd: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Shell:
    monkeypatch.chdir(tmp_path)
    return Shell(capfd)


def model(inside: str) -> str:
    return (
        f'<sdf version="1.9">\n  <model name="m">\n    <link name="l"/>\n    {inside}\n  </model>\n</sdf>\n'
    )


def test_a_comment_goes_before_the_element(lint: Shell) -> None:
    text = model('<pose foo="1">0 0 x 0 0 0</pose>')
    comment = "<!-- sdfcheck: ignore[malformed-value, unknown-attribute] -->\n    "
    assert lint.after(text) == text.replace("<pose", f"{comment}<pose")
    assert lint.err == "Silenced 2 findings.\n"
    assert "All clear: 1 file, no findings (2 suppressed)." in lint.out


@pytest.mark.parametrize("end", ["\r\n", "\r", "\n"])
def test_lines_end_as_those_around_them(lint: Shell, end: str) -> None:
    text = model("\t<pose>x</pose>").replace("\n", end)
    comment = f"<!-- sdfcheck: ignore[malformed-value] -->{end}    \t"
    assert lint.after(text) == text.replace("<pose", f"{comment}<pose")


def test_within_a_line_the_line_stays_one(lint: Shell) -> None:
    text = '<sdf version="1.9"><model name="m"><link name="l"/><pose>x</pose></model></sdf>'
    comment = "<!-- sdfcheck: ignore[malformed-value] -->"
    assert lint.after(text) == text.replace("<pose", f"{comment}<pose")


def test_a_reason_is_given(lint: Shell) -> None:
    text = model("<pose>x</pose>")
    assert "<!-- sdfcheck: ignore[malformed-value] as measured -->\n" in lint.after(
        text, "--reason", "as measured"
    )


@pytest.mark.parametrize("reason", ["a -- b", "a-", "a\nb"])
def test_a_reason_must_fit_into_a_comment(lint: Shell, reason: str) -> None:
    Path("a.sdf").write_text(model(""))
    assert lint("a.sdf", "--add-ignore", "--reason", reason) == 2
    assert "cannot be in a comment" in lint.err


def test_a_comment_that_is_there_grows(lint: Shell) -> None:
    text = model('<!-- sdfcheck: ignore[NS001] mine -->\n    <pose foo="1">x</pose>')
    assert lint.after(text) == text.replace("[NS001]", "[NS001, malformed-value]")


@pytest.mark.parametrize(
    "inside",
    ["stray <pose>0 0 0 0 0 0</pose>", "<static>false</static>\n    stray", "<!-- a -- b -->", "a <foo/>"],
)
def test_findings_outside_of_elements_are_silenced_for_the_file(lint: Shell, inside: str) -> None:
    text = f'<?xml version="1.0"?>\n{model(inside)}'
    after = lint.after(text)
    first, second, rest = after.split("\n", 2)
    assert second.startswith("<!-- sdfcheck: ignore-file[")
    assert f"{first}\n{rest}" == text
    assert "All clear" in lint.out


def test_urdf_stays_free_of_colons_with_blanks(lint: Shell) -> None:
    text = '<robot name="r">\n  <link name="a"/>\n  <link name="a"/>\n</robot>\n'
    after = lint.after(text, name="a.urdf")
    assert "  <!-- sdfcheck:ignore[duplicate-name] -->\n  <link" in after
    assert "All clear" in lint.out


def test_findings_in_included_files_are_silenced_at_the_include(lint: Shell) -> None:
    Path("part").mkdir()
    Path("part/part.sdf").write_text('<sdf version="1.9"><model name="part"/></sdf>')
    text = model("<include>\n      <uri>part/part.sdf</uri>\n    </include>")
    comment = "<!-- sdfcheck: ignore[model-without-link] -->\n    "
    assert lint.after(text) == text.replace("<include", f"{comment}<include")
    assert "All clear" in lint.out


def test_macros_are_silenced_where_they_are_written(lint: Shell) -> None:
    prefix = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'
    macro = '<xacro:macro name="m" params="n">\n    <joint name="${n}" type="revolute">'
    ends = '<parent link="a"/><child link="b"/></joint>\n  </xacro:macro>'
    Path("library.xacro").write_text(f"<robot {prefix}>\n  {macro}{ends}\n</robot>\n")
    links = '<link name="a"/><link name="b"/>'
    call = '<xacro:include filename="library.xacro"/><xacro:m n="j"/>'
    Path("robot.xacro").write_text(f'<robot name="r" {prefix}>\n  {links}\n  {call}\n</robot>\n')
    assert lint(".", "--add-ignore", "--select", "URD005") == 0
    assert "\n    <!-- sdfcheck:ignore[missing-limit] -->\n    <joint" in Path("library.xacro").read_text()
    assert "sdfcheck" not in Path("robot.xacro").read_text()


def test_all_robots_with_mistakes_fall_silent_and_stay_the_same(lint: Shell, tmp_path: Path) -> None:
    shutil.copytree(ROBOTS, tmp_path, dirs_exist_ok=True)
    assert lint(".", "--add-ignore") == 0
    assert "All clear" in lint.out
    texts = {path: path.read_bytes() for path in tmp_path.rglob("*.*") if path.is_file()}
    assert sum(b"sdfcheck" in text for text in texts.values()) >= 5
    assert lint(".", "--add-ignore") == 0
    assert lint.err == "Nothing to silence.\n"
    assert texts == {path: path.read_bytes() for path in texts}


def test_a_diff_writes_nothing(lint: Shell) -> None:
    text = model("<pose>x</pose>")
    assert lint.after(text, "--diff") == text
    assert "+    <!-- sdfcheck: ignore[malformed-value] -->\n" in lint.out
    assert lint.err == "Would silence 1 of 1 finding.\n"


def test_stdin_goes_to_stdout(lint: Shell, monkeypatch: pytest.MonkeyPatch) -> None:
    class Stdin:
        buffer = io.BytesIO(model("<pose>x</pose>").encode())

    monkeypatch.setattr(sys, "stdin", Stdin)
    assert lint("-", "--add-ignore", "--stdin-filename", "a.sdf") == 0
    assert "    <!-- sdfcheck: ignore[malformed-value] -->\n    <pose>" in lint.out


@pytest.mark.parametrize("others", [("--fix",), ("--baseline", "b.json")])
def test_it_goes_alone(lint: Shell, others: tuple[str, ...]) -> None:
    assert lint("--add-ignore", *others) == 2
    assert "--add-ignore goes with neither --fix nor --baseline" in lint.err


def test_a_comment_before_a_part_of_what_the_rule_looks_at_is_unused(lint: Shell) -> None:
    text = (
        '<robot name="r"><link name="a"><inertial>\n<!-- sdfcheck:ignore[INR001] -->\n<mass value="{}"/>'
        '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link></robot>'
    )
    for mass, code in ("-1", 0), ("1", 1):
        Path("a.urdf").write_text(text.format(mass))
        assert lint("a.urdf", "--select", "INR001,SUP001") == code
