"""The pages of all built-in rules."""

from __future__ import annotations

import re
from collections import defaultdict
from functools import cache

import pytest

from sdfcheck.cli.main import COMMANDS, main
from sdfcheck.lint.rulebook.packs import load_index
from sdfcheck.report.manual import Manual, Manuals, record, render
from tests.each import each

COMMAND = re.compile(r"`sdfcheck ([^`]+)`")
INDEX = load_index()
MANUALS = Manuals(INDEX)
BY_CODE = {facts.code: facts for facts in INDEX.facts}


@cache
def page_of(code: str) -> Manual:
    return MANUALS.of(BY_CODE[code])


def named(name: str) -> Manual:
    return next(page_of(facts.code) for facts in INDEX.facts if facts.name == name)


def test_each_example_is_shown_with_its_report_and_is_not_both_wrong_and_right() -> None:
    each(map(page_of, BY_CODE), is_shown, lambda page: page.facts.code)


def is_shown(page: Manual) -> None:
    for example in page.bad:
        first = example.report.partition("\n")[0]
        assert f"[{page.facts.code}]: " in first, example.text
    assert page.sources
    assert page.since
    wrong, right = (
        {(example.name, example.text, tuple(example.files.items())) for example in examples}
        for examples in (page.bad, page.good)
    )
    assert not wrong & right


def test_no_two_pages_have_one_example() -> None:
    pages = defaultdict(set)
    for code in BY_CODE:
        page = page_of(code)
        for example in page.bad:
            pages[example.text, tuple(example.files.items())].add(page.facts.name)
    assert [names for names in pages.values() if len(names) > 1] == []


def test_the_way_to_fix_it_follows_the_description() -> None:
    page = named("missing-inertial")
    assert page.remedy.startswith("Give the link an `<inertial>` with its mass")
    text = render(page)
    headings = [line for line in text.splitlines() if line.startswith("## ")]
    assert headings[:2] == ["## How to fix it", "## What consumers do"]
    assert f"## How to fix it\n\n{page.remedy}\n" in text
    assert "## How to fix it" not in render(page._replace(remedy=""))
    assert record(page)["remedy"] == page.remedy


REMEDIES = "\n".join(INDEX.rule(facts).remedy for facts in INDEX.facts)
COMMANDS_IN_USE = sorted({tuple(line.split()) for line in COMMAND.findall(REMEDIES)})


@pytest.mark.parametrize("command", COMMANDS_IN_USE, ids=" ".join)
def test_a_remedy_names_commands_that_exist(
    command: tuple[str, ...], capsys: pytest.CaptureFixture[str]
) -> None:
    name, *rest = command
    assert name in COMMANDS
    options = [option for option in rest if option.startswith("--")]
    main([*command[: 1 + (name == "convert")], "--help"])
    assert all(option in capsys.readouterr().out for option in options)
    if name in {"describe", "rule"} and not rest[0].endswith(("NAME", "ELEMENT")):
        assert main(list(command)) == 0


def test_consumers_are_a_table() -> None:
    text = render(named("several-parents"))
    assert "| Gazebo | accepts it | refuses the file; version 12 does not |\n" in text
    assert "| urdfdom | – |" in text


def test_fixes_are_shown_as_differences() -> None:
    text = render(named("undeclared-prefix"))
    assert "The fix:\n\n```diff\n-<sdf" in text
    assert "  = help: declare it on the root element (safe fix)\n" in text


def test_an_example_is_in_a_file_of_its_format() -> None:
    names = [example.name for example in named("absolute-path").bad]
    assert names[:4] == ["robot.sdf", "robot.urdf", "robot.sdf", "robot.urdf"]
