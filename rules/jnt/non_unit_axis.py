from collections.abc import Iterator

from sdfcheck import IN_JOINT, IN_URDF_JOINT, Axis, Bad, Diagnostic, Good, Rule, Severity, replace
from sdfcheck_rules.jnt.directions import has_no_length, is_used

ROUNDING = 1e-3
"""How far from 1 the length may be where the numbers are rounded."""


class NonUnitAxis(Rule):
    """The axis of a joint does not have the length 1.

    Consumers keep the direction and make the length 1, so the robot is as it would be. A
    program that uses the numbers as written computes motions that are too long or too short.
    """

    code = "JNT013"
    name = "non-unit-axis"
    severity = Severity.INFO
    remedy = """Divide the three numbers by the length of the axis, √(x² + y² + z²).

    A diagonal is `0.7071068 0.7071068 0`, not `1 1 0`. The length has no meaning; a ratio or a sign belongs
    into the transmission or the `multiplier` of a mimic.
    """
    looks_at = (Axis,)
    scaffold = IN_JOINT

    bad = (
        Bad(
            "<axis><xyz>«0 3 4»</xyz></axis>",
            fixed="<axis><xyz>0 0.6 0.8</xyz></axis>",
            says="the axis of joint `j` has the length 5",
        ),
        Bad(
            '<axis xyz="«0 0 -2»"/><limit lower="-1" upper="1" effort="5" velocity="2"/>',
            fixed='<axis xyz="0 0 -1"/><limit lower="-1" upper="1" effort="5" velocity="2"/>',
            scaffold=IN_URDF_JOINT,
            says="has the length 2",
        ),
    )
    good = (Good("<axis><xyz>0.577 0.577 0.577</xyz></axis>", why="rounded"),)

    @staticmethod
    def applies(axis: Axis) -> bool:
        return abs(axis.length - 1) > ROUNDING and not has_no_length(axis) and is_used(axis)

    def check(self, axis: Axis) -> Iterator[Diagnostic]:
        length = axis.length
        # Adding zero takes the sign from a negative one.
        unit = " ".join(f"{number / length + 0.0:.12g}" for number in axis.xyz)
        message = f"the axis of {axis.joint.title} has the length {length:.3g}, not 1"
        yield self.diagnostic(axis.xyz, message, fix=replace(axis.xyz, unit, "make its length 1"))
