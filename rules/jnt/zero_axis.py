from collections.abc import Iterator

from sdfcheck import IN_JOINT, IN_URDF_JOINT, Bad, Diagnostic, Good, Rule, Severity, problems


class ZeroAxis(Rule):
    """The axis of a joint has no length, so it points nowhere.

    libsdformat and Drake refuse the file; in other readers the joint's motion divides by zero.
    """

    code = "JNT006"
    name = "zero-axis"
    severity = Severity.ERROR
    explains = (problems.ZeroAxis,)
    scaffold = IN_JOINT

    bad = (
        Bad("<axis><xyz>«0 0 0»</xyz></axis>", says="the axis of joint `j` has no length"),
        Bad(
            '<axis xyz="«0 0 0»"/><limit lower="-1" upper="1" effort="5" velocity="2"/>',
            scaffold=IN_URDF_JOINT,
            says="the axis of joint `j` has no length",
        ),
    )
    good = (
        Good("<axis><xyz>0 0 1</xyz></axis>"),
        Good("<axis><xyz>0 0 0.001</xyz></axis>", why="it has a direction"),
    )

    def check(self, problem: problems.ZeroAxis) -> Iterator[Diagnostic]:
        yield self.diagnostic(problem.value, f"the axis of {problem.joint.title} has no length")
