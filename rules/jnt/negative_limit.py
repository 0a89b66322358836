from collections.abc import Iterator
from math import inf

from sdfcheck import (
    IN_JOINT,
    IN_URDF_JOINT,
    REFUSES,
    Bad,
    Consumer,
    Diagnostic,
    Dynamics,
    Good,
    Limit,
    Number,
    Rule,
    Severity,
    accepts,
    refuses,
    warns,
)

NO_LIMIT = (-1.0, -inf)
"""The customary ways to write an effort or a velocity without limit."""


class NegativeLimit(Rule):
    """An effort, velocity, damping or friction of a joint is negative.

    In SDFormat any negative effort or velocity is read as no limit, which is written `-1`.
    Everywhere else a negative number makes no sense: negative damping feeds the
    motion, and Drake refuses it. In URDF Drake aborts at a negative velocity, and Pinocchio refuses a negative
    effort or velocity; `-1` is for information there.
    """

    code = "JNT010"
    name = "negative-limit"
    severity = Severity.WARNING
    remedy = """Write a positive number, or leave the setting out.

    Effort is in N or Nm, velocity in m/s or rad/s, damping in N·s/m or Nm·s/rad, friction in N or Nm. The
    limits are magnitudes that hold in both directions. In SDFormat no limit is `-1`, or no element at all;
    in URDF both are required, and a large number has to do.
    """
    looks_at = (Limit, Dynamics)
    scaffold = IN_JOINT

    bad = (
        Bad(
            "<axis><xyz>0 0 1</xyz><dynamics><damping>«-0.1»</damping></dynamics></axis>",
            says="damping -0.1 of joint `j` is negative",
        ),
        Bad(
            "<axis><xyz>0 0 1</xyz><limit><effort>«-30»</effort></limit></axis>",
            says="effort -30 of joint `j` is negative",
        ),
        Bad(
            '<limit lower="-1" upper="1" effort="5" velocity="«-2»"/>',
            scaffold=IN_URDF_JOINT,
            says="velocity -2 of joint `j` is negative",
        ),
        Bad(
            '<limit lower="-1" upper="1" effort="«-1»" velocity="2"/>',
            scaffold=IN_URDF_JOINT,
            says="effort -1 of joint `j` is negative",
        ),
    )
    good = (
        Good(
            "<axis><xyz>0 0 1</xyz><limit><effort>-1</effort><velocity>-1</velocity></limit></axis>",
            why="the format's way to say no limit",
        ),
        Good("<axis><xyz>0 0 1</xyz><limit><lower>-2</lower><upper>-1</upper></limit></axis>"),
        Good('<limit lower="-1" upper="1" effort="5" velocity="2"/>', scaffold=IN_URDF_JOINT),
    )

    @staticmethod
    def applies(part: Limit | Dynamics) -> bool:
        if not _negative(part):
            return False
        return part is part.axis.limit or part is part.axis.dynamics

    def check(self, part: Limit | Dynamics) -> Iterator[Diagnostic]:
        for quantity, number in _negative(part):
            affects = {}
            if quantity in {"effort", "velocity"} and part.is_urdf:
                affects = {Consumer.PINOCCHIO: REFUSES}
            elif quantity == "damping" and part.is_urdf:
                affects = {Consumer.PINOCCHIO: warns("takes it as it is")}
            is_meant = number.number in NO_LIMIT and part.kind == "limit"
            if is_meant:  # what Drake does with it is its own rules' matter
                affects = dict.fromkeys(Consumer, accepts("takes it as no limit")) | affects
            elif quantity == "velocity" and part.is_urdf:
                affects[Consumer.DRAKE] = refuses("aborts")
            elif quantity != "damping":
                affects[Consumer.DRAKE] = warns("takes it as no limit")
            message = f"{quantity} {number.text} of {part.joint.title} is negative"
            severity = Severity.INFO if is_meant else None
            yield self.diagnostic(number, message, affects=affects, severity=severity)


def _negative(part: Limit | Dynamics) -> list[tuple[str, Number]]:
    """The numbers below 0, with what they are the number of; in SDFormat some say that there is no limit."""
    is_limit = part.kind == "limit"
    names = ("effort", "velocity") if is_limit else ("damping", "friction")
    numbers: list[Number] = [getattr(part, name) for name in names]
    if min(numbers) >= 0 or (is_limit and part.is_urdf and not part.joint.moves):
        return []
    exempt = NO_LIMIT if is_limit and not part.is_urdf else ()
    below = zip(names, numbers, strict=True)
    return [(name, number) for name, number in below if number.number < 0 and number.number not in exempt]
