"""The page about packs: what it shows is the pack below ``fixtures/packs/workshop``, and runs."""

from __future__ import annotations

import re
import shlex
import subprocess
import sys
from pathlib import Path

import pytest

from sdfcheck.cli.main import main
from sdfcheck.testing import FaultyRule, Trial, check_pack, examples

ROOT = Path(__file__).parents[3]
WORKSHOP = ROOT / "fixtures" / "packs" / "workshop"
PAGE = (ROOT / "docs" / "packs.md").read_text(encoding="utf-8")


def blocks(language: str) -> list[str]:
    return re.findall(rf"^```{language}\n(.*?)^```$", PAGE, re.MULTILINE | re.DOTALL)


@pytest.mark.parametrize("example", examples(WORKSHOP / "workshop_rules"), ids=str)
def test_the_examples_of_the_pack(example: Trial | FaultyRule) -> None:
    example.check()


def test_the_files_of_the_page_are_those_of_the_pack() -> None:
    shown = [
        "workshop_rules/fast_camera.py",
        "workshop_rules/zero_effort.py",
        "workshop_rules/shared_topic.py",
        "workshop_rules/center_outside_shapes.py",
        "tests/test_rules.py",
        "sdfcheck.toml",
        "pyproject.toml",
    ]
    texts = [(WORKSHOP / name).read_text(encoding="utf-8") for name in shown]
    assert [*blocks("python"), *blocks("toml")] == texts


@pytest.mark.parametrize("block", blocks("console"))
def test_the_commands_of_the_page(
    block: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(WORKSHOP)
    command, _, expected = block.partition("\n")
    main(shlex.split(command.removeprefix("$ sdfcheck ")))
    assert capsys.readouterr() == (expected, "")


def test_the_failure_of_the_page(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    folder = tmp_path / "workshop_rules"
    folder.mkdir()
    rule = (WORKSHOP / "workshop_rules" / "fast_camera.py").read_text(encoding="utf-8")
    (folder / "fast_camera.py").write_text(rule.replace("«200»", "«50»"), encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    with pytest.raises(AssertionError) as caught:
        check_pack(folder)
    assert str(caught.value) in PAGE


def test_the_test_suite_of_the_pack() -> None:
    own = ["-c", "pyproject.toml", "-p", "no:cacheprovider", "-p", "no:xdist"]
    command = [sys.executable, "-B", "-m", "pytest", "-q", *own, "tests"]
    done = subprocess.run(command, cwd=WORKSHOP, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout
    assert "16 passed" in done.stdout
