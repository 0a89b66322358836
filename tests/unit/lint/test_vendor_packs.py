"""A pack brings a table for a prefix of its own, and rules about it."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.files.library import Library, SearchPaths
from sdfcheck.lint.config.settings import UNSET
from sdfcheck.lint.diagnostic import Diagnostic, Severity
from sdfcheck.lint.engine import Dispatch
from sdfcheck.lint.one_file import lint_source
from sdfcheck.lint.rulebook.pack import PackError
from sdfcheck.lint.rulebook.packs import RuleIndex, load_index
from sdfcheck.lint.select import ActiveRules, select
from sdfcheck.testing import Trial, examples

FLATLAND = Path(__file__).parents[3] / "fixtures" / "packs" / "flatland"
INDEX = load_index((FLATLAND,))

MODEL = (
    '<sdf version="1.7" xmlns:flatland="https://example.org/flatland/schema" {}><world name="w" {}>'
    '<model name="m"><link name="a" {}/><link name="b">{}</link>'
    '<joint name="j" type="revolute"><parent>a</parent><child>b</child>'
    "<axis><xyz>0 0 1</xyz></axis></joint>{}</model></world></sdf>"
)
DRIVE = (
    '<flatland:transmission name="t"><flatland:type>simple</flatland:type><flatland:joint name="j">'
    "<flatland:hardware_interface>EffortJointInterface</flatland:hardware_interface></flatland:joint>{}"
    "</flatland:transmission>"
)


def around(index: RuleIndex) -> Library:
    return Library(SearchPaths(tables=index.tables))


def lint(text: str) -> list[Diagnostic]:
    dispatch, library = Dispatch(INDEX, ActiveRules(INDEX.facts, {})), around(INDEX)
    found = lint_source(text.encode(), Path("model.sdf"), None, dispatch, library).diagnostics
    assert "INT001" not in {d.code for d in found}, found
    return [d for d in found if d.code.startswith(("FLT", "DRK"))]


def said(*, root: str = "", world: str = "", link: str = "", inner: str = "", model: str = "") -> list[str]:
    return [f"{d.code} {d.message}" for d in lint(MODEL.format(root, world, link, inner, model))]


def test_the_example_of_the_proposal_is_fine() -> None:
    assert not said(world='flatland:type="2d"', link='flatland:custom_attr_int="5"', model=DRIVE.format(""))


@pytest.mark.parametrize("example", examples(FLATLAND), ids=str)
def test_the_examples_of_the_pack(example: Trial) -> None:
    example.check()


@pytest.mark.parametrize(
    ("places", "message"),
    [
        (
            {"link": 'flatland:custom_attr_int="50"'},
            "FLT002 `flatland:custom_attr_int` should be from 0 to 10",
        ),
        (
            {"link": 'flatland:custom_attr_int="5.5"'},
            "FLT002 `flatland:custom_attr_int` should be a whole number",
        ),
        ({"inner": "<flatland:transmission/>"}, "FLT001 `flatland:transmission` does not belong in link `b`"),
        ({"inner": "<flatland:laser/>"}, "FLT004 `flatland:laser` needs `flatland:beam`: Flatland refuses"),
        (
            {"model": DRIVE.format("<flatland:gearing>-1</flatland:gearing>")},
            "should be above 0, not `-1`: Flatland aborts",
        ),
        (
            {"model": DRIVE.format("") * 2},
            "FLT004 there is a `flatland:transmission` of the name `t` already",
        ),
        (
            {
                "root": 'flatland:version="2.0"',
                "model": DRIVE.format("<flatland:gearing>2</flatland:gearing>"),
            },
            "FLT004 `flatland:gearing` came with Flatland 2.1, and the file says 2.0",
        ),
    ],
)
def test_the_table_is_held_against_the_document(places: dict[str, str], message: str) -> None:
    found = said(**places)
    assert any(message in text for text in found), found


def test_an_ignored_part_is_a_warning() -> None:
    (found,) = lint(MODEL.format("", "", 'flatland:custom_attr_int="50"', "", ""))
    assert found.severity is Severity.WARNING


def test_rules_of_one_vendor_leave_another_alone() -> None:
    text = MODEL.format('xmlns:drake="http://drake.mit.edu"', "", "", "", "<flatland:x/><drake:y/>")
    assert [d.code for d in lint(text)] == ["FLT001", "DRK001"]


def test_without_the_pack_its_prefix_is_free() -> None:
    index = load_index()
    active = select(index.facts, UNSET)
    text = MODEL.format("", "", "", "", "<flatland:x/>")
    found = lint_source(text.encode(), Path("m.sdf"), None, Dispatch(index, active)).diagnostics
    assert not [d for d in found if "flatland" in d.message]


@pytest.mark.parametrize(
    ("table", "reason"),
    [
        ("x\tdouble\n", "the line `vendor` comes first"),
        ("vendor\tX\turi\nx\tdubble\n", "2: `dubble` is not a type"),
        ("vendor\tX\turi\nx\tdouble\n sdg\tmodel\n", "3: `sdg` is neither sdf, urdf"),
        ("vendor\tX\turi\nx\tdouble\n sdf\tmodel\ttext\t0\trange\n", "3: `range` is not key=value"),
        ("vendor\tX\turi\nx\tdouble\t\trange=low\n sdf\tmodel\ttext\t0\n", "3: not understood"),
        ("vendor\tX\turi\nx\nx\n", "3: x:x is there already"),
        ("vendor\tX\turi\nx\tdouble\t\tdiffers=:y\n", "x.vendor.txt: x:x refers to x:y, which is not there"),
        ("", "no line `vendor`"),
    ],
)
def test_a_faulty_table_is_reported_with_its_line(tmp_path: Path, table: str, reason: str) -> None:
    (tmp_path / "x.vendor.txt").write_text(table)
    with pytest.raises(PackError) as error:
        load_index((tmp_path,))
    assert reason in str(error.value)


def test_a_prefix_has_one_table(tmp_path: Path) -> None:
    (tmp_path / "drake.vendor.txt").write_text("vendor\tMine\turi\n")
    with pytest.raises(PackError, match="the prefix drake is taken"):
        load_index((tmp_path,))


TABLE = """vendor\tMuJoCo\thttps://example.org/mujoco
reads\turdf\tstrict
unknown\turdf\tignored

