"""A file that its format's own parser takes can be converted."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.cli.main import main
from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.migrate.migrate import sdf_to_sdf
from sdfcheck.convert.urdf_to_sdf.conversion import urdf_to_sdf
from sdfcheck.convert.urdf_to_sdf.options import Options
from sdfcheck.formats.version import Version
from sdfcheck.source.document import Document, read

INERTIAL = '<inertial><mass value="{}"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'
LINK = f'<link name="l">{INERTIAL.format(1)}</link>'


def urdf(text: str) -> Document:
    return read(text.encode(), Path("r.urdf"))


def test_an_odd_version_of_xml_is_no_guess() -> None:
    done = urdf_to_sdf(urdf(f'<?xml version="0.0"?>\n<robot name="r">{LINK}</robot>'), Options())
    assert done.verification is not None
    assert done.verification.is_equal


def test_joints_into_what_blocks_include() -> None:
    block = (
        "<gazebo><include><uri>model://lamp</uri><name>lamp</name></include>"
        '<joint name="j" type="fixed"><parent>l</parent><child>lamp::body</child></joint></gazebo>'
    )
    done = urdf_to_sdf(urdf(f'<robot name="r">{LINK}{block}</robot>'), Options())
    assert done.verification is not None
    assert done.verification.is_equal
    assert "<child>lamp::body</child>" in done.text
    assert "<uri>model://lamp</uri>" in done.text


def test_moments_without_mass_that_are_merged_are_reported() -> None:
    text = (
        f'<robot name="r">{LINK}<link name="b">{INERTIAL.format(0)}</link>'
        '<joint name="j" type="fixed"><parent link="l"/><child link="b"/></joint></robot>'
    )
    (loss,) = (
        loss for loss in urdf_to_sdf(urdf(text), Options()).losses if loss.kind is LossKind.CHANGED_INERTIA
    )
    assert loss.message == "link `b` has moments of inertia without mass; they are added to those of `l`"


def test_left_over_xacro(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    source, target = tmp_path / "r.urdf", tmp_path / "r.sdf"
    source.write_text(
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
        f'<xacro:include filename="none.xacro"/>{LINK}<xacro:leg/></robot>'
    )
    arguments = ["convert", "urdf-to-sdf", str(source), "-o", str(target), "--isolated"]
    assert main(arguments) == 1
    assert main([*arguments, "--no-expand", "--losses", "all"]) == 0
    assert "`xacro:leg` is left out: nobody has expanded it" in capsys.readouterr().out
    assert "xacro" not in target.read_text()


FLAT = """<sdf version="1.9" xmlns:foo="u" xmlns:drake="http://drake.mit.edu"><model name="m"><link name="base"/>
<model name="n" foo:kind="arm"><link name="l"/><link name="k"/><foo:part link="l"/><foo:words>l</foo:words>
<joint name="nj" type="fixed"><parent>l</parent><child>k</child></joint></model>
<joint name="j" type="fixed"><parent>base</parent><child>n::l</child></joint>
<drake:collision_filter_group name="g"><drake:member>n::l</drake:member></drake:collision_filter_group>
<foo:d joint="n::nj">n::nj</foo:d></model></sdf>"""


def test_names_in_custom_elements_follow() -> None:
    done = sdf_to_sdf(read(FLAT.encode(), Path("m.sdf")), Version(1, 4))
    assert '<foo:d joint="n__nj">n__nj</foo:d>' in done.text
    assert "<drake:member>n__l</drake:member>" in done.text
    assert '<foo:part link="n__l"/>' in done.text
    messages = [loss.message for loss in done.losses]
    assert any("says `l`: is it the link that is called `n__l` now?" in message for message in messages)
    assert any(message.startswith("attribute `foo:kind` of model `n` is left out") for message in messages)


def test_printing_keeps_words_and_blanks(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    source = tmp_path / "m.sdf"
    kept = (
        "<foo:note>see <b>the</b> manual, page <i>4</i>.</foo:note>",
        '<foo:pre xml:space="preserve">  a\n b <c/> </foo:pre>',
    )
    source.write_text(
        f'<sdf version="1.9" xmlns:foo="u"><model name="m"><link name="l"/>{"".join(kept)}</model></sdf>'
    )
    assert main(["print", str(source)]) == 0
    out = capsys.readouterr().out
    assert all(text in out for text in kept)
