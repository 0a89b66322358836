from collections.abc import Iterator

from sdfcheck import Bad, ControlComponent, Diagnostic, Good, Rule, Severity
from sdfcheck_rules.r2c.scaffold import IN_BLOCK, SINCE_JAZZY


class LeaderInOtherBlock(Rule):
    """A joint in `ros2_control` mimics one that is not in the same block.

    From jazzy on ros2_control looks for the leader among the joints of the block and refuses the description
    if it is not there; up to iron it is accepted.
    """

    code = "R2C016"
    name = "leader-in-other-block"
    severity = Severity.ERROR
    remedy = """List the leader in the same block, or leave the follower out of it.

    If the hardware drives the follower on its own, `mimic="false"` at the joint of the block says so.
    """
    looks_at = (ControlComponent,)
    scaffold = IN_BLOCK

    bad = (
        Bad(
            '<joint name="«follower»"><state_interface name="position"/></joint>',
            says="joint `follower` mimics `lift`, which is not in ros2_control `arm`",
        ),
    )
    good = (
        Good('<joint name="lift"/><joint name="follower"><state_interface name="position"/></joint>'),
        Good('<joint name="follower" mimic="false"/>'),
    )

    @staticmethod
    def applies(component: ControlComponent) -> bool:
        mimic = component.mimic
        return (
            mimic is not None and mimic.leader is not None and mimic.leader_name not in component.block.joints
        )

    def check(self, component: ControlComponent) -> Iterator[Diagnostic]:
        mimic, name = component.mimic, component.name_value
        assert mimic is not None
        assert name is not None
        missing = f"`{mimic.leader_name}`, which is not in {component.block.title}"
        labels = {mimic.leader_value or mimic: "it mimics this joint"}
        yield self.diagnostic(name, f"{component.title} mimics {missing}: {SINCE_JAZZY}", labels=labels)
