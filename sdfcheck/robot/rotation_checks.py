"""Rotations that cannot be meant: degrees where radians are read, quaternions without unit length.

A world holds thousands of poses and hardly one rotation to look at, so whatever ends in
three zeros is passed over at once.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator

from sdfcheck.formats.sdf.values import floats
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element, Value
from sdfcheck.source.record import NamedTuple, Record

_WHOLE_TURN = 2 * math.pi
_STEP = 0.5
"""Degrees that people write by hand are multiples of it."""
_ROUNDING = 1e-3
"""How far from 1 the length of a quaternion may be by rounding its numbers."""
_NOT_ROTATED = (" 0 0 0", " 0.0 0.0 0.0")


class DegreesAsRadians(Record):
    """Angles of more than a turn that are round numbers of degrees.

    ``parts`` are the indices of the words in ``value`` and what the angles are called.
    """

    value: Value
    parts: tuple[tuple[int, str], ...]


class NonUnitQuaternion(Record):
    """A quaternion whose length is not 1; ``length`` is 0 where it gives no rotation at all.

    ``normalized`` are the four numbers of unit length, in their order.
    """

    value: Value
    length: float
    normalized: tuple[float, ...]


Problem = DegreesAsRadians | NonUnitQuaternion


def problems(document: Document) -> Iterator[Problem]:
    """Every rotation of an SDF document that cannot be meant."""
    from sdfcheck.formats.sdf.survey import survey

    return _in_poses(survey(document).index.get("pose", ()))


def urdf_problems(document: Document) -> Iterator[Problem]:
    """Every rotation of a URDF document that cannot be meant."""
    from sdfcheck.formats.urdf.survey import survey

    for origin in survey(document).index.get("origin", ()):
        value = origin.attribute("rpy")
        if value is not None and (parts := _degrees(floats(value.text) or (), 0)):
            yield DegreesAsRadians(value, parts)


class _Attributes(NamedTuple):
    """What the attributes of a pose make of its numbers."""

    degrees: bool
    quaternion: bool


_PLAIN = _Attributes(degrees=False, quaternion=False)


def _in_poses(poses: Iterable[Element]) -> Iterator[Problem]:
    for pose in poses:
        text = pose.text
        attributes = _attributes(pose) if pose.keys() else _PLAIN
        if attributes.degrees or (text and text.endswith(_NOT_ROTATED) and not attributes.quaternion):
            continue
        numbers = floats(pose.content) or ()
        if attributes.quaternion:
            yield from _quaternion(pose, numbers)
        elif len(numbers) == 6 and (parts := _degrees(numbers, 3)):
            yield DegreesAsRadians(pose.own_value, parts)


def _attributes(pose: Element) -> _Attributes:
    given = pose.attributes
    return _Attributes(
        given.get("degrees", "").strip().lower() in {"true", "1"},
        given.get("rotation_format", "").strip() == "quat_xyzw",
    )


def _degrees(numbers: tuple[float, ...], start: int) -> tuple[tuple[int, str], ...]:
    """The angles, the first of which is at ``start``, that are round numbers of degrees beyond a turn."""
    angles = zip(range(start, start + 3), ("roll", "pitch", "yaw"), strict=True)
    return tuple((at, name) for at, name in angles if at < len(numbers) and _is_round(numbers[at]))


def _is_round(angle: float) -> bool:
    return abs(angle) > _WHOLE_TURN and angle % _STEP == 0


def _quaternion(pose: Element, numbers: tuple[float, ...]) -> Iterator[Problem]:
    if len(numbers) != 7:
        return
    length = math.hypot(*numbers[3:])
    if length == 0:
        yield NonUnitQuaternion(pose.own_value, 0.0, ())
    elif abs(length - 1) > _ROUNDING:
        yield NonUnitQuaternion(pose.own_value, length, tuple(n / length + 0.0 for n in numbers[3:]))
