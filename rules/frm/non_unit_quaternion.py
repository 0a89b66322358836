import math
from collections.abc import Iterator

from sdfcheck import (
    IN_LINK,
    REFUSES,
    Bad,
    Consumer,
    Diagnostic,
    Element,
    Good,
    Rule,
    Severity,
    TextEdit,
    make_fix,
)

_NO_ROTATION = (0.0, 0.0, 0.0, 1.0)
_ROUNDING = 1e-3
"""How far from 1 the length may be by rounding the numbers."""
_ROUNDED = 0.01
"""So far from 1 the length is a matter of rounding, and everybody means the same rotation."""


class NonUnitQuaternion(Rule):
    """The quaternion of a pose does not have the length 1.

    libsdformat takes it as it is, so what becomes of it differs from program to program: some
    make it of unit length, as Drake does, others stretch what they turn. Four zeros are not a
    rotation, and Drake refuses the file for it.
    """

    code = "FRM007"
    name = "non-unit-quaternion"
    severity = Severity.WARNING
    remedy = """Divide the four numbers of the quaternion by its length, √(x² + y² + z² + w²).

    The order is `x y z w`: a quaternion that was copied from a program with `w` first has another length
    only if digits are missing, but another rotation in any case. No rotation is `0 0 0 1`. Six digits or
    more keep the length near enough to 1.
    """
    looks_at = (Element,)
    selects = ("sdf:pose",)
    scaffold = IN_LINK

    bad = (
        Bad(
            '<pose rotation_format="quat_xyzw">0 0 1 «0 0 0.706 0.706»</pose>',
            fixed='<pose rotation_format="quat_xyzw">0 0 1 0 0 0.70710678118655 0.70710678118655</pose>',
            says="the quaternion has the length 0.998",
        ),
        Bad(
            '<pose rotation_format="quat_xyzw">0 0 1 «0 0 1 1»</pose>',
            fixed='<pose rotation_format="quat_xyzw">0 0 1 0 0 0.70710678118655 0.70710678118655</pose>',
            unsafe=True,
            says="the quaternion has the length 1.41",
        ),
        Bad(
            '<pose rotation_format="quat_xyzw">0 0 1 «0 0 0 0»</pose>',
            fixed='<pose rotation_format="quat_xyzw">0 0 1 0 0 0 1</pose>',
            unsafe=True,
            says="the quaternion is zero",
        ),
    )
    good = (
        Good(
            '<pose rotation_format="quat_xyzw">0 0 1 0 0 0.7071 0.7071</pose>', why="rounded to four digits"
        ),
        Good('<pose rotation_format="quat_xyzw"/>', why="the default"),
    )

    @staticmethod
    def applies(pose: Element) -> bool:
        if not pose.attributes:
            return False
        length = math.hypot(*_quaternion(pose))
        return abs(length - 1) > _ROUNDING

    def check(self, pose: Element) -> Iterator[Diagnostic]:
        value, numbers = pose.own_value, _quaternion(pose)
        first, last = value.part(3), value.part(6)
        span = first._replace(end=last.end)
        length = math.hypot(*numbers)
        if length == 0:
            fix = make_fix("write the quaternion of no rotation", (TextEdit(span, "0 0 0 1"),), unsafe=True)
            message = "the quaternion is zero, which is not a rotation"
            affects = {Consumer.DRAKE: REFUSES}
            yield self.diagnostic(span, message, fix=fix, severity=Severity.ERROR, affects=affects)
            return
        text = " ".join(f"{number / length + 0.0:.14g}" for number in numbers)
        is_unsafe = abs(length - 1) > _ROUNDED
        fix = make_fix("make its length 1", (TextEdit(span, text),), unsafe=is_unsafe)
        yield self.diagnostic(span, f"the quaternion has the length {length:.3g}, not 1", fix=fix)


def _quaternion(pose: Element) -> tuple[float, ...]:
    """The quaternion of a pose; that of no rotation where it has none that can be read."""
    if pose.attributes.get("rotation_format", "").strip() != "quat_xyzw":
        return _NO_ROTATION
    try:
        numbers = tuple(map(float, pose.content.split()))
    except ValueError:
        return _NO_ROTATION
    return numbers[3:] if len(numbers) == 7 and all(map(math.isfinite, numbers)) else _NO_ROTATION
