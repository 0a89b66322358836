"""The table of URDF, and how its values are read."""

from __future__ import annotations

import pytest

from sdfcheck.formats import history
from sdfcheck.formats.reading import Cause, Outcome
from sdfcheck.formats.schema import AttributeDefinition
from sdfcheck.formats.urdf.findings import read
from sdfcheck.formats.urdf.schema import VERSIONS, extension, known_parents, urdf


def attribute(path: str, name: str) -> AttributeDefinition:
    element = urdf().at(path)
    assert element is not None, path
    return element.attributes[name]


SIZE = attribute("link/visual/geometry/box", "size")
LOWER = attribute("joint/limit", "lower")
RGBA = attribute("material/color", "rgba")
XYZ = attribute("joint/origin", "xyz")


def test_elements_and_attributes_are_found_by_path() -> None:
    limit = urdf().at("joint/limit")
    assert limit is not None
    assert limit.required_attributes == ("effort", "velocity")
    assert history.since(limit, "@jerk") == VERSIONS[2]
    assert limit.attributes["effort"].units == ("N m", "N")
    assert urdf().at("joint/limits") is None
    geometry = urdf().at("link/collision/geometry")
    assert geometry is not None
    assert history.since(geometry, "capsule") == VERSIONS[1]
    assert "capsule" in geometry.children
    oldest = urdf(VERSIONS[0]).at("link/collision/geometry")
    assert oldest is not None
    assert "capsule" not in oldest.children


def test_blocks_are_shared_by_the_places_that_use_them() -> None:
    for path in ("link/visual", "link/collision", "link/inertial", "joint"):
        origin = urdf().at(f"{path}/origin")
        assert origin is not None
        assert set(origin.attributes) == {"xyz", "rpy", "quat_xyzw"}
        assert origin.single


def test_multiplicity() -> None:
    link = urdf().children["link"]
    assert not link.single
    assert "link" in urdf().required_children
    assert link.children["inertial"].single
    assert link.children["inertial"].required_children == ("mass", "inertia")


def test_content_of_others_is_open() -> None:
    for name in ("gazebo", "transmission", "ros2_control"):
        assert urdf().children[name].open
    assert all(child.open for child in urdf().children["mujoco"].children.values())
    assert not urdf().children["link"].open


def test_settings_in_gazebo_that_are_numbers() -> None:
    assert extension().children["mu1"].type == "double"


def test_known_parents() -> None:
    assert known_parents("mass") == ("inertial",)
    assert known_parents("mas") == known_parents("restitution") == ()


@pytest.mark.parametrize("text", ["1", "-1", "+1.5", ".5", "1.", "1e-3", " 1", "1E5", "1e-400"])
def test_numbers(text: str) -> None:
    assert read(LOWER, text).is_fine


@pytest.mark.parametrize(
    ("text", "cause"),
    [
        ("1,5", Cause.COMMA),
        ("1.5kg", Cause.NOT_A_NUMBER),
        ("0x10", Cause.HEXADECIMAL),
        ("1 2", Cause.EXTRA),
        ("1 ", Cause.BLANK),
        ("inf", Cause.NOT_FINITE),
        ("nan", Cause.NOT_FINITE),
        ("1e400", Cause.TOO_LARGE),
        ("true", Cause.NOT_A_NUMBER),
        ("1e", Cause.NOT_A_NUMBER),
    ],
)
def test_numbers_that_urdfdom_refuses(text: str, cause: Cause) -> None:
    assert not LOWER.accepts(text)
    reading = read(LOWER, text)
    assert reading.outcome is Outcome.MALFORMED
    assert reading.refused
    assert reading.cause in {cause, Cause.TRAILING} if cause is Cause.NOT_A_NUMBER else reading.cause is cause


@pytest.mark.parametrize("text", ["0 0 0", "0  0   0", " 0 0 0 ", "\t0 0 0", "1e-3 .5 -2"])
def test_vectors(text: str) -> None:
    assert read(XYZ, text).is_fine


@pytest.mark.parametrize(
    ("text", "part"),
    [
        ("0\t0 0", "\t"),
        ("0 0 0\n", "\n"),
        ("0 0\n 0", "\n"),
        ("0 0 1m", "1m"),
        ("1,5 0 0", "1,5"),
        ("0 x 0", "x"),
    ],
)
def test_the_part_at_fault_in_a_vector(text: str, part: str) -> None:
    reading = read(XYZ, text)
    assert reading.outcome is Outcome.MALFORMED
    assert text[reading.start : reading.end] == part
    assert reading.expected == "3 numbers"


@pytest.mark.parametrize(("text", "got", "part"), [("0 0", 2, "0 0"), ("0 0 0 1", 4, "1")])
def test_the_number_of_numbers(text: str, got: int, part: str) -> None:
    reading = read(XYZ, text)
    assert (reading.outcome, reading.wanted, reading.got) == (Outcome.WRONG_COUNT, (3,), got)
    assert text[reading.start : reading.end] == part


def test_ranges() -> None:
    assert SIZE.accepts("1 2 3")
    assert not SIZE.accepts("1 0 3")
    reading = read(SIZE, "1 0 3")
    assert reading.outcome is Outcome.OUT_OF_RANGE
    assert not reading.refused
    assert reading.range is not None
    assert reading.range.instead == "1"
    assert RGBA.accepts("1 0 0 1")
    assert read(RGBA, "255 0 0 1").refused
    assert read(RGBA, "1 0 0").outcome is Outcome.WRONG_COUNT


def test_choices() -> None:
    kind = attribute("joint", "type")
    assert kind.accepts("revolute")
    for text in ("Revolute", " revolute", "ball"):
        assert not kind.accepts(text)
        assert read(kind, text).outcome is Outcome.NOT_A_CHOICE


@pytest.mark.parametrize("text", ["1", "1 2 3", "1 2 3 4", "x", "1e999", "", "1 ", "-0.5", "0 0 1m", "nan"])
@pytest.mark.parametrize("known", [SIZE, LOWER, RGBA, XYZ], ids=repr)
def test_the_quick_check_accepts_nothing_that_reading_does_not(known: AttributeDefinition, text: str) -> None:
    if known.accepts(text):
        assert read(known, text).is_fine
