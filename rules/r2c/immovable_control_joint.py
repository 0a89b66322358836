from collections.abc import Iterator

from sdfcheck import Bad, ControlComponent, Diagnostic, Good, Rule, Severity
from sdfcheck_rules.r2c.scaffold import IN_BLOCK, SINCE_JAZZY


class ImmovableControlJoint(Rule):
    """`ros2_control` has a joint that the robot cannot drive.

    A fixed joint moves nothing: from jazzy on ros2_control refuses the description for it, earlier releases
    take it. A floating or planar joint has no single position that an interface could hold.
    """

    code = "R2C011"
    name = "immovable-control-joint"
    severity = Severity.ERROR
    remedy = """Remove the joint from the block, or give it a type that can be driven.

    A fixed joint needs no entry: robot_state_publisher knows where it is. A free base is reported by
    odometry, not by an interface of a joint.
    """
    looks_at = (ControlComponent,)
    scaffold = IN_BLOCK

    bad = (
        Bad(
            '<joint name="«tip»"><state_interface name="position"/></joint>',
            says="ros2_control `arm` has joint `tip`, which is fixed",
        ),
    )
    good = (
        Good('<joint name="lift"><state_interface name="position"/></joint>'),
        Good(
            '<sensor name="tip"><state_interface name="force.x"/></sensor>', why="a sensor may be called so"
        ),
    )

    @staticmethod
    def applies(component: ControlComponent) -> bool:
        joint = component.joint
        return joint is not None and joint.type in {"fixed", "floating", "planar"}

    def check(self, component: ControlComponent) -> Iterator[Diagnostic]:
        joint, name = component.joint, component.name_value
        assert joint is not None
        assert name is not None
        does = f": {SINCE_JAZZY}" if joint.is_fixed else ""
        message = f"{component.block.title} has {joint.title}, which is {joint.type}{does}"
        severity = None if joint.is_fixed else Severity.WARNING
        labels = {joint.type_value or joint: "its type"}
        yield self.diagnostic(name, message, labels=labels, severity=severity)
