"""Golden pairs of migrations, and what must hold for all of them; ``--golden`` writes them again."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.convert.comparison import ChangeKind
from sdfcheck.convert.file_difference import compare_files
from sdfcheck.convert.loss import NotConvertible
from sdfcheck.convert.migrate.migrate import LOWEST, TARGETS, sdf_to_sdf
from sdfcheck.convert.migrate.migration import Draft
from sdfcheck.convert.result import Conversion
from sdfcheck.files.library import Library
from sdfcheck.formats.problems import UnknownElement
from sdfcheck.formats.sdf.structure import structure_problems
from sdfcheck.formats.sdf.survey import problems
from sdfcheck.formats.version import Version
from sdfcheck.robot.motion.origin import PoseError
from sdfcheck.source.document import Document, read
from sdfcheck.source.errors import DescriptionError
from tests.golden import assert_as_in

CASES = sorted((Path(__file__).parents[3] / "fixtures" / "convert" / "sdf-to-sdf").iterdir())
ROBOTS = sorted((Path(__file__).parents[3] / "fixtures" / "robots").rglob("*.sdf"))


def opened(path: Path) -> Document:
    document = Library().document(path)
    assert document is not None
    return document


def target(case: Path) -> Version:
    version = Version.parse((case / "to").read_text().strip())
    assert version is not None
    return version


def losses(conversion: Conversion) -> str:
    lines = (
        f"{loss.span.begin.line}:{loss.span.begin.column} {loss.severity.name.lower()} "
        f"{loss.kind.title}: {loss.message}\n"
        for loss in conversion.losses
    )
    return "".join(lines)


def unknown(document: Document) -> set[str]:
    """The names of elements that a document's version does not have."""
    return {problem.element.name for problem in problems(document) if isinstance(problem, UnknownElement)}


def migrate(text: str, version: Version, **options: bool) -> Conversion:
    return sdf_to_sdf(read(text.encode(), Path("m.sdf")), version, **options)


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.name)
def test_the_result_is_as_expected(case: Path, request: pytest.FixtureRequest) -> None:
    conversion = sdf_to_sdf(opened(case / "input.sdf"), target(case))
    if request.config.getoption("--golden"):
        (case / "expected.sdf").write_text(conversion.text, encoding="utf-8")
        (case / "losses.txt").write_text(losses(conversion), encoding="utf-8")
    assert_as_in(conversion.text, case / "expected.sdf")
    assert losses(conversion) == (case / "losses.txt").read_text(encoding="utf-8")
    verification = conversion.verification
    assert verification is None or verification.differences == ()


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.name)
def test_the_result_is_sound_in_its_version(case: Path) -> None:
    result = opened(case / "expected.sdf")
    assert result.version == str(target(case))
    strange = unknown(opened(case / "input.sdf"))
    assert unknown(result) <= strange
    found = [*problems(result), *structure_problems(result)]
    assert [problem for problem in found if not isinstance(problem, UnknownElement)] == []


@pytest.mark.parametrize("version", TARGETS, ids=str)
@pytest.mark.parametrize("path", ROBOTS, ids=lambda path: path.stem)
def test_robots_stay_the_same_in_every_version(path: Path, version: Version) -> None:
    document = opened(path)
    if document.root is None or document.root.name != "sdf" or "with_mistakes" in path.as_posix():
        pytest.skip("no sound SDFormat")
    conversion = sdf_to_sdf(document, version)
    assert conversion.verification is None or conversion.verification.differences == ()
    assert conversion.losses or compare_files(document, conversion.document).changes == ()


