from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.cli.main import main

BOX = '<inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'
ROBOT = f'<robot name="r"><link name="a">{BOX}</link></robot>\n'
MASSLESS = '<robot name="r"><link name="a"/></robot>\n'


@pytest.fixture
def urdf(tmp_path: Path) -> Path:
    file = tmp_path / "r.urdf"
    file.write_text(ROBOT)
    return file


def run(*arguments: str | Path) -> int:
    return main(["convert", "urdf-to-sdf", "--isolated", *map(str, arguments)])


def test_the_result_goes_to_stdout_and_the_proof_to_stderr(
    urdf: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(urdf) == 0
    out, err = capsys.readouterr()
    assert out.startswith('<?xml version="1.0"?>\n<sdf version="1.12">')
    assert err == "verified: 1 link, 1 configuration, max pose error 0e+00 m\n"


def test_a_file_is_written_whole(urdf: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(urdf, "-o", tmp_path / "new" / "r.sdf", "--sdf-version", "1.9") == 0
    assert '<sdf version="1.9">' in (tmp_path / "new" / "r.sdf").read_text()
    assert capsys.readouterr().out == ""


def test_several_inputs_need_a_folder(urdf: Path, tmp_path: Path) -> None:
    other = tmp_path / "s.urdf"
    other.write_text(ROBOT)
    assert run(urdf, other) == 2
    assert run(urdf, other, "--output-dir", tmp_path / "out") == 0
    assert sorted(path.name for path in (tmp_path / "out").iterdir()) == ["r.sdf", "s.sdf"]


def test_two_inputs_with_one_result_are_refused(
    urdf: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    other = tmp_path / "other" / "r.urdf"
    other.parent.mkdir()
    other.write_text(ROBOT)
    assert run(urdf, other, "--output-dir", tmp_path / "out") == 2
    assert f"{urdf} and {other} would both go to" in capsys.readouterr().err
    assert not (tmp_path / "out").exists()


def test_a_file_that_cannot_be_used_does_not_keep_the_others(
    urdf: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "text.urdf").write_text("no robot")
    assert run(tmp_path / "none.urdf", tmp_path / "text.urdf", urdf, "--output-dir", tmp_path / "out") == 2
    assert [path.name for path in (tmp_path / "out").iterdir()] == ["r.sdf"]
    err = capsys.readouterr().err
    assert "none.urdf cannot be read" in err
    assert "text.urdf looks like" in err


def test_losses_are_reported_and_strict_makes_them_count(
    urdf: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    urdf.write_text(MASSLESS)
    target = tmp_path / "r.sdf"
    assert run(urdf, "-o", target, "--output-format", "concise") == 0
    assert "link `a` has no mass; it gets 0.001 kg [CNV014]" in capsys.readouterr().out
    assert run(urdf, "-o", target, "--strict") == 1


def test_errors_of_the_source_stop_it(urdf: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    urdf.write_text(ROBOT.replace('value="1"', 'value="one"'))
    target = tmp_path / "r.sdf"
    assert run(urdf, "-o", target) == 1
    assert not target.exists()
    out, err = capsys.readouterr()
    assert "one" in out
    assert "nothing written" in err
    assert run(urdf, "-o", target, "--no-lint") == 1
    assert not target.exists()


def test_errors_that_urdfdom_does_not_mind_are_shown_and_do_not_stop(
    urdf: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    urdf.write_text(ROBOT.replace('izz="1"', 'izz="5"'))
    target = tmp_path / "r.sdf"
    assert run(urdf, "-o", target, "--strict", "--output-format", "concise") == 0
    assert "no body has these principal moments" in capsys.readouterr().out
    assert target.exists()


def test_the_configuration_says_which_errors_count(urdf: Path, tmp_path: Path) -> None:
    urdf.write_text(ROBOT.replace("</robot>", f'<link name="b">{BOX}</link></robot>'))
    target = tmp_path / "r.sdf"
    assert main(["convert", "urdf-to-sdf", str(urdf), "-o", str(target)]) == 1
    (tmp_path / "sdfcheck.toml").write_text('ignore = ["disconnected-link"]')
    assert main(["convert", "urdf-to-sdf", str(urdf), "-o", str(target)]) == 0
    assert target.exists()


@pytest.mark.parametrize("text", ["", "<robot", "<sdf version='1.9'/>", "\0\1", '<robot name="r"/>'])
def test_bad_input_is_no_traceback(urdf: Path, text: str, capsys: pytest.CaptureFixture[str]) -> None:
    urdf.write_text(text)
    assert run(urdf) in {1, 2}
    assert run(urdf, "--no-lint") in {1, 2}
    assert "internal error" not in capsys.readouterr().err


def test_wrong_usage(urdf: Path, tmp_path: Path) -> None:
    assert run(tmp_path / "none.urdf") == 2
    assert run(urdf, "--sdf-version", "1.3") == 2
    assert run(urdf, "-o", tmp_path / "a", "--output-dir", tmp_path) == 2
    assert run(urdf, "-o", tmp_path) == 2


def test_xacro_is_expanded_with_its_arguments(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "r.urdf.xacro"
    file.write_text(
        '<robot name="r" xmlns:xacro="http://ros.org/wiki/xacro"><xacro:arg name="n" default="a"/>'
        f'<link name="$(arg n)">{BOX}</link></robot>'
    )
    assert run(file, "n:=tower") == 0
    assert '<link name="tower">' in capsys.readouterr().out
    assert run(file, "--output-dir", tmp_path / "out") == 0
    assert (tmp_path / "out" / "r.sdf").exists()


@pytest.mark.parametrize(
    ("command", "text"),
    [
        (["urdf-to-sdf"], ROBOT),
        (["sdf-to-urdf"], '<sdf version="1.9">\n<model name="m">\n<link name="a"/>\n</model>\n</sdf>\n'),
        (
            ["sdf-to-sdf", "--to", "1.5"],
            '<sdf version="1.9">\n<model name="m">\n<link name="a"/>\n</model>\n</sdf>\n',
        ),
    ],
    ids=lambda value: value[0],
)
def test_line_ends_stay(command: list[str], text: str, tmp_path: Path) -> None:
    source, result = tmp_path / "source", tmp_path / "result"
    source.write_bytes(text.replace("\n", "\r\n").encode())
    assert main(["convert", *command, "--isolated", "-q", str(source), "-o", str(result)]) == 0
    written = result.read_bytes()
    assert written.count(b"\r\n") == written.count(b"\n") > 2
