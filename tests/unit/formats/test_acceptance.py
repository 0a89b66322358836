"""The fast check never accepts what the explaining side has something to say about."""

from __future__ import annotations

import pytest

from sdfcheck.formats.choices import Verdict
from sdfcheck.formats.reading import Outcome
from sdfcheck.formats.schema import AttributeDefinition, Definition
from sdfcheck.formats.sdf.schema import schema
from sdfcheck.formats.sdf.values import read_at
from sdfcheck.formats.version import Version

TEXTS = [
    "", " ", "0", "1", "-1", "+1", "1.", ".5", "-0.5", ".", "-", "+", "1e5", "1E-5", "1e", "1e400",
    "1e-400", "0e-999", "9" * 70, "0." + "0" * 400 + "1", "4294967295", "4294967296", "2147483648", "0x10",
    "0x1p3", "inf", "-inf", "nan", "INF", "Infinity", "1.79769e+308", "1.7977e308", "1,5", "1.5kg", "1 2",
    "true", "True", "TRUE", "tRuE", "false", "yes", "1 2 3", "0 0 0", "-1 0 1", "1 2 3 4", "1,2,3",
    "1 2 3abc", "nan 0 0", "1-2 3", "0 0 0 0 0 0", "0 0 0 0 0 inf", "0 0 0 0 0 1e-400", "0 0 0 0 0 0 1",
    "1 1 1 1", "2 0 0 1", "0.1 0.2 0.3", "1_0", "1_0 2 3", "\u0661", "\u0661 2 3", "1\u00a02 3", "1\n2\t3",
    "revolute", "Revolute", "gaussian", "none", "__default__", "quat_xyzw", "ode", "ignored", "100", "-90",
    "1e300 1e300 1e300", "1.0.0", "--1", "1e5e5",
]  # fmt: skip


def all_definitions(version: Version) -> list[Definition | AttributeDefinition]:
    found: dict[str, Definition | AttributeDefinition] = {}
    queue = [schema(version).root]
    while queue:
        definition = queue.pop()
        for attribute in definition.attributes.values():
            found[f"{definition.place} {attribute.name}"] = attribute
        for child in definition.children.values():
            key = f"{child.place} {child.own_multiplicity}"
            if key not in found:
                found[key] = child
                queue.append(child)
    return [definition for definition in found.values() if definition.type is not None]


@pytest.mark.parametrize("version", [Version(1, 2), Version(1, 6), Version(1, 12)], ids=str)
def test_accepted_means_read_as_written(version: Version) -> None:
    definitions = all_definitions(version)
    assert len(definitions) > 200
    wrong = [
        (definition.place, text, reading)
        for definition in definitions
        for text in TEXTS
        if definition.accepts(text) and not (reading := read_at(definition, text)).is_fine
    ]
    assert wrong == []


@pytest.mark.parametrize(
    ("place", "text"),
    [
        ("pose:pose", "1 2 3 0.1 -0.2 3e-05"),
        ("pose:pose", "\n  1 2 3  0 0 0\n"),
        ("link:link/gravity", "true"),
        ("link:link/gravity", "0"),
        ("box_shape:box/size", "1 .5 2."),
        ("joint:joint/axis/limit/lower", "-1e16"),
        ("joint:joint/axis/limit/upper", "inf"),
        ("joint:joint/axis/limit/upper", "1.79769e+308"),
        ("material:material/diffuse", "0.8 0.8 1.0"),
        ("material:material/diffuse", "0 0 .5 1"),
        ("lidar:lidar/scan/horizontal/samples", "640"),
        ("camera:camera/image/format", "R8G8B8"),
        ("mesh_shape:mesh/uri", "model://a/b.dae"),
        ("material:material/pbr/metal/metalness", "0.5"),
        ("spherical_coordinates:spherical_coordinates/latitude_deg", "-22.9"),
    ],
)
def test_usual_values_are_accepted_at_once(place: str, text: str) -> None:
    definition = schema(Version(1, 12)).at(place)
    assert definition is not None
    assert definition.accepts(text)