MOVED = frozenset({"imu-noise", "moved-settings", "states", "states-back"})
"""Settings that are elsewhere in another version: to verification they are the same, to ``diff`` they are not."""


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.name)
def test_a_verified_result_differs_by_its_losses_only(case: Path) -> None:
    document = opened(case / "input.sdf")
    conversion = sdf_to_sdf(document, target(case))
    try:
        found = compare_files(document, conversion.document).changes
    except (DescriptionError, PoseError):
        return  # no robot can be read from the source
    changes = [change for _, several in found for change in several]
    # The frame of a merged model has a name that the format gives it.
    changes = [change for change in changes if not change.name.endswith("__model__")]
    assert conversion.losses or case.name in MOVED or changes == []
    lost = " ".join(loss.message for loss in conversion.losses)
    gone = [change.name.rpartition("::")[2] for change in changes if change.kind is ChangeKind.REMOVED]
    assert [name for name in gone if f"`{name}`" not in lost] == []


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.name)
def test_unchanged_text_stays_to_the_byte(case: Path) -> None:
    document = opened(case / "input.sdf")
    assert Draft(document).text() == document.source.text
    version = Version.parse(document.version or "")
    assert version is not None
    assert version < LOWEST or sdf_to_sdf(document, version).text == document.source.text


def test_parts_that_the_target_lacks_can_be_kept() -> None:
    text = (
        '<sdf version="1.9"><model name="m"><link name="a"><enable_wind>1</enable_wind></link></model></sdf>'
    )
    assert "enable_wind" not in migrate(text, Version(1, 5)).text
    kept = migrate(text, Version(1, 5), keep_unknown=True)
    assert kept.text == text.replace("1.9", "1.5")
    assert kept.losses == ()


def test_an_unknown_version_is_refused() -> None:
    with pytest.raises(NotConvertible, match=r"'2\.0'"):
        migrate('<sdf version="2.0"><model name="m"><link name="a"/></model></sdf>', Version(1, 12))


def test_axes_survive_the_way_down_and_up() -> None:
    case = next(case for case in CASES if case.name == "frames-resolved")
    down = sdf_to_sdf(opened(case / "input.sdf"), Version(1, 5))
    up = migrate(down.text, Version(1, 12))
    assert up.verification is not None
    assert up.verification.is_equal
    assert 'expressed_in="__model__">0 0 1<' in up.text


def test_the_declared_encoding_is_that_of_the_result() -> None:
    text = '<?xml version="1.0" encoding="ISO-8859-1"?>\n<sdf version="1.9"><model name="\xe4"/></sdf>'
    document = read(text.encode("latin-1"), Path("m.sdf"))
    changed = text.replace("ISO-8859-1", "UTF-8").replace("1.9", "1.10")
    assert sdf_to_sdf(document, Version(1, 10)).text == changed


def test_lines_end_as_in_the_source() -> None:
    case = next(case for case in CASES if case.name == "imu-noise")
    text = (case / "input.sdf").read_text(encoding="utf-8").replace("\n", "\r\n")
    expected = (case / "expected.sdf").read_text(encoding="utf-8").replace("\n", "\r\n")
    assert migrate(text, target(case)).text == expected


def test_a_name_newer_than_both_versions_stays_on_the_way_up() -> None:
    text = (
        '<sdf version="1.6"><model name="m"><link name="a"><inertial><fluid_added_mass/></inertial>'
        "</link></model></sdf>"
    )
    up = migrate(text, Version(1, 9))
    assert (up.text, up.losses) == (text.replace("1.6", "1.9"), ())
    down = migrate(text, Version(1, 5))
    assert [loss.kind.title for loss in down.losses] == ["dropped-element"]


def test_an_include_of_what_is_not_there_stays_as_it_is() -> None:
    include = "<include><uri>model://not_here</uri><pose>3 0 0 0 0 0</pose></include>"
    text = f'<sdf version="1.9"><world name="w">{include}</world></sdf>'
    done = migrate(text, Version(1, 4))
    assert include in done.text
    assert [loss.kind.title for loss in done.losses] == ["unknown-reference"]
    nested = text.replace('<world name="w">', '<model name="m">').replace("</world>", "</model>")
    with pytest.raises(NotConvertible, match="not found"):
        migrate(nested, Version(1, 4))


def test_a_file_that_includes_itself_is_not_written_out(tmp_path: Path) -> None:
    file = tmp_path / "m.sdf"
    include = '<include merge="true"><uri>m.sdf</uri></include>'
    file.write_text(f'<sdf version="1.9"><model name="m"><link name="a"/>{include}</model></sdf>')
    with pytest.raises(NotConvertible, match="includes itself"):
        sdf_to_sdf(opened(file), Version(1, 8))


