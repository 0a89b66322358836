from collections.abc import Iterator

from sdfcheck import IN_ROBOT, Bad, Diagnostic, Element, Good, Rule, Severity, Transmission

JOINT = (
    '<gazebo><plugin name="c" filename="libgazebo_ros_control.so"/></gazebo>'
    '<link name="arm"/><joint name="j" type="continuous"><parent link="base"/><child link="arm"/></joint>'
    '<transmission name="t"><type>transmission_interface/SimpleTransmission</type>{}</transmission>'
)
POSITION = "<hardwareInterface>hardware_interface/PositionJointInterface</hardwareInterface>"
RATIO = "<mechanicalReduction>1</mechanicalReduction>"


class MissingHardwareInterface(Rule):
    """A transmission says by no `hardwareInterface` how its joint is driven.

    The parser of ros_control drops such a joint and reports an error, and no controller finds it. In the joint it has
    to be: one in the actuator, as files of ROS before Hydro have it, is read for the actuator only.
    """

    code = "URD024"
    name = "missing-hardware-interface"
    severity = Severity.WARNING
    remedy = """Write `<hardwareInterface>` into the `<joint>` of the transmission.

    It is one of `hardware_interface/EffortJointInterface`, `hardware_interface/VelocityJointInterface` and
    `hardware_interface/PositionJointInterface`: the one that the controller of the joint asks for. ROS 2
    reads no transmissions of this kind: write a `ros2_control` block for it.
    """
    looks_at = (Transmission,)
    scaffold = IN_ROBOT

    bad = (
        Bad(
            JOINT.format(f'<«joint» name="j"/><actuator name="m">{RATIO}</actuator>'),
            says="joint `j` of transmission `t` has no `hardwareInterface`",
        ),
        Bad(
            JOINT.format(f'<«joint» name="j"/><actuator name="m">{POSITION}{RATIO}</actuator>'),
            says="has no `hardwareInterface` of its own; that of the actuator does not count for it",
        ),
    )
    good = (Good(JOINT.format(f'<joint name="j">{POSITION}</joint><actuator name="m">{RATIO}</actuator>')),)

    @staticmethod
    def applies(transmission: Transmission) -> bool:
        value = transmission.type_value
        is_ours = value is not None and value.text.strip().startswith(PREFIX)
        return is_ours and bool(bare_joints(transmission)) and is_for_ros_control(transmission)

    def check(self, transmission: Transmission) -> Iterator[Diagnostic]:
        in_actuator = any(actuator.has("hardwareInterface") for actuator in transmission.actuators)
        for joint in bare_joints(transmission):
            message = f"{joint.title} of {transmission.title} has no `hardwareInterface`"
            if in_actuator:
                message += " of its own; that of the actuator does not count for it"
            yield self.diagnostic(joint, message)


PREFIX = "transmission_interface/"


def is_for_ros_control(transmission: Transmission) -> bool:
    """Does the robot name interfaces, or run ros_control? Drake reads transmissions as well, and needs none."""
    source = transmission.document.source
    return source.contains("<hardwareInterface") or source.contains("ros_control")


def bare_joints(transmission: Transmission) -> list[Element]:
    """The joints without an interface."""
    return [joint for joint in transmission.joint_elements if not joint.has("hardwareInterface")]
