from collections.abc import Iterator

from sdfcheck import Bad, ControlComponent, Diagnostic, Good, Rule, Severity
from sdfcheck_rules.r2c.scaffold import IN_BLOCK, SINCE_JAZZY


class MimicWithoutLeader(Rule):
    """A joint in `ros2_control` is to mimic another one, and the robot does not say which.

    `mimic="true"` demands a `mimic` in the joint itself. From jazzy on ros2_control refuses the description
    without it; up to iron the attribute is not read.
    """

    code = "R2C017"
    name = "mimic-without-leader"
    severity = Severity.ERROR
    remedy = """Write `<mimic joint="…" multiplier="…"/>` in the joint of the robot, or remove `mimic="true"`.
    """
    looks_at = (ControlComponent,)
    scaffold = IN_BLOCK

    bad = (Bad('<joint name="lift" mimic="«true»"/>', says="joint `lift` has no `<mimic>` in the robot"),)
    good = (Good('<joint name="lift"/><joint name="follower" mimic="true"/>'),)

    @staticmethod
    def applies(component: ControlComponent) -> bool:
        value, joint = component.mimic_value, component.joint
        return (
            value is not None
            and value.text.strip().lower() == "true"
            and joint is not None
            and joint.axis.mimic is None
        )

    def check(self, component: ControlComponent) -> Iterator[Diagnostic]:
        value, joint = component.mimic_value, component.joint
        assert value is not None
        assert joint is not None
        message = f"{component.title} has no `<mimic>` in the robot: {SINCE_JAZZY}"
        yield self.diagnostic(value, message, labels={joint: "the joint"})
