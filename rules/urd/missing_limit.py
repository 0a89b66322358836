from collections.abc import Iterator

from sdfcheck import (
    IN_URDF_JOINT,
    REFUSES,
    Bad,
    Consumer,
    Diagnostic,
    Good,
    Rule,
    Severity,
    listed,
    problems,
    warns,
)


class MissingLimit(Rule):
    """A joint lacks the limits that its type needs.

    urdfdom refuses a file with a revolute or prismatic joint without `limit`, and one with
    any `limit` that has no `effort` or no `velocity`, whatever the joint. A `limit` with
    neither `lower` nor `upper` locks the joint, for both are 0; that gets a warning.
    """

    code = "URD005"
    name = "missing-limit"
    severity = Severity.ERROR
    affects = {
        Consumer.GAZEBO: REFUSES,
        Consumer.DRAKE: warns("takes no limits"),
        Consumer.URDFDOM: REFUSES,
        Consumer.MUJOCO: warns("takes no limits"),
    }
    explains = (problems.MissingLimit, problems.LockedByDefault)
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
    )

    def check(self, problem: problems.MissingLimit | problems.LockedByDefault) -> Iterator[Diagnostic]:
        joint = problem.joint
        if isinstance(problem, problems.LockedByDefault):
            message = (
                f"the limit of {joint.title} has no `lower` and no `upper`, so both are 0 and it cannot move"
            )
            affects = dict.fromkeys(Consumer, warns("locks the joint"))
            yield self.diagnostic(problem.limit, message, severity=Severity.WARNING, affects=affects)
        elif problem.limit is None:
            yield self.diagnostic(joint, f"{joint.title} is {problem.type} and has no `limit`")
        else:
            lacks = listed(f"no `{name}`" for name in problem.missing)
            yield self.diagnostic(problem.limit, f"the limit of {joint.title} has {lacks}")
