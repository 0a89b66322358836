from collections.abc import Iterator

from sdfcheck import Bad, ControlComponent, Diagnostic, Good, Rule, Severity
from sdfcheck_rules.r2c.scaffold import IN_BLOCK, SINCE_JAZZY


class CommandOfMimicJoint(Rule):
    """A joint that mimics another one has command interfaces in `ros2_control`.

    Its position is that of its leader. From jazzy on ros2_control refuses such a description;
    up to iron it is accepted.
    """

    code = "R2C015"
    name = "command-of-mimic-joint"
    severity = Severity.ERROR
    remedy = """Remove its command interfaces, or write `mimic="false"` if the hardware drives it itself.

    The states can stay: the hardware computes them from the leader.
    """
    looks_at = (ControlComponent,)
    scaffold = IN_BLOCK

    bad = (
        Bad(
            '<joint name="lift"/><joint name="follower"><«command_interface» name="position"/></joint>',
            says="joint `follower` mimics `lift` and has command interfaces",
        ),
    )
    good = (
        Good('<joint name="lift"/><joint name="follower"><state_interface name="position"/></joint>'),
        Good('<joint name="follower" mimic="false"><command_interface name="position"/></joint>'),
    )

    @staticmethod
    def applies(component: ControlComponent) -> bool:
        return bool(component.commands) and component.mimic is not None

    def check(self, component: ControlComponent) -> Iterator[Diagnostic]:
        mimic = component.mimic
        assert mimic is not None
        message = f"{component.title} mimics `{mimic.leader_name}` and has command interfaces: {SINCE_JAZZY}"
        labels = {mimic.leader_value or mimic: "it mimics this joint"}
        yield self.diagnostic(component.commands[0], message, labels=labels)
