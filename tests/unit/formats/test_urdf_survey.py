"""The walk over URDF documents."""

from __future__ import annotations

from pathlib import Path
from typing import TypeVar

import pytest

from sdfcheck.formats import problems
from sdfcheck.formats.urdf.schema import VERSIONS
from sdfcheck.formats.urdf.survey import UrdfSurvey, survey
from sdfcheck.source.document import read
from sdfcheck.source.sniff import Kind

T = TypeVar("T")

SHAPE = '<geometry><sphere radius="1"/></geometry>'
BOX = '<box size="1 1 1"/>'
ROBOT = '<robot name="r"><link name="a">{}</link></robot>'
JOINT = (
    '<robot name="r"><link name="a"/><link name="b"/>'
    '<joint name="j" type="continuous"><parent link="a"/><child link="b"/>{}</joint></robot>'
)


def walk(text: str) -> UrdfSurvey:
    return survey(read(text.encode(), Path("r.urdf")))


def only(text: str, kind: type[T]) -> T:
    """The one problem of a document, which is of that kind."""
    found = walk(text).problems
    assert [type(problem) for problem in found] == [kind], found
    return found[0]  # type: ignore[return-value]


def test_the_index_lists_elements_in_their_places() -> None:
    surveyed = walk(
        '<robot name="r"><link name="a"/><material name="m"><color rgba="1 1 1 1"/></material>'
        f'<link name="b"><visual>{SHAPE}<material name="m"/></visual></link>'
        '<gazebo><link name="c"/></gazebo><transmission><joint name="j"/></transmission>'
        '<drake:joint xmlns:drake="http://drake.mit.edu" name="d"/></robot>'
    )
    assert surveyed.problems == []
    assert [link.attributes["name"] for link in surveyed.index["link"]] == ["a", "b"]
    assert len(surveyed.index["material"]) == 2
    assert len(surveyed.top("material")) == 1
    assert "joint" not in surveyed.index
    assert [element.name for element in surveyed.customs] == ["drake:joint"]


def test_a_description_for_xacro_is_left_alone_unless_it_is_read_as_urdf() -> None:
    text = (
        b'<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="r">'
        b'<xacro:if value="1"><lnk/></xacro:if><lnk/></robot>'
    )
    surveyed = survey(read(text, Path("r.urdf"), Kind.XACRO))
    assert surveyed.root is None
    assert surveyed.problems == []
    assert survey(read(text, Path("r.urdf"), Kind.URDF)).problems


def test_a_declared_prefix_of_xacro_alone_is_nothing() -> None:
    surveyed = walk('<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="r"><link name="a"/></robot>')
    assert surveyed.root is not None


def test_unknown_elements_are_reported_once_for_each_place() -> None:
    problem = only(
        ROBOT.format(f"<visual>{SHAPE}<x/></visual><visual>{SHAPE}<x/></visual>"),
        problems.UnknownUrdfElement,
    )
    assert len(problem.uses) == 2
    assert (problem.suggestion, problem.needed) == (None, False)


def test_a_misspelt_element_is_not_missing_as_well() -> None:
    problem = only(
        ROBOT.format(f"<visual>{SHAPE.replace('geometry', 'geometri')}</visual>"),
        problems.UnknownUrdfElement,
    )
    assert (problem.suggestion, problem.needed) == ("geometry", True)


def test_a_misspelt_attribute_is_not_missing_as_well() -> None:
    text = ROBOT.format('<visual><geometry><sphere raduis="1"/></geometry></visual>')
    problem = only(text, problems.UnknownUrdfAttribute)
    assert (problem.value.attribute, problem.suggestion, problem.needed) == ("raduis", "radius", True)


def test_an_existing_part_is_not_suggested() -> None:
    text = JOINT.format('<limit effort="1" velocity="1" k_velocity="1"/>')
    assert only(text, problems.UnknownUrdfAttribute).suggestion is None


def test_the_axis_of_a_fixed_joint_is_not_read() -> None:
    assert walk(JOINT.format("<axis/>").replace("continuous", "fixed")).problems == []
    assert only(JOINT.format("<axis/>"), problems.MissingAttribute).attribute == "xyz"


