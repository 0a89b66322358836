from collections.abc import Iterator

from sdfcheck import Bad, ControlTransmission, Diagnostic, Good, Rule, Severity
from sdfcheck_rules.r2c.scaffold import IN_BLOCK, REFUSED

TRANSMISSION = (
    '<transmission name="t"><plugin>transmission_interface/SimpleTransmission</plugin>'
    '<joint name="{}" role="joint1"/></transmission>'
)


class ForeignTransmissionJoint(Rule):
    """A transmission in `ros2_control` is for a joint that its block does not have.

    The parser looks for the joint among those of the same block, throws if it is not there, and the whole
    description is lost. In a block of type `actuator` a transmission has exactly one joint.
    """

    code = "R2C025"
    name = "foreign-transmission-joint"
    severity = Severity.ERROR
    remedy = """Name a joint of the same block, or list the joint there.

    A transmission between an actuator and its joint belongs in the block of the hardware that drives both.
    """
    looks_at = (ControlTransmission,)
    scaffold = IN_BLOCK

    bad = (
        Bad(
            TRANSMISSION.replace("{}", "«left»") + '<joint name="lift"/>',
            fixed=TRANSMISSION.replace("{}", "lift") + '<joint name="lift"/>',
            unsafe=True,
            says="transmission `t` is for joint `left`, which is not in ros2_control `arm`",
        ),
        Bad(
            '<transmission name="t"><plugin>transmission_interface/SimpleTransmission</plugin>'
            '<joint name="«lft»" role="joint1"/></transmission><joint name="lift"/>',
            fixed=TRANSMISSION.replace("{}", "lift") + '<joint name="lift"/>',
            unsafe=True,
            says="did you mean `lift`?",
        ),
    )
    good = (Good(TRANSMISSION.replace("{}", "lift") + '<joint name="lift"/>'),)

    @staticmethod
    def applies(transmission: ControlTransmission) -> bool:
        return bool(transmission.unresolved)

    def check(self, transmission: ControlTransmission) -> Iterator[Diagnostic]:
        for value in transmission.unresolved:
            missing = f"`{value.text}`, which is not in {transmission.block.title}"
            near = transmission.nearest(value.text, transmission.block.joints)
            yield self.diagnostic(
                value, f"{transmission.title} is for joint {missing}: {REFUSED}", meant=near
            )
