"""SDFormat: what it allows where, for each of its versions, and which texts are surely read as written."""

from __future__ import annotations

import re
from functools import cache
from math import inf

from sdfcheck.formats.schema import NOT_GIVEN, Accepts, Definition, Format, RowInVersion, Schema
from sdfcheck.formats.table import Range, Table, at
from sdfcheck.formats.version import VERSIONS, Version

# Digits are counted so that a number stays inside its type without being converted.
_NUMBER = r"[+-]?(?:\d{1,60}\.?\d{0,60}|\.\d{1,60})(?:[eE][+-]?\d\d?)?"
_SINGLE = r"[+-]?(?:\d{1,8}\.?\d{0,8}|\.\d{1,8})(?:[eE][+-]?[0-2]?\d)?"
_SHARE = r"(?:0?\.\d{1,20}|[01](?:\.0*)?)"
_WHOLE = r"[+-]?\d{1,9}"

_LONGEST = 60
_TINY = 1e-300

_TRUTH = frozenset(("true", "false", "1", "0", "True", "False"))
# Each part, and how many of them.
_PATTERNS = {
    "color": (_SHARE, "3,4"),
    "float": (_SINGLE, "1"),
    "pose": (_NUMBER, "6"),
    "time": (_WHOLE, "2"),
    "vector2d": (_NUMBER, "2"),
    "vector3": (_NUMBER, "3"),
}


def _acceptance(definition: RowInVersion) -> Accepts:
    """The check for one place. An empty text is accepted for texts only, where it is the default."""
    kind, bounds = definition.type, definition.range
    if kind is None:
        return _nothing
    if listed := at(definition.row.extra("choices"), definition.version.minor):
        return _choices(definition, listed)
    if kind == "bool":
        return _TRUTH.__contains__
    if kind in {"int", "unsigned int"}:
        return _bounded(_digits, bounds) if bounds else _digits
    if kind == "string" and bounds is None:
        return str.strip if definition.needs_value else _anything
    matches: Accepts
    if kind in {"double", "string"}:
        matches = _number_or_infinity if definition.may_be_infinite else _number
    else:
        matches = _parts(*_PATTERNS[kind])
    return matches if bounds is None else _bounded(matches, bounds)


def _anything(text: str) -> bool:
    return True


def _number(text: str) -> bool:
    # Stripping leaves nothing when all characters are of the given ones.
    if text.strip("0123456789.+-eE \t\n") or len(text) > _LONGEST:
        return False
    try:
        value = abs(float(text))
    except ValueError:
        return False
    return _TINY < value < inf or (value == 0 and "e" not in text and "E" not in text)


def _number_or_infinity(text: str) -> bool:
    return _number(text) or text in {"inf", "-inf", "+inf"}


def _digits(text: str) -> bool:
    return len(text) < 10 and text.isascii() and text.isdigit()


def _nothing(text: str) -> bool:
    return not text or text.isspace()


def _choices(definition: RowInVersion, listed: str) -> Accepts:
    accepted = set(listed.split(","))
    if library := definition.row.extra("library"):
        accepted.intersection_update(library.split(","))
    if definition.default != "__default__":
        accepted.add(definition.default or "")
    accepted.discard("") if definition.needs_value else accepted.add("")
    return frozenset(accepted).__contains__


@cache
def _parts(part: str, count: str) -> Accepts:
    return re.compile(rf"\s*(?:(?:{part})(?:\s+|\Z)){{{count}}}", re.ASCII).fullmatch


def _bounded(matches: Accepts, bounds: Range) -> Accepts:
    holds = bounds.holds

    def accepts(text: str) -> bool:
        return bool(matches(text)) and all(holds(float(part)) for part in text.split())

    return accepts


_NEEDED = frozenset(
    """
    attenuation/range battery/voltage blend/fade_dist blend/min_height
    box/size capsule/length capsule/radius cone/length cone/radius cylinder/length cylinder/radius
    ellipsoid/radii image/height image/scale image/width polyline/height polyline/point sphere/radius
    intrinsics/cx intrinsics/cy intrinsics/fx intrinsics/fy
    axis/xyz axis2/xyz inertia/ixx inertia/iyy inertia/izz
    joint/child joint/parent
    lidar/range lidar/scan ray/range ray/scan range/max range/min scan/horizontal
    horizontal/max_angle horizontal/min_angle horizontal/samples
    logical_camera/aspect_ratio logical_camera/far logical_camera/horizontal_fov logical_camera/near
    population/model road/point sonar/max sonar/min sonar/radius spot/outer_angle
    spherical_coordinates/latitude_deg spherical_coordinates/longitude_deg
    texture/size trajectory/waypoint vertical/max_angle vertical/min_angle vertical/samples
    waypoint/pose waypoint/time
    """.split()
)
"""Required children that make another robot when they are left out, or nothing sensible at all.

libsdformat fills in every required child but the ends of a joint, and says nothing. For
most (the atmosphere of a world, the step of a physics) the default is what an author who
leaves them out expects. Where that depends on something else, ``structure`` decides.
"""


def _is_needed(parent: Definition, child: Definition) -> bool:
    return child.default == NOT_GIVEN or f"{parent.name}/{child.name}" in _NEEDED


SDF = Format(Table("sdf"), "root", VERSIONS, _acceptance, _is_needed)


def schema(version: Version) -> Schema:
    """SDFormat in a version, built once a process."""
    return SDF.schema(version)
