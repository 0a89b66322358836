from collections.abc import Iterator
from math import inf

from sdfcheck import IN_URDF_JOINT, Bad, Diagnostic, Good, Joint, Number, Rule, Severity

SLOWEST = {"revolute": 0.2, "prismatic": 0.02}
"""rad/s and m/s: whatever its effort, a slower joint does not get anywhere."""
PART = 0.05
"""Of the velocity limit: a joint that damping lets reach less of it was not to be damped so."""
LIMIT = '<limit lower="-1" upper="1" effort="100" velocity="{}"/>'


class BrakedJoint(Rule):
    """The friction or the damping of a joint is more than its effort overcomes.

    A friction (N·m, or N of a slide) above the effort holds the joint whatever moves it. Damping grows with the
    speed: effort divided by damping is the fastest that the joint can go. Here that is a small part of its velocity
    limit. Often such a number was tuned until a simulation kept still, or is that of the spring beside it.
    """

    code = "JNT033"
    name = "braked-joint"
    severity = Severity.WARNING
    remedy = """Write the friction and damping of the joint's own bearings and gears: small parts of the effort.

    Damping of 0.01 to 1 N·m·s/rad is usual for arms. An arm that shakes in a simulation has other reasons:
    moments of inertia that are too small, gains that are too large, or collisions that overlap.
    """
    looks_at = (Joint,)
    needs = ("dynamics",)
    scaffold = IN_URDF_JOINT

    bad = (
        Bad(
            LIMIT.format("12") + '<dynamics damping="«1000»"/>',
            says="an effort of 100 turns joint `j` with 0.1 rad/s at most against a damping of 1000",
        ),
        Bad(
            LIMIT.format("2") + '<dynamics damping="0" friction="«120»"/>',
            says="an effort of 100 does not overcome the friction of 120 in joint `j`",
        ),
    )
    good = (
        Good(LIMIT.format("12") + '<dynamics damping="10" friction="5"/>'),
        Good(LIMIT.format("0.3") + '<dynamics damping="1000"/>', why="it is a slow joint"),
    )

    @staticmethod
    def applies(joint: Joint) -> bool:
        return joint.type in SLOWEST and brake(joint) is not None

    def check(self, joint: Joint) -> Iterator[Diagnostic]:
        value, effort = brake(joint), joint.axis.limit.effort
        assert value is not None, "it was compared"
        if value is joint.axis.dynamics.friction:
            message = (
                f"an effort of {effort.text} does not overcome the friction of {value.text} in {joint.title}"
            )
        else:
            moves, unit = ("turns", "rad/s") if joint.type == "revolute" else ("moves", "m/s")
            speed = effort.number / value.number
            message = f"an effort of {effort.text} {moves} {joint.title} with {speed:.2g} {unit} at most"
            message += f" against a damping of {value.text}"
        yield self.diagnostic(value, message, labels={effort: "its effort"})


def brake(joint: Joint) -> Number | None:
    """The friction or damping that keeps a joint from moving."""
    dynamics, limit = joint.axis.dynamics, joint.axis.limit
    effort, velocity = limit.effort.number, limit.velocity.number
    if not dynamics.is_given or not 0 < effort < inf:
        return None
    if effort < dynamics.friction.number < inf:
        return dynamics.friction
    damping = dynamics.damping.number
    if 0 < damping < inf and effort < damping * min(SLOWEST[joint.type], PART * velocity):
        return dynamics.damping
    return None
