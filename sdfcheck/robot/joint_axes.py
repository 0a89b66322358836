"""Axes of SDF joints: there where needed, with a direction, and with limits that make sense.

Source: libsdformat 17's JointAxis.cc, checked against what it reports; Drake and the
physics engines of Gazebo for what an axis and its limits are used for.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

from sdfcheck.formats.sdf.survey import survey
from sdfcheck.formats.sdf.values import floats
from sdfcheck.robot.joint_problems import (
    MissingAxis,
    NegativeLimit,
    NonUnitAxis,
    Problem,
    UselessLimit,
    ZeroAxis,
)
from sdfcheck.source.element import Element, Value

AXES = {
    "revolute": 1,
    "continuous": 1,
    "prismatic": 1,
    "screw": 1,
    "gearbox": 2,
    "revolute2": 2,
    "universal": 2,
    "ball": 0,
    "fixed": 0,
}
"""Joint type → the number of axes that it moves about or along."""

DEFAULT_AXIS = "0 0 1"

_NAMES = ("axis", "axis2")
_NO_LENGTH = 1e-6
"""Below it libsdformat refuses the axis."""
_ROUNDING = 1e-3
"""How far from 1 the length of an axis may be by rounding its numbers."""
_UNLIMITED = 1e15
"""libsdformat's way to say that there is no limit is 1e16."""


def axis_problems(joint: Element) -> Iterator[Problem]:
    """What is wrong with the axes of one joint."""
    kind = joint.attributes.get("type", "").strip().lower()
    count = AXES.get(kind, 0)
    for number, name in enumerate(_NAMES):
        axis = joint.find(name)
        if axis is not None:
            yield from _direction(joint, axis)
            yield from _limits(joint, axis, kind)
        elif number < count and (joint, name) not in survey(joint.document).misspelled:
            yield MissingAxis(joint, kind, name, DEFAULT_AXIS)


def _direction(joint: Element, axis: Element) -> Iterator[Problem]:
    xyz = axis.find("xyz")
    numbers = floats(xyz.content) if xyz is not None else None
    if xyz is None or numbers is None or len(numbers) != 3:
        return
    length = math.hypot(*numbers)
    if length < _NO_LENGTH:
        yield ZeroAxis(xyz.own_value, joint)
    elif abs(length - 1) > _ROUNDING:
        # Adding zero takes the sign from a negative one.
        unit = " ".join(f"{number / length + 0.0:.12g}" for number in numbers)
        yield NonUnitAxis(xyz.own_value, joint, length, unit)


def _limits(joint: Element, axis: Element, kind: str) -> Iterator[Problem]:
    limit, dynamics = axis.find("limit"), axis.find("dynamics")
    if limit is not None:
        yield from _range(joint, limit, kind)
        for name in ("effort", "velocity"):
            value = limit.number(name)
            # A negative one is no limit: the format writes -1, some write -inf.
            if value is not None and value.number < 0 and value.number not in {-1, -math.inf}:
                yield NegativeLimit(value, name, joint)
    if dynamics is not None:
        for name in ("damping", "friction"):
            value = dynamics.number(name)
            if value is not None and value.number < 0:
                yield NegativeLimit(value, name, joint)


def _range(joint: Element, limit: Element, kind: str) -> Iterator[Problem]:
    lower, upper = limit.number("lower"), limit.number("upper")
    inverted = lower and upper and lower.number > upper.number
    if kind == "continuous" and not inverted:
        useless: list[Value] = [v for v in (lower, upper) if v is not None and abs(v.number) < _UNLIMITED]
        if useless:
            yield UselessLimit(useless[0], tuple(useless[1:]), kind, joint)
