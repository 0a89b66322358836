import math
from collections.abc import Iterator

from sdfcheck import (
    IN_LINK,
    IN_ROBOT,
    Bad,
    Consumer,
    Diagnostic,
    Edit,
    Good,
    Rule,
    Severity,
    listed,
    make_fix,
    problems,
    warns,
)


class DegreesAsRadians(Rule):
    """An angle of more than a full turn is a round number of degrees.

    Roll, pitch and yaw are radians in SDFormat and URDF. `90` is read as 14.3 turns, which
    leaves the part at an odd angle. From SDFormat 1.9 on a pose may say `degrees="true"`.
    """

    code = "FRM006"
    name = "degrees-as-radians"
    severity = Severity.WARNING
    affects = dict.fromkeys(Consumer, warns("takes it for radians"))
    explains = (problems.DegreesAsRadians,)
    scaffold = IN_LINK

    bad = (
        Bad(
            "<pose>0 0 1 0 0 «90»</pose>",
            fixed="<pose>0 0 1 0 0 1.5707963267948966</pose>",
            unsafe=True,
            says="yaw 90 is read as radians, and looks like degrees",
        ),
        Bad(
            "<pose>0 0 1 «-180» 0 45</pose>",
            fixed="<pose>0 0 1 -3.141592653589793 0 0.7853981633974483</pose>",
            unsafe=True,
            says="roll -180 and yaw 45 are read as radians, and look like degrees",
        ),
        Bad(
            '<link name="arm"><inertial><origin rpy="«90» 0 0"/><mass value="1"/>'
            '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>'
            '<joint name="j" type="fixed"><parent link="base"/><child link="arm"/></joint>',
            scaffold=IN_ROBOT,
            says="roll 90",
        ),
    )
    good = (
        Good('<pose degrees="true">0 0 1 0 0 90</pose>'),
        Good("<pose>90 0 0 0 0 0</pose>", why="the first three are metres"),
        Good("<pose>0 0 1 0 0 7.853981633974483</pose>", why="a turn and a quarter, in radians"),
        Good("<pose>0 0 1 0 0 6</pose>", why="less than a turn"),
    )

    def check(self, problem: problems.DegreesAsRadians) -> Iterator[Diagnostic]:
        words = problem.value.text.split()
        told = listed(f"{name} {words[at]}" for at, name in problem.parts)
        are, look = ("is", "looks") if len(problem.parts) == 1 else ("are", "look")
        edits = tuple(
            Edit(problem.value.part(at), repr(math.radians(float(words[at])))) for at, _ in problem.parts
        )
        yield self.diagnostic(
            edits[0].span,
            f"{told} {are} read as radians, and {look} like degrees",
            fix=make_fix("write radians", edits, unsafe=True),
        )
