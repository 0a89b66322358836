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
UNTURNED = frozenset(("fixed", "prismatic"))
DRIVEN = """<sdf version="1.12"><model name="m"><link name="base"/><link name="l"/><link name="r"/>
<joint name="left" type="{}"><parent>base</parent><child>l</child>{}</joint>
<joint name="right" type="revolute"><parent>base</parent><child>r</child><axis><xyz>0 1 0</xyz></axis></joint>
<plugin filename="gz-sim-diff-drive-system" name="gz::sim::systems::DiffDrive"><left_joint>{}</left_joint>
<right_joint>right</right_joint></plugin></model></sdf>"""
ROBOT = (
    '<link name="w"><inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'
    '</link><joint name="j" type="{}"><parent link="base"/><child link="w"/><axis xyz="1 0 0"/>'
    '<limit effort="1" velocity="9" lower="{}" upper="{}"/></joint><gazebo>'
    '<plugin filename="gz-sim-thruster-system" name="gz::sim::systems::Thruster"><joint_name>j</joint_name></plugin>'
    "</gazebo>"
)


class LimitedDrive(Rule):
    """A wheel or propeller that a plugin turns cannot turn freely, because its joint has limits or is fixed.

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
        Bad(
            DRIVEN.format("fixed", "", "«left»"),
            scaffold="{}",
            says="`gz-sim-diff-drive-system` turns joint `left`, which is fixed",
        ),
    )
    good = (
        Good(ROBOT.format("continuous", "0", "0").replace(' lower="0" upper="0"', "")),
        Good(ROBOT.format("revolute", "-1e16", "1e16"), why="as good as free"),
        Good(DRIVEN.format("continuous", "<axis><xyz>0 1 0</xyz></axis>", "left"), scaffold="{}"),
    )

    @staticmethod
    def applies(plugin: Plugin) -> bool:
        return next(limited(plugin), None) is not None

    def check(self, plugin: Plugin) -> Iterator[Diagnostic]:
        for value, joint in limited(plugin):
            message = f"`{plugin.filename}` turns {joint.title}, which"
            if joint.type in UNTURNED:
                yield self.diagnostic(value, f"{message} is {joint.type}", labels={joint: "the joint"})
                continue
            limit = joint.axis.limit
            low, high = limit.range
            labels = {limit.upper or limit: "stops it"}
            yield self.diagnostic(value, f"{message} stops at {low:g} and {high:g} rad", labels=labels)


def limited(plugin: Plugin) -> Iterator[tuple[Value, Joint]]:
    """The joints that it turns, and that are limited or do not turn, with where it names them."""
    facts = plugin.known
    if facts is None:
        return
    propeller = PROPELLERS.get(facts.file)
    for reference in plugin.references:
        name, joint = reference.value.element.name, reference.joint
        if joint is None or not (name == propeller or WHEEL.fullmatch(name)):
            continue
        if joint.type == "revolute":
            low, high = joint.axis.limit.range
            is_limited = math.isfinite(high - low) and high - low < ENOUGH
        else:
            is_limited = joint.type in UNTURNED and not reference.is_unresolved
        if is_limited:
            yield reference.value, joint
