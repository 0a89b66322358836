"""What Drake has otherwise in the other format is written in its words, or is a warning."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.convert.result import Conversion
from sdfcheck.convert.sdf_to_urdf import convert
from sdfcheck.convert.urdf_to_sdf.conversion import urdf_to_sdf
from sdfcheck.convert.urdf_to_sdf.options import Options
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.source.document import Document, read

DRAKE = 'xmlns:drake="http://drake.mit.edu"'
BALL = "<collision name='c'><geometry><sphere><radius>.5</radius></sphere></geometry></collision>"
MODEL = (
    '<sdf version="1.10" {}><model name="m">'
    f'<link name="a"><inertial><mass>1</mass></inertial>{BALL}</link>'
    f'<link name="b"><inertial><mass>1</mass></inertial>{BALL}</link>'
    '<joint name="j" type="{}"><parent>a</parent><child>b</child>{}</joint></model></sdf>'
)
UNIVERSAL = "<axis><xyz>{}</xyz></axis><axis2><xyz>{}</xyz></axis2>"
SCREW = "<axis><xyz>0 1 0</xyz><limit><effort>3</effort></limit></axis><screw_thread_pitch>.02</screw_thread_pitch>"


def document(text: str, name: str) -> Document:
    return read(text.encode(), Path(name))


def to_urdf(kind: str, inside: str, declared: str = DRAKE) -> Conversion:
    done = convert(document(MODEL.format(declared, kind, inside), "m.sdf"))
    assert done.verification is not None
    assert done.verification.is_equal
    return done


def warnings(done: Conversion) -> list[str]:
    return [loss.message for loss in done.losses if loss.severity is Severity.WARNING]


@pytest.mark.parametrize(
    ("kind", "inside", "written"),
    [
        ("universal", UNIVERSAL.format("1 0 0", "0 1 0"), '<drake:joint name="j" type="universal">'),
        ("screw", SCREW, '<drake:screw_thread_pitch value="0.02"/>'),
    ],
)
def test_joints_that_drake_has_in_urdf(kind: str, inside: str, written: str) -> None:
    done = to_urdf(kind, inside)
    assert written in done.text
    assert "j_between" not in done.text
    assert any("as `drake:joint` for Drake" in text for text in warnings(done))
    back = urdf_to_sdf(document(done.text, "m.urdf"), Options())
    assert f'<joint name="j" type="{kind}">' in back.text
    assert "j_between" in to_urdf(kind, inside, "").text


def test_a_screw_keeps_its_actuator_and_loses_its_limit() -> None:
    done = to_urdf("screw", SCREW)
    assert "<transmission" in done.text
    assert any("its actuator has no limit" in text for text in warnings(done))
    assert "<transmission" not in to_urdf("screw", SCREW.replace(">3<", ">0<")).text


def test_a_universal_joint_about_other_axes_is_parted_and_contacts_are_named() -> None:
    done = to_urdf("universal", UNIVERSAL.format("0 0 1", "0 1 0"))
    assert "j_between" in done.text
    assert any("Drake takes contacts between `a` and `b` into account" in text for text in warnings(done))


@pytest.mark.parametrize(("declared", "count"), [(DRAKE, 1), ("", 0)])
def test_springs(declared: str, count: int) -> None:
    axis = "<axis><xyz>0 0 1</xyz><dynamics><spring_stiffness>5</spring_stiffness></dynamics></axis>"
    done = to_urdf("revolute", axis, declared)
    assert sum("spring_stiffness" in text for text in warnings(done)) == count


INERTIAL = '<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'
VISUAL = (
    '<visual><geometry><box size="1 1 1"/></geometry>'
    '<material name="p"><color rgba="1 0 0 1"/><texture filename="t.png"/></material></visual>'
)
ROBOT = (
    f'<robot name="r" {{}}><link name="a">{INERTIAL}{VISUAL}</link><link name="b">{INERTIAL}</link>'
    '<joint name="j" type="revolute"><parent link="a"/><child link="b"/><axis xyz="0 0 1"/>'
    '<limit lower="-1" upper="1" effort="{}" velocity="1"/></joint>{}</robot>'
)
TRANSMISSION = (
    '<transmission name="t"><type>transmission_interface/SimpleTransmission</type>'
    '<joint name="j"/><actuator name="m"/></transmission>'
)


@pytest.mark.parametrize(
    ("declared", "effort", "transmission", "says"),
    [
        (DRAKE, "5", "", "an actuator in SDFormat"),
        (DRAKE, "0", TRANSMISSION, "no actuator in SDFormat"),
        (DRAKE, "5", TRANSMISSION, ""),
        (DRAKE, "0", "", ""),
        ("", "5", "", ""),
    ],
)
def test_actuators_that_appear_or_vanish(declared: str, effort: str, transmission: str, says: str) -> None:
    done = urdf_to_sdf(document(ROBOT.format(declared, effort, transmission), "r.urdf"), Options())
    found = [text for text in warnings(done) if "actuator" in text]
    assert len(found) == bool(says)
    assert all(says in text for text in found)


@pytest.mark.parametrize(("declared", "is_there"), [(DRAKE, True), ("", False)])
def test_textures(declared: str, is_there: bool) -> None:
    done = urdf_to_sdf(document(ROBOT.format(declared, "0", ""), "r.urdf"), Options())
    assert ("<drake:diffuse_map>t.png</drake:diffuse_map>" in done.text) is is_there
    back = convert(document(done.text, "r.sdf"))
    assert back.verification is not None
    assert back.verification.is_equal
    assert ('<texture filename="t.png"/>' in back.text) is is_there
