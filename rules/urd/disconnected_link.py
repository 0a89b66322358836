from collections.abc import Iterator

from sdfcheck import IN_ROBOT, REFUSES, Bad, Consumer, Diagnostic, Good, Rule, Severity, problems, warns


class DisconnectedLink(Rule):
    """No joint leads to a link, or on from it, in a robot of several links.

    Such a link is a second root. urdfdom, and with it nearly every program of ROS and the
    conversion to SDFormat, refuses the file; Drake makes a free body of it.
    """

    code = "URD004"
    name = "disconnected-link"
    severity = Severity.ERROR
    affects = {
        Consumer.GAZEBO: REFUSES,
        Consumer.DRAKE: warns("makes a free body of it"),
        Consumer.URDFDOM: REFUSES,
        Consumer.MUJOCO: warns("fixes it to the world"),
    }
    explains = (problems.DisconnectedLink, problems.MisnamedLink)
    scaffold = IN_ROBOT

    bad = (
        Bad('<«link» name="hook"/>', says="no joint ties link `hook` to the rest of the robot"),
        Bad(
            '<link name="a"/><joint name="j" type="fixed"><parent link="base"/><child link="a"/></joint>'
            '<«link» name="b"/>',
        ),
        Bad(
            '<link name="«lower_lge»"/><link name="foot"/>'
            '<joint name="j" type="fixed"><parent link="base"/><child link="lower_leg"/></joint>'
            '<joint name="k" type="fixed"><parent link="lower_leg"/><child link="foot"/></joint>',
            says="and 2 name `lower_leg`, which is none",
        ),
    )
    good = (
        Good("", why="one link alone is a robot"),
        Good(
            '<link name="gripper"/>'
            '<joint name="j" type="fixed"><parent link="base"/><child link="griper"/></joint>',
            why="the joint is to blame",
        ),
    )

    def check(self, problem: problems.DisconnectedLink | problems.MisnamedLink) -> Iterator[Diagnostic]:
        if isinstance(problem, problems.MisnamedLink):
            value, count = problem.value, len(problem.ends)
            message = f"no joint names link `{value.text}`, and {count} name `{problem.meant}`, which is none"
            yield self.diagnostic(
                value,
                message,
                labels={problem.ends[0]: "the first of them"},
                affects=dict.fromkeys(Consumer, REFUSES),
            )
            return
        message = f"no joint ties {problem.link.title} to the rest of the robot"
        yield self.diagnostic(problem.link, message, labels={problem.main: "the root of the rest"})
