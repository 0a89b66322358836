"""The package as programs use it."""

from __future__ import annotations

import re
import subprocess
import sys
from importlib.metadata import version
from pathlib import Path

import pytest

import sdfcheck

FIXTURES = Path(__file__).parents[2] / "fixtures"
GARDEN = FIXTURES / "api" / "garden.sdf"
ARM = FIXTURES / "robots" / "desk_arm" / "desk_arm.urdf"


def test_the_walk_of_the_proposal() -> None:
    """The example of the custom-elements proposal, step by step, on a document of our own."""
    root = sdfcheck.load(GARDEN)

    world = root.world(0)
    season = world.attribute("farm:season")
    assert season is not None
    assert season.text == season.to(str) == "spring"

    model = world.model(0)
    post = model.link(0)
    paint = post.get("farm:paint")
    coats = post.get("farm:coats", int)
    assert (paint, coats) == ("green", 2)

    drive = model.find("farm:drive")
    assert drive is not None
    assert drive.get("name") == "opener"
    assert drive.get("farm:kind") == "farm/Motor"

    joint = drive.find("farm:joint")
    assert joint is not None
    assert joint.get("name") == "hinge"

    signal = joint.find("farm:signal")
    assert signal is not None
    assert joint.get("farm:signal") == signal.content == "effort"
    second = signal.next("farm:signal")
    assert second is not None
    assert second.content == "position"
    assert second.next("farm:signal") is None


def test_parts_by_name() -> None:
    world = sdfcheck.load(GARDEN).world("garden")
    assert world.get("farm:owner") == "Ada"
    model = world.model("gate")
    assert [link.name for link in model.links] == ["post", "wing"]
    assert model.link("wing").element is model.links[1].element
    hinge = model.joint("hinge")
    assert (hinge.type, hinge.parent_name, hinge.child_name) == ("revolute", "post", "wing")
    assert (hinge.parent, hinge.child) == model.links
    assert model.joint(-1).name == "hinge"
    assert model.has("farm:drive")
    assert not model.has("farm:brake")


def test_included_and_nested_models_are_found() -> None:
    world = sdfcheck.load(GARDEN).world(0)
    assert [model.name for model in world.models] == ["gate", "store"]
    store = world.model("store")
    assert store.element.document.path.name == "shed.sdf"
    assert store.include is not None
    assert store.include.get("uri") == "shed.sdf"
    assert store.link("door::panel").name == "panel"
    assert world.model("store::door").link(0).name == "panel"
    assert world.model("gate").include is None


def test_a_urdf_file_is_one_model() -> None:
    root = sdfcheck.load(str(ARM))
    (model,) = root.models
    assert root.worlds == ()
    assert model.name == root.element.get("name")
    joint = model.joints[0]
    assert model.link(joint.parent_name) is joint.parent is not joint.child


def test_xacro_is_expanded() -> None:
    text = """<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
      <xacro:arg name="n" default="a"/><link name="$(arg n)"/></robot>"""
    assert sdfcheck.parse(text, "r.urdf.xacro").model(0).link(0).name == "a"
    assert sdfcheck.parse(text, "r.urdf.xacro", arguments={"n": "b"}).model("r").link(0).name == "b"


@pytest.mark.parametrize(
    ("look", "message"),
    [
        (lambda root: root.world(1), "the file has no world number 1; it has 1 world"),
        (lambda root: root.world("gardn"), "the file has no world `gardn`; did you mean `garden`?"),
        (
            lambda root: root.world(0).model("gate").link(7),
            "model `gate` has no link number 7; it has 2 links",
        ),
        (
            lambda root: root.world(0).model("gate").link("pst"),
            "model `gate` has no link `pst`; did you mean `post`?",
        ),
        (
            lambda root: root.world(0).model("store::dor"),
            "model `store` has no model `dor`; did you mean `door`?",
        ),
        (lambda root: root.model(0), "the file has no model number 0; it has 0 models"),
    ],
)
def test_a_missing_file_is_reported(look: object, message: str) -> None:
    with pytest.raises(sdfcheck.NotFound) as caught:
        look(sdfcheck.load(GARDEN))  # type: ignore[operator]
    assert str(caught.value) == message


def test_values_have_types_or_say_why_not() -> None:
    root = sdfcheck.parse(
        '<sdf version="1.9"><world name="w" a:b="5" a:c="yes" a:d=" true "/></sdf>', "w.sdf"
    )
    world = root.world(0)
    assert world.get("a:b", int) == 5
    assert world.get("a:b", float) == 5.0
    assert world.get("a:d", bool) is True
    assert world.get("a:none", int) is None
    assert world.attribute("a:none") is None
    with pytest.raises(ValueError, match=r"^w\.sdf:1:49: a:c is 'yes', not bool$"):
        world.get("a:c", bool)
    value = world.attribute("a:c")
    assert value is not None
    with pytest.raises(ValueError, match="a:c is 'yes', not float"):
        value.to(float)


