"""Hand-picked facts of the tables, as the lookup gives them."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from sdfcheck.formats.schema import Definition, Schema
from sdfcheck.formats.sdf.schema import schema
from sdfcheck.formats.version import NEWEST, OLDEST, Version


def version(text: str) -> Version:
    parsed = Version.parse(text)
    assert parsed is not None
    return parsed


def format_of(text: str) -> Schema:
    return schema(version(text))


def place(text: str, path: str) -> Definition | None:
    """The definition below the root at a path, or None."""
    found: Definition | None = format_of(text).root
    for name in path.split("/"):
        found = found.children.get(name) if found else None
    return found


def known(text: str, path: str) -> Definition:
    found = place(text, path)
    assert found is not None
    return found


ALL = [str(Version(1, minor)) for minor in range(OLDEST.minor, NEWEST.minor + 1)]


def test_versions_are_ordered_by_number() -> None:
    assert version("1.10") > version("1.9")
    assert sorted(map(version, ["1.12", "1.9", "1.2"])) == [OLDEST, version("1.9"), NEWEST]
    assert [str(version(text)) for text in ALL] == ALL


@pytest.mark.parametrize(
    "text", ["", "1.0", "1.1", "1.13", "2.0", "1.6.0", "1.06", " 1.12", "1.12 ", "1", "1.x"]
)
def test_only_the_exact_texts_of_versions_are_known(text: str) -> None:
    assert Version.parse(text) is None


@pytest.mark.parametrize(
    ("path", "since", "until"),
    [
        ("model/link/sensor/lidar", "1.6", "1.12"),
        ("model/link/sensor/ray", "1.2", "1.12"),
        ("model/link/sensor/navsat", "1.7", "1.12"),
        ("model/link/sensor/imu/noise", "1.4", "1.5"),
        ("model/link/sensor/imu/topic", "1.3", "1.6"),
        ("model/link/collision/geometry/capsule", "1.8", "1.12"),
        ("model/link/collision/geometry/cone", "1.11", "1.12"),
        ("model/link/collision/geometry/box/size", "1.2", "1.12"),
        ("model/link/collision/geometry/mesh/filename", "1.2", "1.2"),
        ("model/link/visual/material/pbr", "1.6", "1.12"),
        ("model/link/inertial/fluid_added_mass/pq", "1.10", "1.12"),
        ("model/link/frame", "1.5", "1.6"),
        ("model/frame", "1.5", "1.12"),
        ("model/model", "1.5", "1.12"),
        ("model/include", "1.5", "1.12"),
        ("model/joint/axis/initial_position", "1.6", "1.8"),
        ("model/joint/axis/use_parent_model_frame", "1.5", "1.6"),
        ("model/joint/axis/mimic", "1.11", "1.12"),
        ("model/joint/screw_thread_pitch", "1.10", "1.12"),
        ("world/physics/gravity", "1.2", "1.5"),
        ("world/gravity", "1.6", "1.12"),
        ("world/physics/update_rate", "1.2", "1.3"),
        ("world/physics/max_step_size", "1.4", "1.12"),
        ("world/include/placement_frame", "1.8", "1.12"),
        ("world/state/model/link/pose", "1.2", "1.11"),
        ("world/state/model_state/link_state/pose", "1.12", "1.12"),
    ],
)
def test_elements_exist_in_their_versions_only(path: str, since: str, until: str) -> None:
    there = [text for text in ALL if place(text, path) is not None]
    assert there == ALL[ALL.index(since) : ALL.index(until) + 1]


def test_a_place_may_come_back() -> None:
    there = [text for text in ALL if place(text, "world/joint") is not None]
    assert there == ["1.2", "1.3", "1.4", "1.5", "1.6", "1.10", "1.11", "1.12"]


@pytest.mark.parametrize(
    ("path", "attribute", "since"),
    [
        ("model/link/pose", "degrees", "1.9"),
        ("model/link/pose", "rotation_format", "1.9"),
        ("model/link/pose", "relative_to", "1.7"),
        ("model", "canonical_link", "1.7"),
        ("model", "placement_frame", "1.8"),
        ("model/link/inertial", "auto", "1.11"),
        ("model/joint/axis/xyz", "expressed_in", "1.7"),
        ("world/include", "merge", "1.10"),
        ("model/include", "merge", "1.9"),
    ],
)
def test_attributes_exist_from_their_version_on(path: str, attribute: str, since: str) -> None:
    there = [text for text in ALL if (found := place(text, path)) and attribute in found.attributes]
    assert there == ALL[ALL.index(since) :]


def test_an_attribute_may_go_away() -> None:
    assert [text for text in ALL if "frame" in known(text, "model/pose").attributes] == ["1.5", "1.6"]


@pytest.mark.parametrize(("text", "multiplicity", "single"), [("1.7", "*", False), ("1.8", "0", True)])
def test_the_root_takes_one_model_since_1_8(text: str, multiplicity: str, single: bool) -> None:
    model = known(text, "model")
    assert (model.multiplicity, model.own_multiplicity, model.single) == (multiplicity, "*", single)


def test_a_use_has_a_multiplicity_of_its_own() -> None:
    sensor = known("1.9", "model/link/sensor")
    assert (sensor.multiplicity, sensor.own_multiplicity) == ("*", "0")
    noise = known("1.9", "model/link/sensor/imu/angular_velocity/x/noise")
    assert (noise.multiplicity, noise.own_multiplicity) == ("0", "1")


def test_required_parts() -> None:
    joint = known("1.9", "model/joint")
    assert joint.required_children == ("parent", "child")
    assert joint.required_attributes == ("name", "type")
    assert "axis" in known("1.4", "model/joint").required_children
    assert known("1.9", "model/plugin").required_attributes == ("filename", "name")
    assert known("1.10", "model/plugin").required_attributes == ("filename",)
    assert known("1.12", "model/link/collision").required_children == ("geometry",)


@pytest.mark.parametrize(
    ("text", "path", "kind", "default"),
    [
        ("1.9", "model/joint/axis/limit/lower", "double", "-1e16"),
        ("1.10", "model/joint/axis/limit/lower", "double", "-inf"),
        ("1.2", "model/joint/axis/limit/effort", "double", "0"),
        ("1.3", "model/joint/axis/limit/effort", "double", "-1"),
        ("1.12", "model/link/pose", "pose", "0 0 0 0 0 0"),
        ("1.12", "model/link/sensor/camera/image/width", "int", "320"),
        ("1.3", "world/scene/ambient", "color", "0.2 0.2 0.2 1.0"),
        ("1.4", "model/link/sensor/force_torque/frame", "string", "parent"),
        ("1.5", "model/link/sensor/force_torque/frame", "string", "child"),
        ("1.2", "world/state/model/link/wrench", None, None),
        ("1.3", "world/state/model/link/wrench", "pose", "0 0 0 0 0 0"),
        ("1.12", "model/link", None, None),
    ],
)
def test_types_and_defaults(text: str, path: str, kind: str | None, default: str | None) -> None:
    definition = known(text, path)
    assert (definition.type, definition.default) == (kind, default)


@pytest.mark.parametrize(
    ("text", "path", "deprecated"),
    [
        ("1.9", "model/joint/thread_pitch", False),
        ("1.10", "model/joint/thread_pitch", True),
        ("1.7", "model/joint/axis/initial_position", False),
        ("1.8", "model/joint/axis/initial_position", True),
        ("1.12", "model/link/sensor/camera/optical_frame_id", True),
    ],
)
def test_deprecated(text: str, path: str, deprecated: bool) -> None:
    assert known(text, path).deprecated is deprecated


@pytest.mark.parametrize(
    ("path", "expected"),
    [
        ("model/joint/axis/limit/lower", "joint:joint/axis/limit/lower"),
        ("model/link/visual/geometry/box/size", "box_shape:box/size"),
        ("world/state/model/pose", "pose:pose"),
        ("world/state/model", "model_state:model_state"),
    ],
)
def test_places_are_the_same_in_all_versions(path: str, expected: str) -> None:
    assert {known(text, path).place for text in ALL[:-1] if place(text, path)} == {expected}


def test_paths_use_the_names_of_the_version() -> None:
    assert known("1.11", "world/state/model/link").path == "link"
    assert known("1.12", "world/state/model_state/link_state").path == "link_state"


def test_one_object_for_one_place() -> None:
    nine = format_of("1.9")
    assert schema(version("1.9")) is nine
    link = known("1.9", "model/link")
    assert link is known("1.9", "world/model/link")
    assert link.children["pose"] is known("1.9", "world/model/joint/pose")
    assert link is not known("1.10", "model/link")


def test_recursion_ends_in_itself() -> None:
    inner = known("1.9", "world/model/model")
    assert inner.children["model"] is inner
    assert inner.children["link"] is known("1.9", "model/link")


def test_plugins_are_open() -> None:
    assert known("1.12", "world/plugin").open
    assert not known("1.12", "world").open


def everything(definition: Definition, seen: set[int]) -> Iterator[Definition]:
    if id(definition) not in seen:
        seen.add(id(definition))
        yield definition
        for child in definition.children.values():
            yield from everything(child, seen)


TYPES = {
    *("bool", "color", "double", "float", "int", "pose", "string", "time"),
    *("unsigned int", "vector2d", "vector3"),
}


@pytest.mark.parametrize("text", ALL)
def test_every_version_unfolds(text: str) -> None:
    found = list(everything(format_of(text).root, set()))
    assert len(found) > 150
    assert all(d.multiplicity in {"0", "1", "+", "*", "-1"} for d in found)
    assert {d.type for d in found if d.type} <= TYPES


def test_unknown_attributes_of_definitions_are_errors() -> None:
    with pytest.raises(AttributeError):
        _ = known("1.9", "model").color  # type: ignore[attr-defined]
