"""The conditions of the rules, so that a clean file loads one module; written by ``make generate``."""

# The types are checked where the conditions are written.
# mypy: ignore-errors

from math import inf as math_inf

jnt_inverted_limits__BOUNDED = frozenset(('prismatic', 'revolute'))

def JNT005_applies(limit):
    lower, upper = (limit.lower, limit.upper)
    if not lower.number > upper.number or not (lower.is_given and upper.is_given):
        return False
    if limit.is_urdf and (not (limit.joint.type in jnt_inverted_limits__BOUNDED and math_inf > lower.number and (upper.number > -math_inf))):
        return False
    return limit.joint.element.name == 'joint' and limit.axis.limit is limit

CONDITIONS = {
    'JNT005': JNT005_applies,
}