armature\tdouble\t0\trange=[0,inf]
 urdf\trobot/joint/dynamics\tattribute\t0
"""
MOTOR = (
    '<robot name="r" xmlns:mujoco="https://example.org/mujoco"><link name="a"/><link name="b"/>'
    '<joint name="j" type="continuous"><parent link="a"/><child link="b"/>'
    '<dynamics damping="1" friction="0" {}/></joint></robot>'
)


@pytest.mark.parametrize(
    ("attribute", "severity", "message"),
    [
        ('mujoco:armature="0.1"', None, ""),
        ('mujoco:armature="-1"', "error", "VND003 `mujoco:armature` should be at least 0, not `-1`"),
        ('mujoco:armatur="1"', "warning", "VND001 `mujoco:armatur` is not known to MuJoCo"),
    ],
)
def test_a_table_is_enough(attribute: str, severity: str | None, message: str, tmp_path: Path) -> None:
    (tmp_path / "mujoco.vendor.txt").write_text(TABLE, encoding="utf-8")
    index = load_index((tmp_path,))

    def found(*targets: str) -> list[Diagnostic]:
        dispatch = Dispatch(index, ActiveRules(index.facts, {}, frozenset(targets)))
        text = MOTOR.format(attribute).encode()
        every = lint_source(text, Path("robot.urdf"), None, dispatch, around(index)).diagnostics
        return [each for each in every if each.code.startswith("VND")]

    assert [each.severity.value for each in found()] == ([] if severity is None else [severity])
    assert all(f"{each.code} {each.message}".startswith(message) for each in found())
    assert [each.concerned for each in found()] == [{"mujoco"}] * len(found())
    assert [each.message for each in found("mujoco")] == [each.message for each in found()]
    assert found("drake") == []


def test_a_pack_with_rules_of_its_own_has_no_others() -> None:
    dispatch = Dispatch(INDEX, ActiveRules(INDEX.facts, {}))
    text = MODEL.format("", "", "", "", "<flatland:transmision/>").encode()
    found = lint_source(text, Path("model.sdf"), None, dispatch, around(INDEX)).diagnostics
    assert [each.code for each in found if each.code.startswith(("FLT", "VND"))] == ["FLT001"]
