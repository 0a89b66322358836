"""Finding one's way: help, completion, a first configuration."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from sdfcheck.cli.convert.command import COMMANDS as CONVERSIONS
from sdfcheck.cli.main import COMMANDS, main
from sdfcheck.lint.config.settings import FIELDS
from sdfcheck.release import HOME

LINES = [[name] for name in COMMANDS if name != "convert"] + [["convert", name] for name in CONVERSIONS]


@pytest.mark.parametrize("line", LINES, ids=" ".join)
def test_help_is_in_sections_and_ends_with_examples(
    line: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    assert main([*line, "--help"]) == 0
    text = capsys.readouterr().out
    _, _, examples = text.partition("\nExamples:\n")
    assert examples.count(f"sdfcheck {' '.join(line)}") >= 2
    assert max(map(len, text.splitlines())) <= 100


def test_lint_lists_its_options_by_what_they_are_about(capsys: pytest.CaptureFixture[str]) -> None:
    main(["lint", "--help"])
    text = capsys.readouterr().out
    headings = [line for line in text.splitlines() if line.endswith(":") and not line.startswith(" ")]
    assert headings == [
        "Input:",
        "Selection:",
        "Fixes:",
        "Output:",
        "Exit code:",
        "Configuration:",
        "Other:",
        "Examples:",
    ]


def test_the_first_page_says_what_to_do_and_where_to_read(capsys: pytest.CaptureFixture[str]) -> None:
    main(["--help"])
    text = capsys.readouterr().out
    assert "To begin: `sdfcheck lint`" in text
    assert HOME in text


@pytest.mark.parametrize(
    ("word", "meant"),
    [
        ("explain", "sdfcheck rule"),
        ("check", "sdfcheck lint"),
        ("format", "sdfcheck print"),
        ("Fix", "sdfcheck lint --fix"),
    ],
)
def test_commands_are_found_by_meaning(word: str, meant: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main([word]) == 2
    assert f"no such command: {word}; try `{meant}" in capsys.readouterr().err


def test_a_misspelt_command_is_found_by_its_letters(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["lnit"]) == 2
    assert "; did you mean `lint`?" in capsys.readouterr().err


def test_config_lists_every_key(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    assert main(["config"]) == 0
    text = capsys.readouterr().out
    assert [field.key for field in FIELDS if f"{field.key} " not in text] == []
    schema = tmp_path / "schema.json"
    assert main(["config", "--output-format", "schema", "-o", str(schema)]) == 0
    assert schema.read_text() == Path(__file__).parents[3].joinpath("docs/sdfcheck.schema.json").read_text()


def test_init_writes_a_configuration_that_works(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(["init", "--target", "gazebo,drake"]) == 0
    file = tmp_path / "sdfcheck.toml"
    text = file.read_text()
    assert 'target = ["gazebo", "drake"]\n' in text
    # Each line that is a comment for now is valid once it is not.
    keys = [f"{field.key} = " for field in FIELDS]
    active = [
        line.removeprefix("# ")
        for line in text.splitlines()
        if line.startswith(tuple(f"# {key}" for key in (*keys, "[", '"')))
    ]
    assert len(active) >= 9
    file.write_text("\n".join(active) + "\n")
    capsys.readouterr()
    assert main(["lint", "--show-settings"]) == 0, capsys.readouterr().err
    before = file.read_bytes()
    assert main(["init"]) == 2
    assert "exists already" in capsys.readouterr().err
    assert file.read_bytes() == before


def test_init_knows_the_targets(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["init", str(tmp_path), "--target", "drak"]) == 2
    assert "did you mean `drake`" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


def completed(words: str, number: int) -> list[str]:
    """The words that bash is offered in the place of that number."""
    code = "from sdfcheck.cli.main import run; run()"
    environment = {
        **os.environ,
        "_SDFCHECK_COMPLETE": "bash_complete",
        "COMP_WORDS": words,
        "COMP_CWORD": str(number),
    }
    done = subprocess.run(
        [sys.executable, "-c", code], env=environment, capture_output=True, text=True, check=False
    )
    assert done.stderr == ""
    return [line.partition(",")[2] for line in done.stdout.splitlines()]


@pytest.mark.parametrize(
    ("words", "number", "offered"),
    [
        ("sdfcheck comp", 1, "completion"),
        ("sdfcheck lint --select NS00", 3, "NS003"),
        ("sdfcheck lint --select NS003,undeclared-p", 3, "NS003,undeclared-prefix"),
        ("sdfcheck lint --output-format sar", 3, "sarif"),
        ("sdfcheck lint --target dr", 3, "drake"),
        ("sdfcheck rule inverted-l", 2, "inverted-limits"),
        ("sdfcheck lint --ignore N", 3, "NS"),
        ("sdfcheck lint --output-format jso", 3, "jsonl"),
        ("sdfcheck graph joints a.sdf --output-format mer", 5, "mermaid"),
        ("sdfcheck convert sdf-to-sdf --sdf-version 1.1", 4, "1.11"),
        ("sdfcheck describe joint/ax", 2, "joint/axis"),
        ("sdfcheck describe drake:proximity_prop", 2, "drake:proximity_properties"),
        ("sdfcheck describe urdf:joint/lim", 2, "urdf:joint/limit"),
    ],
)
def test_shells_complete(words: str, number: int, offered: str) -> None:
    assert offered in completed(words, number)


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_the_script_of_a_shell(shell: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["completion", shell]) == 0
    assert "_SDFCHECK_COMPLETE" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("option", "meant"),
    [
        ("--json", "--output-format json"),
        ("--reporter", "--output-format"),
        ("--xacro-args", "NAME:=VALUE"),
        ("--selcet", "--select"),
    ],
)
def test_options_of_other_programs_lead_to_those_of_this_one(
    option: str, meant: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["lint", option, "x"]) == 2
    assert f"no such option: {option}; try `{meant}`" in capsys.readouterr().err


def test_an_option_that_a_command_lacks_is_not_proposed(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["diff", "--autofix", "x", "y"]) == 2
    assert capsys.readouterr().err.endswith("no such option: --autofix\n")
