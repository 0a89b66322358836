from collections.abc import Iterator
from math import radians, remainder, tau

from sdfcheck import IN_JOINT, IN_URDF_JOINT, Bad, Diagnostic, Good, Limit, Rule, Severity, TextEdit, make_fix

ROUND = 30.0
"""Whole numbers from here on are usual limits in degrees; others are so from ``LEAST`` on."""
LITTLE = 3.0
"""A limit of less is in radians."""
LEAST, MOST = 20.0, 720.0
"""Numbers from here to there are usual limits in degrees. More is a way to write no limit."""
UNLIMITED = 100.0
"""Both ways this is another one, as 1000 is."""
FAST, ROUNDED = 90.0, 50
"""Whole numbers from the first on are usual speeds in degrees a second; multiples of the second mean no limit."""
COARSEST = 0.1
"""rad: one digit after the point is enough to tell turns from other angles."""


class LimitsInDegrees(Rule):
    """The limits of a joint that turns are as one would write them in degrees.

    Both formats measure angles in radians: a joint from -90 to 90 turns fourteen times each way. Of 9,598
    pairs of limits in public robots none that was meant in radians had two whole numbers and one of 30 or more;
    of 3,520 joints in others none had a limit between 13 and 720 that was meant so. Nor has one of the joints between
    limits of 2,172 robots a velocity of a whole number from 90 to 720, but for 100, which means no limit.
    """

    code = "JNT014"
    name = "limits-in-degrees"
    severity = Severity.WARNING
    remedy = """Write the limits in radians: degrees × π / 180.

    ±90° is ±1.5707963, ±180° is ±3.1415927. In xacro `${radians(90)}` keeps the number of the data sheet in
    sight. SDFormat has a unit for the angles of poses only, not for limits. `velocity` of the same joint is
    in rad/s, too: 1 rpm is 0.1047 rad/s.
    """
    looks_at = (Limit,)
    scaffold = IN_JOINT

    bad = (
        Bad(
            "<axis><xyz>0 0 1</xyz><limit><lower>«-90»</lower><upper>90</upper></limit></axis>",
            fixed="<axis><xyz>0 0 1</xyz><limit><lower>-1.5707963</lower><upper>1.5707963</upper></limit></axis>",
            unsafe=True,
            says="limits -90 and 90 of joint `j` are read as radians, and look like degrees",
        ),
        Bad(
            '<limit lower="«0»" upper="180" effort="5" velocity="2"/>',
            fixed='<limit lower="0" upper="3.1415927" effort="5" velocity="2"/>',
            unsafe=True,
            scaffold=IN_URDF_JOINT,
        ),
        Bad(
            '<limit lower="«-166.003»" upper="166.003" effort="5" velocity="2"/>',
            fixed='<limit lower="-2.8972989" upper="2.8972989" effort="5" velocity="2"/>',
            unsafe=True,
            scaffold=IN_URDF_JOINT,
        ),
        Bad(
            '<limit lower="-2.96" upper="2.96" effort="200" velocity="«98»"/>',
            fixed='<limit lower="-2.96" upper="2.96" effort="200" velocity="1.7104227"/>',
            unsafe=True,
            scaffold=IN_URDF_JOINT,
            says="velocity 98 of joint `j` is read as rad/s, and looks like degrees per second",
        ),
    )
    good = (
        Good(
            "<axis><xyz>0 0 1</xyz><limit><lower>-9.42</lower><upper>9.42</upper></limit></axis>",
            why="three turns",
        ),
        Good(
            "<axis><xyz>0 0 1</xyz><limit><lower>-62.8319</lower><upper>62.8319</upper></limit></axis>",
            why="twenty turns",
        ),
        Good(
            "<axis><xyz>0 0 1</xyz><limit><lower>-31.4</lower><upper>31.4</upper></limit></axis>",
            why="ten turns, rounded",
        ),
        Good("<axis><xyz>0 0 1</xyz><limit><lower>-1.5</lower><upper>45</upper></limit></axis>"),
        Good(
            "<axis><xyz>0 0 1</xyz><limit><lower>-1000</lower><upper>1000</upper></limit></axis>",
            why="written for no limit",
        ),
        Good(
            '<limit lower="-100" upper="100" effort="1000" velocity="100"/>',
            scaffold=IN_URDF_JOINT,
            why="written for no limit, as 1000 is",
        ),
        Good(
            '<limit lower="-2.96" upper="2.96" effort="200" velocity="100"/>',
            scaffold=IN_URDF_JOINT,
            why="written for no limit",
        ),
        Good(
            '<joint name="k" type="prismatic"><parent link="base"/><child link="arm"/>'
            '<limit lower="0" upper="60" effort="5" velocity="2"/></joint>',
            scaffold='<robot name="r"><link name="base"/><link name="arm"/>{}</robot>',
            why="m, not rad",
        ),
    )

    @staticmethod
    def applies(limit: Limit) -> bool:
        return is_turned_by_degrees(limit) or is_fast_by_degrees(limit)

    def check(self, limit: Limit) -> Iterator[Diagnostic]:
        lower, upper, velocity, title = limit.lower, limit.upper, limit.velocity, limit.joint.title
        if is_turned_by_degrees(limit):
            edits = tuple(TextEdit(end.span, f"{radians(end):.8g}") for end in (lower, upper))
            yield self.diagnostic(
                lower,
                f"limits {lower.text} and {upper.text} of {title} are read as radians, and look like degrees",
                labels={upper: "the upper limit"},
                fix=make_fix("convert them from degrees", edits, unsafe=True),
            )
        else:
            edit = TextEdit(velocity.span, f"{radians(velocity):.8g}")
            yield self.diagnostic(
                velocity,
                f"velocity {velocity.text} of {title} is read as rad/s, and looks like degrees per second",
                fix=make_fix("convert it from degrees", (edit,), unsafe=True),
            )


def is_turned_by_degrees(limit: Limit) -> bool:
    """Are the positions as one would write them in degrees?"""
    lower, upper = limit.lower, limit.upper
    if not (lower.is_given and upper.is_given and LEAST <= max(-lower, upper) <= MOST):
        return False
    if limit.joint.type not in TURNING or -lower > MOST or limit.axis.limit is not limit:
        return False
    if lower.number % 1 == 0 == upper.number % 1:
        return max(-lower, upper) >= ROUND and not -lower == upper == UNLIMITED
    ends = lower.number, upper.number
    return all(not 0 < abs(end) < LITTLE for end in ends) and not all(map(is_whole_turns, ends))


def is_fast_by_degrees(limit: Limit) -> bool:
    """Is the velocity so, of a joint that turns between limits?"""
    velocity = limit.velocity
    if not velocity.is_given or not FAST <= velocity.number <= MOST or limit.axis.limit is not limit:
        return False
    low, high = limit.range
    is_bounded = limit.joint.type in TURNING and high - low < LEAST
    return is_bounded and velocity.number % 1 == 0 and velocity.number % ROUNDED != 0


def is_whole_turns(angle: float) -> bool:
    """Is an angle in radians a number of whole turns, to the digits that are written, as few others are?"""
    last_digit = 10.0 ** -len(f"{angle}".partition(".")[2])
    return abs(remainder(angle, tau)) < max(1e-5 * abs(angle), last_digit if last_digit <= COARSEST else 0.0)


TURNING = frozenset({"revolute", "revolute2", "universal"})
