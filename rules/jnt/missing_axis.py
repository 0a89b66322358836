from collections.abc import Iterator

from sdfcheck import IN_MODEL, REFUSES, Bad, Consumer, Diagnostic, Good, Rule, Severity, problems, warns

_ENDS = "<parent>base</parent><child>arm</child>"


class MissingAxis(Rule):
    """A joint that moves about or along an axis has none.

    Drake refuses the file. libsdformat accepts it, and Gazebo takes an axis of its own choice
    without a word. Universal joints and those of type revolute2 need two.
    """

    code = "JNT004"
    name = "missing-axis"
    severity = Severity.ERROR
    affects = {Consumer.GAZEBO: warns("takes a default"), Consumer.DRAKE: REFUSES}
    explains = (problems.MissingAxis,)
    scaffold = IN_MODEL

    bad = (
        Bad(
            f'<link name="arm"/><«joint» name="j" type="revolute">{_ENDS}</joint>',
            says="joint `j` of type revolute has no `axis`",
        ),
        Bad(
            f'<link name="arm"/><«joint» name="j" type="universal">{_ENDS}'
            "<axis><xyz>1 0 0</xyz></axis></joint>",
            says="joint `j` of type universal has no `axis2`",
        ),
    )
    good = (
        Good(f'<link name="arm"/><joint name="j" type="ball">{_ENDS}</joint>', why="turns about all axes"),
        Good(f'<link name="arm"/><joint name="j" type="fixed">{_ENDS}</joint>'),
    )

    def check(self, problem: problems.MissingAxis) -> Iterator[Diagnostic]:
        joint = problem.joint
        message = f"{joint.title} of type {problem.type} has no `{problem.axis}`"
        taken = None if problem.default is None else f"some readers take {problem.default} instead"
        yield self.diagnostic(joint, message, help=taken)
