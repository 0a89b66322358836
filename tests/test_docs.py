"""The examples of the documentation work as they are printed; ``make golden`` writes the outputs again."""

from __future__ import annotations

import json
import re
import shlex
import shutil
from collections.abc import Iterator
from pathlib import Path
from xml.etree import ElementTree

import pytest
from jsonschema import Draft202012Validator

from sdfcheck.cli.main import main
from sdfcheck.release import HOME, rule_page

ROOT = Path(__file__).parents[1]
DOCS = ROOT / "docs"
PAGES = sorted([ROOT / "README.md", *DOCS.glob("*.md")])
_BLOCK = re.compile(r"^```(\w+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
EDITS = {
    "0.00003, 0.00018 and 0.00018": (
        'ixx="0.0001" ixy="0" ixz="0" iyy="0.0002" iyz="0" izz="0.01"',
        'ixx="0.00003" ixy="0" ixz="0" iyy="0.00018" iyz="0" izz="0.00018"',
    )
}
"""Words of the tutorial that ask for an edit → what is replaced, and by what."""


def blocks(page: Path, language: str) -> Iterator[str]:
    for match in _BLOCK.finditer(page.read_text(encoding="utf-8")):
        if match[1] == language:
            yield match[2]


def output(command: str, capsys: pytest.CaptureFixture[str]) -> str:
    arguments = shlex.split(command)
    assert arguments.pop(0) == "sdfcheck"
    main(arguments)
    said = capsys.readouterr()
    return said.out + said.err


def test_the_tutorial_shows_what_happens(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    request: pytest.FixtureRequest,
) -> None:
    shutil.copy(ROOT / "fixtures" / "tutorial" / "courier.urdf", tmp_path)
    monkeypatch.chdir(tmp_path)
    page = DOCS / "tutorial.md"
    text = page.read_text(encoding="utf-8")
    assert (
        next(blocks(page, "xml")).strip() == (tmp_path / "courier.urdf").read_text(encoding="utf-8").strip()
    )
    shown, at = "", 0
    for match in _BLOCK.finditer(text):
        for words, (old, new) in EDITS.items():
            if words in text[at : match.start()]:
                robot = tmp_path / "courier.urdf"
                robot.write_text(robot.read_text().replace(old, new))
        block = match[0]
        if match[1] == "console":
            command = match[2].partition("\n")[0]
            block = f"```console\n{command}\n{output(command.removeprefix('$ '), capsys)}```"
        shown += text[at : match.start()] + block
        at = match.end()
    shown += text[at:]
    if request.config.getoption("--golden"):
        page.write_text(shown, encoding="utf-8")
    assert shown == page.read_text(encoding="utf-8")


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_configurations_are_valid(
    page: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    for number, text in enumerate(blocks(page, "toml")):
        if "[build-system]" in text or "[project" in text:
            continue
        folder = tmp_path / str(number)
        folder.mkdir()
        name = "pyproject.toml" if "[tool.sdfcheck" in text else "sdfcheck.toml"
        (folder / name).write_text(text)
        monkeypatch.chdir(folder)
        main(["lint", "--show-settings", "--trust-config"])
        assert capsys.readouterr().err == ""
        if "plugins" not in text:
            assert main(["rules", "--trust-config"]) == 0, capsys.readouterr().err


def test_reports_follow_their_schema(capsys: pytest.CaptureFixture[str]) -> None:
    schema = json.loads((DOCS / "report.schema.json").read_text(encoding="utf-8"))
    main(["lint", "--isolated", "--output-format", "json", str(ROOT / "fixtures" / "robots")])
    report = json.loads(capsys.readouterr().out)
    assert len(report["diagnostics"]) > 20
    Draft202012Validator(schema).validate(report)
    for key in ("diagnostic", "place", "edit", "range", "position"):
        part = schema["$defs"][key]
        assert set(part["required"]) == set(part["properties"])
    found = report["diagnostics"][0]
    assert set(found) == set(schema["$defs"]["diagnostic"]["properties"]), "every key is documented"
    page = (DOCS / "output.md").read_text(encoding="utf-8")
    assert [key for key in (*report, *found, *report["summary"]) if f"`{key}`" not in page] == []


def test_badges_say_what_is_so() -> None:
    from tables.badges import FOLDER, badges

    for name, picture in badges().items():
        assert (FOLDER / name).read_text(encoding="utf-8") == picture, "make picture"
        assert {element.tag.rpartition("}")[2] for element in ElementTree.fromstring(picture).iter()} <= {
            *("svg", "title", "clipPath", "g", "rect", "text")
        }, "nothing that could load from elsewhere"
    (line,) = blocks(DOCS / "ci.md", "markdown")
    assert f"({rule_page('x').partition('rules/')[0]}assets/badge.svg)" in line
    assert f"]({HOME})" in line


def test_the_picture_of_the_readme_is_of_this_version() -> None:
    from tables.picture import PICTURE, report

    drawn = ElementTree.fromstring(PICTURE.read_text(encoding="utf-8"))
    rows: dict[float, str] = {}
    for text in drawn.iter("{http://www.w3.org/2000/svg}text"):
        if "clip-path" in text.attrib:
            rows[float(text.attrib["y"])] = rows.get(float(text.attrib["y"]), "") + "".join(text.itertext())
    drawn_rows = ["".join(row.split()) for _, row in sorted(rows.items())]
    lines = ["".join(line.split()) for line in re.sub(r"\x1b\[[0-9;]*m", "", report()).splitlines()]
    assert list(filter(None, drawn_rows)) == list(filter(None, lines)), "run `make picture`"
    assert "url(" not in PICTURE.read_text(encoding="utf-8").replace("url(#", "")