def test_a_second_model_at_the_top_is_reported() -> None:
    text = '<sdf version="1.7"><model name="a"><link name="l"/></model><model name="b"><link name="l"/></model></sdf>'
    done = migrate(text, Version(1, 8))
    assert done.text == text.replace("1.7", "1.8")
    assert [loss.message.partition(":")[0] for loss in done.losses] == ["model `b` is not read"]


def test_the_root_of_the_oldest_files_gets_its_newer_name() -> None:
    text = '<gazebo version="1.2">\n<model name="m"><link name="a"/></model>\n</gazebo>\n'
    done = migrate(text, Version(1, 4))
    assert done.text == text.replace("gazebo", "sdf").replace("1.2", "1.4")
    assert done.verification is not None
    assert done.verification.links == 1


@pytest.mark.parametrize(
    ("end", "written"), [("box", "__model__"), ("box::lid", "lid"), ("box::inner::lid", "inner::lid")]
)
def test_a_joint_of_a_world_moves_into_its_model(end: str, written: str) -> None:
    inner = '<model name="inner"><link name="lid"/></model>'
    joint = f'<joint name="j" type="fixed"><parent>world</parent><child>{end}</child></joint>'
    text = (
        '<sdf version="1.12"><world name="w"><model name="box"><link name="lid"/>'
        f"{inner}</model>{joint}</world></sdf>"
    )
    done = migrate(text, Version(1, 9))
    assert f"<parent>world</parent><child>{written}</child>" in done.text
    assert done.text.index("<joint") < done.text.index("</world>")


@pytest.mark.parametrize(("name", "kind"), [("j", "joint"), ("base", "link")])
@pytest.mark.parametrize("minor", [7, 9])
def test_a_joint_of_a_world_does_not_move_to_one_of_its_name(name: str, kind: str, minor: int) -> None:
    ends = "<parent>{}</parent><child>{}</child>"
    own = f'<joint name="j" type="fixed">{ends.format("base", "lid")}</joint>'
    model = f'<model name="box"><link name="base"/><link name="lid"/>{own}</model>'
    joint = f'<joint name="{name}" type="fixed">{ends.format("world", "box::base")}</joint>'
    done = migrate(f'<sdf version="1.12"><world name="w">{model}{joint}</world></sdf>', Version(1, minor))
    (loss,) = done.losses
    assert loss.message == (
        f"joint `{name}` is left out: 1.{minor} has joints in models only, "
        f"and in model `box` its name is that of a {kind}"
    )
    assert done.text.count("<joint") == 1


@pytest.mark.parametrize(
    ("around", "minor", "stays"), [("model", 9, True), ("world", 9, False), ("world", 10, True)]
)
def test_a_merge_stays_where_the_version_has_it(around: str, minor: int, stays: bool, tmp_path: Path) -> None:
    tmp_path.joinpath("part.sdf").write_text(
        '<sdf version="1.9"><model name="p"><link name="l"/></model></sdf>'
    )
    include = '<include merge="true"><uri>part.sdf</uri></include>'
    tmp_path.joinpath("m.sdf").write_text(
        f'<sdf version="1.12"><{around} name="m">{include}</{around}></sdf>'
    )
    done = sdf_to_sdf(opened(tmp_path / "m.sdf"), Version(1, minor))
    assert ('merge="true"' in done.text) is stays


@pytest.mark.parametrize("around", ["{}", '<world name="w">{}</world>'])
def test_nested_models_are_flattened_in_worlds_too(around: str) -> None:
    model = '<model name="m"><link name="a"/><model name="n"><link name="b"/></model></model>'
    done = migrate(f'<sdf version="1.7">{around.format(model)}</sdf>', Version(1, 4))
    assert '<link name="n__b"' in done.text
    assert '<model name="n"' not in done.text


