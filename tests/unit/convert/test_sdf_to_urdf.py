"""SDF models become equal URDF robots, and verification sees when they do not."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from sdfcheck.convert.comparison import verify
from sdfcheck.convert.loss import LossKind, NotConvertible
from sdfcheck.convert.result import Conversion
from sdfcheck.convert.sdf_to_urdf import Loops, Options, Unsupported, convert
from sdfcheck.convert.sdf_to_urdf.plan import Naming
from sdfcheck.files.library import Library
from sdfcheck.robot.motion.flatten import mechanism_of
from sdfcheck.robot.root import root_of
from sdfcheck.source.document import read
from sdfcheck.source.errors import WrongUsage
from sdfcheck.source.sniff import Kind

_BODY = (
    "<inertial><pose>0.1 0.2 0.3 1 2 3</pose><mass>2</mass>"
    "<inertia><ixx>0.1</ixx><iyy>0.2</iyy><izz>0.25</izz></inertia></inertial>"
)
_SENSOR = '<sensor name="s" type="imu"><pose>0 0 0.1 0 0 0</pose></sensor>'
_LINKS = f'<link name="a">{_BODY}</link><link name="b"><pose>0 0 1 0.3 0.4 0.5</pose>{_BODY}{_SENSOR}</link>'


def _joint(kind: str, inside: str = "", ends: tuple[str, str] = ("a", "b"), name: str = "j") -> str:
    parent, child = (f"<{r}>{e}</{r}>" for r, e in zip(("parent", "child"), ends, strict=True))
    return f'<joint name="{name}" type="{kind}"><pose>0 0 -0.5 0.1 0 0</pose>{parent}{child}{inside}</joint>'


def _axis(name: str = "axis", xyz: str = "0 1 1", limit: str = "") -> str:
    return f'<{name}><xyz expressed_in="__model__">{xyz}</xyz><limit>{limit}</limit></{name}>'


def _convert(model: str, options: Options | None = None, version: str = "1.9") -> Conversion:
    text = f'<sdf version="{version}"><model name="m">{model}</model></sdf>'
    return convert(read(text.encode(), Path("m.sdf"), Kind.SDF), options)


def _kinds(done: Conversion) -> set[LossKind]:
    return {loss.kind for loss in done.losses}


def _is_equal(done: Conversion) -> bool:
    assert done.verification is not None
    return done.verification.is_equal


@pytest.mark.parametrize("keep", [False, True])
@pytest.mark.parametrize(
    "joint",
    [
        _joint("revolute", _axis(limit="<lower>-1</lower><upper>2</upper>")),
        _joint("prismatic", _axis()),
        _joint("fixed"),
        _joint("universal", _axis() + _axis("axis2", "1 0 0")),
        _joint("screw", _axis() + "<screw_thread_pitch>0.2</screw_thread_pitch>"),
        _joint("revolute", _axis(), ends=("b", "a")),
        _joint("revolute", _axis(), ends=("world", "b")),
    ],
    ids=["revolute", "prismatic", "fixed", "universal", "screw", "backwards", "world"],
)
def test_the_robot_stays_equal(joint: str, keep: bool) -> None:
    assert _is_equal(_convert(_LINKS + joint, Options(keep_link_frames=keep)))


def test_a_link_moves_to_its_joint_and_its_sensor_stays() -> None:
    done = _convert(_LINKS + _joint("revolute", _axis()))
    assert LossKind.SHIFTED_LINK_FRAME in _kinds(done)
    assert '<sensor name="s" type="imu">' in done.text
    assert "<pose>0 0 0.1 0 0 0</pose>" not in done.text


def test_kept_link_frames_need_no_shift() -> None:
    done = _convert(_LINKS + _joint("revolute", _axis()), Options(keep_link_frames=True))
    assert LossKind.SHIFTED_LINK_FRAME not in _kinds(done)
    assert '<link name="b__joint"/>' in done.text
    assert "<pose>0 0 0.1 0 0 0</pose>" in done.text


@pytest.mark.parametrize("axes", [_axis(), _axis() + _axis("axis2", "1 0 0")], ids=["one-axis", "two-axes"])
def test_a_second_parent_is_reversed(axes: str) -> None:
    links = _LINKS + f'<link name="c"><pose>1 0 0 0 0 0</pose>{_BODY}</link>'
    kind = "universal" if "axis2" in axes else "revolute"
    joints = _joint("revolute", _axis()) + _joint(kind, axes, ("c", "b"), "k")
    done = _convert(links + joints)
    assert _is_equal(done)
    assert LossKind.REVERSED_JOINT in _kinds(done)


def test_a_loop_is_cut_and_reported() -> None:
    links = _LINKS + f'<link name="c"><pose>1 0 0 0 0 0</pose>{_BODY}</link>'
    joints = _joint("revolute", _axis()) + _joint("revolute", _axis(), ("b", "c"), "k")
    closing = _joint("revolute", _axis(), ("a", "c"), "l")
    with pytest.raises(NotConvertible, match="closes a loop"):
        _convert(links + joints + closing)
    done = _convert(links + joints + closing, Options(loops=Loops.CUT))
    assert _is_equal(done)
    assert LossKind.CLOSED_LOOP in _kinds(done)


def test_ball_joints_and_forests_follow_the_policy() -> None:
    assert _is_equal(_convert(_LINKS))
    assert 'type="floating"' in _convert(_LINKS + _joint("ball")).text
    for model in (_LINKS, _LINKS + _joint("ball")):
        with pytest.raises(NotConvertible):
            _convert(model, Options(ball=Unsupported.ERROR, forest=Unsupported.ERROR))


def test_parts_that_urdf_cannot_hold_are_reported() -> None:
    shape = "<geometry><ellipsoid><radii>1 2 3</radii></ellipsoid></geometry>"
    done = _convert(f'<link name="a"><visual name="v">{shape}</visual></link>')
    assert {LossKind.UNSUPPORTED_GEOMETRY, LossKind.CHANGED_DEFAULT} <= _kinds(done)


def test_several_models_are_listed() -> None:
    one, two = (f'<model name="{name}"><link name="l"/></model>' for name in ("one", "two"))
    document = read(
        f'<sdf version="1.9"><world name="w">{one}{two}</world></sdf>'.encode(), Path("w.sdf"), Kind.SDF
    )
    with pytest.raises(WrongUsage, match="one, two"):
        convert(document)
    assert '<robot name="two">' in convert(document, Options(model="two")).text


def test_verification_sees_every_changed_number() -> None:
    done = _convert(_LINKS + _joint("revolute", _axis(limit="<lower>-1</lower><upper>2</upper>")))
    assert _is_equal(done)
    body = done.text[: done.text.index("<gazebo")]
    given = re.compile(r'(?:xyz|rpy|mass value|ixx|iyy|izz|lower|upper)="([^"]*)"')
    changed = 0
    for found in given.finditer(body):
        words = found[1].split()
        words[0] = repr(float(words[0]) + 0.01)
        text = body[: found.start(1)] + " ".join(words) + body[found.end(1) :] + "</robot>"
        robot = mechanism_of(root_of(read(text.encode(), Path("m.urdf"), Kind.URDF)).models[0])
        comparison = done.comparisons[0]
        assert not verify(comparison.source, robot, comparison.correspondence).is_equal, found[0]
        changed += 1
    assert changed > 10


def test_names_in_plugins_of_nested_models_follow() -> None:
    arm = (
        f'<model name="arm"><link name="up">{_BODY}</link><link name="low">{_BODY}</link>'
        + _joint("revolute", _axis(), ends=("up", "low"), name="bend")
        + '<plugin filename="p" name="p"><joint_name>bend</joint_name><linkName>low</linkName>'
        "<topic>bend</topic><title>bend it</title><reading link='low'>low::camera</reading></plugin></model>"
    )
    done = _convert(f'<link name="base">{_BODY}</link>' + arm + _joint("fixed", ends=("base", "arm::up")))
    assert _is_equal(done)
    for text in (
        "<joint_name>arm__bend</joint_name>",
        "<linkName>arm__low</linkName>",
        "<topic>bend</topic>",
        '<reading link="arm__low">arm__low::camera</reading>',
    ):
        assert text in done.text
    (left,) = (loss for loss in done.losses if "may name" in loss.message)
    assert "`bend` → `arm__bend`" in left.message


def test_every_copy_of_an_included_model_has_its_sensors(tmp_path: Path) -> None:
    part = f'<sdf version="1.9"><model name="part"><link name="l">{_BODY}{_SENSOR}</link></model></sdf>'
    (tmp_path / "part.sdf").write_text(part)
    includes = "".join(f"<include><uri>part.sdf</uri><name>{n}</name></include>" for n in ("a", "b"))
    text = f'<sdf version="1.9"><model name="m"><link name="base"/>{includes}</model></sdf>'
    document = read(text.encode(), tmp_path / "m.sdf", Kind.SDF)
    document.library = Library()
    done = convert(document)
    assert done.text.count("<sensor") == 2


def test_authors_numbers_stay() -> None:
    visual = '<visual name="v"><pose>0.10 -0 1e-3 0 0 3.14159</pose><geometry><sphere/></geometry></visual>'
    assert '<origin xyz="0.10 0 1e-3" rpy="0 0 3.14159"/>' in _convert(f'<link name="a">{visual}</link>').text


def test_comments_have_a_place_or_are_reported() -> None:
    model = f'<!-- 1 --><link name="a"><!-- 2 -->{_BODY}<gravity><!-- 3 -->1</gravity></link>'
    model += '<enable_wind>0</enable_wind><link name="b"><battery name="b"/><inertial><density><!-- 4 -->1</density>'
    model += "</inertial></link>" + _joint("fixed", "<!-- 5 -->")
    done = _convert(model)
    reported = [loss.message for loss in done.losses if loss.kind is LossKind.DROPPED_COMMENT]
    for number in range(1, 6):
        assert f"<!-- {number} -->" in done.text or any(f"`{number}`" in message for message in reported)


def test_line_ends_stay() -> None:
    text = '<sdf version="1.9">\r\n<model name="m"><link name="a"/></model>\r\n</sdf>\r\n'
    done = convert(read(text.encode(), Path("m.sdf"), Kind.SDF))
    assert done.text.count("\n") == done.text.count("\r\n") > 5


@pytest.mark.parametrize(
    "pose", ["inf 0 0 0 0 0", "0 0 0 nan 0 0", "0 0 0 1e999 0 0", "0 0 0", "a b c d e f"]
)
def test_a_pose_that_is_none_is_refused(pose: str) -> None:
    for link in (
        f"<pose>{pose}</pose>",
        f'<sensor name="s" type="imu"><pose relative_to="l">{pose}</pose></sensor>',
    ):
        with pytest.raises(NotConvertible, match="is not a pose"):
            _convert(f'<link name="a">{link}</link><link name="l"/>')


def test_a_sensor_at_an_unknown_frame_is_refused() -> None:
    with pytest.raises(NotConvertible, match="no frame 'f'"):
        _convert(
            '<link name="a"><sensor name="s" type="imu"><pose relative_to="f">1 0 0 0 0 0</pose></sensor></link>'
        )


def test_a_number_is_read_as_libsdformat_reads_it() -> None:
    limit = '<lower>-1</lower><upper>2;</upper><velocity>3.5"</velocity>'
    done = _convert(_LINKS + _joint("revolute", _axis(limit=limit)))
    assert _is_equal(done)
    assert 'upper="2"' in done.text
    assert 'velocity="3.5"' in done.text


def test_a_block_of_ros2_control_comes_back() -> None:
    block = '<ros2_control name="c" type="system"><joint name="j"><param name="k">1</param></joint></ros2_control>'
    prefixed = block.replace("<ros2", "<urdf:ros2").replace("</ros2", "</urdf:ros2")
    result = _convert(_LINKS + _joint("revolute", _axis()) + prefixed)
    assert "urdf:" not in result.text
    assert re.sub(r">\s+<", "><", result.text).count(block) == 1


@pytest.mark.parametrize(
    ("old", "new", "written"),
    [
        ("<mass>", "<mass shop:by='me'>", '<mass value="2" shop:by="me"/>'),
        ("<inertia>", "<inertia><shop:by>me</shop:by>", "<shop:by>me</shop:by>"),
    ],
)
def test_custom_data_of_an_inertia_is_carried(old: str, new: str, written: str) -> None:
    model = f'<model name="m"><link name="a">{_BODY.replace(old, new)}</link></model>'
    text = f'<sdf version="1.9" xmlns:shop="urn:shop">{model}</sdf>'
    assert written in convert(read(text.encode(), Path("m.sdf"), Kind.SDF)).text


def test_settings_of_an_include_are_accounted_for(tmp_path: Path) -> None:
    tmp_path.joinpath("part.sdf").write_text(f'<sdf version="1.9"><model name="p">{_LINKS}</model></sdf>')
    inside = "<name>q</name><static>0</static><placement_frame>b</placement_frame>"
    include = f"<include><uri>part.sdf</uri>{inside}</include>"
    tmp_path.joinpath("m.sdf").write_text(
        f'<sdf version="1.9"><model name="m"><link name="l"/>{include}</model></sdf>'
    )
    document = Library().document(tmp_path / "m.sdf")
    assert document is not None
    lost = {loss.span.text for loss in convert(document, Options(forest=Unsupported.FIXED)).losses}
    assert not lost & {"name", "static", "placement_frame"}


def test_equal_names_are_numbered_upwards() -> None:
    naming = Naming({"world"})
    assert [naming.unique(name) for name in ("arm", "n::arm", "arm", "arm")] == [
        "arm",
        "n__arm",
        "arm_2",
        "arm_3",
    ]


def test_a_setting_that_is_given_again_is_in_neither_robot() -> None:
    physics = "<physics><ode><limit><cfm>0.1</cfm></limit></ode></physics><physics><ode><erp>0.9</erp></ode></physics>"
    text = f'<sdf version="1.9"><model name="m">{_LINKS}{_joint("revolute", physics)}</model></sdf>'
    verification = convert(read(text.encode(), Path("m.sdf"), Kind.SDF)).verification
    assert verification is not None
    assert verification.is_equal, verification.differences
