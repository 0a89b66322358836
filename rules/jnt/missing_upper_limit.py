from collections.abc import Iterator

from sdfcheck import IN_JOINT, IN_URDF_JOINT, Bad, Diagnostic, Good, Limit, Rule, Severity

BOUNDED = frozenset({"revolute", "prismatic"})


class MissingUpperLimit(Rule):
    """A joint has a lower limit and no upper one.

    In SDFormat it then has no end on that side. In URDF urdfdom, and Gazebo with it, takes 0, Drake and
    MuJoCo take no limit: the robots differ.
    """

    code = "JNT015"
    name = "missing-upper-limit"
    severity = Severity.WARNING
    remedy = """Write the upper limit as well, or leave the lower one out.

    Radians for joints that turn, meters for those that slide. A joint that has no end on that side is rare:
    a continuous one has no limits at all.
    """
    looks_at = (Limit,)
    scaffold = IN_JOINT

    bad = (
        Bad(
            "<axis><xyz>0 0 1</xyz><«limit»><lower>-1</lower></limit></axis>",
            says="joint `j` has the lower limit -1 and no upper one",
        ),
        Bad('<«limit» lower="-1" effort="5" velocity="2"/>', scaffold=IN_URDF_JOINT, says="so 0 is taken"),
    )
    good = (
        Good('<limit upper="1" effort="5" velocity="2"/>', why="from 0", scaffold=IN_URDF_JOINT),
        Good("<axis><xyz>0 0 1</xyz><limit><effort>5</effort></limit></axis>", why="no limit at all"),
        Good("<axis><xyz>0 0 1</xyz><limit><lower>-1e16</lower></limit></axis>", why="no limit at all"),
    )

    @staticmethod
    def applies(limit: Limit) -> bool:
        if not limit.lower.is_given or limit.upper.is_given or limit.has("upper"):
            return False
        return is_missed(limit)

    def check(self, limit: Limit) -> Iterator[Diagnostic]:
        message = f"{limit.joint.title} has the lower limit {limit.lower.text} and no upper one"
        if limit.is_urdf:
            message += ", so 0 is taken"
        yield self.diagnostic(limit, message, labels={limit.lower: "the lower limit"})


def is_missed(limit: Limit) -> bool:
    is_endless = limit.range[0] == -float("inf")
    is_bounded = not limit.is_urdf or limit.joint.type in BOUNDED
    return is_bounded and not is_endless and limit.lacks("upper") and limit.axis.limit is limit
