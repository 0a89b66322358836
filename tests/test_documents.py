"""Commands and suppressions of the documents work, and so do fixes after both."""

from __future__ import annotations

import json
import re
import shlex
from collections.abc import Iterator
from pathlib import Path

import pytest

from sdfcheck.cli.main import main
from sdfcheck.lint.example import Bad, fill, unmark
from sdfcheck.lint.rulebook.trial import Trial, file_name
from sdfcheck.lint.suppress.rules import FACTS
from tests.test_rules import TRIALS

ROOT = Path(__file__).parents[1]
PAGES = sorted([ROOT / "README.md", *(ROOT / "docs").glob("*.md")])
_BLOCK = re.compile(r"^```(?:console|sh|yaml)?\n(.*?)^```$", re.MULTILINE | re.DOTALL)
_XML = re.compile(r"^```xml\n(.*?)^```$", re.MULTILINE | re.DOTALL)
_COMMAND = re.compile(r"^[ \t]*(?:\$ |- (?:script|run): )?(sdfcheck [a-z].*)$", re.MULTILINE)
_ELSEWHERE = {"tutorial.md", "packs.md"}
"""Pages whose commands other tests run, with the files that the pages are about."""
_OWN = {facts.code for facts in FACTS}
_MOVED = {"PYB002"}
"""Where a long line is broken: the comment itself moves the place."""
ROBOT = """<robot name="robot" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="arm" default="right"/>
  <link name="base"/>
  <link name="$(arg arm)_arm"/>
  <joint name="j" type="fixed"><parent link="base"/><child link="$(arg arm)_arm"/></joint>
</robot>
"""


def commands() -> Iterator[tuple[str, str]]:
    for page in PAGES:
        if page.name not in _ELSEWHERE:
            for block in _BLOCK.findall(page.read_text(encoding="utf-8")):
                yield from ((page.name, command) for command in _COMMAND.findall(block))


COMMANDS = sorted(set(commands()))


def furnish(folder: Path) -> None:
    """Write the files that the documents name."""
    (folder / "my_robot").mkdir()
    (folder / "worlds").mkdir()
    (folder / "robots").mkdir()
    (folder / "robot.urdf.xacro").write_text(ROBOT)
    courier = ROOT / "fixtures" / "tutorial" / "courier.urdf"
    text = courier.read_text().replace('"mats"', '"mast"')
    text = text.replace('lower="1.57" upper="-1.57"', 'lower="-1.57" upper="1.57"')
    for name in ("robot", "bot", "lamp", "old", "before", "robots/one", "my_robot/robot"):
        (folder / f"{name}.urdf").write_text(text)
    model = '<sdf version="1.9"><model name="arm"><link name="hand"/></model></sdf>'
    for name in ("model", "new", "after", "a"):
        (folder / f"{name}.sdf").write_text(model)
    world = '<sdf version="1.9"><world name="w"><model name="m"><link name="l"/></model></world></sdf>'
    for name in ("world.sdf", "worlds/world.sdf"):
        (folder / name).write_text(world)


