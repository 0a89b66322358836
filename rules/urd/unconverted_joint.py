from collections.abc import Iterator

from sdfcheck import Bad, Consumer, Diagnostic, Good, Rule, Severity, problems, refuses


class UnconvertedJoint(Rule):
    """A joint is of a type that SDFormat does not have.

    libsdformat drops a floating or planar joint when it converts the robot, but still
    places the child relative to it, so that Gazebo refuses the result. For a robot that is
    free in the world, leave the joint out: it is free anyway.
    """

    code = "URD020"
    name = "unconverted-joint"
    severity = Severity.WARNING
    affects = {Consumer.GAZEBO: refuses("refuses the robot")}
    explains = (problems.UnconvertedJoint,)
    scaffold = (
        '<robot name="r"><link name="a"/><link name="b"/>'
        '<joint name="j" type="{}"><parent link="a"/><child link="b"/></joint></robot>'
    )

    bad = (
        Bad("«planar»", says="joint `j` is planar, which SDFormat has no joint for"),
        Bad("«floating»", says="joint `j` is floating", also=("DRK008",)),
    )
    good = (Good("continuous", why="a revolute joint without limits"), Good("fixed"))

    def check(self, problem: problems.UnconvertedJoint) -> Iterator[Diagnostic]:
        value = problem.value
        message = f"{problem.joint.title} is {value.text}, which SDFormat has no joint for"
        yield self.diagnostic(value, message)
