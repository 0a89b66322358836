"""One name for one thing: the options of all commands, held side by side."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

import click
import pytest

from sdfcheck.cli.convert.command import COMMANDS as CONVERSIONS
from sdfcheck.cli.main import COMMANDS, main
from sdfcheck.cli.parts.options import Renamed

ROBOTS = Path(__file__).parents[3] / "fixtures" / "robots"
SDF = str(next(ROBOTS.rglob("*.sdf")))
LAZY = {name: lazy for name, lazy in COMMANDS.items() if name != "convert"} | CONVERSIONS
COMMAND_OF = {name: lazy.load() for name, lazy in LAZY.items()}
SILENT = {"server", "init", "completion"}
"""The commands without a result that could go to a file."""
RETIRED = {
    "--format": "--output-format",
    "--output": "--output-file",
    "--to": "--sdf-version",
    "--expand": "--no-expand",
    "--exit-code": "--exit-zero",
    "--no-exit-code": "--exit-zero",
}
"""Former spelling → what every command says now."""


def options(command: click.Command, *, hidden: bool = False) -> Iterator[click.Option]:
    for parameter in command.params:
        if isinstance(parameter, click.Option) and (hidden or not parameter.hidden):
            yield parameter


def test_an_option_means_the_same_everywhere() -> None:
    seen: dict[str, dict[tuple[object, ...], list[str]]] = {}
    for name, command in COMMAND_OF.items():
        for option in options(command):
            long = max(option.opts, key=len)
            shape = (
                tuple(option.opts),
                option.is_flag,
                option.multiple or option.metavar == "CONSUMERS",
                option.metavar if option.metavar != "FORMAT[=FILE]" else None,
            )
            seen.setdefault(long, {}).setdefault(shape, []).append(name)
    different = {
        long: shapes for long, shapes in seen.items() if len(shapes) > 1 and long != "--output-format"
    }
    assert not different
    assert len(seen) > 50


@pytest.mark.parametrize("name", COMMAND_OF)
def test_former_spellings_are_not_listed(name: str, capsys: pytest.CaptureFixture[str]) -> None:
    listed = {spelling for option in options(COMMAND_OF[name]) for spelling in option.opts}
    assert not listed & RETIRED.keys()
    line = ["convert", name] if name in CONVERSIONS else [name]
    assert main([*line, "--help"]) == 0
    words = capsys.readouterr().out.split()
    assert not {word.rstrip(",") for word in words} & RETIRED.keys()


@pytest.mark.parametrize("name", sorted(COMMAND_OF.keys() - SILENT))
def test_a_result_can_go_to_a_file(name: str) -> None:
    (option,) = (one for one in options(COMMAND_OF[name]) if "--output-file" in one.opts)
    assert option.opts == ["-o", "--output-file"]


@pytest.mark.parametrize("name", COMMAND_OF)
def test_commands_with_colors_or_a_configuration_have_the_options_for_it(name: str) -> None:
    spelled = {spelling for option in options(COMMAND_OF[name]) for spelling in option.opts}
    assert len(spelled & {"--config", "--isolated", "--trust-config"}) in {0, 3}
    assert len(spelled & {"--package", "--package-path", "--model-path", "--env"}) in {0, 4}


def test_former_spellings_are_understood_for_a_version_more(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    renamed = {old for command in COMMAND_OF.values() for one in options(command) for old in _old(one)}
    assert renamed == {"--format", "--output", "--to"}
    monkeypatch.chdir(tmp_path)
    urdf = tmp_path / "r.urdf"
    urdf.write_text('<robot name="r"><link name="l"/></robot>')
    other = tmp_path / "other.urdf"
    other.write_text('<robot name="r"><link name="k"/></robot>')
    old = (
        ("graph joints {} --format tree", "graph joints {} --output-format text"),
        ("inertia {} --format table", "inertia {}"),
        ("inertia {} --format json", "inertia {} --output-format json"),
        ("lint {} --format concise", "lint {} --output-format concise"),
        ("convert urdf-to-sdf {} --to 1.9", "convert urdf-to-sdf {} --sdf-version 1.9"),
        ("convert urdf-to-sdf {} --expand never", "convert urdf-to-sdf {} --no-expand"),
        ("diff {} other.urdf --no-exit-code", "diff {} other.urdf --exit-zero"),
    )
    for pair in old:
        codes, texts = [], []
        for line in pair:
            codes.append(main([*line.replace("{}", str(urdf)).split(), "--isolated"]))
            texts.append(capsys.readouterr())
        assert codes[0] == codes[1] != 2
        assert texts[0] == texts[1]
    assert main(["convert", "urdf-to-sdf", str(urdf), "--output", "r.sdf"]) == 0
    assert main(["convert", "sdf-to-urdf", "r.sdf", "--package-uris", "--output", "back.urdf"]) == 0
    assert Path("back.urdf").exists()


def _old(option: click.Option) -> tuple[str, ...]:
    return option.old if isinstance(option, Renamed) else ()


@pytest.mark.parametrize(
    "line",
    [
        "lint {} --isolated --exit-zero",
        "lint {} --isolated --output-format json --exit-zero",
        "graph frames {}",
        "targets {} --output-format json",
        "describe joint",
        "inertia {}",
        "print {}",
        "rules NS",
        "rule NS003",
        "config",
        "schema --sdf-version 1.9",
        "convert sdf-to-sdf {} --sdf-version 1.12",
        "diff {} {}",
    ],
)
def test_a_file_gets_what_stdout_gets(line: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    words = line.replace("{}", SDF).split()
    code = main(words)
    shown = capsys.readouterr().out
    file = tmp_path / "result"
    assert main([*words, "-o", str(file)]) == code
    assert capsys.readouterr().out == ""
    assert file.read_text(encoding="utf-8") == shown != ""
    file.unlink()
    assert main([*words, "-o", "-"]) == code
    assert capsys.readouterr().out == shown


@pytest.mark.parametrize("command", ["graph joints", "targets", "inertia", "print", "view", "lint"])
def test_an_input_is_never_written_over(
    command: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "m.sdf"
    file.write_bytes(Path(SDF).read_bytes())
    assert main([*command.split(), str(file), "-o", str(file)]) == 2
    assert "is an input" in capsys.readouterr().err
    assert file.read_bytes() == Path(SDF).read_bytes()


@pytest.mark.parametrize(
    ("words", "meant"),
    [
        (["convert", "upgrade"], "sdfcheck convert sdf-to-sdf FILE"),
        (["convert", "arm.urdf"], "sdfcheck convert urdf-to-sdf arm.urdf"),
        (["arm.urdf.xacro"], "sdfcheck lint arm.urdf.xacro"),
        (["convert", "urdf-to-sd"], "; did you mean `urdf-to-sdf`"),
    ],
)
def test_conversions_and_files_are_understood_too(
    words: list[str], meant: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(words) == 2
    assert meant in capsys.readouterr().err


def test_targets_are_lists_with_the_same_names_everywhere(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["targets", SDF, "--target", "gazebo,drake", "--output-format", "json"]) in {0, 1}
    rows = json.loads(capsys.readouterr().out)["consumers"]
    assert {row["consumer"] for row in rows} == {"gazebo", "drake"}
    for command in ("lint", "targets"):
        assert main([command, SDF, "--target", "drak"]) == 2
        assert "unknown target `drak`; did you mean `drake`?" in capsys.readouterr().err


def test_a_version_is_refused_in_the_same_words_everywhere(capsys: pytest.CaptureFixture[str]) -> None:
    for line, oldest in (
        ("describe joint", "1.2"),
        ("schema", "1.2"),
        (f"convert sdf-to-sdf {SDF}", "1.4"),
        (f"convert urdf-to-sdf {SDF}", "1.4"),
    ):
        assert main([*line.split(), "--sdf-version", "1.13"]) == 2
        expected = f"unknown version `1.13` of SDFormat (choose from {oldest} to 1.12)"
        assert expected in capsys.readouterr().err
