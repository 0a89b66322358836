from collections.abc import Iterator

from sdfcheck import (
    IN_URDF_JOINT,
    Bad,
    Consumer,
    Diagnostic,
    Good,
    Joint,
    Rule,
    Severity,
    Transmission,
    Value,
    accepts,
)

LIMIT = '<limit lower="0" upper="1" effort="1" velocity="1"/></joint>'
TRANSMISSION = (
    '<transmission name="t"><type>transmission_interface/SimpleTransmission</type>'
    '<joint name="{}"><hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface></joint>'
    '<actuator name="m"/></transmission>'
)
FIXED = '<link name="p"/><joint name="plate" type="fixed"><parent link="base"/><child link="p"/></joint>'
ACCEPTED = {Consumer.DRAKE: accepts("makes no actuator")}


class UnknownTransmissionJoint(Rule):
    """A transmission is for a joint that the robot does not have, or that is fixed.

    Drake refuses the file for the first. Controllers find no such joint when they start, mostly long
    after the robot was loaded.
    """

    code = "URD011"
    name = "unknown-transmission-joint"
    severity = Severity.ERROR
    remedy = """Name a joint of the robot in the transmission, with its prefix.

    Where the joint was removed, remove the transmission.
    """
    looks_at = (Transmission,)
    selects = ("urdf:robot/transmission",)
    scaffold = IN_URDF_JOINT.replace("{}</joint>", f"{LIMIT}{{}}").replace('name="j"', 'name="shoulder"')

    bad = (
        Bad(
            TRANSMISSION.replace("{}", "«sholder»"),
            fixed=TRANSMISSION.replace("{}", "shoulder"),
            unsafe=True,
            says="transmission `t` is for joint `sholder`, which does not exist; did you mean `shoulder`?",
        ),
        Bad(
            FIXED + TRANSMISSION.replace("{}", "«plate»"),
            says="transmission `t` is for joint `plate`, which is fixed",
        ),
    )
    good = (Good(TRANSMISSION.replace("{}", "shoulder")),)

    @staticmethod
    def applies(transmission: Transmission) -> bool:
        return bool(transmission.unresolved or fixed_joints(transmission))

    def check(self, transmission: Transmission) -> Iterator[Diagnostic]:
        for value in transmission.unresolved:
            message = f"{transmission.title} is for joint `{value.text}`, which does not exist"
            near = transmission.nearest(value.text, transmission.model.driven)
            yield self.diagnostic(value, message, meant=near, cause=transmission.model.fault_of(value.text))
        for value, joint in fixed_joints(transmission):
            message = f"{transmission.title} is for joint `{value.text}`, which is fixed"
            yield self.diagnostic(
                value,
                message,
                labels={joint: "fixed"},
                severity=Severity.WARNING,
                affects=ACCEPTED,
                help="remove the transmission, or give the joint a type that moves",
            )


def fixed_joints(transmission: Transmission) -> list[tuple[Value, Joint]]:
    """The joints that it is the first to drive and that do not move, with the places of their names."""
    joints = transmission.model.driven
    named = ((value, joints.get(value.text)) for value in transmission.joint_names)
    fixed = [(value, joint) for value, joint in named if joint is not None and joint.is_fixed]
    return [(value, joint) for value, joint in fixed if joint.driver in {transmission, None}]
