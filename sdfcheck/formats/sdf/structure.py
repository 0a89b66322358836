"""Conditions that no row of the tables holds: which parts of a container are used together.

Source: the consumers of libsdformat 17 (Root.cc, Geometry.cc, Sensor.cc, Material.cc,
World.cc) and what they do when run.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import inf

from sdfcheck.formats import problems
from sdfcheck.formats.sdf.survey import Survey, survey
from sdfcheck.formats.version import Version
from sdfcheck.source.document import Document, Element
from sdfcheck.source.sniff import Kind

_SIX = Version(1, 6)

# The order in which libsdformat looks for a shape; the first one found is taken.
SHAPES = (
    "box", "capsule", "cone", "cylinder", "ellipsoid", "plane", "sphere", "mesh", "heightmap", "polyline",
    "image", "empty",
)  # fmt: skip

# A document holds one of these, in addition to worlds.
_ENTITIES = frozenset({"model", "light", "actor"})

_NORMAL_MAPS = frozenset(
    {
        "normal_map_object_space",
        "normal_map_objectspace",
        "normal_map_tangent_space",
        "normal_map_tangentspace",
    }
)


def structure_problems(document: Document) -> list[object]:
    """The problems of a document's composite elements."""
    surveyed = survey(document)
    return [
        *_root(document),
        *_shapes(surveyed),
        *_lights(surveyed),
        *_directions(surveyed),
        *_planes(surveyed),
        *_inertials(surveyed),
        *_sensors(surveyed),
        *_shaders(surveyed),
        *_surfaces(surveyed),
        *_order(surveyed),
    ]


def _root(document: Document) -> Iterator[object]:
    root = document.root
    if root is None or root.name != "sdf":
        return
    first: Element | None = None
    for child in root.children():
        if child.name not in _ENTITIES:
            continue
        if first is None:
            first = child
        else:
            yield problems.RepeatedElement(child, first, root, refused=True)


def _shapes(surveyed: Survey) -> Iterator[object]:
    for geometry in surveyed.index.get("geometry", ()):
        if len(geometry.nodes) < 2:
            continue
        # In a sonar it is the name of a shape.
        if not _is_in(geometry, "sonar"):
            yield from _shapes_of(geometry)


def _shapes_of(geometry: Element) -> Iterator[object]:
    children = list(geometry.children())
    # Where no child is a shape, the unknown or custom child is the mistake, or the vendor's own shape.
    shapes = [child for child in children if child.name in SHAPES]
    if len(shapes) < 2:
        return
    taken = min(shapes, key=lambda shape: SHAPES.index(shape.name))
    for shape in shapes:
        if shape.name != taken.name:
            yield problems.SeveralShapes(shape, taken)


def _parents(surveyed: Survey, name: str) -> set[Element | None]:
    """The elements that hold one of a name."""
    return {element.parent for element in surveyed.index.get(name, ())}


def _is_state(element: Element) -> bool:
    """Is it the state of something? Up to 1.11 states have the names of their subjects."""
    return any(ancestor.name == "state" for ancestor in element.around)


def _is_in(element: Element, parent: str) -> bool:
    return element.parent is not None and element.parent.name == parent


def _lights(surveyed: Survey) -> Iterator[object]:
    """Up to 1.5 a light needed no name; all consumers now ask for one."""
    for light in surveyed.index.get("light", ()):
        given = "name" in light.attributes or (light, "name") in surveyed.noted.misspelled
        if surveyed.version < _SIX and not given and not _is_state(light):
            yield problems.MissingAttribute(light, "name", empty=False)


def _directions(surveyed: Survey) -> Iterator[object]:
    """Lights that shine somewhere, and do not say where to."""
    for light in surveyed.index.get("light", ()):
        is_aimed = light.text_of("type", "").strip() in {"directional", "spot"}
        if is_aimed and not _has(surveyed, light, "direction") and not _is_state(light):
            yield problems.MissingElement(light, "direction", "0 0 -1")


def _planes(surveyed: Survey) -> Iterator[object]:
    """Planes that are seen; as a collision a plane has no end."""
    for plane in surveyed.index.get("plane", ()):
        shape = plane.parent.parent if plane.parent is not None else None
        is_seen = shape is not None and shape.name == "visual"
        if is_seen and not _has(surveyed, plane, "size"):
            yield problems.MissingElement(plane, "size", "1 1")


def _has(surveyed: Survey, element: Element, name: str) -> bool:
    """Has an element a child of a name, perhaps misspelled?"""
    return element.has(name) or (element, name) in surveyed.noted.misspelled


def _inertials(surveyed: Survey) -> Iterator[object]:
    """Moments that belong to no mass: the default of one kilogram was not meant."""
    massive, turning = _parents(surveyed, "mass"), _parents(surveyed, "inertia")
    for inertial in surveyed.index.get("inertial", ()):
        given = inertial in massive or (inertial, "mass") in surveyed.noted.misspelled
        if not given and inertial in turning and not _is_static(inertial):
            yield problems.MissingElement(inertial, "mass", "1")


def _is_static(element: Element) -> bool:
    given = (static for parent in element.around if (static := parent.find("static")) is not None)
    return any(static.content.lower() in {"true", "1"} for static in given)


def _sensors(surveyed: Survey) -> Iterator[object]:
    is_sdf = surveyed.document.kind is Kind.SDF  # nobody says for which version the rest is
    if surveyed.index.get("sensor") and is_sdf:
        from sdfcheck.formats.sdf.sensors import sensor_problems

        yield from sensor_problems(surveyed)


def _shaders(surveyed: Survey) -> Iterator[object]:
    for shader in surveyed.index.get("shader", ()):
        if shader.text_of("type", "").strip() in _NORMAL_MAPS and not shader.has("normal_map"):
            yield problems.MissingElement(shader, "normal_map", None, refused=True)


def _surfaces(surveyed: Survey) -> Iterator[object]:
    for coordinates in surveyed.index.get("spherical_coordinates", ()):
        model = coordinates.find("surface_model")
        if model is not None and model.content == "CUSTOM_SURFACE":
            for name in ("surface_axis_equatorial", "surface_axis_polar"):
                if not coordinates.has(name):
                    yield problems.MissingElement(coordinates, name, None, refused=True)


# Pairs that must be in order: container, lower one, upper one.
_ORDERED = (
    ("horizontal", "min_angle", "max_angle"),
    ("vertical", "min_angle", "max_angle"),
    ("range", "min", "max"),
    ("clip", "near", "far"),
    ("logical_camera", "near", "far"),
    ("sonar", "min", "max"),
    ("particle_emitter", "min_velocity", "max_velocity"),
    ("transceiver", "min_frequency", "max_frequency"),
    ("fog", "start", "end"),
)


def _order(surveyed: Survey) -> Iterator[object]:
    for container, low, high in _ORDERED:
        for element in surveyed.index.get(container, ()):
            yield from _reversed(element, low, element, high)
    for physics in surveyed.index.get("physics", ()):
        for steps in (("ode", "solver"), ("bullet", "solver"), ("simbody",)):
            holder: Element | None = physics
            for step in steps:
                holder = holder.find(step) if holder is not None else None
            if holder is not None:
                yield from _reversed(holder, "min_step_size", physics, "max_step_size")


def _reversed(low_holder: Element, low: str, high_holder: Element, high: str) -> Iterator[object]:
    lower, upper = low_holder.number(low), high_holder.number(high)
    if lower is not None and upper is not None and inf > lower.number > upper.number:
        yield problems.ReversedRange(lower, upper, f"{low} {lower.text} is above {high} {upper.text}")
