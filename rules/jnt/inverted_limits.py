from collections.abc import Iterator
from math import inf

from sdfcheck import IN_JOINT, IN_URDF_JOINT, Bad, Diagnostic, Good, Limit, Rule, Severity, TextEdit, make_fix

BOUNDED = frozenset(("prismatic", "revolute"))
"""The types of joint for which URDF has limits."""


class InvertedLimits(Rule):
    """A joint whose lower limit is above its upper limit has no position to be in.

    Drake refuses the file. libsdformat says nothing about SDFormat, and exchanges the two in URDF.
    urdfdom never compares them, so the mistake surfaces when something tries to move the joint.
    """

    code = "JNT005"
    name = "inverted-limits"
    severity = Severity.ERROR
    remedy = """Exchange the two limits, or correct the sign that was lost.

    Lower is the smaller number. When an axis is turned around, both limits change their signs and their
    places: -0.5 to 2 becomes -2 to 0.5.
    """
    looks_at = (Limit,)
    scaffold = IN_JOINT

    bad = (
        Bad(
            "<axis><xyz>0 0 1</xyz><limit><lower>«1.57»</lower><upper>-1.57</upper></limit></axis>",
            fixed="<axis><xyz>0 0 1</xyz><limit><lower>-1.57</lower><upper>1.57</upper></limit></axis>",
            unsafe=True,
            says="lower limit 1.57 is above upper limit -1.57",
        ),
        Bad(
            '<limit lower="«1.57»" upper="-1.57" effort="5" velocity="2"/>',
            fixed='<limit lower="-1.57" upper="1.57" effort="5" velocity="2"/>',
            unsafe=True,
            scaffold=IN_URDF_JOINT,
            says="lower limit 1.57 is above upper limit -1.57",
        ),
    )
    good = (
        Good(
            "<axis><xyz>0 0 1</xyz><limit><lower>0</lower><upper>0</upper></limit></axis>",
            why="locked on purpose",
        ),
        Good('<limit lower="-1" upper="1" effort="5" velocity="2"/>', scaffold=IN_URDF_JOINT),
    )

    @staticmethod
    def applies(limit: Limit) -> bool:
        lower, upper = limit.lower, limit.upper
        if not lower > upper or not lower.number > upper.number or not (lower.is_given and upper.is_given):
            return False
        if limit.is_urdf and not (limit.joint.type in BOUNDED and inf > lower.number and upper.number > -inf):
            return False
        return limit.axis.limit is limit

    def check(self, limit: Limit) -> Iterator[Diagnostic]:
        lower, upper = limit.lower, limit.upper
        fix = make_fix(
            "exchange them", (TextEdit(lower.span, upper.text), TextEdit(upper.span, lower.text)), unsafe=True
        )
        message = f"lower limit {lower.text} is above upper limit {upper.text}"
        yield self.diagnostic(lower, message, labels={upper: "the upper limit"}, fix=fix)
