"""Nothing is written over what it should not be, and nothing counts as verified that is not whole."""

from __future__ import annotations

import os
import stat
from pathlib import Path

import pytest

from sdfcheck import NotConvertible, Unreadable, load
from sdfcheck.cli.main import main
from sdfcheck.convert.call import convert
from tests.posix import make_pipe

SDF = '<sdf version="1.6"><model name="m"><link name="l"/></model></sdf>\n'
URDF = '<robot name="r"><link name="a"/></robot>\n'
ILL = '<sdf version="1.6"><model name="m"><link name="l"></model></sdf>\n'


def run(command: str, *arguments: object) -> int:
    return main([*command.split(), "--isolated", *map(str, arguments)])


@pytest.fixture
def sdf(tmp_path: Path) -> Path:
    file = tmp_path / "m.sdf"
    file.write_text(SDF)
    return file


@pytest.mark.parametrize(
    ("command", "option"),
    [
        ("convert sdf-to-sdf --sdf-version 1.8", "-o"),
        ("lint --exit-zero --output-format json", "--output-file"),
        ("lint --write-baseline", "--baseline"),
    ],
)
def test_a_pipe_is_not_written_to(
    sdf: Path, tmp_path: Path, command: str, option: str, capsys: pytest.CaptureFixture[str]
) -> None:
    pipe = tmp_path / "pipe"
    make_pipe(pipe)
    assert run(command, sdf, option, pipe) == 2
    assert capsys.readouterr().err == f"error: {pipe} is not a file\n"
    assert stat.S_ISFIFO(pipe.stat().st_mode)


