"""Facts across versions and places."""

from __future__ import annotations

import pytest

from sdfcheck.formats import history
from sdfcheck.formats.schema import Definition
from sdfcheck.formats.sdf.schema import schema
from sdfcheck.formats.version import Version


def at(version: str, place: str) -> Definition:
    parsed = Version.parse(version)
    assert parsed is not None
    found = schema(parsed).at(place)
    assert found is not None
    return found


@pytest.mark.parametrize(
    ("version", "parent", "name", "since"),
    [
        ("1.5", "sensor:sensor", "lidar", "1.6"),
        ("1.7", "geometry:geometry", "capsule", "1.8"),
        ("1.8", "pose:pose", "@degrees", "1.9"),
        ("1.8", "world:world", "joint", "1.10"),
        ("1.4", "world:world", "joint", "1.2"),
        ("1.2", "root:sdf", "world", "1.2"),
    ],
)
def test_since(version: str, parent: str, name: str, since: str) -> None:
    assert str(history.since(at(version, parent), name)) == since


def test_since_of_what_never_was() -> None:
    with pytest.raises(LookupError):
        history.since(at("1.9", "link:link"), "wheel")


@pytest.mark.parametrize(
    ("version", "parent", "name", "last"),
    [
        ("1.9", "joint:joint/axis", "initial_position", "1.8"),
        ("1.12", "joint:joint/axis", "use_parent_model_frame", "1.6"),
        ("1.12", "physics:physics", "update_rate", "1.3"),
        ("1.8", "world:world", "joint", "1.6"),
        ("1.7", "pose:pose", "@frame", "1.6"),
        ("1.12", "state:state", "model", "1.11"),
    ],
)
def test_last_version(version: str, parent: str, name: str, last: str) -> None:
    assert str(history.last_version(at(version, parent), name)) == last


def test_last_version_of_what_never_was() -> None:
    assert history.last_version(at("1.9", "link:link"), "wheel") is None


@pytest.mark.parametrize(
    ("parent", "name", "successor"),
    [
        ("physics:physics", "gravity", "world/gravity"),
        ("physics:physics", "update_rate", "real_time_update_rate"),
        ("pose:pose", "@frame", "@relative_to"),
        ("imu:imu", "topic", "sensor/topic"),
        ("mesh_shape:mesh", "filename", "uri"),
        ("state:state", "model", "model_state"),
        ("joint:joint", "thread_pitch", "screw_thread_pitch"),
        ("joint:joint/axis", "initial_position", None),
    ],
)
def test_successor(parent: str, name: str, successor: str | None) -> None:
    assert history.successor(at("1.12", parent), name) == successor


def test_deprecation() -> None:
    assert history.deprecation(at("1.12", "joint:joint/thread_pitch")) == ("screw_thread_pitch", "1.10")
    assert history.deprecation(at("1.12", "joint:joint/axis")) == (None, "")


def test_every_deprecated_element_has_its_deprecation() -> None:
    for minor in range(2, 13):
        version = Version(1, minor)
        queue, seen = [schema(version).root], set[str]()
        while queue:
            definition = queue.pop()
            seen.add(definition.place)
            queue += [child for child in definition.children.values() if child.place not in seen]
            if definition.deprecated:
                assert history.deprecation(definition).since, definition


def test_renamed_values() -> None:
    kind = at("1.12", "sensor:sensor").attributes["type"]
    assert history.renamed_value(kind, "gpu_ray") == "gpu_lidar"
    assert history.renamed_value(kind, "camera") is None


@pytest.mark.parametrize(
    ("parent", "name", "version", "carried"),
    [
        ("physics:physics", "gravity", "1.5", True),
        ("physics:physics", "gravity", "1.6", False),
        ("pose:pose", "@frame", "1.6", True),
        ("joint:joint/axis", "initial_position", "1.8", False),
    ],
)
def test_carried_over(parent: str, name: str, version: str, carried: bool) -> None:
    parsed = Version.parse(version)
    assert parsed is not None
    assert history.carried_over(at("1.12", parent), name, parsed) is carried


@pytest.mark.parametrize(
    ("version", "parent", "name", "is_read"),
    [
        ("1.6", "joint:joint/axis", "initial_position", False),
        ("1.6", "joint:joint/axis", "use_parent_model_frame", False),
        ("1.6", "joint:joint/physics/ode", "provide_feedback", False),
        ("1.5", "physics:physics", "gravity", True),
        ("1.6", "joint:joint/axis", "xyz", True),
    ],
)
def test_values_that_the_newest_version_has_no_place_for(
    version: str, parent: str, name: str, is_read: bool
) -> None:
    assert history.is_read(at(version, parent).children[name]) is is_read


def test_places_of_a_name() -> None:
    assert history.known_parents("radius") == ("capsule", "cone", "cylinder", "sonar", "sphere")
    assert history.known_parents("lower") == ("joint/axis/limit", "joint/axis2/limit")
    assert history.known_parents("wheel") == ()
    (capsule,) = history.known_places("capsule")
    assert (capsule.parent, str(capsule.versions[0]), len(capsule.versions)) == ("geometry", "1.8", 5)


def test_the_same_place_in_another_version() -> None:
    box = at("1.2", "geometry:geometry").children["box"]
    newest = history.in_version(box, Version(1, 12))
    assert newest is not None
    assert newest.place == box.place
    assert history.in_version(at("1.12", "cone_shape:cone"), Version(1, 9)) is None
    assert history.in_version(at("1.5", "pose:pose"), Version(1, 9)) is at("1.9", "pose:pose")


def test_units() -> None:
    assert at("1.12", "world:world/gravity").units == ("m/s^2",)
    assert at("1.12", "link:link").units == ()


def test_reserved_names_are_checked_on_some_elements_only() -> None:
    assert "link" in history.reserved_name_holders()
    assert "plugin" not in history.reserved_name_holders()