def test_a_link_of_a_flattened_model_is_placed_before_anything_else_is_said_of_it() -> None:
    nested = '<model name="n"><pose>1 2 3 0 0 0</pose><link name="b"><gravity>false</gravity></link></model>'
    done = migrate(
        f'<sdf version="1.7"><model name="m"><link name="a"/>{nested}</model></sdf>', Version(1, 4)
    )
    assert '<link name="n__b"><pose>1 2 3 0 0 0</pose>\n<gravity>' in done.text


@pytest.mark.parametrize(
    ("palm", "name"), [("arm::palm", '<gripper name="hand">'), ("table", '<gripper name="arm__hand">')]
)
def test_a_gripper_of_links_outside_stays_outside(palm: str, name: str) -> None:
    links = '<link name="table"/><link name="arm::palm"/><link name="arm::finger"/>'
    ends = f"<gripper_link>arm::finger</gripper_link><palm_link>{palm}</palm_link>"
    model = f'<model name="m">{links}<gripper name="arm::hand">{ends}</gripper></model>'
    done = migrate(f'<sdf version="1.7">{model}</sdf>', Version(1, 8))
    assert name in done.text


def test_a_joint_whose_pose_leads_nowhere_is_reported() -> None:
    frame = (
        '<link name="a"/><link name="b"><pose relative_to="nowhere"/></link><frame name="f" attached_to="b"/>'
    )
    joint = '<joint name="j" type="fixed"><parent>a</parent><child>f</child></joint>'
    done = migrate(f'<sdf version="1.8"><model name="m">{frame}{joint}</model></sdf>', Version(1, 7))
    assert "<child>f</child>" in done.text
    assert any("the pose cannot be resolved" in each.message for each in done.losses)


@pytest.mark.parametrize(
    ("carrier", "relative", "written"),
    [
        ("", "", "<pose>1 -3 0 0 0 0</pose>"),
        ("", ' relative_to="base"', "<pose>1 -3 1 0 0 0</pose>"),
        (' attached_to="arm::lid"', "", "<pose>1 0 0 0 0 0</pose>"),
        (
            ' attached_to="arm::lid"',
            ' relative_to="base"',
            '<pose relative_to="__model__">1 -3 1 0 0 0</pose>',
        ),
    ],
)
def test_a_frame_of_a_model_by_name_stays_in_place(carrier: str, relative: str, written: str) -> None:
    base, lid = (
        '<link name="{}"><pose>0 0 {} 0 0 0</pose></link>'.format(*each)
        for each in (("base", 1), ("arm::lid", 5))
    )
    own = '<frame name="arm::__model__" attached_to="arm::lid"><pose relative_to="__model__">0 3 0 0 0 0</pose></frame>'
    tool = f'<frame name="arm::tool"{carrier}><pose{relative}>1 0 0 0 0 0</pose></frame>'
    done = migrate(f'<sdf version="1.7"><model name="m">{base}{lid}{own}{tool}</model></sdf>', Version(1, 8))
    assert done.text.partition('<frame name="tool"')[2].partition(">")[2].startswith(written)


def test_an_automatic_inertia_is_written_with_a_plain_pose() -> None:
    inertial = '<inertial auto="true"><pose degrees="true">0 0 0 0 0 90</pose><density>2</density></inertial>'
    ball = "<geometry><sphere><radius>1</radius></sphere></geometry>"
    link = f'<link name="a">{inertial}<collision name="c"><pose>0 0 1 0 0 0</pose>{ball}</collision></link>'
    done = migrate(f'<sdf version="1.12"><model name="m">{link}</model></sdf>', Version(1, 10))
    assert "<inertial><pose>0 0 1 0 0 0</pose>" in done.text


def test_of_two_thread_pitches_the_older_one_is_written() -> None:
    pitches = "<screw_thread_pitch>2</screw_thread_pitch><thread_pitch>5</thread_pitch>"
    joint = f'<joint name="j" type="screw"><parent>a</parent><child>b</child>{pitches}</joint>'
    text = f'<sdf version="1.12"><model name="m"><link name="a"/><link name="b"/>{joint}</model></sdf>'
    done = migrate(text, Version(1, 9))
    assert "</child><thread_pitch>-3.141592653589793</thread_pitch></joint>" in done.text
