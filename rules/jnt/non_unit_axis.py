from collections.abc import Iterator

from sdfcheck import IN_JOINT, IN_URDF_JOINT, Bad, Diagnostic, Good, Rule, Severity, problems, replace


class NonUnitAxis(Rule):
    """The axis of a joint does not have the length 1.

    Readers keep the direction and make the length 1, so the robot is as it would be. Who
    computes with the numbers as they stand gets motions that are too long or too short.
    """

    code = "JNT013"
    name = "non-unit-axis"
    severity = Severity.INFO
    explains = (problems.NonUnitAxis,)
    scaffold = IN_JOINT

    bad = (
        Bad(
            "<axis><xyz>«0 3 4»</xyz></axis>",
            fixed="<axis><xyz>0 0.6 0.8</xyz></axis>",
            says="the axis of joint `j` has the length 5",
        ),
        Bad(
            '<axis xyz="«0 0 -2»"/><limit lower="-1" upper="1" effort="5" velocity="2"/>',
            fixed='<axis xyz="0 0 -1"/><limit lower="-1" upper="1" effort="5" velocity="2"/>',
            scaffold=IN_URDF_JOINT,
            says="has the length 2",
        ),
    )
    good = (Good("<axis><xyz>0.577 0.577 0.577</xyz></axis>", why="rounded"),)

    def check(self, problem: problems.NonUnitAxis) -> Iterator[Diagnostic]:
        value = problem.value
        message = f"the axis of {problem.joint.title} has the length {problem.length:.3g}, not 1"
        yield self.diagnostic(value, message, fix=replace(value, problem.normalized, "make its length 1"))
