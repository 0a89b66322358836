"""The manual page and the recipes of packages say what the program and pyproject.toml say."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from sdfcheck.cli.convert.command import COMMANDS as CONVERSIONS
from sdfcheck.cli.main import COMMANDS, main
from tables.man_page import page

ROOT = Path(__file__).parents[1]
_OPTION = re.compile(r"^ +(?:-\w, )?(--[\w-]+)", re.MULTILINE)


@pytest.mark.parametrize("name", [*(name for name in COMMANDS if name != "convert"), *CONVERSIONS])
def test_the_manual_page_has_each_option(name: str, capsys: pytest.CaptureFixture[str]) -> None:
    path = f"convert {name}" if name in CONVERSIONS else name
    section = page().replace("\\-", "-").partition(f"\n.SS {path}\n")[2].partition("\n.S")[0]
    main([*path.split(), "--help"])
    options = set(_OPTION.findall(capsys.readouterr().out)) - {"--help"}
    assert {option for option in options if option not in section} == set()


def test_nothing_in_the_manual_page_is_a_command_by_accident() -> None:
    lines = [line for line in page().splitlines() if line.startswith((".", "'"))]
    assert {line.partition(" ")[0] for line in lines} == {".TH", ".SH", ".SS", ".PP", ".TP", ".B"}


def test_the_recipe_asks_for_what_the_package_needs() -> None:
    project = (ROOT / "pyproject.toml").read_text()
    needs = re.findall(
        r'^    "([^";]+)",$', project.partition("\ndependencies = [\n")[2].partition("\n]")[0], re.MULTILINE
    )
    python = re.findall(r'^requires-python = "(.*)"$', project, re.MULTILINE)
    run = (
        (ROOT / "packaging" / "conda" / "meta.yaml").read_text().partition("  run:\n")[2].partition("\n\n")[0]
    )
    asked = [line.removeprefix("    - ").replace(" ", "") for line in run.splitlines()]
    assert asked == [f"python{python[0]}", *needs]
