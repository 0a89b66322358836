from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Limit, Rule, Severity, Transmission, Value
from sdfcheck_rules.drk.scaffolds import ROBOT, ROBOT_JOINT

NO_LIMIT = -1.0
"""The velocity limit of SDFormat that means none."""
STOPPED_BY_ZERO = frozenset(("continuous", "prismatic", "revolute"))

JOINT = '<joint name="j" type="{}"><parent link="a"/><child link="b"/>{}</joint>'


class SpecialValue(Rule):
    """A value means something else to Drake than the format says.

    A `mechanicalReduction` other than 1 is ignored, with a warning. The limits of a
    continuous joint, which other consumers ignore, hold in Drake. A velocity limit of 0 keeps the
    joint from moving.
    """

    code = "DRK013"
    name = "special-value"
    severity = Severity.WARNING
    remedy = """Write it as Drake reads it, or leave it for the other consumers.

    A reduction is `drake:gear_ratio`, beside `drake:rotor_inertia` (kg·m²) in the `actuator`. Remove
    `lower` and `upper` of a continuous joint, and write the real velocity of the drive instead of 0.
    """
    default = False
    looks_at = (Limit, Transmission)
    selects = ("sdf:joint/axis/limit", "urdf:robot/joint/limit", "urdf:robot/transmission")
    scaffold = ROBOT_JOINT

    bad = (
        Bad(
            '<transmission><type>SimpleTransmission</type><joint name="j"/><actuator name="m">'
            "<mechanicalReduction>«50»</mechanicalReduction></actuator></transmission>",
            says="to Drake `mechanicalReduction` 50 means nothing",
            scaffold=ROBOT,
        ),
        Bad(
            JOINT.format("continuous", '<limit lower="«-1»" upper="1" effort="1" velocity="1"/>'),
            says="to Drake `lower` -1 means a limit, also for a continuous joint",
            also=("JNT011",),
        ),
        Bad(
            JOINT.format("revolute", '<limit lower="-1" upper="1" effort="1" velocity="«0»"/>'),
            says="to Drake `velocity` 0 means a joint that must not move",
        ),
    )
    good = (
        Good(
            '<transmission><type>SimpleTransmission</type><joint name="j"/><actuator name="m">'
            "<mechanicalReduction>1</mechanicalReduction></actuator></transmission>",
            scaffold=ROBOT,
        ),
        Good(JOINT.format("continuous", '<limit effort="1" velocity="1"/>')),
    )

    def check(self, part: Limit | Transmission) -> Iterator[Diagnostic]:
        for value, meaning, advice in _special(part):
            name = value.attribute or value.element.name
            yield self.diagnostic(
                value, f"to Drake `{name}` {value.text.strip()} means {meaning}", help=advice
            )


def _special(part: Limit | Transmission) -> Iterator[tuple[Value, str, str]]:
    """The values that mean something else to Drake, what, and what to write."""
    if isinstance(part, Transmission):
        advice = "write a `drake:gear_ratio` as well"
        yield from ((value, "nothing", advice) for value in part.reductions if value.number != 1)
        return
    velocity, kind = part.velocity, part.joint.type
    if not part.is_urdf:
        if velocity.value is not None and velocity.number < 0 and velocity.number != NO_LIMIT:
            yield velocity.value, "no limit", "write `-1` for no limit, or the velocity of the drive"
        return
    bound = part.lower.value or part.upper.value
    if kind == "continuous" and bound is not None:
        yield bound, "a limit, also for a continuous joint", "remove the limits, or make the joint revolute"
    if kind in STOPPED_BY_ZERO and velocity.value is not None and velocity.number == 0:
        yield velocity.value, "a joint that must not move", "write the velocity of the drive"
