"""The findings of the walk over a document, as values; the words are tested with the rules."""

from __future__ import annotations

import pytest

from sdfcheck.formats import problems
from tests.unit.formats.walk import BOX, found, in_link, only_in_link
from tests.unit.only import only

FRICTION = f'<collision name="c">{BOX}<surface><friction><ode>{{}}</ode></friction></surface></collision>'


def test_a_sound_document() -> None:
    assert in_link("<pose>0 0 1 0 0 0</pose><inertial><mass>1</mass></inertial>") == []


# Elements


@pytest.mark.parametrize(
    ("text", "places"),
    [
        ("<mass>1</mass>", ("inertial",)),
        ("<static>true</static>", ("model",)),
        ("<inertial><inertia><pose/></inertia></inertial>", ("inertial", "link", "model")),
        (FRICTION.format("<max_vel>1</max_vel>"), ("surface/contact/ode",)),
    ],
)
def test_misplaced_elements_know_where_they_belong(text: str, places: tuple[str, ...]) -> None:
    misplaced = [p for p in in_link(text) if isinstance(p, problems.MisplacedElement)]
    assert [p.places for p in misplaced] == [places]
    assert misplaced[0].ignored


def test_children_of_includes_are_read_in_older_versions_too() -> None:
    include = (
        "<include><uri>model://sun</uri><name>s</name><pose>0 0 1 0 0 0</pose><static>true</static></include>"
    )
    world = f'<sdf version="1.4"><world name="w">{include}</world></sdf>'
    assert [each for each in found(world) if isinstance(each, problems.TooNewElement)] == []


def test_includes_are_followed_wherever_they_are() -> None:
    problem = only(found('<sdf version="1.9"><include/></sdf>'), problems.MisplacedElement)
    assert not problem.ignored
    assert problem.places == ("model", "world")


def test_unknown_elements() -> None:
    problem = only_in_link("<inertail/>", problems.UnknownElement)
    assert problem.suggestion == "inertial"
    assert not problem.refused


def test_workflows_of_pbr_are_a_closed_list() -> None:
    text = f'<visual name="v">{BOX}<material><pbr><shiny/></pbr></material></visual>'
    assert only_in_link(text, problems.UnknownElement).refused


def test_too_new_elements_are_reported_once_with_all_uses() -> None:
    shapes = "".join(
        f'<visual name="{name}"><geometry><capsule><radius>1</radius><length>1</length></capsule></geometry>'
        "</visual>"
        for name in "abc"
    )
    problem = only_in_link(shapes, problems.TooNewElement, "1.7")
    assert [use.name for use in problem.uses] == ["capsule"] * 3
    assert (str(problem.since), problem.declaration.text) == ("1.8", "1.7")


def test_a_too_new_element_is_looked_into() -> None:
    text = '<visual name="v"><geometry><capsule><radius>wide</radius></capsule></geometry></visual>'
    kinds = {type(p).__name__ for p in in_link(text, "1.7")}
    assert kinds == {"TooNewElement", "MalformedValue", "MissingElement"}


def test_too_new_is_also_what_came_and_went() -> None:
    axis = "<axis><xyz>0 0 1</xyz><use_parent_model_frame>1</use_parent_model_frame></axis>"
    model = f'<link name="a"/><link name="b"/><joint name="j" type="revolute">{axis}</joint>'
    problems_found = found(f'<sdf version="1.4"><model name="m">{model}</model></sdf>')
    (problem,) = (each for each in problems_found if isinstance(each, problems.TooNewElement))
    assert (problem.element.name, str(problem.since)) == ("use_parent_model_frame", "1.5")
    assert not any(isinstance(each, problems.MisplacedElement) for each in problems_found)


def test_too_new_attributes() -> None:
    problem = only_in_link(
        '<pose relative_to="l" degrees="true">0 0 0 0 0 0</pose>', problems.TooNewAttribute, "1.8"
    )
    assert (problem.attribute, str(problem.since)) == ("degrees", "1.9")


def test_removed_elements() -> None:
    physics = '<physics type="ode"><gravity>0 0 0</gravity></physics>'
    world = f'<sdf version="{{}}"><world name="w">{physics}</world></sdf>'
    assert found(world.format("1.5")) == []
    problem = only(found(world.format("1.6")), problems.RemovedElement)
    assert (problem.attribute, str(problem.until), problem.successor) == (None, "1.5", "world/gravity")


def test_removed_attributes() -> None:
    assert in_link('<pose frame="l"/>', "1.6") == []
    problem = only_in_link('<pose frame="l"/>', problems.RemovedElement, "1.7")
    poses = '<visual name="{}"><pose frame="l"/><geometry><empty/></geometry></visual>'
    twice = only_in_link(poses.format("a") + poses.format("b"), problems.RemovedElement, "1.7")
    assert (len(twice.others), problem.others) == (1, ())
    assert (problem.attribute, str(problem.until)) == ("frame", "1.6")


def test_repeated_elements() -> None:
    problem = only_in_link("<inertial><mass>1</mass><mass>2</mass></inertial>", problems.RepeatedElement)
    again = only_in_link(
        "<inertial><mass>1</mass><mass>2</mass><mass>3</mass></inertial>", problems.RepeatedElement
    )
    assert ([element.content for element in again.others], problem.others) == (["3"], ())
    assert problem.element.content == "2"
    assert problem.first.content == "1"
    assert not problem.refused


