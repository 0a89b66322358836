from collections.abc import Iterator

from sdfcheck import IN_ROBOT, Bad, Diagnostic, Good, Rule, Severity, Transmission, Value, suggest
from sdfcheck_rules.urd.missing_hardware_interface import JOINT, PREFIX, RATIO

TYPES = tuple(PREFIX + name + "Transmission" for name in ("Simple", "Differential", "FourBarLinkage"))
INTERFACES = tuple(
    f"hardware_interface/{name}Interface"
    for name in (
        *("EffortJoint", "PositionJoint", "VelocityJoint", "PosVelJoint", "PosVelAccJoint", "JointState"),
        *(
            "EffortActuator",
            "PositionActuator",
            "VelocityActuator",
            "ActuatorState",
            "ForceTorqueSensor",
            "ImuSensor",
        ),
    )
)
EFFORT = "<hardwareInterface>{}</hardwareInterface>"
ONE = '<joint name="j">{}</joint><actuator name="m">{}</actuator>'


class MisspelledTransmission(Rule):
    """The type of a transmission, or the interface of its joint, is nearly one that ros_control has.

    ros_control skips such a transmission with an error. Its joint has no interface, and a controller that asks for it
    is not started: "could not find joint in hardware_interface…". In a package of ROS 2, where
    nothing reads it, that is a warning.
    """

    code = "URD028"
    name = "misspelled-transmission"
    severity = Severity.ERROR
    remedy = "Write the name as ros_control does; the interface must be the one that the controllers ask for."
    looks_at = (Transmission,)
    selects = ("urdf:transmission",)
    needs = (PREFIX, "hardwareInterface")
    scaffold = IN_ROBOT
    sources = (
        "https://github.com/ros-simulation/gazebo_ros_pkgs/blob/noetic-devel/gazebo_ros_control/src/default_robot_hw_sim.cpp",
    )

    bad = (
        Bad(
            JOINT.format(ONE.format(EFFORT.format("«hardware_interface/EfortJointInterface»"), RATIO)),
            fixed=JOINT.format(ONE.format(EFFORT.format("hardware_interface/EffortJointInterface"), RATIO)),
            unsafe=True,
            says="ros_control has no `hardware_interface/EfortJointInterface`; did you mean",
        ),
        Bad(
            JOINT.format(ONE.format(EFFORT.format("«EffortJointInterfac»"), RATIO)),
            fixed=JOINT.format(ONE.format(EFFORT.format("hardware_interface/EffortJointInterface"), RATIO)),
            unsafe=True,
            says="did you mean `hardware_interface/EffortJointInterface`?",
        ),
    )
    good = (
        Good(JOINT.format(ONE.format(EFFORT.format("hardware_interface/EffortJointInterface"), RATIO))),
        Good(
            JOINT.format(ONE.format(EFFORT.format("my_hardware/EffortJointInterface"), RATIO)),
            why="of another package",
        ),
    )

    @staticmethod
    def applies(transmission: Transmission) -> bool:
        return next(misspelled(transmission), None) is not None

    def check(self, transmission: Transmission) -> Iterator[Diagnostic]:
        severity = Severity.WARNING if transmission.is_of_ros_2 else None
        for value, meant in misspelled(transmission):
            message = f"ros_control has no `{value.text.strip()}`"
            yield self.diagnostic(value, message, meant=meant, severity=severity)


def misspelled(transmission: Transmission) -> Iterator[tuple[Value, str]]:
    """The names of ros_control's own that are not right, with those that were meant."""
    asked = [(transmission.type_value, TYPES)]
    for joint in transmission.joint_elements:
        asked += [(each.own_value, INTERFACES) for each in joint.children("hardwareInterface")]
    for value, known in asked:
        text = "" if value is None else value.text.strip()
        if value is None or text in known or not text or "$" in text:
            continue
        folder = known[0].partition("/")[0]
        if "/" not in text and known is INTERFACES:
            text = f"{folder}/{text}"  # whose own mistake unprefixed-hardware-interface is
        meant = suggest(text, known)
        if meant not in {None, text} and (
            text.startswith(f"{folder}/") or suggest(text.partition("/")[0], (folder,))
        ):
            yield value, meant
