from collections.abc import Iterator

from sdfcheck import Bad, ControlComponent, Diagnostic, Element, Good, Rule, Severity
from sdfcheck_rules.r2c.scaffold import IN_BLOCK

FOLLOWER = '<joint name="lift"/><joint name="follower"><param name="mimic">{}</param></joint>'


class UnknownLeaderParameter(Rule):
    """The parameter `mimic` of a joint in `ros2_control` names a joint that the block does not have.

    Mock hardware and Gazebo of humble and iron look for the leader among the joints of the block, and stop with an
    exception where it is not there. From jazzy on the parameter is not read.
    """

    code = "R2C035"
    name = "unknown-leader-parameter"
    severity = Severity.WARNING
    remedy = """Name a joint of the same block.

    For jazzy and later, write `<mimic joint="…"/>` in the joint of the robot as well.
    """
    looks_at = (ControlComponent,)
    scaffold = IN_BLOCK

    bad = (
        Bad(
            FOLLOWER.format("«lfit»"),
            fixed=FOLLOWER.format("lift"),
            unsafe=True,
            says="ros2_control `arm` has no joint `lfit`, which joint `follower` is to mimic; did you mean `lift`?",
        ),
    )
    good = (Good(FOLLOWER.format("lift")),)

    @staticmethod
    def applies(component: ControlComponent) -> bool:
        return component.what == "joint" and any(unknown(component))

    def check(self, component: ControlComponent) -> Iterator[Diagnostic]:
        block = component.block
        for parameter in unknown(component):
            leader = parameter.own_value
            message = (
                f"{block.title} has no joint `{leader.text.strip()}`, which {component.title} is to mimic"
            )
            yield self.diagnostic(leader, message, meant=block.nearest(leader.text, block.joints))


def unknown(component: ControlComponent) -> list[Element]:
    """The parameters that name a joint which the block does not have."""
    names = component.block.joints
    return [
        each
        for each in component.mimic_parameters
        if (leader := each.own_value.text.strip()) and "$" not in leader and leader not in names
    ]