@pytest.mark.parametrize(
    ("place", "text", "refused"),
    [
        ("box_shape:box/size", "1 0 1", False),
        ("sphere_shape:sphere/radius", "-1", False),
        ("camera:camera/clip/near", "-0.1", True),
        ("surface:surface/bounce/restitution_coefficient", "1.5", True),
        ("plane_shape:plane/size", "-1 1", False),
        ("camera:camera/image/width", "0", False),
        ("spherical_coordinates:spherical_coordinates/latitude_deg", "900", False),
        ("material:material/pbr/metal/metalness", "2", False),
    ],
)
def test_out_of_range(place: str, text: str, refused: bool) -> None:
    definition = schema(Version(1, 12)).at(place)
    assert definition is not None
    assert not definition.accepts(text)
    reading = read_at(definition, text)
    assert (reading.outcome, reading.refused) == (Outcome.OUT_OF_RANGE, refused)


def test_the_replacement_of_a_size_out_of_range() -> None:
    radius = schema(Version(1, 12)).at("cylinder_shape:cylinder/radius")
    assert radius is not None
    assert radius.range is not None
    assert (radius.range.instead, str(radius.range)) == ("0.5", "above 0")


@pytest.mark.parametrize(
    ("version", "place", "attribute", "text", "verdict", "refused"),
    [
        ("1.12", "joint:joint", "type", "revolute", Verdict.LISTED, False),
        ("1.12", "joint:joint", "type", "Revolute", Verdict.LISTED, False),
        ("1.12", "joint:joint", "type", "revolut", Verdict.UNKNOWN, True),
        ("1.5", "joint:joint", "type", "continuous", Verdict.TOO_NEW, False),
        ("1.4", "joint:joint", "type", "piston", Verdict.REFUSED, True),
        ("1.12", "joint:joint", "type", "piston", Verdict.REMOVED, True),
        ("1.12", "sensor:sensor", "type", "Camera", Verdict.WRONG_CASE, True),
        ("1.12", "sensor:sensor", "type", "wideanglecamera", Verdict.UNLISTED, False),
        ("1.4", "sensor:sensor", "type", "gpu_lidar", Verdict.TOO_NEW, False),
        ("1.12", "physics:physics", "type", "havok", Verdict.UNKNOWN, False),
        ("1.12", "pose:pose", "rotation_format", "quat_wxyz", Verdict.UNKNOWN, True),
    ],
)
def test_choices(
    version: str, place: str, attribute: str, text: str, verdict: Verdict, refused: bool
) -> None:
    parsed = Version.parse(version)
    assert parsed is not None
    parent = schema(parsed).at(place)
    assert parent is not None
    definition = parent.attributes[attribute]
    choices = definition.choices
    assert choices is not None
    assert (choices.judge(text), choices.refuses(text)) == (verdict, refused)
    reading = read_at(definition, text)
    assert reading.is_fine is (verdict is Verdict.LISTED)
    assert reading.is_fine or (reading.verdict, reading.refused) == (verdict, refused)


def test_a_default_outside_the_list_is_fine() -> None:
    fog = schema(Version(1, 12)).at("scene:scene/fog/type")
    assert fog is not None
    assert fog.accepts("none")
    assert read_at(fog, "none").is_fine
    assert not read_at(fog, "thick").is_fine


def test_required_values_may_not_be_empty() -> None:
    nine = schema(Version(1, 9))
    size, pose, joint = nine.at("box_shape:box/size"), nine.at("pose:pose"), nine.at("joint:joint")
    assert size is not None
    assert pose is not None
    assert joint is not None
    assert read_at(size, "").outcome is Outcome.EMPTY
    assert read_at(pose, "").outcome is Outcome.DEFAULT
    assert read_at(joint.attributes["name"], " ").outcome is Outcome.EMPTY
    assert pose.attributes["relative_to"].accepts("")
