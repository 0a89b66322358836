from collections.abc import Iterator

from sdfcheck import REFUSES, Bad, Consumer, Diagnostic, Good, Rule, Severity, problems, refuses, warns

ROBOT = (
    '<robot name="r"><link name="a"/><link name="b"/><link name="c"/>'
    '<joint name="j" type="{}"><parent link="a"/><child link="b"/></joint>'
    '<joint name="k" type="continuous"><parent link="a"/><child link="c"/>'
    '<mimic joint="«j»"/></joint></robot>'
)


class MimicOfFixedJoint(Rule):
    """A joint follows one that is fixed.

    It can never move. In Gazebo the leader is merged away, and libsdformat refuses a
    mimic whose leader does not exist; Drake refuses it because the joints differ in their
    degrees of freedom.
    """

    code = "URD018"
    name = "mimic-of-fixed-joint"
    severity = Severity.ERROR
    affects = {
        Consumer.GAZEBO: refuses("refuses the robot"),
        Consumer.DRAKE: REFUSES,
        Consumer.URDFDOM: warns("takes it as it is"),
        Consumer.MUJOCO: warns("ignores it"),
    }
    explains = (problems.MimicOfFixedJoint,)

    bad = (Bad(ROBOT.replace("{}", "fixed"), says="joint `k` follows joint `j`, which is fixed"),)
    good = (
        Good(ROBOT.replace("{}", "continuous").replace("«", "").replace("»", "")),
        Good(
            ROBOT.replace("{}", "fixed").replace("continuous", "fixed").replace("«", "").replace("»", ""),
            why="a hand that was frozen as a whole",
        ),
    )

    def check(self, problem: problems.MimicOfFixedJoint) -> Iterator[Diagnostic]:
        value = problem.value
        message = f"{problem.joint.title} follows joint `{value.text}`, which is fixed"
        yield self.diagnostic(value, message, labels={problem.leader: "its type"})
