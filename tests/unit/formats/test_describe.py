"""The descriptions of places in the formats."""

from __future__ import annotations

import pytest

from sdfcheck.formats import describe as definition
from sdfcheck.formats.describe import Description, UnknownPlace, describe
from sdfcheck.formats.schema import Format
from sdfcheck.formats.sdf.schema import SDF
from sdfcheck.formats.urdf.schema import URDF
from sdfcheck.formats.version import Version


def only(question: str, version: str = "1.12") -> Description:
    known = Version.parse(version)
    assert known is not None
    (found,) = describe(question, known)
    return found


def test_an_element_and_what_is_in_it() -> None:
    axis = only("joint/axis")
    assert (axis.name, axis.format, axis.what, axis.since, axis.until) == (
        "joint/axis",
        "SDFormat 1.12",
        "element",
        "1.2",
        "",
    )
    assert [parent.name for parent in axis.parents] == ["joint"]
    assert [child.name for child in axis.children] == ["xyz", "dynamics", "limit", "mimic"]
    assert axis.children[-1].since == "1.11"


def test_an_older_version() -> None:
    assert "mimic" not in {child.name for child in only("joint/axis", "1.7").children}
    assert only("joint/axis", "1.4").parents[0].multiplicity == "1"


def test_an_attribute() -> None:
    degrees = describe("pose/@degrees")[0]
    assert (degrees.name, degrees.type, degrees.default, degrees.since) == (
        "pose/@degrees",
        "bool",
        "false",
        "1.9",
    )


def test_choices_and_what_replaced_them() -> None:
    kind = only("sensor/@type")
    assert {"lidar", "ray"} <= set(kind.choices)
    assert "`ray` is now called `lidar`" in kind.notes


def test_a_removed_name_is_reported_with_its_successor() -> None:
    gone = only("joint/axis/use_parent_model_frame")
    assert (gone.format, gone.until, gone.successor) == ("SDFormat 1.6", "1.6", "axis/xyz/@expressed_in")


def test_a_parent_narrows_the_places() -> None:
    assert {parent.name for parent in only("link/pose").parents} == {"link"}
    assert len(describe("pose")[0].parents) > 10


def test_ranges_units_and_open_content() -> None:
    assert only("camera/horizontal_fov").range == "from 0.001 to 6.283186"
    assert only("joint/axis/limit/lower").unit
    assert describe("plugin")[0].open


def test_urdf() -> None:
    limit = only("urdf:joint/limit")
    assert {entry.name: entry.multiplicity for entry in limit.attributes}["@effort"] == "1"
    assert only("urdf:limit/@effort").unit == "N m (turning), N (sliding)"
    assert only("urdf:gazebo").children[0].name == "mu1"
    parents = {parent.name for origin in describe("urdf:origin") for parent in origin.parents}
    assert parents == {"joint", "link/collision", "link/inertial", "link/visual", "robot"}
    assert only("urdf:capsule").since == "1.1"
    assert only("urdf:robot").name == "robot"


def test_drake_in_both_dialects() -> None:
    sdf, urdf = describe("drake:mu_dynamic")
    assert (sdf.format, sdf.type, sdf.range) == ("Drake, SDFormat", "double", "at least 0")
    assert [entry.name for entry in urdf.attributes] == ["@value"]
    properties = describe("drake:proximity_properties")[0]
    assert "drake:mu_static" in {child.name for child in properties.children}


def test_drake_in_one_dialect_only() -> None:
    _, urdf = describe("drake:damping")
    assert urdf.notes == ("in URDF it is ignored; use dynamics/@damping",)


def test_parts_of_drakes_elements() -> None:
    sdf, urdf = describe("drake:joint/@type")
    assert "planar" in sdf.choices
    assert "ball" in urdf.choices
    (narrowed,) = describe("joint/drake:controller_gains")
    assert narrowed.format == "Drake, SDFormat"


@pytest.mark.parametrize(
    ("question", "says"),
    [
        ("jiont", "SDFormat 1.12 has no `jiont`, did you mean `joint`?"),
        ("joint/axs", "`joint` has no `axs`, did you mean `axis`?"),
        ("jiont/axis/xyz", "SDFormat 1.12 has no `jiont`, did you mean `joint`?"),
        ("pose/@degree", "`pose` has no `@degree`, did you mean `@degrees`?"),
        (
            "safety_controller",
            "SDFormat 1.12 has no `safety_controller`; URDF has it: `urdf:safety_controller`",
        ),
        ("sdf:safety_controller", "SDFormat 1.12 has no `safety_controller`"),
        ("urdf:joint/limits", "`joint` has no `limits`, did you mean `limit`?"),
        ("urdf:joint/@typ", "`joint` has no `@typ`, did you mean `@type`?"),
        ("drake:mu_statik", "Drake has no `drake:mu_statik`, did you mean `drake:mu_static`?"),
        ("link/drake:mu_static", "Drake does not read `drake:mu_static` in `link`"),
        ("drake:joint/@nam", "`drake:joint` has no `@nam`, did you mean `@name`?"),
        ("darke:joint", "nothing is known of the prefix `darke`, did you mean `drake:`?"),
        ("", "there is no element without a name"),
        ("urdf:", "there is no element without a name"),
    ],
)
def test_absent_names(question: str, says: str) -> None:
    with pytest.raises(UnknownPlace) as caught:
        describe(question)
    assert str(caught.value) == says


def test_ros2_control_needs_no_prefix() -> None:
    (found,) = describe("ros2_control/joint/command_interface/@data_type")
    assert found.default == "double"
    assert "uint8" in found.choices
    (found,) = describe("ros2_control/properties")
    assert found.since == "jazzy 4.38, kilted 5.7"
    (joint,) = describe("urdf:joint")
    assert joint.parents[0].name == "robot"
    driven, in_control = describe("transmission/joint")
    assert in_control.parents[0].name == "ros2_control/transmission"
    assert [child.name for child in driven.children] == [
        "hardwareInterface",
        "role",
        "mechanicalReduction",
        "offset",
    ]


@pytest.mark.parametrize(("known", "prefix", "least"), [(SDF, "", 300), (URDF, "urdf:", 80)])
def test_everything_that_there_is_can_be_asked_for(known: Format, prefix: str, least: int) -> None:
    uses = definition._everywhere(known.schema(known.newest))
    # Blocks that several elements of ros2_control share have no name of their own.
    parents = {(use.parent.place, use.element.name) for use in uses if use.parent is not None}
    places = sorted(each for each in parents if not each[0].startswith("control_"))
    assert len(places) > least
    for place, name in places[::7]:
        assert describe(f"{prefix}{place.partition(':')[2]}/{name}")