def test_polylines_make_one_shape_together() -> None:
    line = "<polyline><point>0 0</point><point>0 1</point><height>1</height></polyline>"
    assert in_link(f'<visual name="v"><geometry>{line}{line}</geometry></visual>') == []


@pytest.mark.parametrize(
    ("text", "child", "default", "refused"),
    [
        ("<visual name='v'><geometry><box/></geometry></visual>", "size", "1 1 1", False),
        ("<projector name='p'><fov>1</fov></projector>", "texture", None, False),
        (
            "<visual name='v'><geometry><mesh><uri>a</uri><submesh/></mesh></geometry></visual>",
            "name",
            None,
            True,
        ),
    ],
)
def test_missing_elements(text: str, child: str, default: str | None, refused: bool) -> None:
    problem = only_in_link(text, problems.MissingElement)
    assert (problem.child, problem.default, problem.refused) == (child, default, refused)


@pytest.mark.parametrize("kind", ["revolute", "fixed", "ball"])
def test_joints_need_both_ends(kind: str) -> None:
    missing = found(f'<sdf version="1.9"><model name="m"><joint name="j" type="{kind}"/></model></sdf>')
    assert [(p.child, p.others, p.refused) for p in missing] == [("parent", ("child",), True)]


@pytest.mark.parametrize(
    ("version", "frame", "refused"),
    [
        ("1.4", "", True),
        ("1.4", "<use_parent_model_frame>false</use_parent_model_frame>", False),
        ("1.5", "", False),
        ("1.6", "<use_parent_model_frame>true</use_parent_model_frame>", True),
        ("1.6", "<use_parent_model_frame>0</use_parent_model_frame>", False),
        ("1.7", "", False),
    ],
)
def test_an_axis_without_direction_in_an_old_file(version: str, frame: str, refused: bool) -> None:
    ends = "<parent>a</parent><child>b</child>"
    joint = f'<joint name="j" type="revolute">{ends}<axis>{frame}</axis></joint>'
    missing = [
        problem
        for problem in found(f'<sdf version="{version}"><model name="m">{joint}</model></sdf>')
        if isinstance(problem, problems.MissingElement)
    ]
    assert [(problem.child, problem.refused) for problem in missing] == [("xyz", refused)]


def test_a_custom_element_may_have_been_put_in_place_of_a_required_one() -> None:
    sphere = '<visual name="v"><geometry><sphere>{}</sphere></geometry></visual>'
    assert in_link(sphere.format("<p:diameter>2</p:diameter>")) == []
    only_in_link(sphere.format("<p:color>red</p:color>"), problems.MissingElement)


def test_deprecated_elements() -> None:
    text = (
        '<sdf version="1.12"><model name="m"><joint name="j" type="screw"><parent>a</parent><child>b</child>'
        "<thread_pitch>1</thread_pitch></joint></model></sdf>"
    )
    problem = only(found(text), problems.DeprecatedElement)
    assert (problem.successor, problem.since, problem.announced) == ("screw_thread_pitch", "1.10", False)


@pytest.mark.parametrize(
    ("text", "stray"),
    [
        ("<inertial>\n  5 kg\n  heavy <mass>1</mass></inertial>", "5 kg"),
        ("<inertial><mass>1</mass> end</inertial>", "end"),
        ("<inertial><!-- a --> middle <!-- b --></inertial>", "middle"),
    ],
)
def test_stray_text(text: str, stray: str) -> None:
    assert only_in_link(text, problems.StrayText).span.text == stray


def test_character_data_beside_elements_is_a_note() -> None:
    assert in_link("<inertial><![CDATA[a note]]><mass>1</mass></inertial>") == []


# Attributes


def test_unknown_attributes() -> None:
    problem = only_in_link('<pose relativ_to="l"/>', problems.UnknownAttribute)
    assert (problem.attribute, problem.suggestion) == ("relativ_to", "relative_to")


def test_custom_attributes_are_free() -> None:
    assert in_link('<pose p:unit="m" xmlns:p="https://example.org/p"/>') == []


@pytest.mark.parametrize(("attribute", "empty"), [("", False), ('type=""', True), ('type=" "', True)])
def test_missing_attributes(attribute: str, empty: bool) -> None:
    problem = only_in_link(f'<sensor name="s" {attribute}/>', problems.MissingAttribute)
    assert (problem.attribute, problem.empty, problem.until) == ("type", empty, None)


def test_attributes_that_are_no_longer_required() -> None:
    plugin = '<sdf version="{}"><world name="w"><plugin filename="p"{}/></world></sdf>'
    assert found(plugin.format("1.10", "")) == []
    assert str(only(found(plugin.format("1.9", "")), problems.MissingAttribute).until) == "1.9"
    assert str(only(found(plugin.format("1.9", ' name=""')), problems.EmptyName).until) == "1.9"


def test_empty_names() -> None:
    assert only_in_link('<visual name=" ">' + BOX + "</visual>", problems.EmptyName).until is None


def test_many_unknown_attributes_of_one_element_are_counted() -> None:
    attributes = " ".join(f'a{number}="1"' for number in range(30))
    inside = in_link(f"<inertial {attributes}><mass>1</mass></inertial>")
    strange = [problem for problem in inside if isinstance(problem, problems.UnknownAttribute)]
    assert [problem.more for problem in strange] == [29] + [0] * 9
