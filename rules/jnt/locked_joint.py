from collections.abc import Iterator
from math import isfinite

from sdfcheck import IN_JOINT, IN_URDF_JOINT, Bad, Diagnostic, Good, Joint, Limit, Rule, Severity
from sdfcheck_rules.jnt.inverted_limits import BOUNDED
from sdfcheck_rules.jnt.powerless_joint import TRANSMITTED, driver_name

AXIS = "<axis><xyz>0 0 1</xyz><limit><lower>{}</lower><upper>{}</upper></limit></axis>"
FEWEST = 3
"""Joints of a robot that are locked for want of numbers, not on purpose."""
JOINTS = "".join(
    f'<link name="{child}"/><joint name="j{child}" type="revolute"><parent link="{parent}"/><child link="{child}"/>'
    '<axis xyz="0 0 1"/><limit lower="@" upper="@" effort="0" velocity="0"/></joint>'
    for parent, child in ("ab", "bc", "cd")
)


def zeros(*limits: object) -> str:
    """A robot whose joints are all limited from one number to the same."""
    text = JOINTS
    for limit in limits:
        text = text.replace("@", str(limit), 1).replace("@", str(limit).strip("«»"), 1)
    return f'<robot name="r"><link name="a"/>{text}</robot>'


class LockedJoint(Rule):
    """The lower limit of a joint equals its upper one, and is not 0, or something is to drive the joint.

    Nothing can move the joint, and with another limit than 0 it cannot be where simulations start. A sign or a number
    was lost, or an exporter wrote one value for both. Joints that nothing drives are often locked at 0, so that Gazebo
    keeps their links; they are not reported, unless no joint of the robot can move by its limits.
    """

    code = "JNT023"
    name = "locked-joint"
    severity = Severity.WARNING
    remedy = """Give the joint the range that it has, or make it fixed.

    A fixed joint keeps the position in its pose: turn the `<origin>` or `<pose>` by the locked angle. If a
    sign was lost, the limits are mostly symmetric: -0.035 and 0.035.
    """
    looks_at = (Limit,)
    scaffold = IN_JOINT

    bad = (
        Bad(
            AXIS.format("«0.035»", "0.035"),
            says="lower limit 0.035 equals the upper one: joint `j` cannot move",
        ),
        Bad(
            '<limit lower="«1.4»" upper="1.4" effort="5" velocity="2"/>',
            scaffold=IN_URDF_JOINT,
            says="joint `j` cannot move",
        ),
        Bad(
            '<limit lower="«0»" upper="0" effort="0" velocity="0"/>',
            scaffold=TRANSMITTED,
            says="lower limit 0 equals the upper one: joint `j` cannot move, and `transmission` drives it",
        ),
        Bad(
            zeros("«0»", 0, 0),
            scaffold="{}",
            says="no joint of robot `r` can move: all 3 are limited from 0 to 0, as exporters write where nobody has",
        ),
    )
    good = (
        Good(AXIS.format("0", "0"), why="locked on purpose"),
        Good(AXIS.format("1e400", "1e400"), why="these are too large for numbers"),
        Good(
            '<limit lower="0" upper="0" effort="0" velocity="0"/>',
            scaffold=IN_URDF_JOINT,
            why="locked on purpose",
        ),
        Good('<limit lower="-0.035" upper="0.035" effort="5" velocity="2"/>', scaffold=IN_URDF_JOINT),
        Good(zeros(0, 0, 0).replace('upper="0"', 'upper="1"', 1), scaffold="{}", why="locked on purpose"),
        Good('<limit effort="5" velocity="2"/>', scaffold=IN_URDF_JOINT, why="no limits are written"),
    )

    @staticmethod
    def applies(limit: Limit) -> bool:
        lower, upper = limit.lower, limit.upper
        if not (
            lower.is_given and upper.is_given and lower.number == upper.number and isfinite(lower.number)
        ):
            return False
        if limit.joint.type not in BOUNDED or limit.axis.limit is not limit:
            return False
        return lower.number != 0 or limit.joint.driver is not None or is_first_of_all(limit)

    def check(self, limit: Limit) -> Iterator[Diagnostic]:
        lower, upper, driver = limit.lower, limit.upper, limit.joint.driver
        if lower.number == 0 and driver is None:
            robot = limit.joint.scope
            count = sum(joint.moves for joint in limit.joint.root.each(Joint))
            words = (
                f"all {count} are limited from 0 to 0, as exporters write where nobody has entered a number"
            )
            yield self.diagnostic(lower, f"no joint of {robot.title} can move: {words}")
            return
        message = f"lower limit {lower.text} equals the upper one: {limit.joint.title} cannot move"
        labels: dict[object, str] = {upper: "the upper limit"}
        if driver is not None:
            message += f", and `{driver_name(driver)}` drives it"
            labels[driver] = "drives it"
        yield self.diagnostic(lower, message, labels=labels)


def is_first_of_all(limit: Limit) -> bool:
    """Is it of the first joint of a robot of URDF in which all are limited from 0 to 0, without effort or velocity?"""
    joints = [joint for joint in limit.joint.root.each(Joint) if joint.moves] if limit.joint.is_urdf else []
    if len(joints) < FEWEST or joints[0].element is not limit.joint.element:
        return False
    limits = [joint.axis.limit for joint in joints]
    return all(
        joint.type in BOUNDED
        and each.upper.is_given
        and {each.lower.number, each.upper.number, each.effort.number, each.velocity.number} == {0}
        for joint, each in zip(joints, limits, strict=True)
    )