@pytest.mark.parametrize(("page", "command"), COMMANDS)
def test_commands_run(
    page: str,
    command: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    (tmp_path / "work").mkdir()
    furnish(tmp_path / "work")
    (tmp_path / "arm").mkdir()
    monkeypatch.chdir(tmp_path / "work")
    monkeypatch.setattr("click.launch", lambda *_, **__: 0)  # no browser opens
    command = re.sub(r"\$[({][\w.]+[)}]", ".", command)
    name, *arguments = shlex.split(command, comments=True)
    assert name == "sdfcheck"
    if arguments[0] == "server":
        arguments.append("--help")
    before = contents()
    given = [
        str(path) for word in arguments for path in (sorted(Path().glob(word)) if "*" in word else [word])
    ]
    code = main(given)
    said = capsys.readouterr()
    assert code in {0, 1}, said.err
    assert "internal error" not in said.err
    if contents() != before:
        assert main(["lint", "--fix", "--exit-zero", "."]) == 0


def contents() -> dict[Path, bytes]:
    return {path: path.read_bytes() for path in Path().rglob("*") if path.is_file()}


def test_files_that_the_documents_name_are_fixed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    furnish(tmp_path)
    monkeypatch.chdir(tmp_path)
    before = contents()
    assert main(["lint", "--fix", "--exit-zero", "."]) == 0
    assert contents() != before


def test_the_documents_have_commands() -> None:
    assert len(COMMANDS) > 30


def wrapped(text: str) -> tuple[str, str]:
    """A whole document around a fragment, and the name of its file."""
    body = re.sub(r"<!--.*?-->", "", text, flags=re.DOTALL).strip()
    if body.startswith("<robot"):
        return text, "a.urdf"
    if body.startswith("<sdf"):
        return text, "a.sdf"
    if 'xyz="' in text or "<parent link" in text:
        mast = '<link name="mast"><inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0"'
        return f'<robot name="r">{mast} izz="0.01"/></inertial></link>\n{text}</robot>', "a.urdf"
    return f'<sdf version="1.9"><model name="m">\n{text}</model></sdf>', "a.sdf"


SUPPRESSIONS = [
    (page.name, block)
    for page in PAGES
    for block in _XML.findall(page.read_text(encoding="utf-8"))
    if re.search(r"<!--\s*sdfcheck\s*:", block)
]


@pytest.mark.parametrize(("page", "block"), SUPPRESSIONS)
def test_suppressions_silence_something_and_survive_fixes(
    page: str, block: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text, name = wrapped(block)
    file = tmp_path / name
    file.write_text(text, encoding="utf-8")
    asked = ["lint", "--isolated", "--output-format", "json", str(file)]
    assert main(asked) in {0, 1}
    report = json.loads(capsys.readouterr().out)
    assert _OWN.isdisjoint(each["code"] for each in report["diagnostics"]), report["diagnostics"]
    comments = len(re.findall(r"sdfcheck:\s*(?:ignore|disable)", block))
    assert report["summary"]["suppressed"] >= comments
    main([*asked, "--fix", "--unsafe-fixes"])
    after = json.loads(capsys.readouterr().out)
    assert after["summary"]["suppressed"] == report["summary"]["suppressed"]
    assert _OWN.isdisjoint(each["code"] for each in after["diagnostics"])


def test_the_documents_have_suppressions() -> None:
    assert {page for page, _ in SUPPRESSIONS} >= {"README.md", "linting.md", "tutorial.md"}


def firsts() -> Iterator[Trial]:
    seen = set()
    for trial in TRIALS:
        if trial.kind == "bad" and trial.rule.code not in seen:
            seen.add(trial.rule.code)
            yield trial


@pytest.mark.parametrize("trial", list(firsts()), ids=repr)
def test_the_comment_on_the_page_of_a_rule_turns_it_off(
    trial: Trial, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    example, code = trial.example, trial.rule.code
    assert isinstance(example, Bad)
    for name, content in (example.files or {}).items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(content, encoding="utf-8")
    text = unmark(fill(trial.rule.scaffold, example))[0]
    file = tmp_path / file_name(text, example)
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text, encoding="utf-8")
    asked = ["lint", "--isolated", "--select", f"{code},SUP", "--output-format", "json", str(file)]

    def found(*options: str) -> list[str]:
        assert main([*asked, *options]) in {0, 1}
        return [each["code"] for each in json.loads(capsys.readouterr().out)["diagnostics"]]

    if code in _OWN | _MOVED:
        pytest.skip("the comment is what it is about, or moves it")
    assert main(["lint", "--isolated", "--select", code, "--add-ignore", "-q", str(file)]) in {0, 1}
    capsys.readouterr()
    if file.read_text(encoding="utf-8") == text:
        if code not in found():
            pytest.skip("the example needs more than its file")
        assert trial.rule.__module__.split(".")[-2] == "xml", "only a broken text has no place for a comment"
        return
    assert found() == []
    assert found("--fix", "--unsafe-fixes") == []
    assert "sdfcheck:" in file.read_text(encoding="utf-8")