def test_looking_changes_nothing() -> None:
    def tree() -> str:
        return str([(e.name, e.attributes, e.text, e.tail, e.nodes) for e in root.element.walk()])

    root = sdfcheck.load(GARDEN)
    before = tree()
    model = root.world(0).model(0)
    assert model.find("farm:none") is None
    assert model.get("farm:none") is None
    assert not model.has("farm:none")
    assert list(model.children("farm:none")) == []
    with pytest.raises(sdfcheck.NotFound):
        model.link("none")
    assert tree() == before


def test_prefixes_need_no_declaration() -> None:
    root = sdfcheck.parse(
        '<sdf version="1.9"><model name="m"><link name="l" x:a="1"/><x:b>2</x:b></model></sdf>'
    )
    model = root.model("m")
    assert model.link("l").get("x:a", int) == 1
    assert model.get("x:b", float) == 2.0


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "looks like an empty file"),
        ("<mujoco/>", "looks like MJCF"),
        ("<model><name>m</name></model>", "no robot description"),
    ],
)
def test_a_text_that_is_not_a_robot_is_refused(text: str, message: str) -> None:
    with pytest.raises(sdfcheck.Unreadable, match=message):
        sdfcheck.parse(text, "a.sdf")


def test_a_missing_file_is_an_os_error(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError):
        sdfcheck.load(tmp_path / "none.sdf")


def test_linting(tmp_path: Path) -> None:
    run = sdfcheck.lint('<sdf version="1.9"><world name="w"><!-- -- --></world></sdf>', isolated=True)
    assert isinstance(run, sdfcheck.Run)
    (found,) = run.diagnostics
    assert (found.name, found.span.begin) == ("double-hyphen-in-comment", (1, 41))
    assert [run.count(each) for each in sdfcheck.Severity if each is not found.severity] == [0, 0]
    assert run.count(found.severity) == 1
    assert found.fix is not None
    assert sdfcheck.lint(ARM, isolated=True).files == (ARM,)
    assert len(sdfcheck.lint([ARM, GARDEN], isolated=True).files) == 2
    assert (
        sdfcheck.lint(b"<sdf version='1.9'/>", name="b.sdf", isolated=True, select=["NS"]).diagnostics == ()
    )
    with pytest.raises(sdfcheck.WrongUsage, match="no such file"):
        sdfcheck.lint(tmp_path / "none.sdf")
    with pytest.raises(sdfcheck.WrongUsage):
        sdfcheck.lint(ARM, select=["ns01"], isolated=True)


def test_converting_there_and_back() -> None:
    there = sdfcheck.convert(ARM, "sdf", version="1.9")
    assert there.text.startswith("<?xml")
    assert sdfcheck.parse(there.text).version == "1.9"
    assert there.verification is not None
    assert there.verification.is_equal
    assert there.verification.links == len(sdfcheck.load(ARM).models[0].links)
    back = sdfcheck.convert(there.text, "urdf")
    assert back.verification is not None
    assert back.verification.is_equal
    assert sdfcheck.parse(back.text).model(0).link("upper_arm").name == "upper_arm"


def test_converting_between_versions() -> None:
    done = sdfcheck.convert(sdfcheck.load(GARDEN.with_name("shed.sdf")), "sdf", version="1.12", verify=False)
    assert sdfcheck.parse(done.text).version == "1.12"
    assert done.verification is None


@pytest.mark.parametrize(
    ("to", "options", "message"),
    [
        ("mjcf", {}, "URDF is not converted to `mjcf`"),
        ("urdf", {}, "URDF is not converted to `urdf`"),
        ("sdf", {"model": "m"}, "URDF is not converted to `sdf`, model m"),
        ("sdf", {"version": "1.99"}, "`1.99` is not a version of SDFormat from 1.4 to 1.12"),
    ],
)
def test_a_file_that_cannot_be_converted_is_reported(to: str, options: dict[str, str], message: str) -> None:
    with pytest.raises(sdfcheck.WrongUsage, match=message):
        sdfcheck.convert(ARM, to, **options)  # type: ignore[arg-type]


def test_the_package_brings_nothing_along() -> None:
    code = "import sdfcheck, sys; print(*(n for n in sys.modules if n.startswith(('sdfcheck.', 'lxml'))))"
    child = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert child.stdout == "\n"


