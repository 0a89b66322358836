from collections.abc import Iterator
from math import inf

from sdfcheck import Bad, Diagnostic, Good, Limit, Mimic, Rule, Severity

SHARE = 0.05
"""Of the range of the leader: less is rounding."""
ROBOT = (
    '<robot name="r"><link name="a"/><link name="b"/><link name="c"/><joint name="j" type="revolute">'
    '<parent link="a"/><child link="b"/><axis xyz="0 0 1"/><limit lower="0" upper="0.8" effort="1" velocity="1"/>'
    '</joint><joint name="k" type="revolute"><parent link="a"/><child link="c"/><axis xyz="0 0 1"/>'
    '<limit lower="{0}" upper="{1}" effort="1" velocity="1"/><mimic joint="j" multiplier="{2}"/></joint></robot>'
)


class MimicBeyondLimits(Rule):
    """A joint cannot follow its leader through its whole range.

    Position and limits of both are written, and do not fit: the follower stops while the leader goes on. A
    multiplier of -1 needs limits with the opposite signs: where the follower has none of the positions that its leader
    sends it to, but for one end, that is a warning. Where it has a part of them, the rest is for information.
    """

    code = "JNT022"
    name = "mimic-beyond-limits"
    severity = Severity.WARNING
    remedy = """Widen the limits of the follower to what its leader makes it do.

    They are multiplier × limit + offset for both limits of the leader, the smaller one first. If the real
    follower has the narrower range, narrow the limits of the leader instead. With a negative multiplier
    lower and upper change places.
    """
    looks_at = (Mimic,)
    selects = ("urdf:joint/mimic",)

    bad = (
        Bad(
            ROBOT.format("0", "0.8", "-1").replace('joint="j"', 'joint="«j»"'),
            says="joint `k` follows `j` from -0.8 to 0, and has limits of 0 and 0.8",
        ),
        Bad(
            ROBOT.format("0", "0.5", "1").replace('joint="j"', 'joint="«j»"'),
            says="joint `k` follows `j` from 0 to 0.8, and has limits of 0 and 0.5",
        ),
    )
    good = (
        Good(ROBOT.format("-0.8", "0", "-1")),
        Good(ROBOT.format("0", "0.81", "1")),
        Good(ROBOT.format("0", "3.14", "1"), why="wider limits do no harm"),
    )

    @staticmethod
    def applies(mimic: Mimic) -> bool:
        return span(mimic) is not None

    def check(self, mimic: Mimic) -> Iterator[Diagnostic]:
        found, leader = span(mimic), mimic.leader_value
        if found is None or leader is None:
            return
        low, high = found
        limit: Limit = mimic.axis.limit
        shared = min(high, limit.upper) - max(low, limit.lower)
        yield self.diagnostic(
            leader,
            f"{mimic.joint.title} follows `{leader.text.strip()}` from {low:.4g} to {high:.4g}, and has limits of"
            f" {float(limit.lower):.4g} and {float(limit.upper):.4g}",
            labels={limit: "its limits"},
            severity=Severity.INFO if shared > SHARE * min(high - low, limit.upper - limit.lower) else None,
        )


def span(mimic: Mimic) -> tuple[float, float] | None:
    """The positions that a follower is sent to, where some of them are beyond its limits."""
    leader, joint = mimic.leader, mimic.joint
    if leader is None or joint.is_fixed or leader.is_fixed or leader.axis.mimic is not None:
        return None
    low, high = leader.axis.limit.range
    own_low, own_high = joint.axis.limit.range
    if not -inf < low < high < inf or not own_low < own_high:
        return None
    ends = sorted(mimic.multiplier.number * end + mimic.offset.number for end in (low, high))
    room = SHARE * (ends[1] - ends[0])
    return (ends[0], ends[1]) if ends[0] < own_low - room or ends[1] > own_high + room else None
