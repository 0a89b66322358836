from __future__ import annotations

import io
from pathlib import Path

import pytest

from sdfcheck.cli.main import main
from sdfcheck.convert.urdf_to_sdf.joints import Joints
from sdfcheck.robot.motion.mechanism import Joint
from sdfcheck.source.altered import Xml

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
    assert err == "verified: 1 link, 1 configuration, max pose error 0 m\n"


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


def test_results_of_one_name_go_to_folders_of_their_own_unless_that_is_forbidden(
    urdf: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    other = tmp_path / "other" / "r.urdf"
    other.parent.mkdir()
    other.write_text(ROBOT)
    out = tmp_path / "out"
    assert run(urdf, other, "--output-dir", out, "--flat") == 2
    assert f"{urdf} and {other} would both go to" in capsys.readouterr().err
    assert not out.exists()
    assert run(urdf, other, "--output-dir", out) == 0
    assert (out / "r.sdf").exists()
    assert (out / "other" / "r.sdf").exists()


def test_results_of_one_name_in_one_folder_keep_the_whole_name(urdf: Path, tmp_path: Path) -> None:
    (tmp_path / "r.urdf.xacro").write_text(ROBOT)
    assert run(tmp_path, "--output-dir", tmp_path / "out") == 0
    assert sorted(path.name for path in (tmp_path / "out").iterdir()) == ["r.urdf.sdf", "r.urdf.xacro.sdf"]


def test_a_folder_is_walked_and_what_is_not_to_be_converted_ignored(
    urdf: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "world.sdf").write_text('<sdf version="1.9"><world name="w"/></sdf>')
    (tmp_path / "macros.xacro").write_text(
        '<robot xmlns:xacro="http://ros.org/wiki/xacro"><xacro:macro name="m"/></robot>'
    )
    assert run(tmp_path, "--output-dir", tmp_path / "out") == 0
    assert [path.name for path in (tmp_path / "out").iterdir()] == ["r.sdf"]
    err = capsys.readouterr().err
    assert "3 files: 1 verified and 2 ignored\n" in err


def test_one_of_several_may_be_of_another_kind(
    urdf: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    srdf = tmp_path / "r.srdf"
    srdf.write_text('<robot name="r"><group name="g"><link name="a"/></group></robot>')
    assert run(urdf, srdf, "--output-dir", tmp_path / "out") == 0
    assert "r.srdf: looks like SRDF" in capsys.readouterr().err
    assert run(srdf) == 2


def test_a_dash_is_stdin(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def give(text: str) -> None:
        monkeypatch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO(text.encode())))

    give(ROBOT)
    assert run("-") == 0
    assert '<link name="a">' in capsys.readouterr().out
    give(ROBOT)
    assert run("-", "--stdin-filename", tmp_path / "arm.urdf", "--output-dir", tmp_path / "out") == 0
    assert (tmp_path / "out" / "arm.sdf").exists()
    xacro = ROBOT.replace("<robot", '<robot xmlns:xacro="http://ros.org/wiki/xacro"').replace(
        "<link name", '<xacro:arg name="width" default="1"/><link name'
    )
    give(xacro)
    assert run("-", "width:=2") == 0
    give(xacro)
    assert run("-", "widht:=2") == 2
    assert "did you mean `width`" in capsys.readouterr().err
    assert run("--stdin-filename", "x.urdf", tmp_path / "r.urdf") == 2


def test_the_input_is_not_overwritten_by_another_format(urdf: Path, tmp_path: Path) -> None:
    assert run(urdf, "-o", urdf) == 2
    assert urdf.read_text() == ROBOT
    sdf = tmp_path / "m.sdf"
    sdf.write_text('<sdf version="1.9"><model name="m"><link name="a"/></model></sdf>')
    assert main(["convert", "sdf-to-urdf", "--isolated", str(sdf), "-o", str(sdf)]) == 2
    older = ["convert", "sdf-to-sdf", "--isolated", "--sdf-version", "1.8"]
    assert main([*older, str(sdf), "-o", str(sdf)]) == 0


def test_paths_are_written_for_the_folder_of_the_result(tmp_path: Path) -> None:
    source = tmp_path / "here"
    (source / "meshes").mkdir(parents=True)
    (source / "meshes" / "a.stl").write_bytes(b"")
    mesh = '<visual name="v"><geometry><mesh>{}</mesh></geometry></visual>'
    urdf = source / "r.urdf"
    urdf.write_text(
        ROBOT.replace(
            "</link>", '<visual><geometry><mesh filename="meshes/a.stl"/></geometry></visual></link>'
        )
    )
    sdf = source / "m.sdf"
    uri = "<uri>meshes/a.stl</uri>", "<uri>file://meshes/a.stl</uri>", "<uri>lost/a.stl</uri>"
    shapes = "".join(mesh.format(each).replace('"v"', f'"v{number}"') for number, each in enumerate(uri))
    sdf.write_text(f'<sdf version="1.9"><model name="m"><link name="a">{shapes}</link></model></sdf>')
    out = tmp_path / "deep" / "out"
    assert run(urdf, "--output-dir", out) == 0
    assert "<uri>../../here/meshes/a.stl</uri>" in (out / "r.sdf").read_text()
    assert main(["convert", "sdf-to-urdf", "--isolated", str(sdf), "-o", str(out / "m.urdf")]) == 0
    assert 'filename="../../here/meshes/a.stl"' in (out / "m.urdf").read_text()
    older = ["convert", "sdf-to-sdf", "--isolated", "--sdf-version", "1.8"]
    assert main([*older, str(sdf), "--output-dir", str(out)]) == 0
    written = (out / "m.sdf").read_text()
    assert "<uri>../../here/meshes/a.stl</uri>" in written
    assert "<uri>file://../../here/meshes/a.stl</uri>" in written
    assert "<uri>lost/a.stl</uri>" in written


def test_another_encoding_is_reported(urdf: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    urdf.write_bytes(b"\xef\xbb\xbf" + ROBOT.encode())
    assert run(urdf, "-o", tmp_path / "r.sdf") == 0
    assert "UTF-8 with a byte order mark becomes UTF-8\n" in capsys.readouterr().err
    urdf.write_bytes(
        b'<?xml version="1.0" encoding="iso-8859-1"?>' + ROBOT.replace('"r"', '"\xe9"').encode("latin-1")
    )
    assert run(urdf, "-o", tmp_path / "r.sdf") == 0
    assert "ISO8859-1 becomes UTF-8\n" in capsys.readouterr().err
    assert '"\xe9"' in (tmp_path / "r.sdf").read_text("utf-8")


def test_losses_are_grouped_by_file_and_code(
    urdf: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    links = "".join(f'<link name="l{n}"/>' for n in range(3))
    joints = "".join(
        f'<joint name="j{n}" type="continuous"><parent link="a"/><child link="l{n}"/></joint>'
        for n in range(3)
    )
    urdf.write_text(
        f'<robot name="r">\n<link name="a">{BOX}</link>{links}{joints}<transmission name="t"/></robot>'
    )
    assert run(urdf, "-o", tmp_path / "r.sdf") == 0
    out, err = capsys.readouterr()
    assert out.count("CNV014") == 1
    assert " and 2 more, at 2:" in out
    assert "shown with --min-severity info" in err
    assert run(urdf, "-o", tmp_path / "r.sdf", "--losses", "all") == 0
    assert capsys.readouterr().out.count("[CNV014]") == 3
    assert run(urdf, "-o", tmp_path / "r.sdf", "--min-severity", "info") == 0
    assert "info:" in capsys.readouterr().out


def test_yourdfpy_is_refused_where_no_side_is_urdf(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    sdf = tmp_path / "m.sdf"
    sdf.write_text('<sdf version="1.9"><model name="m"><link name="a"/></model></sdf>')
    assert main(["convert", "sdf-to-sdf", "--sdf-version", "1.8", str(sdf), "--verify-with", "yourdfpy"]) == 2
    assert "neither the source nor the result is URDF" in capsys.readouterr().err


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
    assert run(urdf, "-o", target, "--output-format", "concise") == 0
    done = capsys.readouterr()
    assert "no body has these principal moments" in done.out
    assert "; libsdformat refuses it: no body has these principal" in done.err
    assert target.exists()
    assert run(urdf, "-o", target, "--strict") == 1


def test_a_result_that_its_consumer_refuses_although_it_reads_the_source_is_not_written(
    urdf: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    write = Joints.write

    def without_axis(self: Joints, joint: Joint, model: Xml) -> None:
        write(self, joint, model)
        axis = self.context.joints[joint.name].find("axis")
        if axis is not None:
            axis.nodes.clear()

    monkeypatch.setattr(Joints, "write", without_axis)
    hinge = f'<link name="b">{BOX}</link><joint name="j" type="continuous"><parent link="a"/><child link="b"/></joint>'
    urdf.write_text(ROBOT.replace("</robot>", f"{hinge}</robot>"))
    target = tmp_path / "r.sdf"
    assert run(urdf, "-o", target, "--sdf-version", "1.4", "--no-verify") == 1
    assert "CNV031" in capsys.readouterr().out
    assert not target.exists()


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
    (tmp_path / "r.sdf").mkdir()
    assert run(urdf, "-o", tmp_path) == 2  # where the result would go there is a folder


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
            ["sdf-to-sdf", "--sdf-version", "1.5"],
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
