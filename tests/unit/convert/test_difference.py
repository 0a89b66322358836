"""Changes in a robot, and the absence of them."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from sdfcheck.cli.main import main
from sdfcheck.convert.comparison import Change, ChangeKind
from sdfcheck.convert.file_difference import FileDifference, compare_files
from tests.unit.robot.files import opened, write

LINK = (
    "<link name='{}'><inertial><mass>1</mass></inertial>"
    "<visual name='v'><geometry><box><size>1 1 1</size></box></geometry></visual></link>"
)
ARM = (
    "<sdf version='1.10'><model name='arm'>"
    "<link name='base'><inertial><mass>1</mass></inertial>"
    "<visual name='v'><geometry><box><size>1 1 1</size></box></geometry></visual></link>"
    "<link name='fore'><pose>0 0 1 0 0 0</pose><inertial><mass>2</mass></inertial></link>"
    "<link name='tip'><pose relative_to='fore'>0 0 1 0 0 0</pose></link>"
    "<joint name='elbow' type='revolute'><parent>base</parent><child>fore</child><axis><xyz>0 1 0</xyz>"
    "<limit><lower>-1</lower><upper>1</upper></limit></axis></joint>"
    "<joint name='wrist' type='fixed'><parent>fore</parent><child>tip</child></joint>"
    "</model></sdf>"
)
URDF = (
    "<robot name='arm'><link name='base'><inertial><mass value='1'/>"
    "<inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='1'/></inertial>"
    "<visual><geometry><box size='1 1 1'/></geometry></visual></link>"
    "<link name='fore'><inertial><mass value='2'/>"
    "<inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='1'/></inertial></link><link name='tip'/>"
    "<joint name='elbow' type='revolute'><origin xyz='0 0 1'/><parent link='base'/><child link='fore'/>"
    "<axis xyz='0 1 0'/><limit lower='-1' upper='1'/></joint>"
    "<joint name='wrist' type='fixed'><origin xyz='0 0 1'/><parent link='fore'/><child link='tip'/></joint>"
    "</robot>"
)


def difference(folder: Path, a: str, b: str) -> FileDifference:
    names = ["a.urdf" if "<robot" in a else "a.sdf", "b.urdf" if "<robot" in b else "b.sdf"]
    write(folder, dict(zip(names, (a, b), strict=True)))
    return compare_files(opened(folder / names[0]), opened(folder / names[1]))


def changes(folder: Path, a: str, b: str) -> list[Change]:
    return [change for _, found in difference(folder, a, b).changes for change in found]


def edited(folder: Path, old: str, new: str, text: str = ARM) -> list[tuple[str, str, str, str, str]]:
    """The changes that an edit makes, without their kind."""
    assert old in text
    found = changes(folder, text, text.replace(old, new))
    assert all(change.kind is ChangeKind.CHANGED for change in found)
    return [(change.part, change.name, change.what, change.before, change.after) for change in found]


def test_another_text_may_be_the_same_robot(tmp_path: Path) -> None:
    other = ARM.replace(
        "<pose relative_to='fore'>0 0 1 0 0 0</pose>", "<pose degrees='true'>0 0 2 0 0 0</pose>"
    )
    other = other.replace("<mass>2</mass>", "<!-- kg --><mass>2.000</mass>")
    found = difference(tmp_path, ARM, other)
    assert found.changes == ()
    assert (found.models, found.links, found.joints) == (1, 3, 2)


def test_another_format_may_be_the_same_robot(tmp_path: Path) -> None:
    assert changes(tmp_path, ARM, URDF) == []
    assert changes(tmp_path, URDF, ARM) == []


def test_a_change_across_formats(tmp_path: Path) -> None:
    (change,) = changes(tmp_path, ARM, URDF.replace("upper='1'", "upper='2'"))
    assert (change.part, change.name, change.what, change.before, change.after) == (
        "joint",
        "elbow",
        "upper",
        "1",
        "2",
    )


def test_a_link_without_mass_in_the_other_format_is_a_change(tmp_path: Path) -> None:
    massless = re.sub(
        "<link name='fore'>.*</link><link name='tip'/>", "<link name='fore'/><link name='tip'/>", URDF
    )
    for a, b, texts in ((ARM, massless, ("2 kg", "none")), (massless, ARM, ("none", "2 kg"))):
        (change,) = changes(tmp_path, a, b)
        assert (change.name, change.what, change.before, change.after) == ("fore", "inertial", *texts)


@pytest.mark.parametrize(("static", "count"), [("true", 0), ("1", 0), ("0", 1)])
def test_a_block_of_a_urdf_makes_the_robot_static(tmp_path: Path, static: str, count: int) -> None:
    urdf = URDF.replace("</robot>", f"<gazebo><static>{static}</static></gazebo></robot>")
    sdf = ARM.replace("<model name='arm'>", "<model name='arm'><static>true</static>")
    assert sum(change.what == "static" for change in changes(tmp_path, urdf, sdf)) == count


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        ("<mass>2</mass>", "<mass>3</mass>", ("link", "fore", "mass", "2", "3")),
        ("0 1 0</xyz>", "0 0 1</xyz>", ("joint", "elbow", "direction", "0 1 0", "0 0 1")),
        ("<lower>-1<", "<lower>-2<", ("joint", "elbow", "lower", "-1", "-2")),
        ("<upper>1</upper>", "<upper>inf</upper>", ("joint", "elbow", "upper", "1", "none")),
        ("'fixed'", "'ball'", ("joint", "wrist", "type", "fixed", "ball")),
        ("1 1 1</size>", "1 2 1</size>", ("link", "base", "visual `v` size", "1 1 1", "1 2 1")),
        ("<mass>2</mass>", "<pose>1 0 0 0 0 0</pose><mass>2</mass>",
         ("link", "fore", "center of mass", "0 0 0", "1 0 0")),
        ("<mass>2</mass>", "<mass>2</mass><inertia><iyz>0.1</iyz></inertia>", ("link", "fore", "iyz", "0", "0.1")),
        ("</axis>", "<dynamics><damping>1</damping></dynamics></axis>", ("joint", "elbow", "damping", "0", "1")),
        ("<box><size>1 1 1</size></box>", "<sphere/>", ("link", "base", "visual `v` shape", "box `v`", "sphere `v`")),
        ("<model name='arm'>", "<model name='arm'><static>1</static>", ("model", "arm", "static", "false", "true")),
        ("<model name='arm'>", "<model name='arm'><pose>1 0 0 0 0 0</pose>",
         ("model", "arm", "pose", "0 0 0 0 0 0", "1 0 0 0 0 0")),
    ],
)  # fmt: skip
def test_one_edit_is_one_change(tmp_path: Path, old: str, new: str, expected: tuple[str, ...]) -> None:
    assert edited(tmp_path, old, new) == [expected]


def test_a_moved_joint_does_not_move_the_parts_after_it(tmp_path: Path) -> None:
    found = edited(
        tmp_path,
        "<origin xyz='0 0 1'/><parent link='base'/>",
        "<origin xyz='0 0 3'/><parent link='base'/>",
        URDF,
    )
    assert found == [("link", "fore", "pose in `base`", "0 0 1 0 0 0", "0 0 3 0 0 0")]


def test_new_and_removed_findings(tmp_path: Path) -> None:
    found = changes(tmp_path, ARM, ARM.replace("</model>", LINK.format("lamp") + "</model>"))
    assert [(change.kind, change.part, change.name) for change in found] == [
        (ChangeKind.ADDED, "link", "lamp")
    ]
    found = changes(tmp_path, ARM.replace("</model>", LINK.format("lamp") + "</model>"), ARM)
    assert [(change.kind, change.part, change.name) for change in found] == [
        (ChangeKind.REMOVED, "link", "lamp")
    ]


def test_new_names_are_reported_as_such(tmp_path: Path) -> None:
    found = changes(
        tmp_path, ARM, ARM.replace("'base'", "'foot'").replace(">base<", ">foot<").replace("elbow", "knee")
    )
    assert [(change.kind, change.part, change.before, change.after) for change in found] == [
        (ChangeKind.RENAMED, "link", "base", "foot"),
        (ChangeKind.RENAMED, "joint", "elbow", "knee"),
    ]


def test_a_name_among_twins_cannot_be_followed(tmp_path: Path) -> None:
    model = "<sdf version='1.10'><model name='m'>{}{}</model></sdf>"
    found = changes(
        tmp_path,
        model.format(LINK.format("a"), LINK.format("b")),
        model.format(LINK.format("c"), LINK.format("d")),
    )
    assert {change.kind for change in found} == {ChangeKind.ADDED, ChangeKind.REMOVED}


def test_nested_models(tmp_path: Path) -> None:
    nested = (
        "<sdf version='1.10'><model name='m'><link name='a'/><model name='n'><pose>{} 0 0 0 0 0</pose>"
        "<link name='b'/></model></model></sdf>"
    )
    (change,) = changes(tmp_path, nested.format(1), nested.format(2))
    assert (change.name, change.what) == ("n::b", "pose")


def test_models_of_worlds(tmp_path: Path) -> None:
    world = "<sdf version='1.10'><world name='w'>{}</world></sdf>"
    model = "<model name='{}'><pose>{} 0 0 0 0 0</pose><link name='{}'/></model>"
    a = world.format(model.format("x", 0, "l") + model.format("y", 0, "k"))
    b = world.format(model.format("x", 1, "l") + model.format("z", 0, "j") + model.format("q", 0, "j"))
    found = changes(tmp_path, a, b)
    assert [(change.kind.value, change.name) for change in found] == [
        ("changed", "x"),
        ("removed", "y"),
        ("added", "z"),
        ("added", "q"),
    ]


def test_mimicking(tmp_path: Path) -> None:
    mimic = "<mimic joint='wrist'/><limit lower="
    (change,) = changes(tmp_path, URDF, URDF.replace("<limit lower=", mimic))
    assert (change.what, change.before, change.after) == ("mimic", "none", "1 × `wrist` + 0")


def test_a_moved_frame_is_one_change(tmp_path: Path) -> None:
    model = """<sdf version='1.10'><model name='m'><link name='a'/><link name='b'><pose>{}</pose>
      <inertial><pose>{}</pose><mass>2</mass></inertial>
      <visual name='v'><pose>{}</pose><geometry><sphere/></geometry></visual></link>
      <joint name='j' type='revolute'><pose>{}</pose><parent>a</parent><child>b</child>
      <axis><xyz>0 0 1</xyz></axis></joint></model></sdf>"""
    a = model.format("0 0 1 0 0 0", "0 0 0 0 0 0", "0 0 0.5 0 0 0", "0 0 -1 0 0 0")
    b = model.format("0 0 0 0 0 0", "0 0 1 0 0 0", "0 0 1.5 0 0 0", "0 0 0 0 0 0")
    (change,) = changes(tmp_path, a, b)
    assert (change.part, change.name, change.what) == ("link", "b", "frame")
    assert change.after == "0 0 -1 0 0 0"


def test_a_joint_moved_between_links_that_stay_is_one_change(tmp_path: Path) -> None:
    model = """<sdf version='1.10'><model name='m'><link name='a'/><link name='b'><pose>0 0 1 0 0 0</pose></link>
      <joint name='j' type='revolute'><pose>0 0 {} 0 0 0</pose><parent>a</parent><child>b</child>
      <axis><xyz>0 0 1</xyz></axis></joint></model></sdf>"""
    (change,) = changes(tmp_path, model.format(0), model.format(1))
    assert (change.part, change.name, change.what) == ("joint", "j", "pose in the child")


def test_a_model_moved_within_its_frame_stays(tmp_path: Path) -> None:
    model = "<sdf version='1.10'><model name='m'><pose>{}</pose><link name='a'><pose>{}</pose></link></model></sdf>"
    a, b = model.format("0 0 1 0 0 0", "1 0 0 0 0 0"), model.format("1 0 1 0 0 0", "0 0 0 0 0 0")
    assert changes(tmp_path, a, b) == []


def test_a_joint_turned_round_is_one_change(tmp_path: Path) -> None:
    joint = "<joint name='j' type='revolute'><parent>{}</parent><child>{}</child><axis><xyz>0 0 {}</xyz></axis></joint>"
    model = "<sdf version='1.10'><model name='m'><link name='a'/><link name='b'/>{}</model></sdf>"
    a, b = (model.format(joint.format(*ends)) for ends in (("a", "b", 1), ("b", "a", -1)))
    (change,) = changes(tmp_path, a, b)
    assert (change.part, change.name, change.what) == ("joint", "j", "parent and child")


def test_a_frame_on_another_link_is_one_change(tmp_path: Path) -> None:
    text = ARM.replace("</model>", "<frame name='f' attached_to='base'/></model>")
    (change,) = changes(
        tmp_path,
        text,
        text.replace("<frame name='f' attached_to='base'/>", "<frame name='f' attached_to='tip'/>"),
    )
    assert (change.part, change.name, change.what, change.before, change.after) == (
        "frame",
        "f",
        "attached to",
        "base",
        "tip",
    )


def test_the_only_shape_of_a_link_is_followed_without_a_name(tmp_path: Path) -> None:
    found = changes(tmp_path, ARM, ARM.replace("name='v'", "name='w'").replace("1 1 1", "1 1 2"))
    assert [change.what for change in found] == ["name of a visual", "visual `w` size"]


@pytest.mark.parametrize(
    ("name", "reported"), [("base_visual", []), ("base_visual_1", []), ("shell", ["name of a visual"])]
)
def test_a_shape_without_a_name_is_called_like_its_link(
    tmp_path: Path, name: str, reported: list[str]
) -> None:
    found = changes(tmp_path, URDF, URDF.replace("<visual>", f"<visual name='{name}'>", 1))
    assert [change.what for change in found] == reported


def test_a_follower_is_the_same_by_another_reference(tmp_path: Path) -> None:
    mimic = (
        "<mimic joint='lead'><multiplier>2</multiplier><offset>{}</offset><reference>{}</reference></mimic>"
    )
    text = (
        "<sdf version='1.11'><model name='m'><link name='a'/><link name='b'/><link name='c'/>"
        "<joint name='lead' type='revolute'><parent>a</parent><child>b</child><axis><xyz>0 0 1</xyz></axis></joint>"
        "<joint name='follow' type='revolute'><parent>a</parent><child>c</child>"
        "<axis><xyz>0 0 1</xyz>{}</axis></joint></model></sdf>"
    )
    one, same, other = (text.format(mimic.format(*each)) for each in ((0.5, 0.2), (0.1, 0), (0.9, 0)))
    assert changes(tmp_path, one, same) == []
    assert [change.what for change in changes(tmp_path, one, other)] == ["mimic"]


@pytest.mark.parametrize(("kind", "count"), [("fixed", 0), ("revolute", 1)])
def test_a_static_model_needs_no_joint_to_the_world(tmp_path: Path, kind: str, count: int) -> None:
    model = "<sdf version='1.10'><model name='m'><static>1</static><link name='a'/>{}</model></sdf>"
    joint = f"<joint name='j' type='{kind}'><parent>world</parent><child>a</child><axis><xyz>0 0 1</xyz></axis></joint>"
    assert len(changes(tmp_path, model.format(""), model.format(joint))) == count


def test_a_moved_frame_of_the_first_link_is_one_change(tmp_path: Path) -> None:
    model = """<sdf version='1.10'><model name='m'><link name='a'><pose>0 0 {} 0 0 0</pose>
      <inertial><pose>0 0 {} 0 0 0</pose><mass>2</mass></inertial></link><link name='b'/>
      <joint name='j' type='revolute'><parent>a</parent><child>b</child>
      <axis><xyz>0 0 1</xyz></axis></joint></model></sdf>"""
    (change,) = changes(tmp_path, model.format(1, 0), model.format(0, 1))
    assert (change.part, change.name, change.what) == ("link", "a", "frame")


def test_a_joint_without_limits_that_matter_is_continuous(tmp_path: Path) -> None:
    joint = '<joint name="j" type="{}"><parent link="a"/><child link="b"/><limit {} effort="1" velocity="1"/></joint>'
    texts = [
        f'<robot name="r"><link name="a"/><link name="b"/>{joint.format(*given)}</robot>'
        for given in (
            ("revolute", 'lower="-1e16" upper="1e16"'),
            ("continuous", ""),
            ("revolute", 'lower="-9" upper="9"'),
        )
    ]
    files = [tmp_path / f"{number}.urdf" for number in range(3)]
    for file, text in zip(files, texts, strict=True):
        file.write_text(text)
    assert main(["diff", str(files[0]), str(files[1]), "--isolated"]) == 0
    assert main(["diff", str(files[0]), str(files[2]), "--isolated"]) == 1
