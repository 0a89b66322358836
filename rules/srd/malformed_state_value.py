from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Semantics, Severity
from sdfcheck_rules.srd.scaffold import FILE, IN_SRDF, ROBOT


class MalformedStateValue(Rule):
    """The value of a joint in a state is not the numbers that the joint needs.

    srdfdom reads the numbers at the beginning of each word and says nothing: `pi/2` becomes 0, and `1,57`
    becomes two values. MoveIt leaves a joint with another count out of the state.
    """

    code = "SRD005"
    name = "malformed-state-value"
    severity = Severity.ERROR
    remedy = """Write one number for each degree of freedom, with a decimal point and in radians or meters.

    π/2 is `1.5707963`. A planar joint has three numbers (x, y, yaw), a floating one seven. In an SRDF made
    by xacro, `${pi/2}` works.
    """
    looks_at = (Semantics,)
    scaffold = IN_SRDF

    bad = (
        Bad(
            '<group_state name="home" group="all"><joint name="shoulder" value="«pi/2»"/></group_state>',
            file=FILE,
            says="`value` of joint `shoulder` should be a number, not `pi/2`",
        ),
        Bad(
            '<group_state name="home" group="all"><joint name="shoulder" value="«0 1»"/></group_state>',
            file=FILE,
            files=ROBOT,
            says="should be 1 number, not `0 1`",
        ),
    )
    good = (
        Good(
            '<group_state name="home" group="all"><joint name="shoulder" value="0.5"/></group_state>',
            file=FILE,
        ),
    )

    @staticmethod
    def applies(semantics: Semantics) -> bool:
        return any(semantics.miscounted(each) is not None for each in semantics.state_values)

    def check(self, semantics: Semantics) -> Iterator[Diagnostic]:
        for each in semantics.state_values:
            wanted = semantics.miscounted(each)
            if wanted is not None:
                message = f"`value` of {each.joint.title} should be {wanted}, not `{each.value.text}`"
                yield self.diagnostic(each.value, message)
