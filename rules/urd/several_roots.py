from collections.abc import Iterator

from sdfcheck import REFUSES, Bad, Consumer, Diagnostic, Good, Rule, Severity, problems, warns

TREES = (
    '<robot name="r"><link name="a"/><link name="b"/><link name="c"/>{}'
    '<joint name="j" type="fixed"><parent link="a"/><child link="b"/></joint></robot>'
)


class SeveralRoots(Rule):
    """The links form more than one tree.

    A URDF robot is one tree with one root. urdfdom, and with it nearly every program of
    ROS and the conversion to SDFormat, refuses anything else; Drake makes a free body of
    every root. Mostly a joint is missing, or two robots were put into one file.
    """

    code = "URD003"
    name = "several-roots"
    severity = Severity.ERROR
    affects = {
        Consumer.GAZEBO: REFUSES,
        Consumer.DRAKE: warns("makes free bodies of them"),
        Consumer.URDFDOM: REFUSES,
        Consumer.MUJOCO: warns("fixes all of them to the world"),
    }
    explains = (problems.SeveralRoots,)
    scaffold = TREES

    bad = (
        Bad(
            '<«link» name="d"/><joint name="k" type="fixed"><parent link="d"/><child link="c"/></joint>',
            says="link `d` is the root of a second tree (2 links)",
        ),
    )
    good = (
        Good(
            '<joint name="k" type="fixed"><parent link="c"/><child link="a"/></joint>',
            why="a root need not come first",
        ),
    )

    def check(self, problem: problems.SeveralRoots) -> Iterator[Diagnostic]:
        message = f"{problem.root.title} is the root of a second tree ({problem.size} links)"
        yield self.diagnostic(problem.root, message, labels={problem.main: "the root of the largest"})
