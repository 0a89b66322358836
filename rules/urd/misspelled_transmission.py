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
TYPE = "<type>transmission_interface/SimpleTransmission</type>"
WHOLE = JOINT.format(ONE.format(EFFORT.format("hardware_interface/EffortJointInterface"), RATIO))
OF_OLD = WHOLE.replace(TYPE, "").replace(
    'name="t"', 'name="t" {}="transmission_interface/SimpleTransmission"'
)


class MisspelledTransmission(Rule):
    """The type of a transmission, or the interface of its joint, is nearly one that ros_control has.

    Or the type is an attribute, as in robots of ROS before Hydro, or a reduction is malformed. ros_control skips such a
    transmission with an error. Its joint has no interface, and a controller that asks for it is not started: "could
    not find joint in hardware_interface…". In a package of ROS 2, where nothing reads it, that is a warning,
    and so is a malformed reduction, which the controllers of Gazebo do not read.
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
        Bad(
            OF_OLD.format("«type»"),
            says="ros_control reads the type of transmission `t` from an element `type`, not from an attribute",
        ),
        Bad(
            WHOLE.replace(RATIO, RATIO.replace("1", "«-13/3 * 7»")),
            says="the reduction of transmission `t` should be a number, not `-13/3 * 7`",
        ),
    )
    good = (
        Good(WHOLE),
        Good(
            '<transmission name="t" type="SimpleTransmission"><joint name="j"/><actuator name="m"/></transmission>'
            '<link name="a"/><joint name="j" type="fixed"><parent link="base"/><child link="a"/></joint>',
            why="Drake reads the attribute",
        ),
        Good(
            JOINT.format(ONE.format(EFFORT.format("my_hardware/EffortJointInterface"), RATIO)),
            why="of another package",
        ),
    )

    @staticmethod
    def applies(transmission: Transmission) -> bool:
        found = is_of_old(transmission) or any(map(is_no_number, transmission.reductions))
        return found or next(misspelled(transmission), None) is not None

    def check(self, transmission: Transmission) -> Iterator[Diagnostic]:
        severity = Severity.WARNING if transmission.is_of_ros_2 else None
        for value, meant in misspelled(transmission):
            message = f"ros_control has no `{value.text.strip()}`"
            yield self.diagnostic(value, message, meant=meant, severity=severity)
        for value in filter(is_no_number, transmission.reductions):
            message = f"the reduction of {transmission.title} should be a number, not `{value.text.strip()}`"
            yield self.diagnostic(value, message, severity=Severity.WARNING)
        kind = transmission.type_value
        if is_of_old(transmission) and kind is not None:
            title = transmission.title
            message = f"ros_control reads the type of {title} from an element `type`, not from an attribute"
            advice = f"write `<type>{kind.text.strip()}</type>` into it"
            yield self.diagnostic(kind.name_span, message, help=advice, severity=severity)


def is_of_old(transmission: Transmission) -> bool:
    """Is its type an attribute, and ros_control to read it?"""
    is_named = any(joint.has("hardwareInterface") for joint in transmission.joint_elements)
    return is_named and transmission.attribute("type") is not None and not transmission.has("type")


def is_no_number(value: Value) -> bool:
    """Is a text neither a number nor an expression that is yet to be expanded?"""
    return value.number != value.number and value.text.strip() != "" and "$" not in value.text


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
