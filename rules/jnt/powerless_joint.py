from collections.abc import Iterator

from sdfcheck import (
    IN_URDF_JOINT,
    Bad,
    ControlComponent,
    Diagnostic,
    Good,
    Joint,
    Limit,
    Number,
    Part,
    Rule,
    Severity,
    Value,
)
from sdfcheck_rules.jnt.zero_limit import is_locked, zeros

JOINT = (
    '<robot name="r"><link name="a"/><link name="b"/><joint name="j" type="revolute"><parent link="a"/>'
    '<child link="b"/><axis xyz="0 0 1"/>{}</joint>'
)
DRIVEN = (
    JOINT
    + '<ros2_control name="c" type="system"><hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>'
    '<joint name="j"><command_interface name="position"/></joint></ros2_control>'
    '<gazebo><plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">'
    "<parameters>c.yaml</parameters></plugin></gazebo></robot>"
)
ADVICE = "write at least its greatest effort divided by its greatest velocity, or remove `safety_controller`"
CLASSIC = "gazebo_ros2_control/GazeboSystem"
SAFE = (
    '<limit lower="-1" upper="1" effort="5" velocity="1"/>'
    '<safety_controller soft_lower_limit="-0.9" soft_upper_limit="0.9" k_position="20" k_velocity="{}"/>'
)
COMMANDED = DRIVEN.replace('"position"/>', '"effort"/><state_interface name="velocity"/>')
TRANSMITTED = (
    JOINT + '<transmission name="t"><type>transmission_interface/SimpleTransmission</type><joint name="j"/>'
    "</transmission></robot>"
)


class PowerlessJoint(Rule):
    """A joint that something drives has an effort or a velocity of 0.

    Exporters write 0 where nobody has entered a number. Simulators take it for the limit that it is, so that the joint
    does not follow its commands; planners find no way to move it, and Drake makes no actuator for a transmission.
    A `k_velocity` of 0 has the same effect where `ros2_control` commands an effort and reads the velocity: it allows
    the effort that is `k_velocity` times the distance of the velocity from its bound.
    An effort of 0 is harmless where `ros2_control` commands positions or velocities of other hardware than a
    simulator's, as many robots of ROS-Industrial have it, and is not reported there.
    """

    code = "JNT025"
    name = "powerless-joint"
    severity = Severity.WARNING
    remedy = """Write the greatest effort (N·m, or N of a slide) and velocity (rad/s or m/s) of the drive.

    They are on the data sheet of the motor, after the gearbox. For a joint that nothing should move, take it out of
    what drives it.
    """
    looks_at = (Limit,)

    bad = (
        Bad(
            '<limit lower="-1" upper="1" effort="«0»" velocity="0"/>',
            scaffold=DRIVEN,
            says="effort and velocity of joint `j` are limited to 0, and `ros2_control` drives it",
        ),
        Bad(
            '<limit lower="-1" upper="1" effort="5" velocity="«0»"/>',
            scaffold=TRANSMITTED,
            says="velocity of joint `j` is limited to 0, and `transmission` drives it",
        ),
        Bad(
            SAFE.format("«0.0»"),
            scaffold=COMMANDED,
            says="`k_velocity` of joint `j` is 0, by which `ros2_control` limits its effort to 0",
        ),
    )
    good = (
        Good('<limit lower="-1" upper="1" effort="5" velocity="1"/>', scaffold=DRIVEN),
        Good(
            '<limit lower="-1" upper="1" effort="0" velocity="0"/>',
            scaffold=DRIVEN.replace("command_interface", "state_interface"),
            why="only its state is read",
        ),
        Good(
            '<limit lower="-1" upper="1" effort="0" velocity="0"/>',
            scaffold=IN_URDF_JOINT,
            why="nothing drives it",
        ),
        Good(
            '<limit lower="-1" upper="1" effort="0" velocity="1"/>',
            scaffold=DRIVEN.replace("gz_ros2_control/GazeboSimSystem", "mock_components/GenericSystem"),
            why="positions are commanded",
        ),
        Good(
            '<limit lower="-1" upper="1" effort="0" velocity="1"/>',
            scaffold=DRIVEN.replace("gz_ros2_control/GazeboSimSystem", CLASSIC).replace(
                "gz_ros2_control-system", "libgazebo_ros2_control.so"
            ),
            why="Classic sets positions",
        ),
        Good(SAFE.format("10"), scaffold=COMMANDED),
        Good(SAFE.format("0"), scaffold=DRIVEN, why="no effort is commanded"),
    )

    @staticmethod
    def applies(limit: Limit) -> bool:
        return (
            limit.joint.driver is not None
            and limit.joint.moves
            and bool(lacking(limit) or undriven(limit.joint) is not None)
            and not is_locked(limit)
        )

    def check(self, limit: Limit) -> Iterator[Diagnostic]:
        found, driver = lacking(limit), limit.joint.driver
        if driver is None:
            return
        gain = undriven(limit.joint)
        if gain is not None and not found:
            message = (
                f"`k_velocity` of {limit.joint.title} is 0, by which `ros2_control` limits its effort to 0"
            )
            yield self.diagnostic(gain, message, labels={driver: "commands its effort"}, help=ADVICE)
            return
        names, (first, *_) = " and ".join(found), found.values()
        verb = "are" if len(found) > 1 else "is"
        yield self.diagnostic(
            first,
            f"{names} of {limit.joint.title} {verb} limited to 0, and `{driver_name(driver)}` drives it",
            labels={driver: "drives it"},
        )


def undriven(joint: Joint) -> Value | None:
    """The gain of 0 that leaves no effort to a joint of which `ros2_control` commands the effort."""
    controller, driver = joint.find("safety_controller"), joint.driver
    if controller is None or not isinstance(driver, ControlComponent):
        return None
    kinds = {(each.element.name, each.name) for each in driver.interfaces}
    gain = controller.attribute("k_velocity")
    is_limited = {("command_interface", "effort"), ("state_interface", "velocity")} <= kinds
    return gain if gain is not None and gain.number == 0 and is_limited else None


def driver_name(driver: Part) -> str:
    """The element that drives a joint."""
    return "ros2_control" if driver.kind == "component" else driver.kind


def is_forced(driver: ControlComponent) -> bool:
    """Is the joint moved by forces whatever is commanded, as the new Gazebo does it? Classic sets positions."""
    plugin = driver.block.plugin_value
    return driver.block.is_simulated and plugin is not None and plugin.text != CLASSIC


def is_held_by_effort(joint: Joint) -> bool:
    """Does something drive a joint that has no more than its effort?"""
    driver = joint.driver
    if not isinstance(driver, ControlComponent):
        return driver is not None
    return is_forced(driver) or any(interface.name == "effort" for interface in driver.commands)


def lacking(limit: Limit) -> dict[str, Number]:
    """The limits that are 0 and that its driver is subject to."""
    found, driver = zeros(limit), limit.joint.driver
    if isinstance(driver, ControlComponent) and not is_forced(driver):
        commanded = {interface.name for interface in driver.commands}
        return {name: number for name, number in found.items() if name != "effort" or name in commanded}
    return found
