from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Plugin, Rule, Severity
from sdfcheck_rules.geo.scaffolds import car, controlled, controllers, rover

OF_ROS_1 = rover().partition("<gazebo>")[0] + (
    '<gazebo><plugin filename="libgazebo_ros_diff_drive.so" name="d"><leftJoint>{}</leftJoint>'
    "<rightJoint>{}</rightJoint><odometryFrame>odom</odometryFrame><robotBaseFrame>base</robotBaseFrame>"
    "{}</plugin></gazebo></robot>"
)


class ExchangedDriveSides(Rule):
    """The left wheel of a drive is on the right, or a front wheel at the back.

    The plugin or controller turns and steers the wheels by their names alone: with the sides exchanged the robot turns
    right on the command to turn left, and its odometry says the opposite. Left is where the axes of the wheels point
    to, for positive speeds drive forwards. Up to ROS Kinetic the plugin itself exchanged the sides, and robots of that
    time name them so; where `legacyMode` is true, nothing is said.
    """

    code = "GEO009"
    name = "exchanged-drive-sides"
    severity = Severity.WARNING
    remedy = """Exchange the two joints in the parameters of the plugin.

    `left_joint` (or `left_wheel_joint`) is the one with the greater y in a robot that drives along x, as
    ROS has it. If the names of the joints themselves are wrong, rename the joints instead. A robot that
    then drives backwards has axes that point to the right: turn both around.
    """
    looks_at = (Plugin,)

    bad = (
        Bad(
            rover(left="right").replace(">right_joint</left", ">«right_joint»</left"),
            says="`left_joint` names `right_joint`, which is 0.34 m to the right of `left_joint`",
        ),
        Bad(
            OF_ROS_1.format("«right_joint»", "left_joint", ""),
            says="`leftJoint` names `right_joint`, which is 0.34 m to the right of `left_joint`",
        ),
        Bad(
            controlled(rover(), "«parameters»"),
            files=controllers(left="right", right="left"),
            says="`left_wheel_names` of `c.yaml` names `right_joint`, which is 0.34 m to the right",
        ),
        Bad(
            car(base="0.5")
            .replace("<front_left_joint>front", "<front_left_joint>«back")
            .replace("joint</front_left", "joint»</front_left")
            .replace("<back_left_joint>back", "<back_left_joint>front"),
            says="`front_left_joint` names `back_left_joint`, which is 0.5 m behind `front_left_joint`",
        ),
    )
    good = (
        Good(rover()),
        Good(car(base="0.5")),
        Good(
            OF_ROS_1.format("right_joint", "left_joint", "<legacyMode>true</legacyMode>"),
            why="ROS Kinetic turns them back",
        ),
        Good(
            rover(axis="0 -1 0").replace('axis xyz="0 1 0"', 'axis xyz="0 -1 0"'),
            why="the axes are turned, not the sides: opposed-drive-axes owns this one",
        ),
    )

    @staticmethod
    def applies(plugin: Plugin) -> bool:
        return any(drive.misplaced is not None and not drive.is_backward for drive in plugin.drives)

    def check(self, plugin: Plugin) -> Iterator[Diagnostic]:
        for drive in plugin.drives:
            if drive.misplaced is None or drive.is_backward:
                continue  # of the second opposed-drive-axes reports the axes
            wheel, other, way = drive.misplaced
            distance = abs(wheel.ahead_of(other, drive.left.axis))
            if way == "behind":
                distance = drive.axle_distance
            yield self.diagnostic(
                drive.place(wheel.name) or plugin,
                f"{drive.called(wheel.name)} names `{wheel.joint.name}`, which is {distance:.3g} m {way}"
                f" `{other.joint.name}`",
                labels={**drive.labels(wheel.name), other.name: "the other one"},
            )