@pytest.mark.parametrize("name", ["m.sdf", "link.sdf", "hard.sdf", "other.sdf"])
@pytest.mark.parametrize(
    "options",
    [
        ("--output-file", "{}"),
        ("--output-format", "json={}"),
        ("--fix", "--output-file", "{}"),
        ("--write-baseline", "--baseline", "{}"),
    ],
    ids=" ".join,
)
def test_a_report_is_not_written_over_an_input(
    sdf: Path, options: tuple[str, ...], name: str, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = sdf.parent
    (folder / "other.sdf").write_text(SDF)
    (folder / "link.sdf").symlink_to("m.sdf")
    os.link(sdf, folder / "hard.sdf")
    place = folder / name
    assert run("lint", folder, *(option.format(place) for option in options)) == 2
    assert f"{place} is an input and would be overwritten" in capsys.readouterr().err
    assert place.read_text() == SDF


def test_a_named_file_that_is_not_linted_is_an_input(tmp_path: Path) -> None:
    readme = tmp_path / "README.md"
    readme.write_text("hello\n")
    assert run("lint --skip-unrelated", readme, "--output-file", readme) == 2
    assert readme.read_text() == "hello\n"


def test_a_report_that_fails_leaves_the_old_one(
    sdf: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    report = tmp_path / "report.json"
    report.write_text("old")

    def fail(*_: object) -> None:
        raise OSError(28, "no space")

    monkeypatch.setattr(os, "replace", fail)
    assert run("lint", sdf, "--output-file", report) == 2
    assert report.read_text() == "old"
    assert sorted(os.listdir(tmp_path)) == ["m.sdf", "report.json"]


def test_an_input_is_not_replaced_by_another_format(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    urdf = tmp_path / "r.urdf"
    urdf.write_text(URDF)
    assert run("convert urdf-to-sdf", urdf, "-o", urdf) == 2
    assert "is an input" in capsys.readouterr().err
    assert urdf.read_text() == URDF


def test_a_file_can_be_moved_to_another_version_in_place(sdf: Path) -> None:
    assert run("convert sdf-to-sdf --sdf-version 1.8", sdf, "-o", sdf) == 0
    assert sdf.read_text() == SDF.replace("1.6", "1.8")


def test_reports_of_a_conversion_go_elsewhere(sdf: Path, tmp_path: Path) -> None:
    result = tmp_path / "new.sdf"
    for place in (sdf, result):
        options = ("-o", result, "--output-format", f"json={place}")
        assert run("convert sdf-to-sdf --sdf-version 1.8", sdf, *options) == 2
    assert sdf.read_text() == SDF
    assert not result.exists()


@pytest.mark.parametrize("command", ["sdf-to-sdf --sdf-version 1.8", "sdf-to-urdf"])
@pytest.mark.parametrize(
    ("text", "place"), [(ILL, "1:37"), (SDF.replace('"l"', '"l & r"'), "1:50")], ids=["unclosed", "bare &"]
)
def test_broken_text_is_not_verified(
    tmp_path: Path, text: str, place: str, command: str, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "ill.sdf"
    file.write_text(text)
    assert run(f"convert {command} --no-lint", file) == 0
    err = capsys.readouterr().err
    assert f"not verified: the text is broken at {place}" in err
    assert "\nverified" not in f"\n{err}"


def test_a_program_gets_no_conversion_of_text_that_its_consumer_refuses() -> None:
    with pytest.raises(NotConvertible, match="never closed"):
        convert(ILL, "sdf")
    assert convert(SDF, "sdf").verification is not None


@pytest.fixture
def bomb(tmp_path: Path) -> Path:
    """Five files, each of which includes the next twelve times: 271,452 models."""
    link = '<link name="l"/>'
    for level in range(5):
        includes = "".join(
            f"<include><name>n{i}</name><uri>b{level + 1}.sdf</uri></include>" for i in range(12)
        )
        text = f'<sdf version="1.9"><model name="m{level}">{link}{includes}</model></sdf>'
        (tmp_path / f"b{level}.sdf").write_text(text)
    (tmp_path / "b5.sdf").write_text(f'<sdf version="1.9"><model name="m5">{link}</model></sdf>')
    return tmp_path / "b0.sdf"


COMMANDS = [
    "convert sdf-to-sdf --sdf-version 1.12",
    "convert sdf-to-sdf --sdf-version 1.4",
    "convert sdf-to-urdf",
    "graph poses",
    "graph joints",
    "graph frames",
    "inertia",
    "print",
    "print --expand-includes",
]


@pytest.mark.parametrize("command", COMMANDS)
def test_a_target_that_is_not_a_class_of_parts_is_refused(
    bomb: Path, command: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(command, bomb) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert err == f"error: {bomb}: its includes bring in more than 10000 models\n"


def test_so_is_one_that_is_compared_or_loaded(bomb: Path) -> None:
    assert run("diff", bomb, bomb) == 2
    with pytest.raises(Unreadable, match="more than 10000 models"):
        load(bomb)


def test_many_models_are_not_too_many(bomb: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run("diff", bomb.with_name("b2.sdf"), bomb.with_name("b2.sdf")) == 0
    assert capsys.readouterr().out == "the same robot: 1 model, 1885 links, 0 joints\n"


def test_a_long_chain_of_includes_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for number in range(80):
        include = f"<include><uri>c{number + 1}.sdf</uri></include>" if number < 79 else ""
        text = f'<sdf version="1.9"><model name="m{number}"><link name="l"/>{include}</model></sdf>'
        (tmp_path / f"c{number}.sdf").write_text(text)
    assert run("convert sdf-to-sdf --sdf-version 1.12", tmp_path / "c0.sdf") == 2
    assert "includes lead through more than 50 files" in capsys.readouterr().err
    assert run("convert sdf-to-sdf --sdf-version 1.12", tmp_path / "c28.sdf") == 2
    assert run("convert sdf-to-sdf --sdf-version 1.12", tmp_path / "c29.sdf") == 0


def test_a_ring_of_includes_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = '<sdf version="1.9"><model name="m"><link name="l"/><include><uri>{}</uri></include></model></sdf>'
    (tmp_path / "a.sdf").write_text(text.format("b.sdf"))
    (tmp_path / "b.sdf").write_text(text.format("a.sdf"))
    assert run("convert sdf-to-sdf --sdf-version 1.12", tmp_path / "a.sdf") == 2
    assert "includes lead from" in capsys.readouterr().err
