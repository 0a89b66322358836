"""A result is as sound as its source, or not written."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.cli.main import main
from sdfcheck.consumers.reaction import drops
from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.new_errors import new_refusals
from sdfcheck.convert.sdf_to_urdf import convert
from sdfcheck.convert.urdf_to_sdf.conversion import urdf_to_sdf
from sdfcheck.convert.urdf_to_sdf.options import Options, PackageUris
from sdfcheck.formats.version import Version
from sdfcheck.lint.diagnostic import Diagnostic, Severity
from sdfcheck.source.document import Document, read

LINK = (
    '<link name="l"><inertial><mass value="1"/>'
    '<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>{}</link>'
)


def robot(inside: str = "", after: str = "") -> Document:
    return read(f'<robot name="r">{LINK.format(inside)}{after}</robot>'.encode(), Path("r.urdf"))


def test_the_table_names_the_error_that_stopped_it(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    joint = '<link name="b"/>\n<joint name="j" type="round"><parent link="l"/><child link="b"/></joint>'
    for name, impossible in (("a", "1"), ("b", "9")):
        text = f'<robot name="r">{LINK.format("")}\n{joint}</robot>'.replace('ixx="1"', f'ixx="{impossible}"')
        (tmp_path / f"{name}.urdf").write_text(text)
    assert main(["convert", "urdf-to-sdf", str(tmp_path), "--output-dir", str(tmp_path), "--isolated"]) == 1
    rows = [line for line in capsys.readouterr().err.splitlines() if line.startswith("not written")]
    assert [row.partition(": ")[2] for row in rows] == [
        "unknown `type` of joint `j`: `round` (3:23, SCH015)"
    ] * 2


def test_a_xacro_file_that_lacks_an_argument_is_refused_with_this_reason(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    source = tmp_path / "r.xacro"
    source.write_text('<robot name="$(arg n)" xmlns:xacro="http://www.ros.org/wiki/xacro"/>')
    assert main(["convert", "urdf-to-sdf", str(source), "-o", str(tmp_path / "r.sdf"), "--isolated"]) == 1
    out, err = capsys.readouterr()
    assert "argument `n` has no value" in out
    assert "--no-expand" not in err
    left_over = source.rename(tmp_path / "r.urdf")
    impossible = LINK.format("<xacro:grey/>").replace('ixx="1"', 'ixx="9"')
    left_over.write_text(f'<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">{impossible}</robot>')
    arguments = ["convert", "urdf-to-sdf", str(left_over), "-o", str(tmp_path / "r.sdf"), "--isolated"]
    assert main(arguments) == 1
    assert "--no-expand leaves out what is for xacro" in capsys.readouterr().err
    assert main([*arguments, "--no-expand"]) == 0, "the source has the error of the result"


def test_an_error_in_an_included_file_is_the_sources(tmp_path: Path) -> None:
    xacro = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'
    impossible = LINK.format("").replace('ixx="1"', 'ixx="9"')
    (tmp_path / "part.xacro").write_text(f"<robot {xacro}>{impossible}</robot>")
    source = tmp_path / "r.xacro"
    source.write_text(f'<robot name="r" {xacro}><xacro:include filename="part.xacro"/></robot>')
    assert main(["convert", "urdf-to-sdf", str(source), "-o", str(tmp_path / "r.sdf"), "--isolated"]) == 0
    assert "<ixx>9</ixx>" in (tmp_path / "r.sdf").read_text()


def test_a_result_with_a_new_error_is_not_written(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    source, target = tmp_path / "r.urdf", tmp_path / "r.sdf"
    source.write_text(
        f'<robot name="r">{LINK.format("")}\n'
        '<gazebo reference="l"><sensor name="s" type="camra"/></gazebo></robot>'
    )
    arguments = ["convert", "urdf-to-sdf", str(source), "-o", str(target), "--isolated", "--color", "never"]
    assert main(arguments) == 1
    out, err = capsys.readouterr()
    assert out.count("`camra`") == 1, "the source's own finding says it"
    assert "CNV031" not in out
    assert "nothing written: unknown `type` of sensor `s`" in err
    assert not target.exists()
    assert main([*arguments, "--no-lint"]) == 0
    assert target.exists()


def test_an_error_in_a_block_that_libsdformat_reads_on_is_the_sources(tmp_path: Path) -> None:
    source, target = tmp_path / "r.urdf", tmp_path / "r.sdf"
    sensor = '<sensor name="s" type="imu"><update_rate>1,5</update_rate></sensor>'
    source.write_text(f'<robot name="r">{LINK.format("")}<gazebo reference="l">{sensor}</gazebo></robot>')
    assert main(["convert", "urdf-to-sdf", str(source), "-o", str(target), "--isolated"]) == 0
    assert "<update_rate>1,5</update_rate>" in target.read_text()


def test_warnings_that_mean_another_robot_are_shown(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    source = tmp_path / "m.sdf"
    source.write_text(
        '<sdf version="1.9"><model name="m"><link name="l"><collision name="c"><geometry>'
        "<sphere><radius>0</radius></sphere></geometry></collision></link></model></sdf>"
    )
    target = str(tmp_path / "m.urdf")
    assert main(["convert", "sdf-to-urdf", str(source), "-o", target, "--isolated"]) == 0
    assert "`radius` should be above 0, not 0, so libsdformat takes 1" in capsys.readouterr().out


@pytest.mark.parametrize(
    "shape", ['<sphere radius="0"/>', '<box size="1 0 1"/>', '<cylinder radius="1" length="-1"/>']
)
def test_a_shape_without_size_is_left_out(shape: str) -> None:
    done = urdf_to_sdf(robot(f"<collision><geometry>{shape}</geometry></collision>"), Options())
    assert "<collision" not in done.text
    assert [loss.kind for loss in done.losses] == [LossKind.UNSUPPORTED_GEOMETRY]
    assert done.verification is not None
    assert done.verification.is_equal


def test_names_with_delimiters_are_changed() -> None:
    after = '<gazebo reference="l"><sensor name="s" type="imu"><api name="a::B"/></sensor></gazebo>\
<gazebo><plugin name="c::D" filename="f"><x name="e::F"/></plugin></gazebo>'
    done = urdf_to_sdf(robot(after=after), Options())
    assert '<api name="a__B"/>' in done.text
    assert '<plugin name="c::D" filename="f">' in done.text
    assert '<x name="e::F"/>' in done.text
    assert [loss.message for loss in done.losses] == ["api `a::B` of a <gazebo> block is named `a__B`"]


def test_two_sensors_have_two_names() -> None:
    block = '<gazebo reference="l"><sensor name="s" type="imu"/></gazebo>'
    done = urdf_to_sdf(robot(after=block * 3), Options())
    assert [f'name="s{end}" type' in done.text for end in ("", "_2", "_3")] == [True] * 3
    assert sum(loss.kind is LossKind.RENAMED for loss in done.losses) == 2


NOISE = (
    "<imu><noise><type>gaussian</type><rate><mean>0</mean><stddev>0.01</stddev></rate>"
    "<accel><mean>0</mean><stddev>0.2</stddev></accel></noise></imu>"
)


def test_the_noise_of_old_imus_is_said_for_each_axis() -> None:
    after = f'<gazebo reference="l"><sensor name="s" type="imu">{NOISE}</sensor></gazebo>'
    done = urdf_to_sdf(robot(after=after), Options())
    assert done.text.count("<stddev>0.01</stddev>") == done.text.count("<stddev>0.2</stddev>") == 3
    assert done.text.count('<noise type="gaussian">') == 6
    assert "<rate>" not in done.text
    assert "<rate>" in urdf_to_sdf(robot(after=after), Options(Version(1, 5))).text


@pytest.mark.parametrize(("version", "severity"), [("1.5", Severity.INFO), ("1.7", Severity.WARNING)])
def test_old_noise_that_consumers_ignored_is_a_warning(version: str, severity: Severity) -> None:
    sensor = f'<sensor name="s" type="imu">{NOISE}</sensor>'
    text = f'<sdf version="{version}"><model name="m"><link name="l">{sensor}</link></model></sdf>'
    losses = convert(read(text.encode(), Path("m.sdf"))).losses
    assert [loss.severity for loss in losses if "the noise of" in loss.message] == [severity]
    block = f'<gazebo reference="l">{sensor}</gazebo>'
    losses = urdf_to_sdf(robot(after=block), Options()).losses
    assert [loss.severity for loss in losses if "the noise of" in loss.message] == [Severity.WARNING]


def test_a_pose_in_an_old_frame_that_consumers_ignored_is_a_warning() -> None:
    block = '<gazebo reference="l"><sensor name="s" type="imu"><pose frame="l">1 0 0 0 0 0</pose></sensor></gazebo>'
    done = urdf_to_sdf(robot(after=block), Options())
    assert '<pose relative_to="l">' in done.text
    (loss,) = done.losses
    assert loss.severity is Severity.WARNING
    assert "libsdformat ignores its `frame`" in loss.message


def test_in_urdf_as_well() -> None:
    text = (
        f'<sdf version="1.5"><model name="m"><link name="l"><sensor name="s" type="imu">{NOISE}</sensor>'
        "</link></model></sdf>"
    )
    done = convert(read(text.encode(), Path("m.sdf")))
    assert done.text.count("<stddev>0.01</stddev>") == 3


def test_a_custom_element_of_a_block_gets_a_name_that_nothing_in_the_model_has() -> None:
    done = urdf_to_sdf(robot(after='<gazebo><x:tag name="l" xmlns:x="urn:x"/></gazebo>'), Options())
    assert 'name="l_2"' in done.text
    assert [loss.message for loss in done.losses] == ["x:tag `l` is named `l_2`"]


def test_a_package_is_named_once() -> None:
    mesh = '<visual><geometry><mesh filename="package://{}.obj"/></geometry></visual>'
    meshes = "".join(mesh.format(file) for file in ("arm/a", "arm/b", "hand/a"))
    done = urdf_to_sdf(robot(meshes), Options(package_uris=PackageUris.MODEL))
    assert done.text.count("model://") == 3
    assert [loss.kind for loss in done.losses].count(LossKind.CHANGED_URI) == 2


def test_a_part_that_a_consumer_of_the_result_drops_is_an_error() -> None:
    """The source has nothing of the kind, which that consumer reads in full."""
    source = read(b'<sdf version="1.9"><model name="m"><link name="a"/></model></sdf>', Path("m.sdf"))
    result = read(b'<robot name="m"><link name="a"/></robot>', Path("m.urdf"))
    assert result.root is not None
    found = Diagnostic(
        "URD014",
        "massless-moving-link",
        Severity.WARNING,
        "link `a` is dropped",
        result.root.span,
        affects=(("gazebo", drops("the link and those below it")),),
    )
    errors, refusal = new_refusals(source, (), result, (found,))
    assert [one.code for one in errors] == ["CNV031"]
    assert refusal is None
    assert new_refusals(source, (found,), result, (found,)) == ([], None)
    for_drake = read(
        b'<sdf version="1.9" xmlns:drake="http://drake.mit.edu"><model name="m"><link name="a"/></model></sdf>',
        Path("m.sdf"),
    )
    assert new_refusals(for_drake, (), result, (found,)) == ([], None)


def test_errors_of_urdf_that_come_back_stop_nothing(tmp_path: Path) -> None:
    axis = '<axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="1" velocity="1" acceleration="9"/>'
    joint = f'<joint name="j" type="revolute"><parent link="l"/><child link="b"/>{axis}</joint>'
    other = LINK.format("").replace('name="l"', 'name="b"')
    (tmp_path / "r.urdf").write_text(f'<robot name="r">{LINK.format("")}{other}{joint}</robot>')
    there, back = tmp_path / "r.sdf", tmp_path / "back.urdf"
    assert main(["convert", "urdf-to-sdf", str(tmp_path / "r.urdf"), "-o", str(there), "--isolated"]) == 0
    assert main(["convert", "sdf-to-urdf", str(there), "-o", str(back), "--isolated"]) == 0
    assert 'acceleration="9"' in back.read_text()
