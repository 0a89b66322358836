from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Semantics, Severity
from sdfcheck_rules.srd.scaffold import FILE, IN_SRDF, ROBOT


class StateOutsideLimits(Rule):
    """The value of a joint in a state is outside of its limits.

    MoveIt reads it in silence, and planning to the state fails.
    """

    code = "SRD006"
    name = "state-outside-limits"
    severity = Severity.WARNING
    remedy = """Write a value between the limits of the joint, or correct the limits in the URDF.

    Leave a margin of about 0.01 to the stop: planning refuses a state that lies a rounding error outside.
    """
    looks_at = (Semantics,)
    scaffold = IN_SRDF

    bad = (
        Bad(
            '<group_state name="home" group="all"><joint name="shoulder" value="«1.5»"/></group_state>',
            file=FILE,
            files=ROBOT,
            says="joint `shoulder` is at 1.5 in state `home`, outside of its limits -1 and 1",
        ),
    )
    good = (
        Good(
            '<group_state name="home" group="all"><joint name="shoulder" value="1"/></group_state>',
            file=FILE,
            files=ROBOT,
        ),
    )

    @staticmethod
    def applies(semantics: Semantics) -> bool:
        return any(semantics.outside(each) is not None for each in semantics.state_values)

    def check(self, semantics: Semantics) -> Iterator[Diagnostic]:
        for each in semantics.state_values:
            joint = semantics.outside(each)
            if joint is not None:
                low, high = (bound.text or "0" for bound in (joint.axis.limit.lower, joint.axis.limit.upper))
                state = each.state.attributes.get("name", "")
                message = f"{joint.title} is at {each.value.text} in state `{state}`"
                message += f", outside of its limits {low} and {high}"
                yield self.diagnostic(each.value, message, labels={joint.axis.limit: "its limits"})
