"""The numbers of URDF, and the poses that it writes as ``origin``.

Without numpy: lint merges links with it, and numpy takes longer to load than most files to lint.
"""

from __future__ import annotations

import math
from typing import TypeAlias

from sdfcheck.robot.solids import Moments
from sdfcheck.source.document import Element
from sdfcheck.source.errors import DescriptionError
from sdfcheck.source.record import NamedTuple

Triple: TypeAlias = tuple[float, float, float]
Rows: TypeAlias = tuple[Triple, Triple, Triple]


UNTURNED: Rows = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


class Origin(NamedTuple):
    """A pose: the rows of its rotation and its position (m)."""

    rotation: Rows = UNTURNED
    position: Triple = (0.0, 0.0, 0.0)

    def followed_by(self, inner: Origin) -> Origin:
        """The pose of what ``inner`` places in this one's frame."""
        first, second, third = (self.turned(column) for column in zip(*inner.rotation, strict=True))
        rows = tuple(zip(first, second, third, strict=True))
        return Origin((rows[0], rows[1], rows[2]), self.applied_to(inner.position))

    def turned(self, vector: Triple) -> Triple:
        """A vector of the inner frame, in the axes of the outer one."""
        x, y, z = vector
        (a, b, c), (d, e, f), (g, h, i) = self.rotation
        return a * x + b * y + c * z, d * x + e * y + f * z, g * x + h * y + i * z

    def applied_to(self, point: Triple) -> Triple:
        """A point of the inner frame (m), in the outer one."""
        x, y, z = self.turned(point)
        return x + self.position[0], y + self.position[1], z + self.position[2]

    def seen(self, point: Triple) -> Triple:
        """A point of the outer frame (m), in the inner one."""
        x, y, z = (at - start for at, start in zip(point, self.position, strict=True))
        (a, b, c), (d, e, f), (g, h, i) = self.rotation
        return a * x + d * y + g * z, b * x + e * y + h * z, c * x + f * y + i * z

    def seen_along(self, vector: Triple) -> Triple:
        """A vector of the outer frame, in the axes of the inner one."""
        return Origin(self.rotation).seen(vector)

    def turned_moments(self, moments: Moments) -> Moments:
        """Moments along the axes of the inner frame, along those of the outer one."""
        xx, yy, zz, xy, xz, yz = moments
        columns = [self.turned(row) for row in ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz))]
        (ixx, ixy, ixz), (_, iyy, iyz), (_, _, izz) = (self.turned(row) for row in zip(*columns, strict=True))
        return Moments(ixx, iyy, izz, ixy, ixz, iyz)


class PoseError(DescriptionError):
    """A pose that cannot be worked out: an unknown frame, a ring, a value that is not a pose."""


def origin_in(element: Element) -> Origin:
    """The pose that an element's ``origin`` writes; no displacement without one.

    Raises DescriptionError where a number is not one.
    """
    origin = element.find("origin")
    if origin is None:
        return Origin()
    x, y, z = numbers_of(origin, "xyz", (0.0, 0.0, 0.0))
    if origin.text_of("quat_xyzw") is not None:
        return Origin(of_quaternion(*numbers_of(origin, "quat_xyzw", (0.0, 0.0, 0.0, 1.0))), (x, y, z))
    return Origin(of_rpy(*numbers_of(origin, "rpy", (0.0, 0.0, 0.0))), (x, y, z))


def pose_in(pose: Element | None) -> Origin:
    """The pose that a ``pose`` of SDFormat writes, whatever it is relative to; no displacement without one.

    Raises DescriptionError if its numbers cannot be read.
    """
    if pose is None or not pose.content:
        return Origin()
    from sdfcheck.formats.sdf.values import floats

    numbers = floats(pose.content)
    attributes = pose.attributes
    is_quaternion = attributes.get("rotation_format", "").strip() == "quat_xyzw"
    if numbers is None or len(numbers) != (7 if is_quaternion else 6) or not all(map(math.isfinite, numbers)):
        raise DescriptionError(f"{pose.content!r} is not a pose", pose)
    x, y, z, *turn = numbers
    if is_quaternion:
        return Origin(of_quaternion(*turn), (x, y, z))
    if attributes.get("degrees", "").strip().lower() in {"true", "1"}:
        turn = [math.radians(angle) for angle in turn]
    return Origin(of_rpy(*turn), (x, y, z))


def of_rpy(roll: float, pitch: float, yaw: float) -> Rows:
    """The rows of the rotation of roll, pitch, yaw (rad)."""
    if not (roll or pitch or yaw):
        return UNTURNED
    cr, sr = math.cos(roll), math.sin(roll)
    cp, sp = math.cos(pitch), math.sin(pitch)
    cy, sy = math.cos(yaw), math.sin(yaw)
    return (
        (cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr),
        (sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr),
        (-sp, cp * sr, cp * cr),
    )


def of_quaternion(x: float, y: float, z: float, w: float) -> Rows:
    """The rows of the rotation of a quaternion, normalized first; of the zero quaternion, no rotation."""
    norm = math.sqrt(x * x + y * y + z * z + w * w)
    if norm == 0:
        return UNTURNED
    x, y, z, w = x / norm, y / norm, z / norm, w / norm
    return (
        (1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)),
        (2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)),
        (2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)),
    )


def numbers_of(element: Element, name: str, default: tuple[float, ...]) -> tuple[float, ...]:
    """The finite numbers of an attribute of URDF, as many as the default has; raises DescriptionError."""
    text = element.text_of(name)
    if text is None:
        return default
    try:
        numbers = tuple(float(part) for part in text.split())
    except ValueError:
        numbers = ()
    if len(numbers) != len(default) or not all(map(math.isfinite, numbers)):
        raise DescriptionError(f"{name} {text!r} is not {len(default)} finite numbers", element)
    return numbers


def urdf_number(element: Element, name: str, default: float) -> float:
    """A number of URDF, infinite in a limit only; raises DescriptionError for anything else."""
    text = element.text_of(name)
    if text is None:
        return default
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if math.isnan(value) or (math.isinf(value) and element.name != "limit"):
        raise DescriptionError(f"{name} {text!r} is not a finite number", element)
    return value
