from collections.abc import Iterator
from math import inf

from sdfcheck import IN_URDF_JOINT, Bad, Diagnostic, Good, Joint, Rule, Severity

SLOWEST = {"revolute": 0.2, "prismatic": 0.02}
"""rad/s and m/s: whatever its effort, a slower joint does not get anywhere."""
PART = 0.05
"""Of the velocity limit: a joint that damping lets reach less of it was not to be damped so."""
LIMIT = '<limit lower="-1" upper="1" effort="100" velocity="{}"/>'


class BrakedJoint(Rule):
    """The damping of a joint is more than its effort overcomes.

    Damping grows with the speed: effort divided by damping is the fastest that the joint can go, here a small part of
    its velocity limit. Often such a number was tuned until a simulation kept still, or is that of the spring beside it.
    """

    code = "JNT033"
    name = "braked-joint"
    severity = Severity.WARNING
    remedy = """Write the damping of the joint's own bearings and gears, in N·m·s/rad, or in N·s/m of a slide.

    0.01 to 1 is usual for arms. An arm that shakes in a simulation has other reasons: moments of inertia that
    are too small, gains that are too large, or collisions that overlap.
    """
    looks_at = (Joint,)
    needs = ("dynamics",)
    scaffold = IN_URDF_JOINT

    bad = (
        Bad(
            LIMIT.format("12") + '<dynamics damping="«1000»"/>',
            says="an effort of 100 turns joint `j` with 0.1 rad/s at most against a damping of 1000",
        ),
    )
    good = (
        Good(LIMIT.format("12") + '<dynamics damping="10" friction="5"/>'),
        Good(LIMIT.format("0.3") + '<dynamics damping="1000"/>', why="it is a slow joint"),
    )

    @staticmethod
    def applies(joint: Joint) -> bool:
        return joint.type in SLOWEST and joint.axis.dynamics.is_given and is_braked(joint)

    def check(self, joint: Joint) -> Iterator[Diagnostic]:
        damping, effort = joint.axis.dynamics.damping, joint.axis.limit.effort
        moves, unit = ("turns", "rad/s") if joint.type == "revolute" else ("moves", "m/s")
        speed = f"{effort.number / damping.number:.2g} {unit} at most"
        message = f"an effort of {effort.text} {moves} {joint.title} with {speed} against a damping of {damping.text}"
        yield self.diagnostic(damping, message, labels={effort: "its effort"})


def is_braked(joint: Joint) -> bool:
    """Is the greatest speed against the damping next to nothing, and a small part of the velocity limit?"""
    limit, damping = joint.axis.limit, joint.axis.dynamics.damping.number
    slowest = min(SLOWEST[joint.type], PART * limit.velocity.number)
    return 0 < limit.effort.number < damping * slowest < inf
