from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.convert.result import Conversion, seen_from
from sdfcheck.convert.urdf_to_sdf.conversion import urdf_to_sdf
from sdfcheck.convert.urdf_to_sdf.options import FixedJoints, Options
from sdfcheck.convert.writer import number, numbers, render, settled, write_atomically
from sdfcheck.source.altered import Xml, copied
from sdfcheck.source.document import Comment, read
from sdfcheck.source.errors import WrongUsage
from sdfcheck.source.sniff import Kind


def test_text_and_attributes_are_escaped() -> None:
    root = Xml("a", "1 < 2 & 3", name='say "hi"')
    assert render(root) == '<?xml version="1.0"?>\n<a name="say &quot;hi&quot;">1 &lt; 2 &amp; 3</a>\n'


def test_comments_stay_comments() -> None:
    root = Xml("a")
    root.extend(Comment(" one -- two -"))
    text = render(root, before=[Comment(" first ")])
    assert "<!-- first -->" in text
    assert "<!-- one - - two - -->" in text


@pytest.mark.parametrize(
    ("value", "text"),
    [(0.0, "0"), (-0.0, "0"), (1.0, "1"), (0.1, "0.1"), (1e-7, "1e-07"), (1 / 3, repr(1 / 3))],
)
def test_numbers_are_short_and_exact(value: float, text: str) -> None:
    assert number(value) == text
    assert float(number(value)) == value


def test_dust_is_swept() -> None:
    assert numbers((1, -6e-17, 2.5)) == "1 0 2.5"


def test_copies_keep_prefixes_and_comments() -> None:
    text = '<robot name="r" xmlns:a="urn:a"><a:b c="1"><!-- why --><d>2</d></a:b></robot>'
    root = read(text.encode(), Path("r.urdf"), Kind.URDF).root
    assert root is not None
    node = copied(next(root.children()))
    assert (node.name, node.attributes) == ("a:b", {"c": "1"})
    assert isinstance(node.nodes[0], Comment)
    assert node.reach("d").text == "2"


def test_a_folder_that_is_not_there_is_wrong_usage(tmp_path: Path) -> None:
    with pytest.raises(WrongUsage, match="cannot write"):
        write_atomically(tmp_path / "none" / "a.sdf", "text")


def test_a_rounding_error_is_zero() -> None:
    assert settled(-1.29e-32) == 0
    assert settled(-1.29e-32, 1e-18) == -1.29e-32
    assert settled(3e-14) == 3e-14
    assert numbers((-1.29e-32, 0.5, -0.0)) == "0 0.5 0"


def test_mass_properties_of_links_that_were_joined_are_written_without_noise() -> None:
    box = '<inertial><mass value="{}"/><inertia ixx="0.1" ixy="0" ixz="0" iyy="0.2" iyz="0" izz="0.3"/></inertial>'
    text = (
        f'<robot name="r"><link name="a">{box.format(1)}</link><link name="b">{box.format(2)}</link>'
        '<joint name="j" type="fixed"><origin rpy="1.5707963267948966 0 3.141592653589793"/>'
        '<parent link="a"/><child link="b"/></joint></robot>'
    )
    document = read(text.encode(), Path("r.urdf"), Kind.URDF)
    done = urdf_to_sdf(document, Options(fixed_joints=FixedJoints.MERGE))
    assert "e-" not in done.text.partition("<inertial>")[2].partition("</inertial>")[0]
    assert done.verification is not None
    assert done.verification.is_equal


def test_angles_in_a_text_are_escaped() -> None:
    node = Xml("a", "1 < 2 > 1 & 3 ]]> 4")
    assert "1 &lt; 2 &gt; 1 &amp; 3 ]]&gt; 4" in render(node)


@pytest.mark.parametrize(
    ("written", "moved"),
    [
        ("a.stl", "../source/a.stl"),
        ("  a.stl ", "  ../source/a.stl "),
        ("b.stl", "b.stl"),
        ("model://m/a.stl", "model://m/a.stl"),
    ],
)
def test_files_are_named_as_seen_from_the_folder_of_the_result(
    tmp_path: Path, written: str, moved: str
) -> None:
    source, target = tmp_path / "source", tmp_path / "target"
    for folder in (source, target):
        folder.mkdir()
    (source / "a.stl").touch()
    text = (
        '<sdf version="1.9"><model name="m"><link name="l"><visual name="v"><geometry><mesh>'
        "<uri>{}</uri></mesh></geometry></visual></link></model></sdf>"
    )
    document = read(text.format(written).encode(), source / "m.sdf", Kind.SDF)
    done = Conversion(document.source.text, document)
    assert seen_from(done, source, target) == text.format(moved)
