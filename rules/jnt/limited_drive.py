import math
import re
from collections.abc import Iterator

from sdfcheck import IN_ROBOT, Bad, Diagnostic, Good, Joint, Plugin, Rule, Severity, Value

WHEEL = re.compile(
    r"(?:left|right|front|back|rear)(?:_?(?:left|right|front|back|rear))?_?joint", re.IGNORECASE
)
"""The parameters that name the wheels of drives; those of steering have another word in them."""
PROPELLERS = {"gz-sim-thruster-system": "joint_name", "gz-sim-multicopter-motor-model-system": "jointName"}
ENOUGH = 100.0
"""Radians: a wheel that can turn so far was meant to turn freely."""
ROBOT = (
    '<link name="w"><inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'
    '</link><joint name="j" type="{}"><parent link="base"/><child link="w"/><axis xyz="1 0 0"/>'
    '<limit effort="1" velocity="9" lower="{}" upper="{}"/></joint><gazebo>'
    '<plugin filename="gz-sim-thruster-system" name="gz::sim::systems::Thruster"><joint_name>j</joint_name></plugin>'
    "</gazebo>"
)


class LimitedDrive(Rule):
    """A wheel or propeller that a plugin turns cannot turn freely, because its joint has limits.

    It stops at the limit, after less than a few turns, and the robot does not move on.
    """

    code = "JNT027"
    name = "limited-drive"
    severity = Severity.WARNING
    remedy = """Make the joint free to turn.

    In URDF that is `type="continuous"`, without `lower` and `upper`. In SDFormat, leave `lower` and `upper` out of
    `limit`: the joint then turns without end.
    """
    looks_at = (Plugin,)
    scaffold = IN_ROBOT

    bad = (
        Bad(
            ROBOT.format("revolute", "-1.57", "1.57").replace("<joint_name>j<", "<joint_name>«j»<"),
            also=("URD013",),
            says="`gz-sim-thruster-system` turns joint `j`, which stops at -1.57 and 1.57 rad",
        ),
    )
    good = (
        Good(ROBOT.format("continuous", "0", "0").replace(' lower="0" upper="0"', "")),
        Good(ROBOT.format("revolute", "-1e16", "1e16"), why="as good as free"),
    )

    @staticmethod
    def applies(plugin: Plugin) -> bool:
        return next(limited(plugin), None) is not None

    def check(self, plugin: Plugin) -> Iterator[Diagnostic]:
        for value, joint, low, high in limited(plugin):
            message = f"`{plugin.filename}` turns {joint.title}, which stops at {low:g} and {high:g} rad"
            limit = joint.axis.limit
            yield self.diagnostic(value, message, labels={limit.upper or limit: "stops it"})


def limited(plugin: Plugin) -> Iterator[tuple[Value, Joint, float, float]]:
    """The joints that it turns and that are limited: where it names them, the joint, its limits."""
    facts = plugin.known
    if facts is None:
        return
    propeller = PROPELLERS.get(facts.file)
    for reference in plugin.references:
        name, joint = reference.value.element.name, reference.joint
        if joint is not None and joint.type == "revolute" and (name == propeller or WHEEL.fullmatch(name)):
            low, high = joint.axis.limit.range
            if math.isfinite(high - low) and high - low < ENOUGH:
                yield reference.value, joint, low, high
