"""Pipes, devices, links and large files: whatever lies in a folder, a run ends and says what it left out."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from sdfcheck.cli.main import main
from tests.posix import make_pipe

SDF = '<sdf version="1.6"><model name="m"><link name="l"/></model></sdf>\n'


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "a.sdf").write_text(SDF)
    make_pipe(tmp_path / "pipe.sdf")
    (tmp_path / "zero.sdf").symlink_to("/dev/zero")
    (tmp_path / "loop.sdf").symlink_to("loop.sdf")
    return tmp_path


def test_a_walk_leaves_them_out(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["lint", "."]) == 0
    assert "1 file, no findings (3 files skipped)" in capsys.readouterr().out
    main(["lint", "--show-files", "."])
    assert "skipped: pipe.sdf: a pipe, not a file" in capsys.readouterr().err


@pytest.mark.parametrize("name", ["pipe.sdf", "zero.sdf"])
def test_a_named_one_is_refused(folder: Path, name: str, capsys: pytest.CaptureFixture[str]) -> None:
    kind = "a pipe" if name == "pipe.sdf" else "a device"
    assert main(["lint", name]) == 2
    assert capsys.readouterr().err == f"error: {name}: cannot be read: {kind}, not a file\n"
    for command in ("graph poses", "inertia", "print", "targets", "expand"):
        assert main([*command.split(), name]) == 2
        assert capsys.readouterr().err == f"error: {name}: {kind}, not a file\n"
    assert main(["convert", "sdf-to-urdf", name]) == 2
    assert main(["diff", "a.sdf", name]) == 2


def test_an_included_one_brings_nothing(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    include = "<include><uri>pipe.sdf</uri><name>n</name></include>"
    (folder / "a.sdf").write_text(SDF.replace("</model>", f"{include}</model>"))
    assert main(["lint", "a.sdf"]) == 1
    assert "RES" in capsys.readouterr().out


COMMANDS = (
    "lint",
    "graph poses",
    "inertia",
    "convert sdf-to-urdf",
    "convert sdf-to-sdf --sdf-version 1.9",
    "targets",
)


@pytest.mark.parametrize("command", COMMANDS)
def test_the_size_limit_is_configured(folder: Path, command: str, capsys: pytest.CaptureFixture[str]) -> None:
    arguments = [*command.split(), "a.sdf"]
    assert main(arguments) == 0
    capsys.readouterr()
    (folder / "sdfcheck.toml").write_text("max-file-size = 0.00001\n")
    assert main(arguments) == 2
    err = capsys.readouterr().err
    reason = "cannot be read: larger than 10 bytes (`max-file-size` in the configuration)"
    assert err == f"error: a.sdf{':' if command in {'lint', 'targets'} else ''} {reason}\n"


@pytest.mark.parametrize("value", ["0", "-1", "true", '"1"', "nan", "inf"])
def test_a_limit_is_a_positive_number(folder: Path, value: str, capsys: pytest.CaptureFixture[str]) -> None:
    (folder / "sdfcheck.toml").write_text(f"max-file-size = {value}\n")
    assert main(["lint", "a.sdf"]) == 2
    assert "`max-file-size` should be a number of megabytes" in capsys.readouterr().err


def test_settings_show_the_limit(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    main(["lint", "--show-settings", "a.sdf"])
    assert "max-file-size = 256\n" in capsys.readouterr().out


@pytest.mark.parametrize("jobs", ["1", "2"])
def test_a_folder_that_cannot_be_read_makes_the_run_incomplete(
    folder: Path, jobs: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (folder / "closed").mkdir()
    for number in range(70):
        (folder / f"m{number}.sdf").write_text(SDF)
    known = os.scandir

    def scandir(place: Path) -> object:
        if place.name == "closed":
            raise PermissionError(13, "Permission denied")
        return known(place)

    monkeypatch.setattr(os, "scandir", scandir)
    assert main(["lint", "--exit-zero", "--jobs", jobs, "."]) == 2
    assert "error: closed: cannot be read: Permission denied\n" in capsys.readouterr().err


@pytest.mark.parametrize(
    "text",
    ["a = " + "[" * 5000 + "]" * 5000, "a = " + "{a=" * 5000 + "1" + "}" * 5000],
    ids=["lists", "tables"],
)
def test_a_deeply_nested_configuration_is_named(
    folder: Path, text: str, capsys: pytest.CaptureFixture[str]
) -> None:
    (folder / "sdfcheck.toml").write_text(text)
    assert main(["lint", "a.sdf"]) == 2
    assert capsys.readouterr().err == "error: sdfcheck.toml: tables and lists are nested too deeply\n"


def test_a_deeply_nested_baseline_is_none(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (folder / "known.json").write_text('{"a":' * 100_000)
    assert main(["lint", "a.sdf", "--baseline", "known.json"]) == 2
    assert capsys.readouterr().err == "error: known.json is not a baseline\n"


@pytest.mark.parametrize(
    "words", [("inertia",), ("graph", "joints"), ("view", "-o", "page.html"), ("diff", "sound.sdf")]
)
def test_a_broken_text_is_named_by_commands_that_read_what_there_is(
    words: tuple[str, ...],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "sound.sdf").write_text(SDF)
    (tmp_path / "broken.sdf").write_text(
        '<sdf version="1.6"><model name="m"><link name="l"></lnk></model></sdf>'
    )
    main([*words, "broken.sdf"])
    assert "warning: broken.sdf:1:53: the text is broken here" in capsys.readouterr().err
    main([*words, "sound.sdf"])
    assert "broken" not in capsys.readouterr().err


@pytest.mark.parametrize("name", ["loop", "loop/x.sdf", "x" * 300], ids=["loop", "in a loop", "long"])
@pytest.mark.parametrize("options", ["print -o", "lint --output-format json --output-file"])
def test_a_result_that_has_no_place_is_an_error(
    folder: Path, options: str, name: str, capsys: pytest.CaptureFixture[str]
) -> None:
    (folder / "loop").symlink_to("loop")
    command, *rest = options.split()
    assert main([command, "a.sdf", *rest, name]) == 2
    assert f"error: cannot write {name}: " in capsys.readouterr().err


@pytest.mark.parametrize(
    ("name", "text", "said"),
    [
        ("sdfcheck.toml", 'model-paths = ["a\\u0000b"]', "has the character NUL"),
        ("b.json", '{"version": 1, "counts": {"a.sdf": {"NAM001": 1e400}}}', "b.json is not a baseline"),
    ],
)
def test_odd_values_of_other_files_are_errors(
    folder: Path, name: str, text: str, said: str, capsys: pytest.CaptureFixture[str]
) -> None:
    (folder / name).write_text(text)
    assert main(["lint", "a.sdf", *(["--baseline", name] if name == "b.json" else [])]) == 2
    assert said in capsys.readouterr().err


@pytest.mark.skipif(sys.platform == "win32", reason="a shell of POSIX closes it")
@pytest.mark.parametrize("closed", ["lint - <&-", "print a.sdf >&-"])
def test_closed_streams_are_errors(folder: Path, closed: str) -> None:
    command = f'"{sys.executable}" -m sdfcheck {closed}'
    done = subprocess.run(command, shell=True, cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 2
    assert "is closed" in done.stderr
    assert "Traceback" not in done.stderr
