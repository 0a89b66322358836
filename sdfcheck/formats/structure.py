"""What the tables cannot say: which parts of a container go together.

Source: the readers of libsdformat 17 (Geometry.cc, Sensor.cc, Material.cc, Mesh.cc,
World.cc) and what they do when run.
"""

from __future__ import annotations

from collections.abc import Iterator

from sdfcheck.formats import problems
from sdfcheck.formats.survey import Survey, survey
from sdfcheck.source.document import Document

# The order in which libsdformat looks for a shape; the first one found is taken.
SHAPES = (
    "box", "capsule", "cone", "cylinder", "ellipsoid", "plane", "sphere", "mesh", "heightmap", "polyline",
    "image", "empty",
)  # fmt: skip

_CAMERA_TYPES = (
    "camera depth depth_camera rgbd rgbd_camera thermal thermal_camera segmentation segmentation_camera "
    "boundingbox boundingbox_camera wideanglecamera wide_angle_camera multicamera"
)
# Sensor type → the elements that may hold its settings.
SETTINGS = {
    **{kind: ("camera",) for kind in _CAMERA_TYPES.split()},
    "air_pressure": ("air_pressure",),
    "air_speed": ("air_speed",),
    "altimeter": ("altimeter",),
    "force_torque": ("force_torque",),
    "navsat": ("navsat", "gps"),
    "gps": ("navsat", "gps"),
    **{kind: ("lidar", "ray") for kind in ("lidar", "gpu_lidar", "ray", "gpu_ray")},
    "imu": ("imu",),
    "magnetometer": ("magnetometer",),
    "contact": ("contact",),
    "logical_camera": ("logical_camera",),
    "sonar": ("sonar",),
    "rfid": ("rfid",),
    "rfidtag": ("rfidtag",),
    "wireless_receiver": ("transceiver",),
    "wireless_transmitter": ("transceiver",),
}
_ALL_SETTINGS = frozenset(name for names in SETTINGS.values() for name in names)

# Without these settings a sensor of the type has nothing sensible to run on.
_NEEDS_SETTINGS = frozenset({*_CAMERA_TYPES.split(), "lidar", "gpu_lidar", "ray", "gpu_ray", "logical_camera"})


def structure_problems(document: Document) -> list[object]:
    """The problems of a document's composite elements."""
    surveyed = survey(document)
    return [
        *_shapes(surveyed),
        *_sensors(surveyed),
        *_materials(surveyed),
        *_meshes(surveyed),
        *_surfaces(surveyed),
        *_order(surveyed),
    ]


def _shapes(surveyed: Survey) -> Iterator[object]:
    for geometry in surveyed.index.get("geometry", ()):
        if len(geometry) == 1 and geometry[0].tag in SHAPES:
            continue
        children = list(geometry.children())
        shapes = [child for child in children if child.name in SHAPES]
        if len(shapes) == 1:
            continue
        if not shapes:
            # An unknown or custom child is the mistake, or the vendor's own shape.
            if not children:
                yield problems.MissingShape(geometry)
            continue
        taken = min(shapes, key=lambda shape: SHAPES.index(shape.name))
        for shape in shapes:
            if shape.name != taken.name:
                yield problems.SeveralShapes(shape, taken)


def _sensors(surveyed: Survey) -> Iterator[object]:
    for sensor in surveyed.index.get("sensor", ()):
        kind = sensor.attribute("type")
        if kind is None or kind.text not in SETTINGS:
            continue
        expected = SETTINGS[kind.text]
        given = [child for child in sensor.children() if child.name in _ALL_SETTINGS]
        fitting = [child for child in given if child.name in expected]
        if not fitting and given:
            yield problems.MismatchedSensor(kind, expected[0], given[0])
        elif not given and kind.text in _NEEDS_SETTINGS:
            yield problems.MismatchedSensor(kind, expected[0], None)


def _materials(surveyed: Survey) -> Iterator[object]:
    for script in surveyed.index.get("script", ()):
        if script.parent is None or script.parent.name != "material":
            continue
        for name in ("uri", "name"):
            if not script.has(name):
                yield problems.MissingElement(script, name, None)
    for shader in surveyed.index.get("shader", ()):
        if shader.attributes.get("type", "").startswith("normal_map") and not shader.has("normal_map"):
            yield problems.MissingElement(shader, "normal_map", None)


def _meshes(surveyed: Survey) -> Iterator[object]:
    for submesh in surveyed.index.get("submesh", ()):
        name = submesh.find("name")
        if name is None:
            yield problems.MissingElement(submesh, "name", None)


def _surfaces(surveyed: Survey) -> Iterator[object]:
    for coordinates in surveyed.index.get("spherical_coordinates", ()):
        model = coordinates.find("surface_model")
        if model is not None and model.content == "CUSTOM_SURFACE":
            for name in ("surface_axis_equatorial", "surface_axis_polar"):
                if not coordinates.has(name):
                    yield problems.MissingElement(coordinates, name, None)


# Pairs that must be in order: container, lower one, upper one.
_ORDERED = (
    ("horizontal", "min_angle", "max_angle"),
    ("vertical", "min_angle", "max_angle"),
    ("range", "min", "max"),
    ("clip", "near", "far"),
    ("solver", "min_step_size", "max_step_size"),
)


def _order(surveyed: Survey) -> Iterator[object]:
    for container, low, high in _ORDERED:
        for element in surveyed.index.get(container, ()):
            lower, upper = element.number(low), element.number(high)
            if lower is not None and upper is not None and lower.number > upper.number:
                bound = f"{low} {lower.text} is above {high} {upper.text}"
                yield problems.ReversedRange(lower, upper, bound)
