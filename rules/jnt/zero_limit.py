from collections.abc import Iterator

from sdfcheck import IN_JOINT, IN_URDF_JOINT, Bad, Diagnostic, Good, Limit, Number, Rule, Severity


class ZeroLimit(Rule):
    """The effort or the velocity of a joint is limited to zero, so that nothing can drive it.

    Exporters write 0 where nobody has entered a number. Controllers and planners take it as the
    limit that it is; a joint that only swings freely is not affected. Where something drives the joint, powerless-joint
    says so.
    """

    code = "JNT016"
    name = "zero-limit"
    severity = Severity.INFO
    remedy = """Write the greatest effort and velocity of the drive, or leave the joint without controllers.

    Effort is in Nm (N for prismatic joints) at the joint, after the gear: motor torque × ratio ×
    efficiency. Velocity is in rad/s (m/s): the speed of the motor divided by the ratio, 1 rpm = 0.1047
    rad/s. Both are in the data sheet of the servo. Without one, take a generous guess such as 100 and 10,
    which lets controllers work.
    """
    preview = True
    looks_at = (Limit,)
    scaffold = IN_JOINT

    bad = (
        Bad(
            "<axis><xyz>0 0 1</xyz><limit><effort>«0»</effort></limit></axis>",
            says="effort of joint `j` is limited to 0",
        ),
        Bad(
            '<limit lower="-1" upper="1" effort="«0»" velocity="0"/>',
            scaffold=IN_URDF_JOINT,
            says="effort and velocity of joint `j` are limited to 0",
        ),
    )
    good = (
        Good("<axis><xyz>0 0 1</xyz><limit><effort>-1</effort></limit></axis>", why="no limit"),
        Good('<limit lower="0" upper="0" effort="0" velocity="0"/>', why="locked", scaffold=IN_URDF_JOINT),
    )

    @staticmethod
    def applies(limit: Limit) -> bool:
        if not zeros(limit) or not limit.joint.moves or is_locked(limit):
            return False
        return limit.axis.limit is limit and limit.joint.driver is None

    def check(self, limit: Limit) -> Iterator[Diagnostic]:
        found = zeros(limit)
        names, (first, *_) = " and ".join(found), found.values()
        verb = "are" if len(found) > 1 else "is"
        yield self.diagnostic(first, f"{names} of {limit.joint.title} {verb} limited to 0")


def is_locked(limit: Limit) -> bool:
    """Does it leave one position only?"""
    return limit.lower == limit.upper and limit.range[0] == limit.range[1]


def zeros(limit: Limit) -> dict[str, Number]:
    """The limits that are 0."""
    if limit.effort and limit.velocity:
        return {}
    limits = {"effort": limit.effort, "velocity": limit.velocity}
    return {name: number for name, number in limits.items() if number.is_given and number.number == 0}
