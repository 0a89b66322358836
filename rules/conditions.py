"""The conditions of the rules, so that a clean file loads one module; written by ``make generate``."""

# The types are checked where the conditions are written.
# mypy: ignore-errors

from math import inf as math_inf
from math import pi as math_pi

def JNT004_applies(joint):
    return not joint.is_urdf and any((not axis.is_given and (not joint.misspells(name)) for axis, name in zip(joint.axes, ('axis', 'axis2'), strict=False)))

jnt_inverted_limits__BOUNDED = frozenset(('prismatic', 'revolute'))

def JNT005_applies(limit):
    lower, upper = (limit.lower, limit.upper)
    if not lower.number > upper.number or not (lower.is_given and upper.is_given):
        return False
    if limit.is_urdf and (not (limit.joint.type in jnt_inverted_limits__BOUNDED and math_inf > lower.number and (upper.number > -math_inf))):
        return False
    return limit.joint.element.name == 'joint' and limit.axis.limit is limit

jnt_directions__NO_LENGTH = 1e-06

def jnt_directions__has_no_length(axis):
    return axis.length <= 0 if axis.is_urdf else axis.length < jnt_directions__NO_LENGTH

jnt_directions__WITH_AXIS = frozenset(('continuous', 'planar', 'prismatic', 'revolute'))

def jnt_directions__is_used(axis):
    joint = axis.joint
    if axis is not joint.axis and axis is not joint.axis2:
        return False
    return not axis.is_urdf or joint.type in jnt_directions__WITH_AXIS

def JNT006_applies(axis):
    return jnt_directions__has_no_length(axis) and jnt_directions__is_used(axis)

jnt_negative_limit__NO_LIMIT = (-1.0, -math_inf)

def jnt_negative_limit___negative(part):
    is_limit = part.kind == 'limit'
    names = ('effort', 'velocity') if is_limit else ('damping', 'friction')
    numbers = [(name, getattr(part, name)) for name in names]
    found = [(name, number) for name, number in numbers if number.number < 0]
    if not found or (is_limit and part.is_urdf and (not part.joint.moves)):
        return []
    return [(name, number) for name, number in found if not is_limit or number.number not in jnt_negative_limit__NO_LIMIT]

def JNT010_applies(part):
    return bool(jnt_negative_limit___negative(part)) and part in (part.axis.limit, part.axis.dynamics)

jnt_useless_limit__ENDLESS_TYPES = frozenset(('continuous', 'floating', 'planar'))

jnt_useless_limit__ROUNDING = 0.001

jnt_useless_limit__UNLIMITED = 1000000000000000.0

def jnt_useless_limit___useless(limit):
    lower, upper = (limit.lower, limit.upper)
    if not (lower.is_given or upper.is_given) or limit.joint.type not in jnt_useless_limit__ENDLESS_TYPES:
        return []
    if limit.is_urdf:
        if lower.is_given and upper.is_given and (upper.number - lower.number > 2 * math_pi - jnt_useless_limit__ROUNDING):
            return []
        return [value for value in (lower, upper) if value.is_given and abs(value.number) > 0]
    if lower.number > upper.number:
        return []
    return [value for value in (lower, upper) if value.is_given and abs(value.number) < jnt_useless_limit__UNLIMITED]

def JNT011_applies(limit):
    return bool(jnt_useless_limit___useless(limit)) and limit.axis.limit is limit

jnt_non_unit_axis__ROUNDING = 0.001

def JNT013_applies(axis):
    return abs(axis.length - 1) > jnt_non_unit_axis__ROUNDING and (not jnt_directions__has_no_length(axis)) and jnt_directions__is_used(axis)

CONDITIONS = {
    'JNT004': JNT004_applies,
    'JNT005': JNT005_applies,
    'JNT006': JNT006_applies,
    'JNT010': JNT010_applies,
    'JNT011': JNT011_applies,
    'JNT013': JNT013_applies,
}
