"""Numbers of a description in canonical form: shortest exact texts, poses in one unit."""

from __future__ import annotations

import math
from dataclasses import dataclass

from sdfcheck.convert.rewrite.tidy_tree import Branch
from sdfcheck.convert.writer import number
from sdfcheck.formats.sdf.schema import Definition, schema
from sdfcheck.formats.sdf.values import floats
from sdfcheck.formats.sdf.version import Version

_NUMERIC = frozenset(
    ("angle", "color", "double", "float", "pose", "quaternion", "vector2d", "vector2i", "vector3")
)
_URDF_NUMERIC = {
    "axis": ("xyz",),
    "box": ("size",),
    "calibration": ("falling", "rising"),
    "capsule": ("length", "radius"),
    "color": ("rgba",),
    "cylinder": ("length", "radius"),
    "dynamics": ("damping", "friction"),
    "inertia": ("ixx", "ixy", "ixz", "iyy", "iyz", "izz"),
    "limit": ("effort", "lower", "upper", "velocity", "acceleration", "jerk"),
    "mass": ("value",),
    "mesh": ("scale",),
    "mimic": ("multiplier", "offset"),
    "origin": ("xyz", "quat_xyzw"),
    "safety_controller": ("k_position", "k_velocity", "soft_lower_limit", "soft_upper_limit"),
    "sphere": ("radius",),
}
_URDF_FREE = frozenset(("gazebo", "ros2_control", "transmission"))
_MOST_ROUNDS = 8


@dataclass(frozen=True, slots=True)
class NumberStyle:
    """How numbers are written.

    ``degrees``: whether the angles of poses are; None leaves each as it is. ``snap``:
    angles this near to a whole degree (in degrees) become one. ``precision``:
    significant digits, None for as many as it takes.
    """

    degrees: bool | None = None
    snap: float | None = None
    precision: int | None = None

    def number(self, value: float) -> str:
        return number(value if self.precision is None else float(f"{value:.{self.precision}g}"))

    def numbers(self, text: str) -> str:
        """A list of numbers in canonical form; any other text as it is."""
        values = floats(text)
        if values is None or len(values) != len(text.split()):
            return text
        return " ".join(self.number(value) for value in values)

    def angle(self, value: float, *, degrees: bool) -> str:
        """An angle in degrees or radians, snapped; what comes out stays as it is when it goes in again."""
        text = self.number(value)
        for _ in range(_MOST_ROUNDS):
            following = self.number(self._snapped(float(text), degrees))
            if following == text:
                break
            text = following
        return text

    def _snapped(self, value: float, degrees: bool) -> float:
        if self.snap is None or not math.isfinite(value):
            return value
        in_degrees = value if degrees else math.degrees(value)
        whole = round(in_degrees)
        if abs(in_degrees - whole) > self.snap:
            return value
        return float(whole) if degrees else math.radians(whole)


def tidy_sdf(root: Branch, version: Version, style: NumberStyle) -> None:
    """Rewrite the numbers of an SDF tree wherever the format has numbers; nothing in plugins or custom elements."""
    waiting: list[tuple[Branch, Definition]] = [(root, schema(version).root)]
    while waiting:
        branch, definition = waiting.pop()
        for name, value in branch.attributes.items():
            attribute = definition.attributes.get(name)
            if attribute is not None and attribute.type in _NUMERIC:
                branch.attributes[name] = style.numbers(value)
        if definition.type == "pose":
            _tidy_pose(branch, definition, style)
        elif definition.type in _NUMERIC and branch.text:
            branch.text = style.numbers(branch.text)
        if not definition.open:
            inner = ((child, definition.children.get(child.name)) for child in branch.children)
            waiting += [(child, found) for child, found in inner if found is not None]


def tidy_urdf(root: Branch, style: NumberStyle) -> None:
    """Rewrite the numbers of a URDF tree; nothing in extensions."""
    for child in root.children:
        if child.name in _URDF_FREE or ":" in child.name:
            continue
        for name in _URDF_NUMERIC.get(child.name, ()):
            if name in child.attributes:
                child.attributes[name] = style.numbers(child.attributes[name])
        angles = floats(child.attributes.get("rpy", "")) if child.name == "origin" else None
        if angles is not None and len(angles) == 3:
            child.attributes["rpy"] = " ".join(style.angle(angle, degrees=False) for angle in angles)
        tidy_urdf(child, style)


def _tidy_pose(pose: Branch, definition: Definition, style: NumberStyle) -> None:
    values = floats(pose.text)
    if values is None:
        return
    if len(values) != 6 or pose.attributes.get("rotation_format", "euler_rpy").strip() != "euler_rpy":
        pose.text = style.numbers(pose.text)
        return
    has_degrees = pose.attributes.get("degrees", "").strip().lower() in {"true", "1"}
    wants_degrees = has_degrees if style.degrees is None else style.degrees
    angles = list(values[3:])
    if wants_degrees and not has_degrees and any(angles) and "degrees" in definition.attributes:
        angles = [math.degrees(angle) for angle in angles]
        pose.attributes["degrees"] = "true"
        has_degrees = True
    elif has_degrees and not wants_degrees:
        angles = [math.radians(angle) for angle in angles]
        del pose.attributes["degrees"]
        has_degrees = False
    texts = [style.number(value) for value in values[:3]]
    pose.text = " ".join((*texts, *(style.angle(angle, degrees=has_degrees) for angle in angles)))
