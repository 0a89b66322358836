from collections.abc import Iterator
from math import pi

from sdfcheck import IN_MODEL, IN_ROBOT, Bad, Diagnostic, Good, Limit, Number, Rule, Severity

_ENDS = "<parent>base</parent><child>arm</child>"
_URDF_ENDS = '<parent link="base"/><child link="arm"/>'

ENDLESS_TYPES = frozenset(("continuous", "floating", "planar"))
ROUNDING = 1e-3
"""A whole turn may be this much smaller than 2π."""
UNLIMITED = 1e15
"""SDFormat writes 1e16 where there is no limit."""


class UselessLimit(Rule):
    """A joint has position limits that its type does not know.

    A continuous joint turns without end; only Drake limits it in URDF anyway.
    """

    code = "JNT011"
    name = "useless-limit"
    severity = Severity.WARNING
    remedy = """Make the joint revolute, or leave its `lower` and `upper` out.

    A revolute joint takes both in radians. A wheel or a propeller of URDF turns without end: keep it continuous with
    `effort` and `velocity` only. In SDFormat, a revolute joint without limits does.
    """
    looks_at = (Limit,)
    scaffold = IN_MODEL

    bad = (
        Bad(
            f'<link name="arm"/><joint name="j" type="continuous">{_ENDS}<axis><xyz>0 0 1</xyz>'
            "<limit><lower>«-1»</lower><upper>1</upper></limit></axis></joint>",
            says="joint `j` of type continuous has no use for the limit -1",
            also=("GAZ039",),
        ),
        Bad(
            f'<link name="arm"/><joint name="j" type="continuous">{_URDF_ENDS}<axis xyz="0 0 1"/>'
            '<limit lower="«-1»" upper="1" effort="5" velocity="2"/></joint>',
            scaffold=IN_ROBOT,
            says="joint `j` of type continuous has no use for the limit -1",
        ),
    )
    good = (
        Good(
            f'<link name="arm"/><joint name="j" type="continuous">{_ENDS}<axis><xyz>0 0 1</xyz>'
            "<limit><lower>-1e16</lower><upper>1e16</upper><effort>5</effort></limit></axis></joint>",
            why="as good as no limit, and the effort counts",
        ),
    )

    @staticmethod
    def applies(limit: Limit) -> bool:
        return bool(_useless(limit)) and limit.axis.limit is limit

    def check(self, limit: Limit) -> Iterator[Diagnostic]:
        first, *others = _useless(limit)
        joint = limit.joint
        message = f"{joint.title} of type {joint.type} has no use for the limit {first.text}"
        labels = {other.span: "nor for this one" for other in others}
        yield self.diagnostic(first, message, labels=labels)


def _useless(limit: Limit) -> list[Number]:
    """The position limits that exclude positions which the joint can have."""
    if limit.joint.type not in ENDLESS_TYPES:
        return []
    lower, upper = limit.lower, limit.upper
    if limit.is_urdf:
        # A bound that is not written is 0 there, and whole turns exclude nothing.
        if lower.is_given and upper.is_given and upper.number - lower.number > 2 * pi - ROUNDING:
            return []
        return [value for value in (lower, upper) if value.is_given and abs(value.number) > 0]
    if lower.number > upper.number:
        return []  # the business of inverted-limits
    return [value for value in (lower, upper) if value.is_given and abs(value.number) < UNLIMITED]