def test_every_public_name_is_there() -> None:
    for name in sdfcheck.__all__:
        assert getattr(sdfcheck, name) is not None
    assert set(sdfcheck.__all__) == set(dir(sdfcheck))


MANUAL = FIXTURES.parent / "docs" / "api.md"


def examples_of_the_manual() -> str:
    text = MANUAL.read_text(encoding="utf-8")
    return "".join(re.findall(r"^```python\n(.*?)^```$", text, re.MULTILINE | re.DOTALL))


def test_the_examples_of_the_manual_run(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    for file in GARDEN.parent.iterdir():
        (tmp_path / file.name).write_bytes(file.read_bytes())
    (tmp_path / "copy.sdf").write_bytes(GARDEN.read_bytes())
    monkeypatch.chdir(tmp_path)
    exec(examples_of_the_manual(), {})
    out = capsys.readouterr().out
    assert out.startswith(
        "['post', 'wing']\nLink('panel')\n30.0\n1.6 True -inf (default)\n1.0 (default) False\n"
    )
    assert "640.0 240.0 (default)\n(0.0, 0.05, 0.0) (3.0, 0.05, 0.0)\n(4, 4)\n['base'] ['lift']\n1.5\n" in out
    assert "spring\n['farm:owner', 'farm:season'] Ada\ngreen 2\nopener effort " in out
    assert "\nleaf\n" in out
    assert "\n1 file\n1\n2 files\n" in out
    assert out.endswith(
        "True True\n()\n['drake', 'gazebo', 'isaac', 'mujoco', 'pinocchio', 'pybullet', 'ros', 'urdfdom']\n1.5\n"
        '<robot name="arm">\n'
    )
    assert "farm:coats" in (tmp_path / "copy.sdf").read_text()
    with pytest.raises(ValueError, match="not int") as caught:
        sdfcheck.load("garden.sdf").world(0).model(0).link(0).get("farm:paint", int)
    place = str(caught.value).partition(": ")[0]
    assert str(caught.value).replace(place, "") in MANUAL.read_text(encoding="utf-8")


@pytest.mark.skipif(version("mypy").startswith("1."), reason="mypy 2 is needed")
def test_the_examples_of_the_manual_have_sound_types(tmp_path: Path) -> None:
    script = tmp_path / "manual.py"
    script.write_text(examples_of_the_manual(), encoding="utf-8")
    cache = FIXTURES.parent / ".mypy_cache"
    options = ["--strict", "--cache-dir", str(cache), "--python-version", "3.10"]
    command = [sys.executable, "-m", "mypy", *options, str(script)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr


def test_a_sensor_knows_the_link_that_it_is_on() -> None:
    sensor = '<sensor name="s" type="imu"/>'
    joint = f'<joint name="j" type="fixed"><parent>l</parent><child>k</child>{sensor}</joint>'
    text = f'<sdf version="1.9"><model name="m"><link name="l">{sensor}</link><link name="k"/>{joint}</model></sdf>'
    on_link, on_joint = sdfcheck.parse(text).each(sdfcheck.Sensor)
    assert on_link.link is on_link.owner
    assert on_joint.link is None
    assert on_joint.owner is not None


def test_the_place_that_xacro_cannot_expand_is_said(tmp_path: Path) -> None:
    file = tmp_path / "r.urdf.xacro"
    xacro = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'
    file.write_text(f'<robot name="r" {xacro}>\n<link name="${{1/0}}"/></robot>')
    with pytest.raises(sdfcheck.Unreadable, match=r"xacro:2:13: `\$\{1/0\}` cannot be expanded, so xacro"):
        sdfcheck.load(file)
    file.write_text(f'<robot name="r" {xacro}>\n<xacro:include filename="$(find far)/a.xacro"/></robot>')
    with pytest.raises(sdfcheck.Unreadable, match="package `far` is not found, so xacro does not expand"):
        sdfcheck.load(file)


def test_packages_are_named_for_xacro(tmp_path: Path) -> None:
    part = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro">{}</robot>'
    (tmp_path / "far").mkdir()
    (tmp_path / "far" / "part.xacro").write_text(part.format('<link name="l"/>'))
    (tmp_path / "near").mkdir()
    file = tmp_path / "near" / "r.urdf.xacro"
    include = '<xacro:include filename="$(find far)/part.xacro"/>'
    file.write_text(part.format(include).replace("<robot", '<robot name="r"'))
    loaded = sdfcheck.load(file, packages={"far": tmp_path / "far"})
    assert [link.name for link in loaded.model("r").links] == ["l"]
