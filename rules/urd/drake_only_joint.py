from collections.abc import Iterator

from sdfcheck import Bad, Consumer, Diagnostic, Good, Rule, Severity, problems

ROBOT = '<robot name="r" xmlns:drake="http://drake.mit.edu"><link name="a"/><link name="b"/>{}</robot>'
ENDS = '<parent link="a"/><child link="b"/>'


class DrakeOnlyJoint(Rule):
    """A link hangs by nothing but a `drake:joint`, which only Drake reads.

    For every other reader the link is a second root. urdfdom, and with it the programs of
    ROS and the conversion to SDFormat, refuses the file. `--target drake` leaves the rule out.
    """

    code = "URD021"
    name = "drake-only-joint"
    severity = Severity.ERROR
    affects = {Consumer.URDFDOM: "refuses the file", Consumer.GAZEBO: "refuses the file"}
    explains = (problems.DrakeOnlyJoint,)
    scaffold = ROBOT

    bad = (
        Bad(
            f'<«drake:joint» name="j" type="ball">{ENDS}</drake:joint>',
            says="only Drake reads `drake:joint`; for other readers link `b` is a second root",
        ),
    )
    good = (
        Good(
            f'<joint name="j" type="fixed">{ENDS}</joint><drake:joint name="k" type="ball">{ENDS}</drake:joint>',
            why="another joint leads there",
        ),
    )

    def check(self, problem: problems.DrakeOnlyJoint) -> Iterator[Diagnostic]:
        what = f"{problem.link.title} is a second root"
        if problem.count > 1:
            what = f"{problem.link.title} and {problem.count - 1} more are further roots"
        message = f"only Drake reads `drake:joint`; for other readers {what}"
        yield self.diagnostic(problem.joint, message, labels={problem.link: "this link"})