@pytest.mark.parametrize(
    ("inside", "kind"),
    [
        ("<inertial/><inertial/>", problems.RepeatedElement),
        ("words", problems.StrayText),
        ('<contact><lateral_friction value="high"/></contact>', problems.MalformedValue),
        (f'<visual><origin xyz=""/>{SHAPE}</visual>', problems.MissingAttribute),
        (f'<visual><origin xyz="1 2"/>{SHAPE}</visual>', problems.WrongComponentCount),
        (f'<visual><origin xyz="1 2 3m"/>{SHAPE}</visual>', problems.MalformedValue),
        (f'<visual><origin xyz="1\t2 3"/>{SHAPE}</visual>', problems.MalformedValue),
        (f"<visual>{SHAPE.replace('1', '-1')}</visual>", problems.ValueOutOfRange),
        (
            f"<visual>{SHAPE.replace('</', BOX + '</')}</visual>",
            problems.SeveralShapes,
        ),
    ],
)
def test_kinds_of_problems(inside: str, kind: type) -> None:
    found = walk(ROBOT.format(inside)).problems
    assert kind in {type(problem) for problem in found}
    assert {type(problem) for problem in found} == {kind}


def test_lines_may_be_broken_between_attributes_and_before_numbers() -> None:
    assert walk(ROBOT.format(f'<visual\n\tname="v"><origin\n xyz="\n1 2 3"/>{SHAPE}</visual>')).problems == []


def test_the_place_of_a_bad_number() -> None:
    problem = only(ROBOT.format(f'<visual><origin xyz="1 2,5 3"/>{SHAPE}</visual>'), problems.MalformedValue)
    assert problem.span.text == "2,5"


def test_versions() -> None:
    assert walk('<robot name="r" version="1.2"><link name="a"/></robot>').version == VERSIONS[2]
    assert walk('<robot name="r" version="1"><link name="a"/></robot>').version == VERSIONS[0]
    quaternion = f'<visual><origin quat_xyzw="0 0 0 1"/>{SHAPE}</visual>'
    feature = only(ROBOT.format(quaternion), problems.FeatureAboveVersion)
    assert (feature.what, feature.since, feature.declared) == ("quat_xyzw", "1.1", "1.0")
    assert walk(ROBOT.replace('"r"', '"r" version="1.1"').format(quaternion)).problems == []


def test_subjects_of_rules_are_not_reported_twice() -> None:
    inertial = '<inertial><mass value="1"/><inertia ixx="1"/></inertial><inertial/>'
    assert [type(p) for p in walk(ROBOT.format(inertial)).problems] == [problems.RepeatedElement]
    assert (
        walk(ROBOT.format("<inertial/><visual/><visual><geometry><mesh/></geometry></visual>")).problems == []
    )
    assert walk(JOINT.format('<limit lower="0"/>')).problems == []


def test_dynamics_need_one_of_two_attributes() -> None:
    assert only(JOINT.format("<dynamics/>"), problems.MissingAttribute).attribute == "damping"
    assert walk(JOINT.format('<dynamics friction="1"/>')).problems == []
    misspelled = walk(JOINT.format('<dynamics dampng="1"/>')).problems
    assert [type(problem) for problem in misspelled] == [problems.UnknownUrdfAttribute]


@pytest.mark.parametrize(
    ("setting", "kind"),
    [
        ("<mu1/>", problems.MalformedValue),
        ("<mu1>slippery</mu1>", problems.MalformedValue),
        ("<mu1>0.5x</mu1>", problems.MisreadValue),
        ('<kp value="high"/>', problems.MalformedValue),
    ],
)
def test_numbers_in_gazebo(setting: str, kind: type) -> None:
    text = (
        f'<robot name="r"><link name="a"><collision/></link><gazebo reference="a">{setting}</gazebo></robot>'
    )
    assert [type(problem) for problem in walk(text).problems] == [kind]


def test_sound_settings_in_gazebo() -> None:
    settings = '<mu1> 0.5 </mu1><kp value="1e5"/><x>y</x>'
    text = f'<robot name="r"><link name="a"/><gazebo reference="a">{settings}</gazebo></robot>'
    assert walk(text).problems == []


def test_expressions_are_reported_once_and_not_as_bad_numbers() -> None:
    text = ROBOT.format(
        '<!-- ${no} --><visual><geometry><sphere radius="${r}"/></geometry></visual><visual name="$(arg v)"/>'
    )
    found = walk(text).problems
    (problem,) = found
    assert isinstance(problem, problems.UnexpandedExpression)
    assert (problem.count, problem.span.text) == (2, "${r}")
    assert [value.text for value in problem.values] == ["${r}", "$(arg v)"]
