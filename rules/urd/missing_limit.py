from collections.abc import Iterator
from typing import Any

from sdfcheck import (
    IN_URDF_JOINT,
    REFUSES,
    Bad,
    Consumer,
    Diagnostic,
    Good,
    Joint,
    Limit,
    Rule,
    Severity,
    listed,
    warns,
)

BOUNDED = ("revolute", "prismatic")
REQUIRED = ("effort", "velocity")


class MissingLimit(Rule):
    """A joint lacks the limits that its type needs.

    urdfdom refuses a file with a revolute or prismatic joint without `limit`, and one with
    any `limit` that has no `effort` or no `velocity`, whatever the joint. A `limit` with
    neither `lower` nor `upper` locks the joint in urdfdom and libsdformat, for both are 0; Drake and
    MuJoCo take no limits. That gets a warning.
    """

    code = "URD005"
    name = "missing-limit"
    severity = Severity.ERROR
    remedy = """Give the joint `<limit lower="…" upper="…" effort="…" velocity="…"/>`.

    Positions are in rad or m, effort in Nm or N, velocity in rad/s or m/s: the data sheet of the drive has
    them. A joint that turns without end is of type continuous, and needs no `lower` and `upper`. Where
    nothing is known, an effort of 100 and a velocity of 10 do no harm in most simulators.
    """
    looks_at = (Joint, Limit)
    selects = ("urdf:robot/joint", "urdf:joint/limit")
    scaffold = IN_URDF_JOINT

    bad = (
        Bad(
            '<robot name="r"><link name="a"/><link name="b"/><«joint» name="j" type="prismatic">'
            '<parent link="a"/><child link="b"/></joint></robot>',
            scaffold="",
            says="joint `j` is prismatic and has no `limit`",
        ),
        Bad('<«limit» lower="0" upper="1" velocity="1"/>', says="the limit of joint `j` has no `effort`"),
        Bad('<«limit» lower="0" upper="1"/>', says="has no `effort` and no `velocity`"),
        Bad('<«limit» effort="1" velocity="1"/>', says="so both are 0 and it cannot move"),
    )
    good = (
        Good('<limit upper="1" effort="1" velocity="1"/>', why="lower is 0"),
        Good(
            '<robot name="r"><link name="a"/><link name="b"/><joint name="j" type="continuous">'
            '<parent link="a"/><child link="b"/></joint></robot>',
            why="turns without end",
            scaffold="",
        ),
        Good(
            '<robot name="r"><joint name="j"><limit lower="-1" upper="1"/></joint></robot>',
            why="missing-element reports a robot without links",
            scaffold="",
        ),
    )

    @staticmethod
    def applies(part: Any) -> bool:
        joint = part if part.kind == "joint" else part.joint
        if not joint.has("parent") and not joint.has("child"):
            return False  # no joint at all, as missing-element says
        if part.kind == "joint":
            return not part.has("limit") and part.type in BOUNDED and part.lacks("limit")
        return any(map(part.lacks, REQUIRED)) or is_locked(part)

    def check(self, part: Joint | Limit) -> Iterator[Diagnostic]:
        if isinstance(part, Joint):
            message = f"{part.title} is {part.type} and has no `limit`"
            yield self.diagnostic(part, message, affects={Consumer.PYBULLET: REFUSES})
            return
        joint = part.joint.title
        if missing := [name for name in REQUIRED if part.lacks(name)]:
            lacks = listed(f"no `{name}`" for name in missing)
            yield self.diagnostic(part, f"the limit of {joint} has {lacks}")
        if is_locked(part):
            message = f"the limit of {joint} has no `lower` and no `upper`, so both are 0 and it cannot move"
            affects = dict.fromkeys((Consumer.GAZEBO, Consumer.URDFDOM), warns("locks the joint"))
            yield self.diagnostic(part, message, severity=Severity.WARNING, affects=affects)


def is_locked(limit: Limit) -> bool:
    return limit.joint.type in BOUNDED and limit.lacks("lower") and limit.lacks("upper")
